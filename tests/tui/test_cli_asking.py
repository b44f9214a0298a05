"""`teach`: which policy asks, with which weights, and a teacher with faults."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from tests.sessions.rooms import BOIL
from tests.tui.commandline import assert_refused, here
from verbteach_scenarios.weights import STARTING, starting_weights
from verbteach_sessions.learned import taught_by

SHOWN = BOIL.removesuffix("good\n")


def header(session: str) -> dict[str, Any]:
    read: dict[str, Any] = json.loads((Path(session) / "header.json").read_text("utf-8"))
    return read


def taught(folder: Path, script: str, *words: object) -> dict[str, Any]:
    lines = folder / "lines.txt"
    lines.write_text(script, "utf-8")
    ran = here("teach", "--teacher", lines, "--sessions", folder, "--json", *words)
    assert ran.status == 0, ran
    return dict(ran.document)


def test_written_lines_are_seldom_asked_and_somebody_who_answers_is(tmp_path: Path) -> None:
    assert header(taught(tmp_path, BOIL)["session"])["policy"]["name"] == "she16"
    words = ("teach", "--teacher", "simulated", "--lessons", 1, "--sessions", tmp_path, "--json")
    ran = here(*words)
    assert ran.status == 0, ran
    assert header(ran.document["session"])["policy"]["name"] == "rl"
    assert sum(ran.document["questions_by_type"].values()) == ran.document["questions"]


def test_eyes_of_ones_own_are_recorded_and_told(tmp_path: Path) -> None:
    words = ("--noise", "0.2,on=perfect,open=0.45", "--noise-reading", "phantom")
    session = taught(tmp_path, BOIL, *words)["session"]
    noise = header(session)["noise"]
    assert (noise["spread"], noise["spreads"]) == (0.2, {"on": 0.0, "open": 0.45})
    assert noise["phantoms"] is True
    assert "noise 0.2, on 0.0, open 0.45, seed 0" in here("replay", session, "--plain").out
    assert here("replay", session, "--verify").status == 0


def test_eyes_that_nobody_has_are_refused_in_a_line(tmp_path: Path) -> None:
    words = ("teach", "--teacher", "simulated", "--sessions", tmp_path, "--noise")
    assert_refused(here(*words, "often"), "often", "perfect")
    assert_refused(here(*words, "0.2,on"), "on=0.1")
    assert_refused(here(*words, "0.2,opne=0.1"), "opne", "openable")
    assert_refused(here("evaluate", "--noise", "0.2,opne=0.1"), "opne", "openable")
    assert list(tmp_path.iterdir()) == []


def test_weights_of_a_file_are_held_when_frozen(tmp_path: Path) -> None:
    words = ("--weights", STARTING, "--freeze")
    document = taught(tmp_path, SHOWN + "skip\n", *words)
    policy = header(document["session"])["policy"]
    assert policy["name"] == "rl"
    assert policy["frozen"] is True
    assert policy["execution"]["mean"] == list(starting_weights().execution.values)
    assert set(document["questions_by_type"]) == {"goal_relevant_ynq"}


def test_verbs_and_weights_carry_over(tmp_path: Path) -> None:
    words = ("teach", "--teacher", "simulated", "--sessions", tmp_path, "--json", "--lessons")
    first = here(*words, 2).document
    second = here(*words, 1, "--from", first["session"]).document
    assert set(first["verbs_learned"]) <= set(second["verbs_learned"])
    known = taught_by(Path(first["session"])).policy
    assert known is not None
    begun = header(second["session"])["policy"]
    assert begun["learning"]["mean"] == list(known.learning.mean)
    assert begun["learning"]["mean"] != header(first["session"])["policy"]["learning"]["mean"]


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("--policy", "manual", "--freeze"), "--freeze"),
        (("--policy", "she16", "--weights", str(STARTING)), "--weights"),
        (("--weights", "no-such-file"), "no-such-file"),
        (("--policy", "psychic"), "psychic"),
        (("--teacher", "-", "--wrong-answers", "0.5"), "--wrong-answers"),
        (("--teacher", "simulated", "--dont-know", "1.5"), "--dont-know"),
        (("--teacher", "-", "--patience", "3"), "--patience"),
    ],
)
def test_wrong_use_is_one_line(tmp_path: Path, words: tuple[str, ...], said: str) -> None:
    assert_refused(here("teach", "--sessions", tmp_path, "--scene", "kitchen-1", *words), said)


def test_a_file_of_other_weights_is_refused(tmp_path: Path) -> None:
    weights = json.loads(STARTING.read_text("utf-8"))
    weights["phases"]["learning"]["features"][0] = "mood"
    path = tmp_path / "weights.json"
    path.write_text(json.dumps(weights), "utf-8")
    ran = here("teach", "--sessions", tmp_path, "--weights", path, "--teacher", "-")
    assert_refused(ran, "weights.json", "mood")


def test_a_teacher_who_cannot_say_answers_nothing(tmp_path: Path) -> None:
    words = ("--teacher", "simulated", "--lessons", 3, "--noise", "std5", "--policy", "manual")
    ran = here("teach", *words, "--dont-know", 1, "--sessions", tmp_path, "--json")
    assert ran.status == 0, ran
    events = Path(ran.document["session"], "events.jsonl").read_text("utf-8")
    assert ran.document["questions"] > 0
    assert '"act":"unsure"' in events
    assert '"act":"yes"' not in events

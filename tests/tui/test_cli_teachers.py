"""Fitting users, evaluating policies, making the example and teaching by stand-ins, by command."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from tests.docs.test_commands import documented_keys, keys
from tests.tui.commandline import assert_refused, here


@pytest.fixture(scope="module")
def corpus(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Four sessions of two people, made by the command."""
    folder = tmp_path_factory.mktemp("corpus") / "example"
    words = ("--sessions", 4, "--lessons", 2, "--jobs", 1, "--seed", 2)
    made = here("sessions", "example", "--out", folder, *words, "--json")
    assert made.status == 0
    assert made.err == ""
    assert len(made.document["sessions"]) == 4
    assert made.document["simulated"] is True
    assert all(Path(one).is_dir() for one in made.document["sessions"])
    assert set(keys(made.document)) <= documented_keys("sessions example")
    return folder


@pytest.fixture(scope="module")
def user(corpus: Path) -> Path:
    """A user fitted to them."""
    out = corpus.parent / "people.json"
    told = here("sessions", "fit", corpus, "--out", out)
    assert told.status == 0
    assert "2 people" in told.out
    assert "include_fluent" in told.out
    assert "agreement majority" in told.out
    return out


def sessions_in(folder: Path) -> list[Path]:
    return sorted(path for path in folder.iterdir() if path.is_dir())


def test_what_was_fitted_is_one_document(corpus: Path, tmp_path: Path) -> None:
    fitted = here("sessions", "fit", corpus, "--out", tmp_path / "people.json", "--json")
    assert fitted.status == 0
    document = fitted.document
    assert (document["people"], document["sessions"]) == (2, 4)
    assert document["answers"] == sum(one["answers"] for one in document["rates"].values())
    assert 0.0 <= document["held_out"]["agreement"]["mean"] <= 1.0
    assert document["meeting"] is None
    assert set(keys(document)) <= documented_keys("sessions fit")


@pytest.mark.parametrize("prefix", ["", "fitted:"])
def test_a_fitted_user_teaches(prefix: str, user: Path, tmp_path: Path) -> None:
    words = ("--teacher", f"{prefix}{user}", "--lessons", 1, "--scene", "kitchen-1", "--json")
    taught = here("teach", *words, "--sessions", tmp_path)
    assert taught.status == 0
    assert taught.document["episodes"] >= 1
    header = json.loads((Path(taught.document["session"]) / "header.json").read_text())
    assert (header["teacher"], header["interface"]) == ("simulated", "simulated")


def test_comparing_needs_enough_people(corpus: Path, tmp_path: Path) -> None:
    refused = here("sessions", "fit", corpus, "--out", tmp_path / "p.json", "--check", "--json")
    assert_refused(refused, "--check", "4 people at least")


def test_a_policy_is_evaluated_or_the_reason_is_told(corpus: Path) -> None:
    words = ("sessions", "evaluate-policy", corpus, "--policy")
    declined = here(*words, "split", "--json")
    assert declined.status == 1
    assert set(declined.document["phases"]) == {"execution", "learning"}
    told = here(*words, "random", "--minimum", 1, "--json")
    assert told.status == 0
    phases = [one for one in told.document["phases"].values() if not one["refused"]]
    for phase in phases:
        assert phase["mean_weight"] == pytest.approx(1.0, abs=0.5)
        low, high = phase["estimates"]["doubly_robust"]["ci95"]
        assert low <= high
        assert set(keys(phase)) <= documented_keys("sessions evaluate-policy")
    assert "doubly robust" in here(*words, "random", "--minimum", 1).out
    assert_refused(here(*words, "she16"), "she16", "manual")


def test_a_record_teaches_again_and_says_where_it_is_left(corpus: Path, tmp_path: Path) -> None:
    first = sessions_in(corpus)[0]
    again = here("teach", "--teacher", first, "--sessions", tmp_path, "--json")
    assert again.status == 0
    shown = here("sessions", "show", first, "--json").document
    assert again.document["content_hash"] == shown["content_hash"]
    assert again.document["session"] != str(first)
    words = ("teach", "--teacher", first / "events.jsonl", "--sessions", tmp_path)
    other = here(*words, "--scene", "living-room-6")
    assert_refused(other, "left the record at event 1", "living-room-6", "no answer")
    resumed = here(*words, "--resume", again.document["session"])
    assert_refused(resumed, "--resume")


def test_a_file_that_is_no_fitted_user_is_refused_before_there_is_a_session(tmp_path: Path) -> None:
    wrong = tmp_path / "wrong.json"
    wrong.write_text("{}")
    folder = tmp_path / "sessions"
    for teacher in (f"fitted:{wrong}", f"fitted:{tmp_path / 'missing.json'}"):
        assert_refused(here("teach", "--teacher", teacher, "--sessions", folder), ".json")
    assert not folder.exists()


def test_lessons_and_rates_are_for_those_who_have_them(
    corpus: Path, user: Path, tmp_path: Path
) -> None:
    session = sessions_in(corpus)[0]
    folder = ("--sessions", tmp_path)
    assert_refused(here("teach", "--teacher", session, "--lessons", 2, *folder), "--lessons")
    words = ("teach", "--teacher", f"fitted:{user}", "--wrong-answers", 0.5)
    assert_refused(here(*words, *folder), "--wrong-answers")


BY_A_PERSON = """\
command: boil the water
do: moveto StoveKnob_1
do: turn StoveKnob_1
done
good
"""


@pytest.fixture
def persons(tmp_path: Path) -> Path:
    """A folder with a session of one person."""
    words = ("--teacher", "-", "--scene", "kitchen-1", "--participant", "k7m2xq9fhd")
    ran = here("teach", *words, "--sessions", tmp_path / "theirs", typed=BY_A_PERSON)
    assert ran.status == 0, ran
    return tmp_path / "theirs"


def copies(folder: Path) -> list[tuple[str, str]]:
    ran = here("sessions", "withdraw", "k7m2xq9fhd", "--sessions", folder, "--yes", "--json")
    assert ran.document["deleted"] is True
    return [(one["format"], one["out"]) for one in ran.document["exports"]]


def test_a_withdrawal_lists_the_users_fitted_to_the_person(persons: Path, tmp_path: Path) -> None:
    out = tmp_path / "user.json"
    assert here("sessions", "fit", persons, "--out", out).status == 0
    assert copies(persons) == [("fitted user", str(out))]


@pytest.mark.slow  # weights are trained
def test_a_withdrawal_lists_the_weights_trained_on_the_person(
    persons: Path, tmp_path: Path
) -> None:
    out = tmp_path / "weights.json"
    words = ("--episodes", 12, "--noise", "perfect", "--from", persons, "--out", out)
    assert here("train", *words).status == 0
    assert copies(persons) == [("weights", str(out))]


def test_nobody_is_entered_where_a_program_taught(corpus: Path, user: Path) -> None:
    assert user.exists()
    assert not (corpus / "exports.jsonl").exists()

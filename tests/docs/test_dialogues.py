"""The four dialogues of the paper's Table 1 are held end to end, and the page shows them."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import pytest

from docs import dialogues
from docs.dialogues import Dialogue
from verbteach_sessions.replay import verify
from verbteach_sessions.transcript import ROBOT, TEACHER, Line

Held = Sequence[tuple[Dialogue, Sequence[Line]]]


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("table-1")


@pytest.fixture(scope="module")
def four(folder: Path) -> Held:
    return dialogues.held(folder)


def kinds(said: Sequence[Line], speaker: str) -> list[str]:
    return [line.kind for line in said if line.speaker == speaker]


def after(said: Sequence[Line], kind: str) -> str:
    """What the teacher said to the robot's first act of a kind."""
    at = next(i for i, line in enumerate(said) if line.kind == kind and line.speaker == ROBOT)
    return next(line.kind for line in said[at:] if line.speaker == TEACHER)


def test_shown_once_it_carries_out_and_is_judged(four: Held) -> None:
    said = four[0][1]
    assert kinds(said, ROBOT)[0] == "select_hypo"
    assert kinds(said, TEACHER) == ["command", "good"]


def test_an_unknown_verb_is_shown_and_induced(four: Held) -> None:
    said = four[1][1]
    robot = kinds(said, ROBOT)
    assert robot[0] == "request_demonstration"
    assert "could you show me an example?" in said[1].text
    assert "learned" in robot
    assert not {"goal_relevant_ynq", "np_grd_ynq"} & set(robot)


def test_it_asks_what_is_meant_and_then_does_it(four: Held) -> None:
    said = four[2][1]
    robot = kinds(said, ROBOT)
    done = robot.index("select_hypo")
    assert {"np_grd_ynq", "goal_pred_ynq"} <= set(robot[:done])
    assert after(said, "np_grd_ynq") == "yes"
    question = next(line.text for line in said if line.kind == "np_grd_ynq")
    assert question.startswith("I see a ")
    assert question.endswith(", is that the pot?")
    assert after(said, "select_hypo") == "good"


def test_it_asks_whether_what_was_shown_last_belongs_to_it(four: Held) -> None:
    said = four[3][1]
    question = next(line for line in said if line.kind == "goal_relevant_ynq")
    assert question.text == "So after boiling the water, should the kettle be on the table?"
    assert after(said, "goal_relevant_ynq") == "no"
    kept = next(line.text for line in said if line.kind == "include_fluent")
    must = kept.split(".", maxsplit=1)[0]
    assert "the water must be hot" in must
    assert "table" not in must
    assert "learned" in kinds(said, ROBOT)


def test_each_can_be_replayed_to_the_bit(four: Held, folder: Path) -> None:
    assert len(four) == 4
    for path in sorted(folder.iterdir()):
        assert verify(path, dialogues.settings()).verified


def test_the_page_is_current(four: Held) -> None:
    assert dialogues.PAGE.read_text("utf-8") == dialogues.page(four), (
        "run: python docs/dialogues.py"
    )

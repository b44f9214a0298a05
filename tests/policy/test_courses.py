"""Courses: every cut's fate of a command, worked out together, is what each cut comes to alone."""

from __future__ import annotations

import math
from dataclasses import dataclass

import pytest
from hypothesis import given
from hypothesis import strategies as st

from verbteach.dialogue.acts import NpGrdWhq, RobotAct, SelectHypo
from verbteach.policy.courses import Course, Outcome, Piece

ACT = SelectHypo(frozenset(), "", ())


@dataclass(frozen=True)
class Stop:
    """A moment of a made-up command: how sure, what is chosen either way, and what follows."""

    sure: float
    choices: tuple[RobotAct, RobotAct]
    ahead: tuple[Stop | Outcome, Stop | Outcome]

    def choice(self, *, sure: bool) -> RobotAct:
        return self.choices[0 if sure else 1]

    def after(self, *, sure: bool) -> Stop | Outcome:
        return self.ahead[0 if sure else 1]


outcomes = st.sampled_from([Outcome.RIGHT, Outcome.WRONG])
levels = st.sampled_from([0.0, 0.2, 0.4, 0.6, 0.8, 1.0])


def asking(ahead: st.SearchStrategy[Stop]) -> st.SearchStrategy[Stop]:
    """One that asks either way; one that acts if it may, and asks if not; one that differs."""
    same, other = NpGrdWhq("mug"), NpGrdWhq("cup")
    return st.one_of(
        st.builds(lambda s, a: Stop(s, (same, same), (a, a)), levels, ahead),
        st.builds(lambda s, o, a: Stop(s, (ACT, same), (o, a)), levels, outcomes, ahead),
        st.builds(lambda s, a, b: Stop(s, (same, other), (a, b)), levels, ahead, ahead),
    )


shown = st.builds(lambda s, o: Stop(s, (ACT, NpGrdWhq("")), (o, Outcome.SHOWN)), levels, outcomes)
stops = st.recursive(shown, asking, max_leaves=6)


def alone(stop: Stop | Outcome, cut: float) -> tuple[Outcome, int]:
    """What one cut comes to, followed by itself."""
    asked = 0
    while not isinstance(stop, Outcome):
        stop = stop.after(sure=stop.sure >= cut)
        asked += not isinstance(stop, Outcome)
    return stop, asked


@given(stops, levels)
def test_a_course_is_what_each_cut_comes_to_alone(stop: Stop, cut: float) -> None:
    assert Course.of(stop).at(cut)[1:] == alone(stop, cut)


@given(stops)
def test_a_course_is_read_back_as_it_was_written(stop: Stop) -> None:
    course = Course.of(stop)
    assert Course.from_json(course.to_json()) == course
    wrong = [cut for cut in (0.0, 0.2, 0.4, 0.6, 0.8, 1.0) if alone(stop, cut)[0] is Outcome.WRONG]
    assert min(course.worst, 1.0) == max(wrong, default=-math.inf)


@pytest.mark.parametrize(
    "rows",
    [[], [[0.5, "right", 0]], [[0.5, "right", 0], [0.4, "shown", 1], [None, "shown", 1]],
     [[None, "fine", 0]], [["x", "right", 0]], [3]],
)  # fmt: skip
def test_what_is_no_course_is_refused(rows: list[list[object]]) -> None:
    with pytest.raises(ValueError, match=r"course|Outcome|float"):
        Course.from_json(rows)


def test_pieces_have_an_order() -> None:
    with pytest.raises(ValueError, match="rising"):
        Course((Piece(0.5, Outcome.RIGHT, 0), Piece(0.5, Outcome.WRONG, 0)))

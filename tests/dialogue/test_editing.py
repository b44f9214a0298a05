"""A demonstration is edited while it is shown: steps come in, go, and change places."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.dialogue.stage import BOIL, robot, shown, tell
from verbteach.dialogue import acts
from verbteach.dialogue.demonstration import edited
from verbteach.dialogue.moves import IllegalMoveError, Phase
from verbteach.dialogue.robot import Robot
from verbteach.world.plan import Action
from verbteach.world.simulator import applicable, run

STEPS = [Action.parse(step) for step in BOIL]


def shown_so_far(pupil: Robot) -> tuple[Action, ...]:
    assert pupil.state.episode is not None
    assert pupil.state.episode.demonstrated is not None
    return pupil.state.episode.demonstrated.actions


def watching(*steps: str) -> Robot:
    pupil = robot()
    tell(pupil, acts.Command("boil the water"), *shown(*steps)[:-1])
    return pupil


def test_a_forgotten_step_is_inserted_and_the_world_is_as_if_it_had_been_shown() -> None:
    pupil = watching("moveto Mug_2", *BOIL)
    turn = tell(pupil, acts.Remove(1, 1), acts.Insert(1, Action.parse("moveto Tap_1")))
    assert shown_so_far(pupil) == (Action.parse("moveto Tap_1"), *STEPS)
    assert pupil.state.world == watching("moveto Tap_1", *BOIL).state.world
    assert turn.phase is Phase.DEMONSTRATION
    revised = turn.waiting_act
    assert isinstance(revised, acts.ReviseSteps)
    assert revised.steps == shown_so_far(pupil)
    assert turn.texts[-1].startswith("I see 7 steps now")


def test_an_edit_that_makes_a_later_step_impossible_is_refused_with_its_reason() -> None:
    pupil = watching(*BOIL)
    before = pupil.state.world
    turn = tell(pupil, acts.Remove(2, 2))
    assert isinstance(turn.waiting_act, acts.RefuseRevision)
    assert turn.waiting_act.step == 3
    assert "set the kettle" in turn.texts[-1]
    assert "holding" in turn.texts[-1]
    assert shown_so_far(pupil) == tuple(STEPS)
    assert pupil.state.world == before


def test_steps_change_places_and_a_range_of_them_is_taken_away() -> None:
    pupil = watching("moveto Tap_1", *BOIL)
    tell(pupil, acts.Move(1, 5))
    steps = [str(step) for step in shown_so_far(pupil)]
    assert steps == [*BOIL[:4], "moveto Tap_1", *BOIL[4:]]
    tell(pupil, acts.Remove(3, 7))
    assert shown_so_far(pupil) == tuple(STEPS[:2])
    turn = tell(pupil, acts.Remove(1, 2))
    assert turn.texts[-1] == "Then I have seen no step yet."


def test_what_is_learned_is_what_the_edited_steps_did() -> None:
    plain = tell(watching(*BOIL), acts.Done()).waiting_act
    pupil = watching(*BOIL[:4], "moveto StoveKnob_2", *BOIL[4:])
    edited_turn = tell(pupil, acts.Remove(5, 5), acts.Done())
    assert edited_turn.waiting_act == plain


@pytest.mark.parametrize(
    "act",
    [
        acts.Insert(0, STEPS[0]),
        acts.Insert(9, STEPS[0]),
        acts.Remove(3, 2),
        acts.Remove(1, 7),
        acts.Move(7, 1),
        acts.Move(1, 0),
    ],
)
def test_a_number_that_no_step_has_changes_nothing(act: acts.TeacherAct) -> None:
    pupil = watching(*BOIL)
    before = pupil.state.digest
    with pytest.raises(IllegalMoveError, match="there is no step"):
        pupil.receive(act)
    assert pupil.state.digest == before


def test_without_a_step_there_is_nothing_to_take_away() -> None:
    with pytest.raises(IllegalMoveError, match="no step yet"):
        watching().receive(acts.Remove(1, 1))


@given(st.lists(st.integers(0, 99), max_size=6), st.data())
def test_an_edit_only_adds_takes_away_or_moves(numbers: list[int], data: st.DataObject) -> None:
    steps = tuple(Action("wait", (str(number),)) for number in numbers)
    at = data.draw(st.integers(1, len(steps) + 1))
    new = Action("look")
    more = edited(steps, acts.Insert(at, new))
    assert more[at - 1] == new
    assert edited(more, acts.Remove(at, at)) == steps
    to = data.draw(st.integers(1, len(more)))
    moved = edited(more, acts.Move(at, to))
    assert moved[to - 1] == new
    assert edited(moved, acts.Move(to, at)) == more


@settings(max_examples=10, deadline=None)
@given(st.data())
def test_the_world_is_always_what_the_steps_make_of_it(data: st.DataObject) -> None:
    pupil = watching(*BOIL)
    for _ in range(8):
        count = len(shown_so_far(pupil))
        possible = applicable(pupil.setting.task, pupil.state.world)
        place = st.integers(1, max(count, 1))
        act = data.draw(
            st.one_of(
                st.builds(acts.Insert, st.integers(1, count + 1), st.sampled_from(possible)),
                st.builds(acts.Move, place, place),
                place.map(lambda at: acts.Remove(at, at)),
            )
        )
        if count or isinstance(act, acts.Insert):
            pupil.receive(act)
        assert pupil.state.episode is not None
        states = run(pupil.setting.task, pupil.state.episode.start, shown_so_far(pupil))
        assert len(states) == len(shown_so_far(pupil)) + 1
        assert pupil.state.world == states[-1]


def test_fifty_one_steps_can_be_shown_and_edited() -> None:
    pupil = watching(*(f"moveto {('Tap_1', 'Mug_2', 'Counter_1')[i % 3]}" for i in range(51)))
    assert len(shown_so_far(pupil)) == 51
    tell(pupil, acts.Move(51, 1), acts.Remove(10, 50))
    assert len(shown_so_far(pupil)) == 10

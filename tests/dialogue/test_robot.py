"""A person teaches the robot: from the first command to the verb carried out elsewhere."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Sequence
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.dialogue.stage import BOIL, robot, shown, taught_to_boil, tell
from verbteach.dialogue import acts
from verbteach.dialogue.acts import DemonstrationReason, TeacherAct
from verbteach.dialogue.moves import ROBOT_MOVES, TEACHER_MOVES, IllegalMoveError, Phase
from verbteach.dialogue.robot import Robot
from verbteach.dialogue.setting import UnknownObjectError, UnknownSceneError
from verbteach.verbs.space import FrameKey
from verbteach.world.fluents import Fluent, Literal, satisfied
from verbteach.world.plan import Action
from verbteach.world.simulator import applicable

HOT = Literal(Fluent("hot", ("Water",)))


def test_an_unknown_verb_is_asked_to_be_shown() -> None:
    turn = tell(robot(), acts.Command("boil the water"))
    assert turn.phase is Phase.DEMONSTRATION
    assert turn.waiting_act == acts.RequestDemonstration(DemonstrationReason.UNKNOWN_VERB)
    assert turn.texts[-1] == "I don't know how to boil the water, could you show me an example?"


def test_a_demonstration_is_watched_step_by_step_and_read_back() -> None:
    pupil = robot()
    turn = tell(pupil, acts.Command("boil the water"), *shown(*BOIL)[:-1])
    observed = turn.waiting_act
    assert isinstance(observed, acts.ObserveStep)
    assert HOT in observed.change
    turn = tell(pupil, acts.Done())
    include = turn.waiting_act
    assert isinstance(include, acts.IncludeFluent)
    assert HOT in include.goal
    assert len(include.goal) < len(observed.change)


def test_a_confirmed_goal_is_kept_and_carried_out_in_another_scene() -> None:
    pupil = taught_to_boil()
    assert pupil.state.knowledge.verbs == ("boil",)
    turn = tell(pupil, acts.GoToScene("kitchen-3"), acts.Command("boil the water"))
    assert isinstance(turn.waiting_act, acts.SelectHypo)
    assert turn.trace is not None
    assert turn.trace.failed is None
    assert satisfied({HOT}, pupil.state.world)
    turn = tell(pupil, acts.Good())
    assert pupil.state.totals.successes == 1
    assert turn.phase is Phase.COMMAND
    assert turn.reward == 100.0


def test_a_wrong_execution_puts_the_world_back_and_asks_to_be_shown() -> None:
    pupil = taught_to_boil()
    before = tell(pupil, acts.GoToScene("kitchen-3")) and pupil.state.world
    turn = tell(pupil, acts.Command("boil the water"), acts.Bad())
    assert turn.waiting_act == acts.RequestDemonstration(
        DemonstrationReason.WRONG_EXECUTION, restored=True
    )
    assert "put everything back" in turn.texts[-1]
    assert pupil.state.world == before
    assert turn.reward == -2.0


def test_a_step_that_cannot_be_done_is_refused_in_words_and_changes_nothing() -> None:
    pupil = robot()
    tell(pupil, acts.Command("boil the water"))
    before = pupil.state.world
    turn = tell(pupil, acts.Do(Action("grasp", ("Kettle_1",))))
    refused = turn.waiting_act
    assert isinstance(refused, acts.RefuseStep)
    assert "near" in refused.reason
    assert pupil.state.world == before
    assert pupil.state.episode is not None
    assert pupil.state.episode.demonstrated is not None
    assert pupil.state.episode.demonstrated.actions == ()


@pytest.mark.parametrize(
    ("steps", "reason"),
    [
        ((), DemonstrationReason.NO_STEP),
        (
            ("moveto Tap_1", "turn-on Tap_1", "turn-off Tap_1", "moveto Counter_1"),
            None,
        ),
    ],
)
def test_a_demonstration_that_shows_nothing_goes_on(
    steps: tuple[str, ...], reason: DemonstrationReason | None
) -> None:
    turn = tell(robot(), acts.Command("boil the water"), *shown(*steps))
    waiting = turn.waiting_act
    if reason is None:
        assert isinstance(waiting, acts.IncludeFluent)
    else:
        assert waiting == acts.RequestDemonstration(reason)


def test_striking_and_keeping_change_what_is_kept() -> None:
    pupil = robot()
    turn = tell(pupil, acts.Command("boil the water"), *shown(*BOIL))
    read_back = turn.waiting_act
    assert isinstance(read_back, acts.IncludeFluent)
    extra = sorted(read_back.goal - {HOT})[0]
    on = Literal(Fluent("is-on", ("Burner_1",)))
    turn = tell(pupil, acts.Bad(), acts.Strike(extra), acts.Keep(on))
    assert turn.waiting_act == acts.IncludeFluent((read_back.goal - {extra}) | {on})
    tell(pupil, acts.Good())
    frame = pupil.state.knowledge.frames[FrameKey("boil", 1)]
    confirmed = [node for node in frame.nodes.values() if node.confirmed]
    assert any(len(node.literals) == len(read_back.goal) for node in confirmed)
    kinds = {
        (one.fluent.predicate, one.positive) for n in frame.nodes.values() for one in n.literals
    }
    assert (extra.fluent.predicate, extra.positive) not in kinds
    assert ("is-on", True) in kinds


def test_what_was_not_shown_cannot_be_kept() -> None:
    pupil = robot()
    tell(pupil, acts.Command("boil the water"), *shown(*BOIL))
    with pytest.raises(IllegalMoveError, match="does not hold"):
        pupil.receive(acts.Keep(Literal(Fluent("is-on", ("Burner_2",)))))
    with pytest.raises(IllegalMoveError, match="names nothing"):
        pupil.receive(acts.Keep(Literal(Fluent("is-on", ("Unicorn_1",)))))


def test_what_does_not_fit_leaves_everything_as_it_was() -> None:
    pupil = taught_to_boil()
    before = pupil.state.digest
    with pytest.raises(IllegalMoveError):
        pupil.receive(acts.Done())
    with pytest.raises(UnknownSceneError, match="kitchen-1"):
        pupil.receive(acts.GoToScene("kitchen-99"))
    tell(pupil, acts.Command("wash the mug"))
    asked = pupil.state.digest
    if pupil.turn.phase is Phase.EXECUTION:
        with pytest.raises(UnknownObjectError):
            pupil.receive(acts.Point("Unicorn_1"))
    assert pupil.state.digest == asked != before


def test_an_unclear_reference_is_asked_about_and_pointing_settles_it() -> None:
    pupil = robot()
    turn = tell(pupil, acts.Command("wash the mug"))
    assert turn.waiting_act == acts.NpGrdWhq("the mug")
    turn = tell(pupil, acts.Point("Mug_2"))
    assert turn.reward == -6.5
    assert pupil.state.episode is not None
    assert pupil.state.episode.grounding["the mug"] == (("Mug_2", 1.0),)
    assert turn.phase is Phase.DEMONSTRATION


def test_taking_over_puts_the_world_back_first() -> None:
    pupil = taught_to_boil()
    tell(pupil, acts.GoToScene("kitchen-3"))
    before = pupil.state.world
    turn = tell(pupil, acts.Command("boil the water"), acts.Show())
    assert turn.phase is Phase.DEMONSTRATION
    assert pupil.state.world == before


def test_going_back_to_an_earlier_state_is_exact() -> None:
    pupil = taught_to_boil()
    earlier = pupil.state
    tell(pupil, acts.GoToScene("kitchen-3"), acts.Command("boil the water"), acts.Good())
    later = pupil.state.digest
    pupil.state = earlier
    tell(pupil, acts.GoToScene("kitchen-3"), acts.Command("boil the water"), acts.Good())
    assert pupil.state.digest == later


def test_every_sentence_is_there_and_fits_its_act() -> None:
    pupil = taught_to_boil()
    assert len(pupil.turn.acts) == len(pupil.turn.texts)
    assert all(text.strip() for text in pupil.turn.texts)
    assert pupil.explain()


def fitting(pupil: Robot, rng: np.random.Generator) -> TeacherAct:
    """A random act that the table allows now, of a kind and content a person might choose."""
    kinds = sorted(TEACHER_MOVES[pupil.turn.phase], key=lambda kind: kind.name)
    made: TeacherAct = _made(pupil, kinds[int(rng.integers(len(kinds)))], rng)
    return made


def _made(pupil: Robot, kind: Any, rng: np.random.Generator) -> Any:
    def one_of(choices: Sequence[Any]) -> Any:
        return choices[int(rng.integers(len(choices)))]

    objects = sorted(pupil.setting.scene.objects)
    words = ("boil the water", "no", "yes", "the red mug", "", "take the mug and put it here")
    on = Literal(Fluent("is-on", ("Burner_1",)), bool(rng.integers(2)))
    step, (at, to) = (
        one_of(applicable(pupil.setting.task, pupil.state.world)),
        rng.integers(1, 5, 2),
    )
    arguments: dict[Any, tuple[Any, ...]] = {
        acts.Command: (one_of(words),),
        acts.Say: (one_of(words),),
        acts.Point: (one_of(objects),),
        acts.Do: (step,),
        acts.GoToScene: (one_of(("kitchen-1", "kitchen-2")),),
        acts.Strike: (on,),
        acts.Keep: (on,),
        acts.Insert: (int(at), step),
        acts.Remove: (int(at), int(to)),
        acts.Move: (int(at), int(to)),
        acts.RuleOut: ("boil/1", frozenset({on}), on),
        acts.Confirm: ("boil/1", frozenset({on}), on),
        acts.Stop: (1,),
    }
    return kind(*arguments.get(kind, ()))


@settings(max_examples=15, deadline=None)
@given(st.integers(0, 2**32 - 1))
def test_whatever_a_person_does_the_dialogue_goes_on(seed: int) -> None:
    rng = np.random.default_rng(seed)
    pupil = robot()
    for _ in range(25):
        phase, act = pupil.turn.phase, fitting(pupil, rng)
        try:
            turn = pupil.receive(act)
        except IllegalMoveError:
            continue
        assert turn.phase in TEACHER_MOVES[phase][type(act)]
        assert type(turn.waiting_act) in ROBOT_MOVES[turn.phase]
        assert all(text.strip() for text in turn.texts)


@pytest.mark.slow
def test_the_order_of_hashing_reaches_nothing() -> None:
    script = (
        "from tests.dialogue.stage import *;"
        "p = taught_to_boil();"
        "tell(p, acts.GoToScene('kitchen-2'), acts.Command('boil the water'), acts.Good());"
        "print(p.state.digest)"
    )
    digests = {
        subprocess.run(
            [sys.executable, "-c", script],
            env={"PYTHONHASHSEED": seed},
            capture_output=True,
            text=True,
            check=True,
        ).stdout
        for seed in ("0", "1", "2")
    }
    assert len(digests) == 1

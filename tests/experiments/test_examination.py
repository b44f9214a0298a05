"""A robot that was taught is examined as it is: on the commands given, learning nothing."""

from __future__ import annotations

from collections.abc import Sequence

import pytest

from tests.experiments.interactive_room import bench
from verbteach.experiments import interactive_results as results
from verbteach.experiments.examination import Examination, Pupil
from verbteach.experiments.figures import Observation
from verbteach.experiments.gold import whole_change
from verbteach.experiments.policy_scores import policy_scores
from verbteach.perception.noise import NoiseModel
from verbteach.policy.asking_policy import AskingPolicy
from verbteach.policy.fixed_rules import ManualPolicy, SilentPolicy
from verbteach.verbs.examples import Example, Memory
from verbteach.verbs.instance import Instance
from verbteach.verbs.lifting import lift
from verbteach.verbs.space import Demonstration
from verbteach.world.fluents import Goal


def _changed(one: Instance) -> Goal:
    return whole_change(one, bench().room(one).task).literals


def memory(rooms: set[str]) -> Memory:
    """What a robot knows that saw every demonstration of some rooms rightly."""
    here = bench()
    examples = []
    for one in here.instances:
        if one.environment in rooms:
            change, binding = lift(_changed(one), one.grounding, here.room(one).surroundings)
            shown = Demonstration(one.id, one.verb, one.phrases, one.grounding)
            examples.append(Example(shown, change, binding))
    return Memory.keeping(examples)


def examined(policy: AskingPolicy, level: str = "perfect") -> tuple[results.Tested, ...]:
    here = bench()
    rooms = sorted({one.environment for one in here.instances})
    commands = [one for one in here.instances if one.environment == rooms[0]]
    exam = Examination(here, commands, NoiseModel.named(level))
    return exam.held(Pupil(memory(set(rooms[1:])), policy))


def mean(rows: Sequence[results.Tested]) -> float:
    return sum(row.sji for row in rows) / len(rows)


def test_what_was_taught_elsewhere_is_carried_out_here() -> None:
    rows = examined(SilentPolicy())
    assert mean(rows) > 0.2
    assert all(not row.questions for row in rows)


def test_asking_helps() -> None:
    asking = examined(ManualPolicy())
    assert mean(asking) > mean(examined(SilentPolicy()))
    assert sum(sum(row.questions.values()) for row in asking) > 0


def test_the_same_examination_gives_the_same_marks() -> None:
    assert examined(ManualPolicy(), "std3") == examined(ManualPolicy(), "std3")


def test_progress_is_told() -> None:
    here, heard = bench(), list[int]()
    exam = Examination(here, here.instances[:3], NoiseModel.named("perfect"))
    exam.held(Pupil(Memory(), SilentPolicy()), heard=heard.append)
    assert heard == [1, 2, 3]


def test_figures_count_every_question() -> None:
    rows = examined(ManualPolicy())
    scores = policy_scores([rows], [[Observation("one", 2.0), Observation("two", 1.0)]])
    assert scores["questions_learning"]["mean"] == pytest.approx(1.5)
    asked = sum(sum(row.questions.values()) for row in rows) / len(rows)
    assert scores["questions_execution"]["mean"] == pytest.approx(asked)
    assert sum(scores["by_type"].values()) == pytest.approx(asked)
    assert scores["instances"] == len(rows)


def test_without_commands_there_are_no_figures() -> None:
    with pytest.raises(ValueError, match="at least one run"):
        policy_scores([()], [[Observation("one", 0.0)]])

"""Evaluating demonstration-only learners: folds, leaks, mappers, ceilings, the document."""

from __future__ import annotations

import json
import os
import pickle
import subprocess
import sys
from collections.abc import Callable, Iterable
from dataclasses import replace
from typing import TypeVar

import pytest

from tests.experiments.shelves import STARTS, grounds, instances, put, room
from verbteach.experiments.evaluation import Grounds, ceiling_trials, evaluate, run_trials, scores
from verbteach.experiments.folds import held_out, is_development, leave_one_environment_out
from verbteach.experiments.groundings import shown
from verbteach.experiments.jobs import Setup
from verbteach.experiments.judging import Judge, Score
from verbteach.experiments.polling import Lesson
from verbteach.experiments.she16 import CRITERIA, VARIANTS, Variant, variant
from verbteach.perception.noise import LEVELS, READINGS, NoiseModel
from verbteach.verbs.application import certain, uniform
from verbteach.verbs.change import ObjectSet
from verbteach.verbs.instance import Instance
from verbteach.world.plan import Action

_J = TypeVar("_J")
_R = TypeVar("_R")
STRONG = VARIANTS["she16"]


def by_post(function: Callable[[_J], _R], jobs: Iterable[_J]) -> list[_R]:
    """Jobs done in other processes' way: sent as bytes, the last one first."""
    letters = [pickle.dumps(job) for job in jobs]
    answers = [function(pickle.loads(letter)) for letter in reversed(letters)]
    return [pickle.loads(pickle.dumps(answer)) for answer in reversed(answers)]


def setup(chosen: Variant = STRONG, **changes: object) -> Setup:
    return replace(Setup(chosen, development=2), **changes)  # type: ignore[arg-type]


def test_folds_hold_out_whole_environments() -> None:
    found = instances()
    folds = leave_one_environment_out(found)
    assert [fold.name for fold in folds] == sorted(STARTS)
    for fold in folds:
        assert {i.environment for i in fold.test} == {fold.name}
        assert fold.name not in {i.environment for i in fold.train}
        assert len(fold.train) + len(fold.test) == len(found)
    with pytest.raises(ValueError, match="only one"):
        leave_one_environment_out(folds[0].test)
    with pytest.raises(ValueError, match="instances to test"):
        held_out(found, ())


def test_the_development_part_is_whole_documents() -> None:
    many = [replace(instances()[0], group=str(n)) for n in range(1000)]
    assert 150 < sum(map(is_development, many)) < 250
    assert len({is_development(i) for i in many[:1] * 3}) == 1


@pytest.mark.parametrize("name", sorted(VARIANTS))
@pytest.mark.parametrize("grounding", ["oracle", "corpus"])
def test_every_command_gets_one_trial(name: str, grounding: str) -> None:
    trials = run_trials(grounds(), setup(VARIANTS[name], grounding=grounding))
    assert [t.instance for t in trials] == sorted(i.id for i in instances())
    assert all(0 <= value <= 1 for t in trials for value in t.score)


def test_what_all_teachers_do_is_done_elsewhere() -> None:
    """Five of six only put the box on the shelf, so that is what is done, in every room."""
    trials = run_trials(grounds(), setup(grounding="oracle"))
    for trial, instance in zip(trials, sorted(instances(), key=lambda i: i.id), strict=True):
        box, shelf = instance.grounding
        assert trial.plan == tuple(map(str, put(box, shelf, instance.start)))
        assert trial.score == (
            Score(1, 1) if len(instance.actions) == 2 else pytest.approx((2 / 3, 2 / 3))
        )


@pytest.mark.parametrize("criterion", CRITERIA)
def test_every_criterion_and_object_set_runs(criterion: str) -> None:
    for kind in ObjectSet:
        trials = run_trials(grounds(), setup(variant("she16", criterion, kind.value)))
        assert len(trials) == len(instances())


@pytest.mark.parametrize("reading", READINGS)
@pytest.mark.parametrize("level", LEVELS)
def test_other_ways_of_spreading_the_work_change_nothing(level: str, reading: str) -> None:
    chosen = setup(noise=NoiseModel.named(level, reading), seed=3)
    assert run_trials(grounds(), chosen, mapper=by_post) == run_trials(grounds(), chosen)


def test_runs_differ_by_their_draws_only_with_noise() -> None:
    noisy = setup(noise=NoiseModel.named("std5"))
    assert run_trials(grounds(), noisy, 0) == run_trials(grounds(), noisy, 0)
    assert run_trials(grounds(), noisy, 0) != run_trials(grounds(), noisy, 1)
    assert run_trials(grounds(), setup(), 0) == run_trials(grounds(), setup(), 1)


def test_lessons_that_are_known_are_not_learned_again_and_change_nothing() -> None:
    noisy = setup(noise=NoiseModel.named("std3"))
    first, *others = grounds().folds
    known: dict[str, Lesson] = {}
    run_trials(replace(grounds(), folds=(first,)), noisy, known=known)
    assert set(known) == {i.id for i in first.train}
    held = dict(known)
    rest = replace(grounds(), folds=tuple(others))
    assert run_trials(rest, noisy, known=known) == run_trials(rest, noisy)
    assert all(known[name] is lesson for name, lesson in held.items())
    assert set(known) > set(held)


def lit(instance: Instance) -> Instance:
    """The instance as if its teacher had lit the lamp instead of moving the box."""
    actions = (Action("light", ("Lamp_1",)),)
    end = room().outcome(instance.start, actions)
    return replace(instance, actions=actions, end=end, gold=actions)


@pytest.mark.parametrize("name", sorted(VARIANTS))
def test_the_answers_to_test_commands_do_not_leak(name: str) -> None:
    """Another demonstration of the held-out commands changes their scores and no plan."""
    chosen = setup(VARIANTS[name], grounding="corpus")
    fold = grounds().folds[0]
    other = replace(fold, test=tuple(map(lit, fold.test)))
    first = run_trials(replace(grounds(), folds=(fold,)), chosen)
    second = run_trials(replace(grounds(), folds=(other,)), chosen)
    assert [t.plan for t in first] == [t.plan for t in second]
    assert [t.score for t in first] != [t.score for t in second]


def test_other_folds_do_not_leak_into_a_fold() -> None:
    """A fold alone gives what it gives among others: no fold learns from its own test part."""
    whole = run_trials(grounds(), setup())
    alone = [
        trial
        for fold in grounds().folds
        for trial in run_trials(replace(grounds(), folds=(fold,)), setup())
    ]
    assert sorted(alone) == whole


def test_ceilings_are_above() -> None:
    document = evaluate(grounds(), setup(variant("she16", "most_specific")), resample=50)
    ceilings = document["ceilings"]
    assert document["sji"]["mean"] <= ceilings["oracle_selection"]["sji"]["mean"]
    assert ceilings["oracle_goal"]["sji"]["mean"] == 1.0
    assert all(t.score == Score(1, 1) for t in ceiling_trials(grounds()))


def test_the_document_has_what_the_command_line_promises() -> None:
    document = evaluate(grounds(), setup(), runs=2, ceilings=False, resample=50)
    again = json.loads(json.dumps(document))
    assert again == document
    for name in ("ied", "sji", "questions_learning", "questions_execution"):
        assert set(document[name]) == {"mean", "sd", "ci95", "runs"}
        assert document[name]["runs"] == 2
    assert document["instances"] == len(instances())
    assert document["questions_learning"]["mean"] == 0.0
    assert "ceilings" not in document


def test_scores_are_means_over_commands() -> None:
    trials = run_trials(grounds(), setup(grounding="oracle"))
    found = scores([trials], resample=50)
    assert found.sji.mean == pytest.approx(sum(t.score.sji for t in trials) / len(trials))


def test_a_judge_knows_the_gold() -> None:
    first = instances()[0]
    judge = Judge(first, room())
    assert judge.score(first.actions) == Score(1, 1)
    assert judge.score(()) == Score(0, 0)
    assert judge.score((Action("put", ("Box_2", "Shelf_2")),)) == Score(0, 0)  # cannot be done
    half = judge.score(first.actions[:1])
    assert half.ied == 0.5
    assert 0 < half.sji < 1
    assert judge.ceiling == Score(1, 1)


def test_a_demonstration_settles_what_was_meant() -> None:
    belief = uniform((("Box_1", "Box_2"), ("Shelf_1", "Shelf_2")))
    everything = frozenset({"Box_2", "Shelf_2"})
    assert shown(belief, everything, frozenset()) == ("Box_2", "Shelf_2")
    assert shown(belief, frozenset(), everything) == ("Box_2", "Shelf_2")
    assert shown(belief, frozenset({"Box_2"}), frozenset({"Box_1"})) == ("Box_2", "Shelf_1")
    assert shown(certain(("Lamp_1",)), everything, everything) == ("Lamp_1",)


def test_a_given_grounder_is_asked_with_experience() -> None:
    asked: list[int] = []

    def own(instance: Instance, experience: object) -> object:
        asked.append(len(experience))  # type: ignore[arg-type]
        return certain(instance.grounding)

    run_trials(grounds(), setup(grounding="own", grounder=own))
    assert 0 in asked  # a demonstration is grounded without any other
    assert max(asked) == len(grounds().folds[0].train)
    with pytest.raises(ValueError, match="needs a grounder"):
        Setup(STRONG, grounding="own")


def test_names_that_are_none_are_refused() -> None:
    with pytest.raises(ValueError, match="she16-all"):
        variant("she17")
    with pytest.raises(ValueError, match="most_general"):
        variant("she16", "best")
    with pytest.raises(ValueError, match="argument-only"):
        variant("she16", None, "some")
    assert variant() is STRONG
    assert variant("she16-all").learning.object_set is ObjectSet.ALL


_SCRIPT = """
import json
from tests.experiments.shelves import grounds
from verbteach.experiments.evaluation import evaluate
from verbteach.experiments.jobs import Setup
from verbteach.experiments.she16 import VARIANTS
from verbteach.perception.noise import NoiseModel
setup = Setup(VARIANTS["she16"], NoiseModel.named("std3", "phantom"), development=2)
print(json.dumps(evaluate(grounds(), setup, resample=20)))
"""


def test_hash_order_changes_nothing() -> None:
    def outcome(seed: str) -> str:
        environment = {**os.environ, "PYTHONHASHSEED": seed}
        done = subprocess.run(
            [sys.executable, "-c", _SCRIPT],
            env=environment, capture_output=True, text=True, check=True,
        )  # fmt: skip
        return done.stdout

    assert outcome("1") == outcome("2")


def test_grounds_list_each_instance_once() -> None:
    found = grounds()
    assert len(found.instances) == len(found.train) == len(instances())
    one = Grounds(held_out(instances()[:12], instances()[12:]), found.tasks, found.planner)
    assert len(one.train) == 12
    assert len(one.instances) == len(instances())

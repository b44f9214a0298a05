"""Evaluating a learner from demonstrations: learn in some environments, act in others.

A demonstration's space depends on nothing but the demonstration and is
computed once a run; a fold only merges. The work is cut into jobs that
``mapper`` may spread over processes: results are the same for every mapper.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Protocol, TypeVar

from verbteach.collecting import without_collecting
from verbteach.experiments.figures import Figure, Observation, constant, figure
from verbteach.experiments.folds import Fold, is_development
from verbteach.experiments.jobs import (
    Development,
    Setup,
    Site,
    Trial,
    develop_all,
    learn_all,
    test_all,
)
from verbteach.experiments.judging import Judge
from verbteach.experiments.parcels import Parcel
from verbteach.experiments.polling import Lesson, School
from verbteach.experiments.she16 import CRITERIA, ORACLE, REGRESSION
from verbteach.experiments.sight import Sight, stream
from verbteach.experiments.workroom import PlannerMaker, furnished
from verbteach.verbs.criteria import PLAIN_CRITERIA, Teller
from verbteach.verbs.instance import Instance
from verbteach.verbs.regression import fit
from verbteach.world.task import Task

_J = TypeVar("_J")
_R = TypeVar("_R")


class Mapper(Protocol):
    """Applies a function to jobs, somehow and somewhere; the results keep the jobs' order."""

    def __call__(self, function: Callable[[_J], _R], jobs: Iterable[_J], /) -> Iterable[_R]:
        """Like ``map``."""
        ...


@dataclass(frozen=True)
class Grounds:
    """What is evaluated on: folds, and the tasks of their instances with a planner's maker."""

    folds: tuple[Fold, ...]
    tasks: Mapping[str, Task]
    planner: PlannerMaker

    @property
    def instances(self) -> tuple[Instance, ...]:
        """Every instance of every fold once, by id."""
        found = {i.id: i for fold in self.folds for i in (*fold.train, *fold.test)}
        return tuple(found[name] for name in sorted(found))

    @cached_property
    def parcels(self) -> dict[str, Parcel[Task]]:
        """The tasks as they travel with jobs."""
        return {key: Parcel(task) for key, task in self.tasks.items()}

    @property
    def train(self) -> tuple[Instance, ...]:
        """Every instance that some fold learns from, by id."""
        found = {i.id: i for fold in self.folds for i in fold.train}
        return tuple(found[name] for name in sorted(found))


def run_trials(
    grounds: Grounds,
    setup: Setup,
    run: int = 0,
    mapper: Mapper = map,
    known: dict[str, Lesson] | None = None,
    sight: Sight | None = None,
    school: School | None = None,
) -> list[Trial]:
    """One run: the trials of all folds, by instance.

    ``known``, ``sight`` and ``school`` as in ``compare_criteria``.
    """
    own = setup.variant.criterion
    return compare_criteria(grounds, setup, (own,), run, mapper, known, sight, school)[own]


def compare_criteria(
    grounds: Grounds,
    setup: Setup,
    criteria: Sequence[str] = CRITERIA,
    run: int = 0,
    mapper: Mapper = map,
    known: dict[str, Lesson] | None = None,
    sight: Sight | None = None,
    school: School | None = None,
) -> dict[str, list[Trial]]:
    """One run of learners that learn alike and differ in how they choose: trials by criterion.

    The same as ``run_trials`` with each ``setup.variant.criterion``, at about
    the price of one: demonstrations are learned from once, and candidate goals
    gathered once. ``known`` are the lessons of an earlier call with the same
    setup and run on the same instances, whatever its folds; what is learned
    now is added. ``sight`` is that of the setup's noise and seed, the run and
    the instances, where somebody has looked through it before. ``school`` is
    that of an earlier call with more lessons of the same setup and run: all
    that those say about a command is remembered there.
    """
    with without_collecting():
        sight = sight or Sight.of(setup.noise, grounds.instances, setup.seed, run)
        site = Site(setup, sight, grounds.parcels, grounds.planner)
        known = {} if known is None else known
        _learn(grounds, site, mapper, known)
        school = School() if school is None else school
        school.admit({instance.id: known[instance.id] for instance in grounds.train})
        lessons = Parcel(school)
        chosen = _criteria(grounds, site, lessons, criteria, mapper)
        jobs = [
            (site.only(fold.test), fold.test, (lessons, [i.id for i in fold.train]), own)
            for fold, own in zip(grounds.folds, chosen, strict=True)
        ]
        found = list(mapper(test_all, jobs))
    return {name: sorted(trial for one in found for trial in one[name]) for name in criteria}


def _learn(grounds: Grounds, site: Site, mapper: Mapper, known: dict[str, Lesson]) -> None:
    """Add the lessons that are still to be learned to those that are known."""
    new = [instance for instance in grounds.train if instance.id not in known]
    jobs = [(site.only(own), own) for own in _by_environment(new).values()]
    for lessons in mapper(learn_all, jobs):
        known.update((lesson.demonstration.id, lesson) for lesson in lessons)


def _criteria(
    grounds: Grounds,
    site: Site,
    lessons: Parcel[School],
    names: Sequence[str],
    mapper: Mapper,
) -> list[dict[str, Teller | None]]:
    """Each fold's criteria; the regression is fitted to what the fold may learn from."""
    alike: dict[str, Teller | None] = {
        name: PLAIN_CRITERIA.get(name) for name in names if name != REGRESSION
    }
    if REGRESSION not in names:
        return [alike] * len(grounds.folds)
    development = _developed(grounds, site, lessons, mapper)
    fitting = site.setup.variant.fitting
    return [
        {**alike, REGRESSION: fit(list(_within(development, fold).values()), fitting)}
        for fold in grounds.folds
    ]


def _developed(
    grounds: Grounds, site: Site, lessons: Parcel[School], mapper: Mapper
) -> Development:
    """Votes on the development commands, by lessons from other environments than theirs."""
    share = site.setup.development
    jobs = []
    for environment, own in _by_environment(grounds.train).items():
        chosen = [i for i in own if is_development(i, share)]
        others = [i.id for i in grounds.train if i.environment != environment]
        if chosen:
            jobs.append((site.only(chosen), chosen, (lessons, others)))
    return {name: own for found in mapper(develop_all, jobs) for name, own in found.items()}


def _within(development: Development, fold: Fold) -> Development:
    """The development votes whose command and demonstration the fold learns from."""
    known = {instance.id for instance in fold.train}
    return {name: development[name].among(known) for name in sorted(development) if name in known}


def _by_environment(instances: Sequence[Instance]) -> dict[str, list[Instance]]:
    found: dict[str, list[Instance]] = defaultdict(list)
    for instance in instances:
        found[instance.environment].append(instance)
    return {name: found[name] for name in sorted(found)}


@dataclass(frozen=True)
class Scores:
    """IED and SJI over all test commands."""

    ied: Figure
    sji: Figure

    def to_json(self) -> dict[str, Any]:
        """Plain JSON."""
        return {"ied": self.ied.to_json(), "sji": self.sji.to_json()}


def scores(runs: Sequence[Sequence[Trial]], seed: int = 0, resample: int = 2000) -> Scores:
    """Summarise the runs' trials; intervals come from ``resample`` bootstrap samples."""
    rows = [[(trial.group, trial.score) for trial in trials] for trials in runs]
    return Scores(
        figure(
            [[Observation(g, s.ied) for g, s in run] for run in rows],
            stream(seed, "ied"),
            resample,
        ),
        figure(
            [[Observation(g, s.sji) for g, s in run] for run in rows],
            stream(seed, "sji"),
            resample,
        ),
    )


def ceiling_trials(grounds: Grounds) -> list[Trial]:
    """What planning to the whole gold change from the true state comes to, by instance."""
    tests = [instance for fold in grounds.folds for instance in fold.test]
    return sorted(_ceiling(grounds, instance) for instance in tests)


def _ceiling(grounds: Grounds, instance: Instance) -> Trial:
    key = instance.task_key
    judge = Judge(instance, furnished(key, grounds.tasks[key], grounds.planner))
    where = (instance.id, instance.group, instance.environment, instance.verb)
    return Trial(*where, judge.ceiling, 1, ())


def evaluate(
    grounds: Grounds,
    setup: Setup,
    runs: int = 1,
    mapper: Mapper = map,
    *,
    ceilings: bool = True,
    resample: int = 2000,
) -> dict[str, Any]:
    """Evaluate a learner; the JSON document of ``verbteach evaluate``.

    With ``ceilings`` it also has what the learner would come to if it always
    chose the best of its candidate goals (``oracle_selection``), and what
    planning to the demonstrated change comes to (``oracle_goal``).
    """
    own = setup.variant.criterion
    criteria = tuple(dict.fromkeys([own, ORACLE] if ceilings else [own]))
    found = [compare_criteria(grounds, setup, criteria, run, mapper) for run in range(runs)]
    trials = [one[own] for one in found]
    document = {
        "policy": setup.variant.name,
        "criterion": setup.variant.criterion,
        "objects": setup.variant.learning.object_set.value,
        "grounding": setup.grounding,
        "folds": [fold.name for fold in grounds.folds],
        **scores(trials, setup.seed, resample).to_json(),
        "questions_learning": constant(0.0, runs).to_json(),
        "questions_execution": constant(0.0, runs).to_json(),
        "instances": len(trials[0]),
    }
    if ceilings:
        oracle = [one[ORACLE] for one in found]
        goal = [ceiling_trials(grounds)] * runs
        document["ceilings"] = {
            "oracle_selection": scores(oracle, setup.seed, resample).to_json(),
            "oracle_goal": scores(goal, setup.seed, resample).to_json(),
        }
    return document

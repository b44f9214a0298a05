"""Where commands go wrong, by kind, with examples.

Each command that does not come to the demonstrated change is put down to one
cause: the command and its demonstration, the vocabulary, the planner, the
candidate goals, the grounding, or the choice; what would have helped most.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from enum import Enum

from verbteach.experiments.evaluation import Grounds, Mapper, ceiling_trials, compare_criteria
from verbteach.experiments.gold import whole_change
from verbteach.experiments.jobs import Setup, Trial
from verbteach.experiments.she16 import ORACLE
from verbteach.verbs.instance import Instance

EPSILON = 1e-9


class Kind(Enum):
    """Why a command went wrong."""

    NOTHING_CHANGED = "the demonstration ends as it began"
    MISALIGNED = "the demonstration changes none of the objects spoken of"
    UNSEEN_VERB = "nobody taught the verb"
    PLANNING = "a plan to the demonstrated change differs just as much"
    NO_CANDIDATE = "no candidate goal comes near enough"
    GROUNDING = "the goal was chosen for other objects"
    CHOICE = "another candidate would have been better"


@dataclass(frozen=True)
class Mishap:
    """A command that went wrong: what was demonstrated and what was planned."""

    instance: Instance
    kind: Kind
    sji: float
    best: float
    wanted: tuple[str, ...]
    plan: tuple[str, ...]


@dataclass(frozen=True)
class Analysis:
    """All mishaps among ``commands`` commands, by instance."""

    commands: int
    mishaps: tuple[Mishap, ...]

    def of(self, kind: Kind) -> tuple[Mishap, ...]:
        """Those of a kind."""
        return tuple(one for one in self.mishaps if one.kind is kind)

    def lost(self, kind: Kind) -> float:
        """How much the kind takes from the mean SJI."""
        return sum(1.0 - one.sji for one in self.of(kind)) / self.commands


@dataclass(frozen=True)
class _Outcomes:
    """One command's SJI: as it went, with the best candidate, with gold grounding, at most."""

    own: float
    best: float
    grounded: float
    goal: float


def analyse(grounds: Grounds, setup: Setup, mapper: Mapper = map) -> Analysis:
    """Carry out every test command and put down what goes wrong to a cause."""
    chosen = setup.variant.criterion
    found = compare_criteria(grounds, setup, (chosen, ORACLE), mapper=mapper)
    certain = replace(setup, grounding="oracle", grounder=None)
    grounded = compare_criteria(grounds, certain, (chosen,), mapper=mapper)[chosen]
    lists = (found[chosen], found[ORACLE], grounded, ceiling_trials(grounds))
    tested = {i.id: (i, fold.train) for fold in grounds.folds for i in fold.test}
    mishaps = []
    for trials in zip(*lists, strict=True):
        instance, train = tested[trials[0].instance]
        outcomes = _Outcomes(*(trial.score.sji for trial in trials))
        if outcomes.own < 1.0 - EPSILON:
            taught = any(one.verb == instance.verb for one in train)
            mishaps.append(_mishap(grounds, instance, trials[0], outcomes, taught))
    return Analysis(len(found[chosen]), tuple(mishaps))


def _mishap(
    grounds: Grounds, instance: Instance, trial: Trial, outcomes: _Outcomes, taught: bool
) -> Mishap:
    change = whole_change(instance, grounds.tasks[instance.task_key]).literals
    if not change:
        kind = Kind.NOTHING_CHANGED
    elif not instance.changed_objects & _spoken_of(instance):
        kind = Kind.MISALIGNED
    elif not taught:
        kind = Kind.UNSEEN_VERB
    else:
        kind = cause(outcomes.own, outcomes.best, outcomes.grounded, outcomes.goal)
    wanted = tuple(str(literal) for literal in sorted(change))
    return Mishap(instance, kind, outcomes.own, outcomes.best, wanted, trial.plan)


def _spoken_of(instance: Instance) -> frozenset[str]:
    return frozenset(thing for objects in instance.candidates for thing in objects)


def cause(own: float, best: float, grounded: float, goal: float) -> Kind:
    """Which step lost most, of a command that makes sense and whose verb was taught.

    SJI: ``own`` as it went, ``best`` with the best candidate, ``grounded`` by
    the same method with the gold objects, ``goal`` planning to the whole change.
    """
    if own >= goal - EPSILON:
        return Kind.PLANNING
    if max(goal, best) - best >= best - own:
        return Kind.NO_CANDIDATE
    return Kind.GROUNDING if grounded - own >= (best - own) / 2 else Kind.CHOICE


def markdown(analysis: Analysis, examples: int = 3) -> str:
    """A table of the kinds, then examples of each: those that lost most."""
    rows = [
        f"| {kind.value} | {len(analysis.of(kind))} | {analysis.lost(kind):.3f} |" for kind in Kind
    ]
    right = analysis.commands - len(analysis.mishaps)
    rows.append(f"| exactly the demonstrated change | {right} | |")
    table = "\n".join(["| kind | commands | mean SJI lost |", "| --- | --- | --- |", *rows])
    parts = [table]
    for kind in Kind:
        chosen = _telling(analysis.of(kind), examples)
        if chosen:
            parts.append(f"**{kind.value.capitalize()}**\n\n" + "\n".join(map(_line, chosen)))
    return "\n\n".join(parts) + "\n"


def _telling(mishaps: Sequence[Mishap], most: int) -> list[Mishap]:
    """Those that lost most, one for each verb."""
    first: Mapping[str, Mishap] = {
        one.instance.verb: one for one in sorted(mishaps, key=lambda m: (-m.sji, m.instance.id))
    }
    return sorted(first.values(), key=lambda m: (m.sji - m.best, m.instance.id))[:most]


def _line(one: Mishap) -> str:
    said = f"{one.instance.verb} ({', '.join(one.instance.phrases)})"
    wanted = ", ".join(one.wanted) or "nothing"
    plan = "; ".join(one.plan) or "nothing"
    return (
        f"- {one.instance.id}, *{said}*: demonstrated {wanted}; done: {plan}."
        f" SJI {one.sji:.2f}, best candidate {one.best:.2f}."
    )

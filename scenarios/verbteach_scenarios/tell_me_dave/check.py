"""``benchmark check``: is a corpus folder whole, and does the project's domain fit it?"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from statistics import fmean
from typing import Any, TypeAlias

from verbteach.world.plan import Planner
from verbteach.world.planner import SearchPlanner
from verbteach.world.task import Task
from verbteach_scenarios.lengths import Lengths
from verbteach_scenarios.tell_me_dave.corpus import read_corpus
from verbteach_scenarios.tell_me_dave.documents import Corpus, Oddity
from verbteach_scenarios.tell_me_dave.instances import CorpusInstance, instances
from verbteach_scenarios.tell_me_dave.reach import Reached, ReachKind, reach
from verbteach_scenarios.tell_me_dave.rooms import Rooms
from verbteach_scenarios.tell_me_dave.transitions import Difference, differences

Progress: TypeAlias = Callable[[str, int, int], None]
"""Called with the stage ("reading", "running", "planning"), what is done, and of how much."""

_REPORTED = 20
"""How often a stage reports, at most, beside its end."""


@dataclass(frozen=True)
class BenchmarkReport:
    """What a corpus folder holds and how the domain fits it.

    ``verbs`` and ``noun_phrases`` count distinct ones in lower case, the
    phrases those of the instances' frames. ``cleaned`` are the lengths
    without needless moves. ``reached`` has an entry for each instance.
    """

    documents: int
    environments: int
    clauses: int
    instances: int
    verbs: int
    noun_phrases: int
    length: Lengths
    cleaned: Lengths
    transitions: int
    differences: tuple[Difference, ...]
    reached: tuple[Reached, ...]
    oddities: tuple[Oddity, ...]

    @property
    def reproduced(self) -> float:
        """The share of transitions that the domain reproduces; 1 where there is none."""
        if not self.transitions:
            return 1.0
        return 1.0 - len(self.differences) / self.transitions

    @property
    def sji(self) -> float:
        """Mean SJI of plans to each instance's whole change; 0 without instances."""
        return fmean(r.sji for r in self.reached) if self.reached else 0.0

    @property
    def exact(self) -> float:
        """The share of instances whose plan changed just what the demonstration changed."""
        exact = sum(r.kind is ReachKind.EXACT for r in self.reached)
        return exact / len(self.reached) if self.reached else 0.0

    def to_json(self) -> dict[str, Any]:
        """Return plain JSON, as the command line prints it."""
        return {
            "documents": self.documents,
            "environments": self.environments,
            "clauses": self.clauses,
            "instances": self.instances,
            "verbs": self.verbs,
            "noun_phrases": self.noun_phrases,
            "length": vars(self.length),
            "cleaned_length": vars(self.cleaned),
            "transitions": self.transitions,
            "reproduced": self.reproduced,
            "reachable": {
                "sji": self.sji,
                "exact": self.exact,
                "kinds": _counts(r.kind.value for r in self.reached),
            },
            "kinds": _counts(d.kind.value for d in self.differences),
            "differences": [_difference(d) for d in self.differences],
            "warnings": [
                {"file": o.path.name, "line": o.line, "message": o.reason} for o in self.oddities
            ],
        }


def check_corpus(
    folder: Path,
    progress: Progress | None = None,
    planner: Callable[[Task], Planner] = SearchPlanner,
) -> BenchmarkReport:
    """Read a folder, run every recorded action, and plan to every instance's whole change.

    Raise ``CorpusError`` where the folder cannot be read whole.
    """
    tell = progress or (lambda stage, done, of: None)
    corpus = read_corpus(folder, lambda done, of: _tell(tell, "reading", done, of))
    rooms = Rooms.of(corpus)
    found = _run(corpus, rooms, tell)
    chosen = instances(corpus, rooms=rooms)
    reached = _plan(chosen, rooms, tell, planner)
    return BenchmarkReport(
        documents=len(corpus.documents),
        environments=len(set(rooms.environments.values())),
        clauses=sum(len(document.clauses) for document in corpus.documents),
        instances=len(chosen),
        verbs=len({c.instance.verb for c in chosen}),
        noun_phrases=len({phrase for c in chosen for phrase in c.noun_phrases}),
        length=Lengths.of([len(c.instance.actions) for c in chosen]),
        cleaned=Lengths.of([len(c.instance.gold) for c in chosen]),
        transitions=sum(len(document.steps) - 1 for document in corpus.documents),
        differences=found,
        reached=reached,
        oddities=corpus.oddities,
    )


def _run(corpus: Corpus, rooms: Rooms, tell: Progress) -> tuple[Difference, ...]:
    found: list[Difference] = []
    for done, document in enumerate(corpus.documents, start=1):
        found += differences(document, rooms)
        _tell(tell, "running", done, len(corpus.documents))
    return tuple(found)


def _plan(
    chosen: Sequence[CorpusInstance],
    rooms: Rooms,
    tell: Progress,
    planner: Callable[[Task], Planner],
) -> tuple[Reached, ...]:
    planners: dict[str, Planner] = {}
    reached = []
    for done, one in enumerate(chosen, start=1):
        key = one.instance.task_key
        if key not in planners:
            planners[key] = planner(rooms.task(key))
        reached.append(reach(one.instance, rooms.task(key), planners[key]))
        _tell(tell, "planning", done, len(chosen))
    return tuple(reached)


def _tell(tell: Progress, stage: str, done: int, of: int) -> None:
    if done == of or done % max(1, of // _REPORTED) == 0:
        tell(stage, done, of)


def _counts(kinds: Iterable[str]) -> dict[str, int]:
    return dict(sorted(Counter(kinds).items()))


def _difference(difference: Difference) -> dict[str, Any]:
    return {
        "document": difference.document,
        "step": difference.step,
        "action": difference.action,
        "expected": list(difference.expected),
        "got": list(difference.got),
        "kind": difference.kind.value,
        "reason": difference.reason,
    }

"""Who is asked about a command: all lessons of a run once, of which each learner hears some."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple, TypeAlias

from verbteach.verbs.application import ApplicationParameters, Situation, supports
from verbteach.verbs.hypothesis import NoHypothesis
from verbteach.verbs.knowledge import VerbKnowledge
from verbteach.verbs.poll import Poll
from verbteach.verbs.space import Demonstration, HypothesisSpace

_REMEMBERED = 512
"""Polls that a school remembers; then it begins anew."""

_Asked: TypeAlias = tuple[str, bool]
"""The name of a command, and whether all verbs' goals are borrowed."""


class Lesson(NamedTuple):
    """What a demonstration taught."""

    demonstration: Demonstration
    outcome: HypothesisSpace | NoHypothesis


class School:
    """The lessons of a run, and what they all said about commands.

    Learners that heard more or fewer of them ask about the same commands;
    what is remembered does not travel.
    """

    def __init__(self, lessons: Mapping[str, Lesson] | None = None) -> None:
        self._lessons = dict(lessons or {})
        self._polls: dict[_Asked, tuple[Situation, ApplicationParameters, Poll]] = {}
        self._knowledge: VerbKnowledge | None = None

    def __reduce__(self) -> tuple[type[School], tuple[Mapping[str, Lesson]]]:
        return School, (self._lessons,)

    def __len__(self) -> int:
        return len(self._lessons)

    def admit(self, lessons: Mapping[str, Lesson]) -> None:
        """Take lessons in; where one is new, everybody is asked anew."""
        if not lessons.keys() <= self._lessons.keys():
            self._lessons |= lessons
            self._polls, self._knowledge = {}, None

    def panel(self, names: Iterable[str]) -> Panel:
        """Some of the lessons, in this order."""
        return Panel(self, tuple([self._lessons[name] for name in names]))

    def poll(
        self, name: str, situation: Situation, parameters: ApplicationParameters, borrows: bool
    ) -> Poll:
        """What all lessons say about the command of that name; see ``supports``."""
        kept = self._polls.get((name, borrows))
        if kept is None or kept[:2] != (situation, parameters):
            if self._knowledge is None:
                self._knowledge = merged(self._lessons.values())
            if len(self._polls) >= _REMEMBERED:
                self._polls.clear()
            poll = Poll.of(supports(self._knowledge, situation, parameters, borrows), situation)
            kept = self._polls[name, borrows] = (situation, parameters, poll)
        return kept[2]


@dataclass(frozen=True)
class Panel:
    """The lessons that one learner heard."""

    school: School
    lessons: Sequence[Lesson]

    @cached_property
    def experience(self) -> tuple[Demonstration, ...]:
        """What was demonstrated, understood or not."""
        return tuple(one.demonstration for one in self.lessons)

    def poll(self, name: str, situation: Situation, parameters: ApplicationParameters) -> Poll:
        """What they say about the command of that name.

        Where all verbs' goals are borrowed, asking the whole school only pays
        for those who heard most of it.
        """
        borrows = self._taught[situation.frame.verb] < parameters.borrow_below
        if borrows and 2 * len(self.lessons) < len(self.school):
            return Poll.of(supports(self._knowledge, situation, parameters, True), situation)
        return self.school.poll(name, situation, parameters, borrows).among(self._names)

    @cached_property
    def _names(self) -> frozenset[str]:
        return frozenset(one.demonstration.id for one in self.lessons)

    @cached_property
    def _knowledge(self) -> VerbKnowledge:
        return merged(self.lessons)

    @cached_property
    def _taught(self) -> Counter[str]:
        """How many lessons taught each verb."""
        return Counter(one.demonstration.verb for one in self.lessons if _taught(one))


def merged(lessons: Iterable[Lesson]) -> VerbKnowledge:
    """What the lessons that taught something taught."""
    outcomes = (one.outcome for one in lessons)
    return VerbKnowledge.merged(space for space in outcomes if isinstance(space, HypothesisSpace))


def _taught(lesson: Lesson) -> bool:
    return isinstance(lesson.outcome, HypothesisSpace)

"""What the right answer would have been, as far as anything tells; else unknown.

The world tells about fluents and changes, a lesson about all it is meant to
teach, and what the person did later about objects and goals. Nothing is made up.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field

from verbteach.dialogue import acts
from verbteach.dialogue.acts import RobotAct
from verbteach.dialogue.judging import Judge
from verbteach.dialogue.lesson import Lesson
from verbteach.dialogue.setting import Settings
from verbteach.world.fluents import Goal, Literal
from verbteach_sessions.people.standing import Standing


@dataclass(frozen=True)
class LessonBook:
    """Lessons by scene and command: what a simulated teacher, or a study's task, meant."""

    lessons: Mapping[tuple[str, str], tuple[Lesson, ...]] = field(default_factory=dict)

    @classmethod
    def of(cls, lessons: Iterable[Lesson]) -> LessonBook:
        """A book of these lessons."""
        found: dict[tuple[str, str], tuple[Lesson, ...]] = {}
        for one in lessons:
            key = one.scene, one.command
            found[key] = (*found.get(key, ()), one)
        return cls(found)

    def meant(self, scene: str, command: str) -> tuple[Lesson, ...]:
        """The lessons that the command may have come from; none where none has these words."""
        return self.lessons.get((scene, command), ())


@dataclass(frozen=True)
class Later:
    """What the rest of an episode showed: what phrases meant, and the goal that was accepted."""

    meant: Mapping[str, str] = field(default_factory=dict)
    goal: Goal | None = None


@dataclass(frozen=True)
class Gold:
    """Says whether yes is right, for one episode."""

    lessons: Sequence[Lesson]
    later: Later
    settings: Settings

    def truth(self, question: RobotAct, now: Standing) -> bool | None:
        """Whether yes (or good) is the right answer; ``None`` where nothing tells.

        For a question which object it is there is no yes: see :meth:`objects`.
        """
        known = self._by_the_world(question, now)
        if known is not None:
            return known
        if self.lessons:
            said = {self._by_the_lesson(one, question, now) for one in self.lessons}
            return said.pop() if len(said) == 1 else None
        return self._by_what_followed(question)

    def objects(self, phrase: str) -> frozenset[str] | None:
        """The objects that a phrase means; ``None`` where nothing tells."""
        if self.lessons:
            said = {frozenset(_of_phrase(one, phrase)) for one in self.lessons}
            found = said.pop() if len(said) == 1 else frozenset()
            return found or None
        thing = self.later.meant.get(phrase)
        return None if thing is None else frozenset({thing})

    def _by_the_world(self, question: RobotAct, now: Standing) -> bool | None:
        if isinstance(question, acts.EnvPredYnq) and now.start is not None:
            return question.fluent in now.start
        if now.start is None or now.world is None:
            return None
        if isinstance(question, acts.PredChangeYnq):
            literal = question.literal
            return literal.holds(now.world) and not literal.holds(now.start)
        return None

    def _by_the_lesson(self, lesson: Lesson, question: RobotAct, now: Standing) -> bool | None:
        match question:
            case acts.NpGrdYnq(np=phrase, object=thing):
                return thing in _of_phrase(lesson, phrase)
            case acts.BulkNpGrdYnq(pairs=pairs):
                return all(thing in _of_phrase(lesson, phrase) for phrase, thing in pairs)
            case acts.GoalPredYnq(literal=literal) | acts.GoalRelevantYnq(literal=literal):
                return literal in lesson.goal
        return self._judged(lesson, question, now)

    def _judged(self, lesson: Lesson, question: RobotAct, now: Standing) -> bool | None:
        if now.start is None or now.world is None:
            return None
        judge = Judge(lesson, self.settings(lesson.scene))
        if isinstance(question, acts.SelectHypo):
            return judge.execution(now.start, now.world)
        if isinstance(question, acts.IncludeFluent):
            return judge.goal(now.start, question.goal)
        return None

    def _by_what_followed(self, question: RobotAct) -> bool | None:
        match question:
            case acts.NpGrdYnq(np=phrase, object=thing):
                return self._was_meant(phrase, thing)
            case acts.BulkNpGrdYnq(pairs=pairs):
                return _all(self._was_meant(phrase, thing) for phrase, thing in pairs)
            case acts.GoalPredYnq(literal=literal) | acts.GoalRelevantYnq(literal=literal):
                return self._was_kept(literal)
        return None

    def _was_meant(self, phrase: str, thing: str) -> bool | None:
        meant = self.later.meant.get(phrase)
        return None if meant is None else thing == meant

    def _was_kept(self, literal: Literal) -> bool | None:
        return None if self.later.goal is None else literal in self.later.goal


def _of_phrase(lesson: Lesson, phrase: str) -> tuple[str, ...]:
    return lesson.grounding.get(phrase, ())


def _all(known: Iterable[bool | None]) -> bool | None:
    found = list(known)
    if False in found:
        return False
    return None if None in found else True

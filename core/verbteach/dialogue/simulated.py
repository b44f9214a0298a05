"""A simulated teacher: it gives bundled lessons' commands and answers from their gold.

How often it errs, does not know or has had enough are settable; its draws
depend on its seed, the lesson and the question, on nothing else.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import islice

import numpy as np

from verbteach.dialogue import acts
from verbteach.dialogue.acts import TeacherAct
from verbteach.dialogue.judging import Judge
from verbteach.dialogue.lesson import Lesson
from verbteach.dialogue.moves import Phase
from verbteach.dialogue.setting import Settings
from verbteach.dialogue.state import RobotState
from verbteach.dialogue.turn import RobotTurn
from verbteach.world.fluents import Literal


def seeded_order(lessons: Sequence[Lesson], count: int, seed: int) -> tuple[Lesson, ...]:
    """``count`` lessons in a seeded order; more than there are repeat in a newly seeded order."""
    return tuple(islice(_rounds(lessons, seed), count))


def _rounds(lessons: Sequence[Lesson], seed: int) -> Iterator[Lesson]:
    number = 0
    while lessons:
        order = np.random.default_rng([seed, number]).permutation(len(lessons))
        yield from (lessons[int(index)] for index in order)
        number += 1


@dataclass(frozen=True)
class TeacherHabits:
    """How good a simulated teacher is at answering questions; by default it is perfect.

    ``wrong`` is the probability that a yes/no answer is the opposite of the
    right one, ``unsure`` that any answer is "I don't know". After ``patience``
    questions about one command every answer is "I don't know".
    """

    wrong: float = 0.0
    unsure: float = 0.0
    patience: int | None = None
    seed: int = 0

    def __post_init__(self) -> None:
        for name, rate in (("wrong", self.wrong), ("unsure", self.unsure)):
            if not 0.0 <= rate <= 1.0:
                raise ValueError(f"{name}: a rate is between 0 and 1, not {rate}")


class SimulatedTeacher:
    """Teaches ``lessons`` one after the other; implements ``Teacher``.

    ``given`` counts those whose command has been said; a teacher who comes back
    to a session is told how many. ``habits`` are for answers to questions:
    demonstrations and judgements are always right.
    """

    def __init__(
        self,
        lessons: Sequence[Lesson],
        settings: Settings,
        given: int = 0,
        habits: TeacherHabits | None = None,
    ) -> None:
        self._lessons = tuple(lessons)
        self._settings = settings
        self.given = given
        self._habits = habits or TeacherHabits()

    def reply(self, turn: RobotTurn, state: RobotState) -> TeacherAct | None:
        """Answer from the current lesson, or give the next one's command."""
        match turn.phase:
            case Phase.COMMAND:
                return self._command(state)
            case Phase.EXECUTION | Phase.LEARNING:
                return self._answer(turn, state)
            case Phase.JUDGEMENT:
                return self._judgement(state)
            case Phase.DEMONSTRATION:
                return self._step(turn, state)
            case Phase.READ_BACK:
                return self._correction(state)

    @property
    def first_scene(self) -> str:
        """Where the first lesson takes place; there has to be one."""
        return self._lessons[0].scene

    @property
    def lesson(self) -> Lesson:
        """The lesson whose command was said last."""
        return self._lessons[self.given - 1]

    def habits(self, question: acts.RobotAct) -> TeacherHabits:
        """How well a question to the lesson's command is answered."""
        return self._habits

    def _command(self, state: RobotState) -> TeacherAct | None:
        # Lessons are checked: the grammar reads their commands as meant, and no word is a slip.
        if state.offered:
            return acts.Command("yes")
        if state.suggested:
            return acts.Command("no")
        if self.given >= len(self._lessons):
            return None
        lesson = self._lessons[self.given]
        found = self._settings(lesson.scene).scene.initial
        if state.scene != lesson.scene or state.world != found:
            return acts.GoToScene(lesson.scene)
        self.given += 1
        return acts.Command(lesson.command)

    def _answer(self, turn: RobotTurn, state: RobotState) -> TeacherAct:
        question = turn.waiting_act
        asked = len(state.episode.asked) if state.episode else 0
        habits = self.habits(question)
        draws = np.random.default_rng([habits.seed, self.given, asked, 0x7EAC])
        unsure, wrong = draws.random(2).tolist()
        patience = habits.patience
        if unsure < habits.unsure or (patience is not None and asked >= patience):
            return acts.Unsure()
        if isinstance(question, acts.NpGrdWhq):
            gold = self._gold(question.np)
            return acts.Point(gold[0]) if gold else acts.Unsure()
        truth = self._truth(question, state, turn)
        if truth is None:
            return acts.Unsure()
        return acts.Yes() if truth != (wrong < habits.wrong) else acts.No()

    def _truth(self, question: acts.RobotAct, state: RobotState, turn: RobotTurn) -> bool | None:
        """The right answer to a yes/no question; None where the lesson does not say."""
        match question:
            case acts.NpGrdYnq(np=phrase, object=thing):
                return thing in self._gold(phrase)
            case acts.BulkNpGrdYnq(pairs=pairs):
                return all(thing in self._gold(phrase) for phrase, thing in pairs)
            case acts.EnvPredYnq(fluent=fluent):
                return fluent in (state.episode.start if state.episode else state.world)
            case acts.GoalPredYnq(literal=literal) | acts.GoalRelevantYnq(literal=literal):
                shown = isinstance(question, acts.GoalRelevantYnq)
                return literal in self.lesson.goal or (shown and self._needed(literal, state, turn))
            case acts.PredChangeYnq(literal=literal):
                before = state.episode.start if state.episode else state.world
                return literal.holds(state.world) and not literal.holds(before)
        return None

    def _needed(self, literal: Literal, state: RobotState, turn: RobotTurn) -> bool:
        """Whether what the robot is about to keep is right with the literal, and wrong without.

        What is meant can be said in other words than the lesson's: in the cupboard, put away.
        """
        options = turn.decisions[-1].candidates if turn.decisions else ()
        kept = next((o.act.goal for o in options if isinstance(o.act, acts.IncludeFluent)), None)
        if kept is None or state.episode is None:
            return False
        judge, start = self._judge(), state.episode.start
        return judge.goal(start, kept) and not judge.goal(start, kept - {literal})

    def _gold(self, phrase: str) -> tuple[str, ...]:
        return self.lesson.grounding.get(phrase, ())

    def _judge(self) -> Judge:
        return Judge(self.lesson, self._settings(self.lesson.scene))

    def _judgement(self, state: RobotState) -> TeacherAct:
        episode = state.episode
        start = episode.start if episode else state.world
        return acts.Good() if self._judge().execution(start, state.world) else acts.Bad()

    def _step(self, turn: RobotTurn, state: RobotState) -> TeacherAct:
        waiting = turn.waiting_act
        nothing = acts.DemonstrationReason.NOTHING_CHANGED
        stuck = isinstance(waiting, acts.RequestDemonstration) and waiting.reason is nothing
        if stuck or isinstance(waiting, acts.RefuseStep):
            return acts.Skip()
        shown = state.episode.demonstrated if state.episode else None
        done = len(shown.actions) if shown else 0
        steps = self.lesson.demonstration
        return acts.Do(steps[done]) if done < len(steps) else acts.Done()

    def _correction(self, state: RobotState) -> TeacherAct:
        """Say right or wrong; after a wrong, correct the goal literal by literal."""
        episode = state.episode
        if episode is None or episode.read_back is None:
            return acts.Skip()
        read_back, meant = episode.read_back, self.lesson.goal
        if self._judge().goal(episode.start, read_back.goal):
            return acts.Good()
        if not read_back.rejected:
            return acts.Bad()
        for literal in sorted(meant - read_back.goal):
            return acts.Keep(literal)
        for literal in sorted(read_back.goal - meant):
            return acts.Strike(literal)
        return acts.Skip()

"""The simulated human of the experiments: answers from a data instance and judges executions.

METHOD of She & Chai (2017), section 5.1, as far as it goes: a grounding is
right if the object survives the narrowing to what changed; environment answers
come from the true start, goal and change answers from the true change.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import NamedTuple
from zlib import crc32

import numpy as np

from verbteach.dialogue.acts import (
    BulkNpGrdYnq,
    EnvPredYnq,
    GoalPredYnq,
    GoalRelevantYnq,
    NpGrdWhq,
    NpGrdYnq,
    PredChangeYnq,
    RobotAct,
)
from verbteach.dialogue.inquiry import Label, Reply
from verbteach.experiments.gold import whole_change
from verbteach.experiments.metrics import sji
from verbteach.experiments.workroom import Workroom
from verbteach.verbs.change import StateChange
from verbteach.verbs.instance import Instance
from verbteach.world.fluents import Goal
from verbteach.world.plan import Action, Plan


class AnswerRates(NamedTuple):
    """How often a person's yes/no answers of one kind are wrong, and how often "don't know"."""

    error: float = 0.0
    unsure: float = 0.0


@dataclass(frozen=True)
class HumanParameters:
    """How good a teacher is.

    ``right_from``: an execution is judged right when its SJI is at least that.
    ``error``: the probability that a yes/no answer is the wrong one; ``unsure``
    that it is "I don't know". After ``patience`` questions every answer is
    "I don't know".
    """

    right_from: float = 1.0
    error: float = 0.0
    unsure: float = 0.0
    patience: int = 1000

    def rates(self, question: str) -> AnswerRates:
        """The rates for one kind of question, by the act's name."""
        return AnswerRates(self.error, self.unsure)

    def teaching(self, instance: str) -> HumanParameters:
        """Who teaches an instance, by its id: here always the same."""
        return self


@dataclass(frozen=True)
class Person(HumanParameters):
    """A teacher with rates of their own for some kinds of questions, by the act's name."""

    by_question: Mapping[str, AnswerRates] = field(default_factory=dict)

    def rates(self, question: str) -> AnswerRates:
        """The rates for one kind of question; the general ones where it has none of its own."""
        return self.by_question.get(question, super().rates(question))


@dataclass(frozen=True)
class People(HumanParameters):
    """Several teachers, at least one: which of them teaches an instance hangs on its id alone."""

    people: tuple[HumanParameters, ...] = (HumanParameters(),)

    def teaching(self, instance: str) -> HumanParameters:
        """One of the people."""
        return self.people[crc32(instance.encode()) % len(self.people)]


@dataclass(frozen=True)
class SimulatedHuman:
    """One instance's human."""

    instance: Instance
    room: Workroom
    parameters: HumanParameters = field(default_factory=HumanParameters)

    @cached_property
    def change(self) -> StateChange:
        """What the demonstration really changed."""
        return whole_change(self.instance, self.room.task)

    def reply(self, act: RobotAct, asked: int, rng: np.random.Generator) -> Reply:
        """Answer the question that comes after ``asked`` others; two draws are taken each time."""
        unsure, wrong = rng.random(2).tolist()
        rates = self.parameters.rates(act.name)
        if asked >= self.parameters.patience or unsure < rates.unsure:
            return Reply(Label.UNSURE)
        if isinstance(act, NpGrdWhq):
            return Reply(Label.OBJECTS, self._meant(act.np))
        return Reply.of(self.truth(act) != (wrong < rates.error))

    def truth(self, act: RobotAct) -> bool:
        """The right answer to a yes/no question."""
        match act:
            case NpGrdYnq(np=phrase, object=thing):
                return thing in self._meant(phrase)
            case BulkNpGrdYnq(pairs=pairs):
                return all(thing in self._meant(phrase) for phrase, thing in pairs)
            case EnvPredYnq(fluent=fluent):
                return fluent in self.instance.start
            case GoalPredYnq(literal=literal) | PredChangeYnq(literal=literal):
                return literal in self._literals
            case GoalRelevantYnq(literal=literal):
                return literal in (self.instance.goal or self._literals)
        raise TypeError(f"{act!r} is no yes/no question")

    def score(self, actions: Sequence[Action]) -> float:
        """The SJI of what the actions change in the true world, up to the first that fails.

        It is remembered: the same few plans are judged over and over.
        """
        plan = tuple(actions)
        if plan not in self._scores:
            self._scores[plan] = self._score(plan)
        return self._scores[plan]

    def _score(self, actions: Sequence[Action]) -> float:
        end = self.room.outcome(self.instance.start, actions)
        static = self.room.surroundings.static
        return sji(self.change, StateChange.between(self.instance.start, end, static))

    def right(self, actions: Sequence[Action]) -> bool:
        """Whether an execution is judged right."""
        return self.score(actions) >= self.parameters.right_from

    def right_goal(self, goal: Goal) -> bool:
        """Whether an included goal is: planning to it from the true start gives the change."""
        answer = self.room.planner.plan(self.instance.start, goal)
        return isinstance(answer, Plan) and self.right(answer.actions)

    @cached_property
    def _scores(self) -> dict[tuple[Action, ...], float]:
        return {}

    @cached_property
    def _literals(self) -> Goal:
        return self.change.literals

    def _meant(self, phrase: str) -> tuple[str, ...]:
        return self.instance.narrowed[self.instance.phrases.index(phrase)]

"""The courses of an experiment's test commands, by how sure the robot has to be."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from verbteach.dialogue.acts import RobotAct, SelectHypo
from verbteach.dialogue.execution_inquiry import ExecutionInquiry
from verbteach.dialogue.promise import Promise, Sureness, held_to
from verbteach.experiments.asked_command import AskedCommand
from verbteach.experiments.carrying_out import carry_out
from verbteach.experiments.sight import stream
from verbteach.policy.asking_policy import ENDING
from verbteach.policy.courses import Course, Outcome


@dataclass(frozen=True)
class CommandMoment:
    """A test command in a ``state``, after so many questions.

    Draws depend on the command and on how many questions there were, so that
    every cut meets the same answers.
    """

    command: AskedCommand
    sureness: Sureness
    state: ExecutionInquiry
    asked: int = 0

    @property
    def sure(self) -> float:
        """How sure the robot is of the goal that it would carry out."""
        return self.sureness.now(self.state.candidates()) or 0.0

    def choice(self, *, sure: bool) -> RobotAct:
        """What the policy chooses."""
        return self._willing if sure else self._unwilling

    def after(self, *, sure: bool) -> CommandMoment | Outcome:
        """What that leads to, answered by the command's human and carried out in its room."""
        act = self.choice(sure=sure)
        if isinstance(act, SelectHypo):
            return self._carried_out
        if isinstance(act, ENDING):
            return Outcome.SHOWN
        reply = self.command.human.reply(act, self.asked, self._rng("answer"))
        state = self.state.after(act, reply)
        return CommandMoment(self.command, self.sureness, state, self.asked + 1)

    @cached_property
    def _willing(self) -> RobotAct:
        return self._chosen(None)

    @cached_property
    def _unwilling(self) -> RobotAct:
        return self._chosen(Promise(rate=0.5, sure=1.0, lessons=1, sureness=self.sureness))

    def _chosen(self, promise: Promise | None) -> RobotAct:
        offered = held_to(promise, self.state.candidates())
        return self.command.policy.choose(None, offered, self._rng("choice")).act

    @property
    def _carried_out(self) -> Outcome:
        human = self.command.human
        right = carry_out(self.state, human, self.command.gold).sji >= human.parameters.right_from
        return Outcome.RIGHT if right else Outcome.WRONG

    def _rng(self, what: str) -> np.random.Generator:
        return stream(0, self.asked, "course", what, self.command.instance.id)


def course_of(command: AskedCommand, sureness: Sureness) -> Course:
    """The command's course from its first words on."""
    return Course.of(CommandMoment(command, sureness, command.start))

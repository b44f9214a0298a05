"""A test command from its first words to its scores, for whoever wants to look into it."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TypeAlias

from verbteach.dialogue.execution_inquiry import ExecutionInquiry
from verbteach.experiments.carrying_out import Carried
from verbteach.experiments.simulated_human import SimulatedHuman
from verbteach.policy.asking_policy import AskingPolicy
from verbteach.verbs.examples import Memory
from verbteach.verbs.instance import Instance
from verbteach.world.plan import Action


@dataclass(frozen=True)
class AskedCommand:
    """How a policy asked about a command, and how it was carried out.

    ``start`` is the execution phase before the first question and ``end`` after
    the last; ``memory`` is what the robot knew of verbs; ``gold`` the sequence
    that the plan is compared with.
    """

    instance: Instance
    human: SimulatedHuman
    memory: Memory
    policy: AskingPolicy
    start: ExecutionInquiry
    end: ExecutionInquiry
    gold: Sequence[Action]
    carried: Carried


Witness: TypeAlias = Callable[[AskedCommand], None]
"""Told of each test command once it is carried out."""


def unwitnessed(command: AskedCommand) -> None:
    """Tell nobody."""

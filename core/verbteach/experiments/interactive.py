"""One dialogue of an experiment: a policy asks, the simulated human answers, somebody keeps score.

The same loop serves both phases; the phase's inquiry says what can be asked.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from typing import Generic, Protocol, Self, TypeVar

import numpy as np

from verbteach.dialogue.acts import RobotAct
from verbteach.dialogue.decision import Candidate, Decision
from verbteach.dialogue.inquiry import Reply
from verbteach.dialogue.rewards import Rewards
from verbteach.experiments.carrying_out import Carried
from verbteach.experiments.simulated_human import SimulatedHuman
from verbteach.policy.asking_policy import ENDING, AskingPolicy

MOST = 8
"""So many questions are traced at most."""


class Inquiry(Protocol):
    """A phase's state: see ``dialogue.inquiry``."""

    def candidates(self) -> tuple[Candidate, ...]:
        """The acts to choose from."""
        ...

    def after(self, act: RobotAct, reply: Reply) -> Self:
        """The state after a reply."""
        ...


Phase = TypeVar("Phase", bound=Inquiry)


@dataclass(frozen=True)
class Turn:
    """One choice of the robot's and the reward of it; the last one's is the phase's success."""

    decision: Decision
    reward: float


@dataclass(frozen=True)
class Dialogue(Generic[Phase]):
    """A phase from its first choice to its last; ``questions`` counts acts by name."""

    state: Phase
    turns: tuple[Turn, ...]
    questions: Counter[str] = field(default_factory=Counter)

    @property
    def ended_with(self) -> RobotAct:
        """The act that ended it."""
        return self.turns[-1].decision.act

    @property
    def asked(self) -> int:
        """How many questions were put; a bulk question is one."""
        return sum(self.questions.values())


def hold(
    state: Phase,
    policy: AskingPolicy,
    human: SimulatedHuman,
    rewards: Rewards,
    rng: np.random.Generator,
) -> Dialogue[Phase]:
    """Ask until an act ends the phase; that act's turn has no reward yet."""
    turns: list[Turn] = []
    questions: Counter[str] = Counter()
    while True:
        decision = policy.choose(None, state.candidates(), rng)
        act = decision.act
        if isinstance(act, ENDING):
            return Dialogue(state, (*turns, Turn(decision, 0.0)), questions)
        reply = human.reply(act, len(turns), rng)
        turns.append(Turn(decision, rewards.of(act.name, positive=reply.positive)))
        questions[act.name] += 1
        state = state.after(act, reply)


def judged(dialogue: Dialogue[Phase], right: float, rewards: Rewards) -> Dialogue[Phase]:
    """The dialogue with the reward of its last act, between wrong (0) and right (1)."""
    last = dialogue.turns[-1]
    name = last.decision.act.name
    yes, no = rewards.of(name, positive=True), rewards.of(name, positive=False)
    earned = no + right * (yes - no)
    return replace(dialogue, turns=(*dialogue.turns[:-1], Turn(last.decision, earned)))


def asked_on(
    state: Phase,
    carried: Callable[[Phase], Carried],
    policy: AskingPolicy,
    human: SimulatedHuman,
    rng: np.random.Generator,
    most: int = MOST,
) -> tuple[Carried, ...]:
    """How the command would be carried out after no question, after one, and so on.

    ``carried`` says how in a state. It ends with the policy, or after ``most`` questions.
    """
    found = [carried(state)]
    while len(found) <= most:
        act = policy.choose(None, state.candidates(), rng).act
        if isinstance(act, ENDING):
            break
        state = state.after(act, human.reply(act, len(found) - 1, rng))
        found.append(carried(state))
    return tuple(found)

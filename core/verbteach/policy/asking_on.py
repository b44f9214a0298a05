"""Policies that do not stop by themselves: how good their questions are, whenever they end.

With them, what a policy would come to with exactly one, two or three questions
can be compared.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import ClassVar

import numpy as np

from verbteach.dialogue.decision import Candidate, Decision
from verbteach.policy.asking_policy import AskingPolicy, ending, questions
from verbteach.policy.fixed_rules import RandomPolicy, SplitPolicy
from verbteach.policy.linear import LinearPolicy


@dataclass(frozen=True)
class AskingOnPolicy:
    """Takes another policy's choice among the questions while there is one."""

    asking: AskingPolicy
    name: str = "asking-on"
    asks: ClassVar[bool] = True

    def choose(
        self, episode: object, candidates: Sequence[Candidate], rng: np.random.Generator
    ) -> Decision:
        """Ask, or end the phase where no question is left."""
        left = questions(candidates)
        if not left:
            return Decision(tuple(candidates), ending(candidates), reason="no question is left")
        asked = self.asking.choose(episode, [candidates[i] for i in left], rng)
        return Decision(tuple(candidates), left[asked.chosen], reason="asks on")


def asking_on(policy: AskingPolicy) -> AskingPolicy:
    """The policy without its own wish to stop; a rule that ends for want of questions still does.

    Its first questions are the policy's own, unless that draws lots.
    """
    if isinstance(policy, SplitPolicy):
        return replace(policy, cap=float("inf"))
    if isinstance(policy, LinearPolicy | RandomPolicy):
        return AskingOnPolicy(policy)
    return policy

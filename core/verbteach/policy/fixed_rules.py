"""Policies that are rules: the paper's two baselines, the split rule, and asking nothing."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from verbteach.dialogue.acts import (
    EnvPredYnq,
    GoalPredYnq,
    GoalRelevantYnq,
    NpGrdYnq,
    PredChangeYnq,
    RobotAct,
)
from verbteach.dialogue.decision import Candidate, Decision
from verbteach.policy.asking_policy import ending

_DOUBTS: dict[type[RobotAct], str] = {
    EnvPredYnq: "env_pred_ynq.doubt",
    GoalPredYnq: "goal_pred_ynq.doubt",
    PredChangeYnq: "pred_change_ynq.doubt",
    GoalRelevantYnq: "goal_relevant_ynq.aside",
}


def in_doubt(candidate: Candidate) -> float:
    """How doubtful a yes/no question's answer is, 0 to 1; 0 for other acts."""
    if isinstance(candidate.act, NpGrdYnq):
        return 1.0 - abs(2.0 * candidate.features["np_grd_ynq.probability"] - 1.0)
    name = _DOUBTS.get(type(candidate.act))
    return candidate.features.get(name, 0.0) if name else 0.0


@dataclass(frozen=True)
class SilentPolicy:
    """Asks nothing."""

    name: str = "silent"
    asks: ClassVar[bool] = True

    def choose(
        self, episode: object, candidates: Sequence[Candidate], rng: np.random.Generator
    ) -> Decision:
        """End the phase at once."""
        return Decision(tuple(candidates), ending(candidates), reason="this policy asks nothing")


@dataclass(frozen=True)
class RandomPolicy:
    """Chooses every act with the same probability (She & Chai 2017, section 5.1)."""

    name: str = "random"
    asks: ClassVar[bool] = True

    def choose(
        self, episode: object, candidates: Sequence[Candidate], rng: np.random.Generator
    ) -> Decision:
        """Draw one."""
        chosen = int(rng.integers(len(candidates)))
        return Decision(tuple(candidates), chosen, 1.0 / len(candidates), reason="drawn at random")


@dataclass(frozen=True)
class ManualPolicy:
    """Asks yes/no questions until there are no more (She & Chai 2017, section 5.1).

    First about objects, then the environment or the change, then the goal, and
    where that is offered whether parts of the change that the command does not
    speak of belong to it. A question whose answer is less doubtful than
    ``doubt`` counts as no question; the paper does not say which there are.
    """

    doubt: float = 0.2
    name: str = "manual"
    asks: ClassVar[bool] = True

    def choose(
        self, episode: object, candidates: Sequence[Candidate], rng: np.random.Generator
    ) -> Decision:
        """Take the most doubtful question of the first kind that is left."""
        for kind in (NpGrdYnq, EnvPredYnq, PredChangeYnq, GoalPredYnq, GoalRelevantYnq):
            found = [i for i, one in enumerate(candidates) if isinstance(one.act, kind)]
            best = max(found, key=lambda i: in_doubt(candidates[i]), default=None)
            if best is not None and in_doubt(candidates[best]) > self.doubt:
                return Decision(tuple(candidates), best, reason="a question is left")
        return Decision(tuple(candidates), ending(candidates), reason="no question is left")


@dataclass(frozen=True)
class SplitPolicy:
    """Asks the goal question that best halves what is left, ``cap`` times at most.

    In the learning phase the changed fluent that is most in doubt stands for
    the goal question. With a fractional ``cap`` the last question is asked
    with that probability, so that the mean number can be set.
    """

    cap: float = 3.0
    doubt: float = 0.1
    name: str = "split"
    asks: ClassVar[bool] = True

    def choose(
        self, episode: object, candidates: Sequence[Candidate], rng: np.random.Generator
    ) -> Decision:
        """Take the most doubtful goal or change question."""
        found = [
            i
            for i, one in enumerate(candidates)
            if isinstance(one.act, GoalPredYnq | PredChangeYnq)
        ]
        best = max(found, key=lambda i: in_doubt(candidates[i]), default=None)
        enough = best is None or in_doubt(candidates[best]) <= self.doubt
        if enough or best is None or not self._one_more(candidates[best], rng):
            return Decision(tuple(candidates), ending(candidates), reason="enough is known")
        return Decision(tuple(candidates), best, reason="the answer halves what is left")

    def _one_more(self, question: Candidate, rng: np.random.Generator) -> bool:
        left = self.cap - round(10.0 * question.features["ask.asked"])
        return left >= 1.0 or (left > 0.0 and rng.random() < left)

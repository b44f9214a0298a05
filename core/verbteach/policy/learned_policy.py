"""The question policy that learns while a person teaches: one set of weights for each phase.

Q(s, a) = theta . phi(s, a), with a Gaussian over theta. The robot takes the
act that is best under a draw of theta (Thompson 1933), so it explores where it
is unsure and less and less. It begins with what was learned in simulation.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from hashlib import sha256
from typing import Any, ClassVar

import numpy as np

from verbteach.dialogue.decision import Candidate, Decision
from verbteach.dialogue.moves import Phase
from verbteach.dialogue.policy import Taken
from verbteach.dialogue.state import EpisodeState
from verbteach.policy.learners import GAMMA, REWARD_SCALE
from verbteach.policy.linear import Weights
from verbteach.policy.posterior import Posterior
from verbteach.policy.weights_file import PolicyWeights

PRIOR = 0.02
"""The weights' variance where simulation left none; success is worth 1."""


@dataclass(frozen=True)
class LiveLearning:
    """How a robot learns to ask from the person in front of it.

    ``price`` multiplies what questions cost, as it did in training; what is
    recorded as reward stays the paper's. ``noise`` is the variance of a
    one-step return. ``forget`` makes the simulator's posterior that many times
    wider, so that one person's answers count against thousands of simulated
    ones. ``exploration`` scales Thompson's draws, 0 takes the best act;
    ``draws`` of them estimate an act's probability.
    """

    gamma: float = GAMMA
    price: float = 1.0
    noise: float = 0.2
    forget: float = 4.0
    exploration: float = 0.2
    draws: int = 200


@dataclass(frozen=True)
class LearnedPolicy:
    """Weights of both phases, and how they are used. ``frozen``: neither learn nor explore."""

    execution: Posterior
    learning: Posterior
    how: LiveLearning = field(default_factory=LiveLearning)
    frozen: bool = False
    name: str = "rl"
    asks: ClassVar[bool] = True

    @classmethod
    def beginning(cls, weights: PolicyWeights, *, frozen: bool = False) -> LearnedPolicy:
        """A policy that begins with trained weights, and with the price they were trained at."""
        price = weights.parameters.get("price", 1.0)
        how = LiveLearning(price=float(price) if isinstance(price, int | float) else 1.0)
        return cls(
            _posterior(weights, "execution", weights.execution, how),
            _posterior(weights, "learning", weights.learning, how),
            how,
            frozen,
        )

    @cached_property
    def digest(self) -> str:
        """SHA-256 of the weights of both phases and how sure they are."""
        return sha256((self.execution.digest + self.learning.digest).encode()).hexdigest()

    def choose(
        self, episode: EpisodeState, candidates: Sequence[Candidate], rng: np.random.Generator
    ) -> Decision:
        """The act that is best under a draw of the weights; values are those of the mean."""
        posterior = self._of(episode.phase.value)
        valued = tuple(_valued(one, posterior) for one in candidates)
        best = max(range(len(valued)), key=lambda i: (valued[i].value or 0.0, -i))
        winners = self._winners(valued, posterior, best, rng)
        chosen = winners[int(rng.integers(len(winners)))]
        propensity = winners.count(chosen) / len(winners)
        explored = chosen != best
        return Decision(valued, chosen, propensity, explored, _REASONS[explored], self.digest)

    def told(self, taken: Taken) -> tuple[LearnedPolicy, Mapping[str, Any] | None]:
        """Learn from one step; the record holds what was seen and the weights that came of it."""
        if self.frozen:
            return self, None
        seen = dict(taken.features)
        for name, value in (taken.following or {}).items():
            seen[name] = seen.get(name, 0.0) - self.how.gamma * value
        price = 1.0 if taken.following is None else self.how.price
        reward = taken.reward * price * REWARD_SCALE
        return self._conditioned(taken.phase, {n: v for n, v in seen.items() if v}, reward)

    def after(self, record: Mapping[str, Any]) -> LearnedPolicy:
        """Learn again from what :meth:`told` recorded. Raises ``ValueError`` for other records."""
        try:
            phase, seen, reward = record["phase"], record["seen"], record["reward"]
            return self._conditioned(phase, seen, reward)[0]
        except (KeyError, TypeError) as error:
            raise ValueError(f"no record of a step: {error}") from error

    def trained(self) -> Mapping[str, Mapping[str, float]]:
        """The weights of both phases by feature."""
        return {"execution": self.execution.weights, "learning": self.learning.weights}

    def _conditioned(
        self, phase: str, seen: Mapping[str, float], reward: float
    ) -> tuple[LearnedPolicy, Mapping[str, Any]]:
        posterior, delta = self._of(phase).told(seen, reward, self.how.noise)
        learned = (
            replace(self, execution=posterior)
            if phase == Phase.EXECUTION.value
            else replace(self, learning=posterior)
        )
        record = {
            "phase": phase,
            "seen": {name: seen[name] for name in sorted(seen)},
            "reward": reward,
            "delta": delta,
            "weights": dict(posterior.weights),
            "digest": learned.digest,
        }
        return learned, record

    def _of(self, phase: str) -> Posterior:
        return {"execution": self.execution, "learning": self.learning}[phase]

    def _winners(
        self,
        valued: Sequence[Candidate],
        posterior: Posterior,
        best: int,
        rng: np.random.Generator,
    ) -> list[int]:
        """The act that is best in each of some draws of the weights."""
        if self.frozen or self.how.exploration <= 0.0 or len(valued) < 2:
            return [best]
        matrix = np.array([posterior.rows(one.features) for one in valued])
        values = np.array([one.value or 0.0 for one in valued])
        drawn = posterior.draws(self.how.draws, rng) @ matrix.T
        winners: list[int] = (values + self.how.exploration * drawn).argmax(axis=1).tolist()
        return winners


def _valued(candidate: Candidate, posterior: Posterior) -> Candidate:
    shares = posterior.shares(candidate.features)
    return replace(candidate, value=math.fsum(shares.values()), shares=shares)


def _posterior(
    trained: PolicyWeights, phase: str, weights: Weights, how: LiveLearning
) -> Posterior:
    rows = trained.covariances.get(phase)
    named = weights.to_json()
    unmet = {one: kin for one, kin in _KIN.items() if named.get(one) == 0.0 and kin in named}
    begun = {name: named[unmet.get(name, name)] for name in named}
    if rows is None:
        return Posterior.of(begun, PRIOR)
    place = {name: index for index, name in enumerate(named)}
    spread = [list(row) for row in rows]
    for one, kin in unmet.items():
        spread[place[one]][place[one]] = rows[place[kin]][place[kin]]
    wide = tuple(tuple(row) for row in spread)
    return Posterior(tuple(begun), tuple(begun.values()), wide).spread(how.forget)


_KIN = {"goal_relevant_ynq": "pred_change_ynq", "bulk_np_grd_ynq": "np_grd_ynq"}
"""An act that training never met is taken to be worth what its kin is, and as surely."""


_REASONS = {
    False: "it is worth most, as far as I have learned",
    True: "others seem worth more, but I am not sure of that and wanted to find out",
}

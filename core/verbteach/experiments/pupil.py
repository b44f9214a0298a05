"""A question policy that practises: it logs its choices, and learns both phases from them.

It is told of each step by the robot itself, as a policy that learns live is. It
grows with every call, so it is of no use where turns are taken back.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, ClassVar, Self

import numpy as np
from numpy.typing import NDArray

from verbteach.dialogue.decision import Candidate, Decision
from verbteach.dialogue.policy import Taken
from verbteach.dialogue.state import EpisodeState
from verbteach.experiments.interactive_training import LEARNERS, Trained
from verbteach.policy.asking_policy import AskingPolicy
from verbteach.policy.fixed_rules import ManualPolicy, RandomPolicy
from verbteach.policy.learners import GAMMA, REWARD_SCALE, BayesianTD, Step, lspi
from verbteach.policy.linear import FeatureSpace, LinearPolicy, Weights
from verbteach.policy.weights_file import SPACES

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class LivePractice:
    """How a robot practises on lessons.

    It goes on until each phase has come up ``dialogues`` times; execution comes
    up less often. The first ``warm`` times of a phase ManualPolicy and
    RandomPolicy lead in turn, then the learner with exploration ``epsilon``.
    After ``session`` lessons another robot begins, which knows no verb. ``price``
    multiplies what questions cost. ``ridges`` hold a phase's weights back when
    ``lspi`` refits them, for each step of its log.
    """

    learner: str = "lspi"
    dialogues: int = 340
    warm: int = 250
    session: int = 100
    epsilon: float = 0.3
    gamma: float = GAMMA
    price: float = 3.2
    ridges: Mapping[str, float] = field(
        default_factory=lambda: {"execution": 0.0035, "learning": 0.0035}
    )


class Pupil:
    """Both phases' learners, and which of them leads; implements ``LearningPolicy``."""

    name: ClassVar[str] = "practising"
    asks: ClassVar[bool] = True
    digest: ClassVar[str] = ""

    def __init__(self, practice: LivePractice, rng: np.random.Generator) -> None:
        self._phases = {name: _Phase(name, space, practice, rng) for name, space in SPACES.items()}

    @property
    def dialogues(self) -> int:
        """How often the phase came up that came up less often."""
        return min(phase.dialogues for phase in self._phases.values())

    @property
    def executions(self) -> tuple[tuple[Mapping[str, float], bool], ...]:
        """The features of each execution that was judged, and whether it was right."""
        return tuple(self._phases["execution"].executions)

    def begin(self) -> None:
        """A command is given: whatever was under way is over."""
        for phase in self._phases.values():
            phase.actor = None

    def choose(
        self, episode: EpisodeState, candidates: Sequence[Candidate], rng: np.random.Generator
    ) -> Decision:
        """As whoever leads in this dialogue."""
        return self._phases[episode.phase.value].choose(candidates, rng)

    def told(self, taken: Taken) -> tuple[Self, Mapping[str, Any] | None]:
        """Log the step and learn from it; the record of the session is not kept."""
        self._phases[taken.phase].told(taken)
        return self, None

    def trained(self) -> dict[str, Trained]:
        """What was learned, by phase."""
        return {name: phase.trained() for name, phase in self._phases.items()}


class _Phase:
    def __init__(
        self, name: str, space: FeatureSpace, practice: LivePractice, rng: np.random.Generator
    ) -> None:
        self._practice, self._space, self._rng = practice, space, rng
        self._ridge = practice.ridges[name]
        online = "bayesian" if practice.learner == "lspi" else practice.learner
        self._learner = LEARNERS[online](len(space.names), practice.gamma)
        self._log: list[Step] = []
        self._returns: list[float] = []
        self._questions: list[int] = []
        self._offered: Decision | None = None
        self.dialogues = 0
        self.executions: list[tuple[Mapping[str, float], bool]] = []
        self.actor: AskingPolicy | None = None

    def choose(self, candidates: Sequence[Candidate], rng: np.random.Generator) -> Decision:
        if self.actor is None:
            self.actor = self._leading()
            self.dialogues += 1
            self._returns.append(0.0)
            self._questions.append(0)
            self._learner.begin()
        self._offered = self.actor.choose(None, candidates, rng)
        return self._offered

    def told(self, taken: Taken) -> None:
        step = self._step(taken)
        self._learner.learn(step)
        self._log.append(step)
        self._returns[-1] += step.reward / REWARD_SCALE
        if taken.following is not None:
            self._questions[-1] += 1
            return
        self.actor = None
        if "select_hypo" in taken.features:
            self.executions.append((taken.features, taken.reward > 0.0))

    def trained(self) -> Trained:
        values, practice = self._learner.weights, self._practice
        if practice.learner == "lspi":
            size = len(self._space.names)
            values = lspi(self._log, size, practice.gamma, self._ridge)
        covariance = None
        if isinstance(self._learner, BayesianTD):
            covariance = tuple(tuple(row) for row in self._learner.covariance.tolist())
        weights = Weights(self._space, tuple(values.tolist()))
        return Trained(weights, tuple(self._returns), tuple(self._questions), covariance)

    def _leading(self) -> AskingPolicy:
        if self.dialogues < self._practice.warm:
            return RandomPolicy() if self.dialogues % 2 else ManualPolicy()
        weights = Weights(self._space, tuple(self._learner.acting(self._rng).tolist()))
        return LinearPolicy(weights, self._practice.epsilon)

    def _step(self, taken: Taken) -> Step:
        """As learners see it; what follows is what was offered when the next act was chosen."""
        features = self._row(taken.features)
        if taken.following is None or self._offered is None:
            return Step(features, taken.reward * REWARD_SCALE, None)
        reward = taken.reward * self._practice.price * REWARD_SCALE
        offered = self._space.matrix(self._offered.candidates)
        return Step(features, reward, offered, self._offered.chosen)

    def _row(self, features: Mapping[str, float]) -> Floats:
        row = np.zeros(len(self._space.names))
        for name, value in features.items():
            row[self._space.index[name]] = value
        return row

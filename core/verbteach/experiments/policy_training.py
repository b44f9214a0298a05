"""Training the question policies for use: nothing held out, several noise levels together.

What comes out is a file's worth of weights with the figures of their training.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, field, replace
from typing import Any

import numpy as np

from verbteach.dialogue.promise import Sureness
from verbteach.experiments.interactive_bench import Bench
from verbteach.experiments.interactive_protocol import Config, Learned, learn
from verbteach.experiments.interactive_training import (
    LEARNERS,
    Heard,
    Trained,
    TrainingParameters,
    unheard,
)
from verbteach.experiments.live_practice import Classroom, Practised, practise
from verbteach.experiments.pupil import LivePractice
from verbteach.experiments.simulated_human import HumanParameters
from verbteach.perception.noise import NoiseModel
from verbteach.policy.sureness import fitted
from verbteach.policy.weights_file import Matrix, PolicyWeights

LEARNER_NAMES: tuple[str, ...] = (*LEARNERS, "lspi")
"""The learners that ``TrainingParameters.learner`` may name."""

NOISES = ("perfect", "std3")
"""The levels that a robot in a person's hands is most likely to have."""


@dataclass(frozen=True)
class Schooling:
    """What to train on and how: the noise levels are met together, evenly; ``human`` answers."""

    noises: tuple[str, ...] = NOISES
    reading: str = "literal"
    seed: int = 0
    training: TrainingParameters = field(default_factory=TrainingParameters)
    human: HumanParameters = field(default_factory=HumanParameters)

    def configs(self) -> list[Config]:
        """One configuration a noise level."""
        base = Config(
            reading=self.reading, seed=self.seed, training=self.training, human=self.human
        )
        return [replace(base, noise=noise) for noise in self.noises]


def with_dialogues(training: TrainingParameters, count: int) -> TrainingParameters:
    """The same training with so many dialogues, as large a share of them warm."""
    return replace(
        training, dialogues=count, warm=round(training.warm * count / training.dialogues)
    )


def train_live(
    room: Classroom,
    schooling: Schooling,
    practice: LivePractice,
    source: str,
    heard: Heard = unheard,
) -> tuple[PolicyWeights, Sureness]:
    """Train both policies as they are used: on lessons taught to a live robot.

    Also how sure it may be of what it carries out, from the executions in
    practice. Of the schooling count noise, reading and seed. Raises
    ``ValueError`` where there is too little to practise on.
    """
    noises = [NoiseModel.named(name, schooling.reading) for name in schooling.noises]
    practised = practise(
        room,
        practice,
        noises,
        schooling.seed,
        lambda done: heard("practice", done, practice.dialogues, 0.0),
    )
    weights = PolicyWeights(
        execution=practised.phases["execution"].weights,
        learning=practised.phases["learning"].weights,
        learner=practice.learner,
        parameters={**asdict(practice), "ridges": dict(practice.ridges)},
        training=_live_report(room, schooling, source, practised),
        covariances=_covariances(practised.phases),
    )
    return weights, fitted(practised.executions)


def _live_report(
    room: Classroom, schooling: Schooling, source: str, practised: Practised
) -> dict[str, Any]:
    return {
        "source": source,
        "instances": len(room.lessons),
        "environments": sorted({lesson.scene for lesson in room.lessons}),
        "noise": list(schooling.noises),
        "noise_reading": schooling.reading,
        "seed": schooling.seed,
        "goals_kept": practised.goals_right / max(1, practised.goals),
        "phases": {name: phase_report(one) for name, one in practised.phases.items()},
    }


def train_policies(
    bench: Bench, schooling: Schooling, source: str, heard: Heard = unheard
) -> PolicyWeights:
    """Train both policies on the bench; ``source`` says what is on it.

    Raises ``ValueError`` where there is nothing to practise on. ``heard`` as in
    ``interactive_protocol.run``.
    """
    learned = learn(bench, schooling.configs(), heard)
    both = {"execution": learned.execution, "learning": learned.learning}
    return PolicyWeights(
        execution=learned.execution.weights,
        learning=learned.learning.weights,
        learner=schooling.training.learner,
        parameters=_parameters(schooling.training),
        training=_report(bench, schooling, source, learned),
        covariances=_covariances(both),
    )


def _parameters(training: TrainingParameters) -> dict[str, Any]:
    """The training parameters as plain JSON; tuples become lists as a file has them."""
    data = asdict(training)
    prices = data["rewards"]["prices"]
    data["rewards"] = {name: list(pair) for name, pair in sorted(prices.items())}
    return data


def _report(bench: Bench, schooling: Schooling, source: str, learned: Learned) -> dict[str, Any]:
    dialogues = sum(one.dialogues for one in learned.taught)
    right = sum(one.right for one in learned.taught)
    return {
        "source": source,
        "instances": len(bench.instances),
        "environments": sorted({i.environment for i in bench.instances}),
        "noise": list(schooling.noises),
        "noise_reading": schooling.reading,
        "seed": schooling.seed,
        "goals_kept": right / max(1, dialogues),
        "phases": {
            "execution": phase_report(learned.execution),
            "learning": phase_report(learned.learning),
        },
    }


def phase_report(trained: Trained) -> dict[str, Any]:
    """Episodes, mean return and questions; ``last`` over the last fifth, which is the learned."""
    last = max(1, len(trained.returns) // 5)
    return {
        "episodes": len(trained.returns),
        "mean_return": float(np.mean(trained.returns)),
        "questions": int(np.sum(trained.questions)),
        "last": {
            "episodes": last,
            "mean_return": float(np.mean(trained.returns[-last:])),
            "questions": int(np.sum(trained.questions[-last:])),
        },
    }


def _covariances(phases: Mapping[str, Trained]) -> dict[str, Matrix]:
    found = {name: one.covariance for name, one in phases.items()}
    return {name: matrix for name, matrix in found.items() if matrix is not None}


def totals(weights: PolicyWeights) -> dict[str, Any]:
    """Both phases together: ``episodes``, ``mean_return`` of an episode, ``questions``."""
    phases: Sequence[Mapping[str, Any]] = list(weights.training["phases"].values())
    episodes = sum(phase["episodes"] for phase in phases)
    earned = sum(phase["mean_return"] * phase["episodes"] for phase in phases)
    return {
        "episodes": episodes,
        "mean_return": earned / episodes,
        "questions": sum(phase["questions"] for phase in phases),
    }

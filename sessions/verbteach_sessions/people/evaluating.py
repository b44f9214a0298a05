"""Evaluating a policy on records that were made under others, phase by phase."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from verbteach.experiments.off_policy.evaluation import (
    MINIMUM,
    Evaluation,
    UnsupportedLogError,
    evaluate,
)
from verbteach.policy.learners import GAMMA
from verbteach_sessions.people.logs import Chances, LoggedPhase, log_of, logged
from verbteach_sessions.people.recorded import Recorded


@dataclass(frozen=True)
class PhaseReport:
    """What the records say of a policy in one phase, or why they say nothing."""

    evaluation: Evaluation | None
    refused: str = ""

    def to_json(self) -> dict[str, Any]:
        """Plain JSON; ``refused`` is null where there is an evaluation."""
        found = {} if self.evaluation is None else self.evaluation.to_json()
        return {**found, "refused": self.refused or None}


def evaluate_policy(
    records: Sequence[Recorded],
    chances: Chances,
    rng: np.random.Generator,
    *,
    gamma: float = GAMMA,
    minimum: float = MINIMUM,
) -> Mapping[str, PhaseReport]:
    """What each phase would have earned under the policy with these ``chances``."""
    phases = [one for record in records for one in logged(record)]
    return {
        name: _report([one for one in phases if one.phase == name], chances, rng, gamma, minimum)
        for name in ("execution", "learning")
    }


def _report(
    phases: Sequence[LoggedPhase],
    chances: Chances,
    rng: np.random.Generator,
    gamma: float,
    minimum: float,
) -> PhaseReport:
    if not phases:
        return PhaseReport(None, "the records hold no choice among questions in this phase")
    try:
        return PhaseReport(evaluate(log_of(phases, chances, gamma), rng, minimum))
    except UnsupportedLogError as error:
        return PhaseReport(None, str(error))

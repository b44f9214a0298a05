"""Evaluating a policy on records that were made under others, phase by phase."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from verbteach.experiments.off_policy.evaluation import (
    MINIMUM,
    Evaluation,
    UnsupportedLogError,
    check_support,
    evaluate,
)
from verbteach.policy.learners import GAMMA
from verbteach.policy.weights_file import SPACES
from verbteach_sessions.people.logs import Chances, LoggedPhase, log_of, logged
from verbteach_sessions.people.recorded import Recorded


@dataclass(frozen=True)
class PhaseReport:
    """What the records say of a policy in one phase, or why they say nothing.

    ``left_out``: the logged policies whose sessions say nothing, with the reason.
    """

    evaluation: Evaluation | None
    refused: str = ""
    left_out: Mapping[str, str] = field(default_factory=dict)

    @property
    def tells(self) -> bool:
        """Whether there are estimates."""
        return self.evaluation is not None and bool(self.evaluation.estimates)

    def to_json(self) -> dict[str, Any]:
        """Plain JSON; ``refused`` is null where there is an evaluation."""
        found = {} if self.evaluation is None else self.evaluation.to_json()
        return {**found, "refused": self.refused or None, "left_out": dict(self.left_out)}


def evaluate_policy(
    records: Sequence[Recorded],
    chances: Chances,
    rng: np.random.Generator,
    *,
    gamma: float = GAMMA,
    minimum: float = MINIMUM,
) -> Mapping[str, PhaseReport]:
    """What each phase would have earned under the policy with these ``chances``.

    The sessions held under one policy are used together or not at all, so that
    none is chosen by how it went.
    """
    by_policy: dict[str, list[LoggedPhase]] = {}
    for record in records:
        by_policy.setdefault(record.header.method.policy.name, []).extend(logged(record))
    return {
        phase: _report(by_policy, phase, chances, rng, gamma, minimum) for phase in sorted(SPACES)
    }


def _report(
    by_policy: Mapping[str, Sequence[LoggedPhase]],
    phase: str,
    chances: Chances,
    rng: np.random.Generator,
    gamma: float,
    minimum: float,
) -> PhaseReport:
    used: list[LoggedPhase] = []
    left_out: dict[str, str] = {}
    for policy in sorted(by_policy):
        found = [one for one in by_policy[policy] if one.phase == phase]
        reason = _unusable(found, chances, gamma)
        if reason:
            left_out[policy] = reason
        else:
            used += found
    if not used:
        reasons = "; ".join(f"{name}: {reason}" for name, reason in left_out.items())
        return PhaseReport(None, reasons or NOTHING, left_out)
    return PhaseReport(evaluate(log_of(used, chances, gamma), rng, minimum), "", left_out)


NOTHING = "there is no choice among questions in this phase"


def _unusable(phases: Sequence[LoggedPhase], chances: Chances, gamma: float) -> str:
    """Why the phases that one policy was logged in say nothing; empty where they do."""
    if not phases:
        return NOTHING
    try:
        check_support(log_of(phases, chances, gamma))
    except UnsupportedLogError as error:
        return str(error)
    return ""

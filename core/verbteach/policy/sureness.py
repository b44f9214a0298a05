"""How sure the robot may be that acting now is right: fitted to executions in simulation.

Logistic regression on what describes ``select_hypo``. It orders executions by
how safe they are, whatever policy asks; what share of them is right at which
sureness is for calibration to say (``stopping.py``), not for this fit.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

import numpy as np

from verbteach.dialogue import execution_inquiry
from verbteach.dialogue.promise import Sureness

FEATURES = tuple(
    name for name in execution_inquiry.FEATURES if name.partition(".")[0] == "select_hypo"
)
"""What describes carrying the best goal out; the first is the level."""


def fitted(
    executions: Iterable[tuple[Mapping[str, float], bool]], ridge: float = 1.0, rounds: int = 25
) -> Sureness:
    """The sureness that makes what was seen likeliest; ``executions`` are features and rightness.

    ``ridge`` holds all weights but the level back, in executions' worth. Newton's
    method, from nothing known. Raises ``ValueError`` where there is none.
    """
    rows = list(executions)
    if not rows:
        raise ValueError("nothing was carried out in training: there is nothing to be sure by")
    seen = np.array([_row(features) for features, _ in rows])
    right = np.array([float(good) for _, good in rows])
    held_back = np.diag([1e-3, *[ridge] * (len(FEATURES) - 1)])
    weights = np.zeros(len(FEATURES))
    for _ in range(rounds):
        chance = 1.0 / (1.0 + np.exp(-np.clip(seen @ weights, -30.0, 30.0)))
        slope = seen.T @ (right - chance) - held_back @ weights
        bend = (seen * (chance * (1.0 - chance))[:, None]).T @ seen + held_back
        weights = weights + np.linalg.solve(bend, slope)
    return Sureness(dict(zip(FEATURES, weights.tolist(), strict=True)))


def _row(features: Mapping[str, float]) -> Sequence[float]:
    return [features.get(name, 0.0) for name in FEATURES]

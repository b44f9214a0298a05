"""Is a difference more than chance? Paired permutations of documents, corrected for many tests."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from verbteach.experiments.figures import Observation


def paired_permutation(
    runs: Sequence[Sequence[Observation]],
    others: Sequence[Sequence[Observation]],
    rng: np.random.Generator,
    flips: int = 5000,
) -> float:
    """The two-sided p of the mean difference between two policies on the same runs and commands.

    Commands of a document are alike, and so is a document in every run, so the
    signs of whole documents are flipped, all runs together. At least 1 / (flips + 1).
    """
    sums: dict[str, float] = {}
    for one, other in zip(runs, others, strict=True):
        for mine, theirs in zip(one, other, strict=True):
            if mine.group != theirs.group:
                raise ValueError("the observations are not of the same commands")
            sums[mine.group] = sums.get(mine.group, 0.0) + mine.value - theirs.value
    differences = np.array([sums[group] for group in sorted(sums)])
    seen = abs(differences.sum())
    signs = rng.integers(0, 2, size=(flips, len(differences))) * 2 - 1
    as_large = int((np.abs(signs @ differences) >= seen - 1e-12).sum())
    return (as_large + 1) / (flips + 1)


def holm(probabilities: Sequence[float]) -> tuple[float, ...]:
    """Holm's correction: adjusted probabilities in the given order, each at most 1."""
    order = sorted(range(len(probabilities)), key=lambda i: (probabilities[i], i))
    adjusted = [0.0] * len(probabilities)
    highest = 0.0
    for rank, index in enumerate(order):
        highest = max(highest, (len(order) - rank) * probabilities[index])
        adjusted[index] = min(1.0, highest)
    return tuple(adjusted)

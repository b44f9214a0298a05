"""How long demonstrations are: the same figures for the corpus and for lessons."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from statistics import fmean, stdev


@dataclass(frozen=True)
class Lengths:
    """Lengths of action sequences; ``sd`` is a sample's, 0 of a single one."""

    mean: float
    sd: float
    min: int
    max: int

    @classmethod
    def of(cls, lengths: Sequence[int]) -> Lengths:
        """Summarise lengths; all 0 where there is none."""
        if not lengths:
            return cls(0.0, 0.0, 0, 0)
        sd = stdev(lengths) if len(lengths) > 1 else 0.0
        return cls(fmean(lengths), sd, min(lengths), max(lengths))

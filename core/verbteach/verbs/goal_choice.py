"""Choosing among goals: how alike each is to what may be meant, now and after one more answer.

Arrays of choices and of truths (what may be meant, each with its probability);
the best choice has the highest expected Jaccard index.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

Bools = NDArray[np.bool_]
Ints = NDArray[np.int64]
Floats = NDArray[np.float64]
Singles = NDArray[np.float32]


class Edited(NamedTuple):
    """How alike choices (rows) and truths (columns) are once one literal is in all, or in none.

    ``neither`` where the literal was in neither of the two, ``either`` where it
    was in one of them, ``both`` where it was in both.
    """

    neither: Floats
    either: Floats
    both: Floats

    def expected(self, chosen: Bools, wanted: Bools, weights: Floats) -> Floats:
        """Each choice's expected likeness (choices x literals), truths weighed by ``weights``.

        ``chosen`` (choices x literals) and ``wanted`` (truths x literals) say
        which have the literal; ``weights`` are truths x literals.
        """
        without, within = np.where(wanted, 0.0, weights), np.where(wanted, weights, 0.0)
        absent = self.neither @ without + self.either @ within
        present = self.either @ without + self.both @ within
        return np.where(chosen, present, absent)


@dataclass(frozen=True)
class Decision:
    """The hypotheses that take part, the goals to choose from, and how alike they are.

    ``truths`` (kept x literals) have the probabilities ``chances``;
    ``choices`` (choices x literals); ``sizes`` count the literals of each truth,
    ``shared`` and ``union`` those of each choice with each truth; ``index`` are
    the truths' numbers in the pool.
    """

    truths: Singles
    chances: Floats
    choices: Singles
    sizes: Singles
    shared: Singles
    union: Singles
    index: Ints

    @cached_property
    def jaccard(self) -> Floats:
        """How alike each choice is to each truth, 0 to 1."""
        return _doubles(self.shared / self._some)

    @cached_property
    def if_added(self) -> Edited:
        """How alike they are once a literal is added to all."""
        more = self.shared + 1
        return Edited(_doubles(more / (self.union + 1)), _doubles(more / self._some), self.jaccard)

    @cached_property
    def if_taken(self) -> Edited:
        """How alike they are once a literal is taken out of all."""
        fewer = np.maximum(self.union - 1, 1)
        either, both = self.shared / fewer, (self.shared - 1) / fewer
        return Edited(self.jaccard, _doubles(either), _doubles(both))

    @cached_property
    def _some(self) -> Singles:
        """The union, 1 where there is none: what shares nothing is not alike."""
        return np.maximum(self.union, 1)

    @cached_property
    def values(self) -> Floats:
        """The expected Jaccard index of each choice."""
        return self.jaccard @ self.chances

    @cached_property
    def value(self) -> float:
        """That of the best."""
        return float(self.values[self.order[0]])

    @cached_property
    def order(self) -> Ints:
        """The choices, the best first; ties in the choices' order."""
        return (-self.values).argsort(kind="stable")


def _doubles(values: NDArray[np.floating[Any]]) -> Floats:
    """In the precision of the chances, once: each product of the two would convert them anew."""
    return values.astype(np.float64)

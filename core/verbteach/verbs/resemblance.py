"""How alike two commands are, and how much a demonstration of one says about the other.

A demonstration counts for a new command by the exponential of a weighted sum
of these likenesses, each between 0 and 1. Nothing is excluded: what somebody
did when told to "turn on" a thing says a little about "set" as well.
"""

from __future__ import annotations

from dataclasses import astuple, dataclass
from functools import cached_property, lru_cache
from itertools import count
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray


class Said(NamedTuple):
    """A command as the frame has it: the verb and its grounded noun phrases, in order."""

    verb: str
    phrases: tuple[str, ...]

    @property
    def number(self) -> int:
        """What tables have the command's row at: a number of its own in this process."""
        known = _NUMBERS.get(self)
        return _NUMBERS.setdefault(self, next(_UNUSED)) if known is None else known


_NUMBERS: dict[Said, int] = {}
_UNUSED = count()


@dataclass(frozen=True)
class Kernel:
    """What each likeness weighs; the values that are used are those of ``PoolParameters``.

    Of the words: ``verb`` the same verb, ``arity`` as many phrases, ``slots``
    words shared phrase by phrase, ``words`` words shared with any phrase. Of
    the binding: ``objects`` phrases with a shared word that mean the very same
    object, ``kinds`` arguments that afford the same, ``possible`` the share of
    the change that some action could bring about here, ``open`` the share
    that is still to be brought about, ``hand`` whether the change speaks of
    what the robot holds; with it a change that lets go of a thing is also
    bound to the held one. Records from before there were ``possible`` and
    ``hand`` are read with the defaults, without them.
    """

    verb: float = 3.0
    arity: float = 0.5
    slots: float = 2.0
    words: float = 2.0
    objects: float = 1.0
    kinds: float = 2.5
    possible: float = 0.0
    open: float = 1.5
    hand: float = 0.0

    @cached_property
    def of_words(self) -> NDArray[np.float64]:
        """Weights for ``likeness``, in its order."""
        return np.array(astuple(self)[:4])

    @cached_property
    def of_bindings(self) -> NDArray[np.float64]:
        """Weights of ``objects``, ``kinds``, ``possible``, ``open`` and ``hand``."""
        return np.array(astuple(self)[4:])


@lru_cache(maxsize=1 << 16)
def likeness(said: Said, known: Said) -> tuple[float, float, float, float]:
    """Return the likenesses of words: verb, arity, slots, words."""
    longer = max(len(said.phrases), len(known.phrases), 1)
    pairs = zip(said.phrases, known.phrases, strict=False)
    slots = sum(overlap(mine, other) for mine, other in pairs) / longer
    best = [max((overlap(p, q) for q in known.phrases), default=0.0) for p in said.phrases]
    return (
        float(said.verb == known.verb),
        float(len(said.phrases) == len(known.phrases)),
        slots,
        sum(best) / len(best) if best else 0.0,
    )


@lru_cache(maxsize=1 << 16)
def overlap(one: str, other: str) -> float:
    """Return the Jaccard index of the words of two phrases; 1 where both have none."""
    words, others = set(one.split()), set(other.split())
    union = len(words | others)
    return len(words & others) / union if union else 1.0

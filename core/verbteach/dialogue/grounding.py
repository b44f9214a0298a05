"""The grounding belief: for each noun phrase, how likely each object is what it means.

This is *Grd* of She & Chai (2017), section 4.3: a confirmed object gets
probability 1, a denied one 0. It knows nothing of how candidates were found.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import TypeAlias

Distribution: TypeAlias = tuple[tuple[str, float], ...]


def _normalised(weights: Mapping[str, float]) -> Distribution:
    total = math.fsum(weights.values())
    ranked = sorted(weights.items(), key=lambda item: (-item[1], item[0]))
    return tuple((object_id, weight / total) for object_id, weight in ranked if weight > 0)


@dataclass(frozen=True)
class GroundingBelief:
    """Noun phrases in the order said, each with its distribution, the likeliest object first.

    A phrase for which nothing fits has an empty distribution. ``settled`` holds
    the phrases that the teacher has answered for.
    """

    phrases: tuple[tuple[str, Distribution], ...] = ()
    settled: frozenset[str] = frozenset()

    @classmethod
    def of(cls, weights: Mapping[str, Mapping[str, float]]) -> GroundingBelief:
        """From each phrase's weights, which need not sum to one."""
        return cls(tuple((phrase, _normalised(of)) for phrase, of in weights.items()))

    def __getitem__(self, phrase: str) -> Distribution:
        return self._by_phrase[phrase]

    @cached_property
    def _by_phrase(self) -> Mapping[str, Distribution]:
        return dict(self.phrases)

    @cached_property
    def names(self) -> tuple[str, ...]:
        """The noun phrases, in the order said."""
        return tuple([phrase for phrase, _ in self.phrases])

    @property
    def grounded(self) -> tuple[str, ...]:
        """The phrases that at least one object fits."""
        return tuple(phrase for phrase, objects in self.phrases if objects)

    def best(self, phrase: str) -> str | None:
        """The likeliest object, or ``None`` where nothing fits."""
        objects = self[phrase]
        return objects[0][0] if objects else None

    def margin(self, phrase: str) -> float:
        """How far the likeliest object is ahead of the next, in [0, 1]; 0 where nothing fits."""
        chances = [chance for _, chance in self[phrase]][:2]
        return chances[0] - (chances[1] if len(chances) > 1 else 0.0) if chances else 0.0

    def entropy(self, phrase: str) -> float:
        """Shannon entropy of the phrase's distribution in nats (Table 3)."""
        return math.fsum(-p * math.log(p) for _, p in self[phrase] if p > 0) + 0.0

    def confirm(self, phrase: str, object_id: str) -> GroundingBelief:
        """The phrase means this object: its probability becomes 1 (section 4.3)."""
        return self._with(phrase, ((object_id, 1.0),), settled=True)

    def deny(self, phrase: str, object_id: str) -> GroundingBelief:
        """The phrase does not mean this object: its probability becomes 0 (section 4.3)."""
        rest = {o: p for o, p in self[phrase] if o != object_id}
        return self._with(phrase, _normalised(rest) if rest else (), settled=False)

    def restrict(self, phrase: str, objects: Mapping[str, float]) -> GroundingBelief:
        """The phrase means one of ``objects``, weighted; settled when only one is left."""
        return self._with(phrase, _normalised(objects), settled=len(objects) == 1)

    def _with(self, phrase: str, objects: Distribution, *, settled: bool) -> GroundingBelief:
        phrases = tuple((p, objects if p == phrase else d) for p, d in self.phrases)
        done = self.settled | {phrase} if settled else self.settled - {phrase}
        return GroundingBelief(phrases, done)

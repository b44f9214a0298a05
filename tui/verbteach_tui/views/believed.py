"""The scene as the robot sees it: what it takes for true, and where it is not sure."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import NamedTuple

from verbteach.perception.belief import BELIEVED, Belief
from verbteach.world.fluents import Fluent, State
from verbteach_tui.views.marks import stem
from verbteach_tui.views.picture import PLACES

SURE = 0.95
"""From here on a confidence shows as certainty, and below one minus it as its opposite."""


class Believed(NamedTuple):
    """What to draw as if it were true, and how sure the robot is where it is not sure.

    A thing is drawn where it most likely is, even if that is not likely; a
    condition is drawn as holding where that is likelier than not. ``doubts``
    gives each fluent's confidence.
    """

    state: State
    doubts: Mapping[Fluent, float]

    @classmethod
    def of(cls, belief: Belief) -> Believed:
        """Sort a belief into what to draw and what to doubt."""
        places = dict(_likeliest_places(belief))
        state, doubts = set[Fluent](), dict[Fluent, float]()
        for fluent, confidence in belief.items():
            placing = _is_place(fluent)
            if placing and places[fluent.args[0]] != fluent and confidence < SURE:
                continue  # it is likelier elsewhere
            if confidence <= 1.0 - SURE:
                continue
            if placing or confidence > BELIEVED:
                state.add(fluent)
            if confidence < SURE:
                doubts[fluent] = confidence
        return cls(frozenset(state), doubts)


def _is_place(fluent: Fluent) -> bool:
    return len(fluent.args) == 2 and stem(fluent.predicate) in PLACES


def _likeliest_places(belief: Belief) -> Iterator[tuple[str, Fluent]]:
    """For each thing the place it most likely is at; among equals the first."""
    found: dict[str, tuple[float, Fluent]] = {}
    for fluent, confidence in belief.items():
        if _is_place(fluent):
            known = found.get(fluent.args[0])
            if known is None or confidence > known[0]:
                found[fluent.args[0]] = (confidence, fluent)
    yield from ((thing, fluent) for thing, (_, fluent) in found.items())

"""The scene as a picture, still without a screen: furniture, what is in and on it, how it is."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cached_property

from verbteach.world.fluents import Fluent, State
from verbteach.world.scene import Scene
from verbteach_tui.views.labels import Labels
from verbteach_tui.views.marks import CONTENT_GLYPH, Mark, mark_of, stem
from verbteach_tui.views.possible import changeable

PLACES = ("on", "in", "inside", "beside", "standson", "under")
"""Relations of a thing to where it is, by their stems; the first that holds places it."""

PARTS = (
    "controls",
    "feeds",
    "powers",
    "partof",
    "channelup",
    "channeldown",
    "volumeup",
    "volumedown",
)
"""Relations of a part or a switch to what it belongs to; only unplaced things show as parts."""

_HOLDING = frozenset({"grasping", "holding"})
_NEAR = frozenset({"near", "at"})
_STUFF = ("has", "contains")
_WORDS = {"standson": "on", "inside": "in"}


@dataclass(frozen=True)
class Thing:
    """An object as seen: where it is (``relation`` to what is around it), how it is, what it holds.

    ``moved``: it was somewhere else a moment ago. ``part``: a knob, a button or
    the like of what it is shown with. ``sure``: how sure the robot is that it is
    there, where it is not sure.
    """

    id: str
    label: str
    relation: str = ""
    marks: tuple[Mark, ...] = ()
    contents: tuple[Thing, ...] = ()
    moved: bool = False
    part: bool = False
    sure: float | None = None

    @property
    def furnished(self) -> bool:
        """Whether something is in or on it, its own parts apart."""
        return any(not inside.part for inside in self.contents)


@dataclass(frozen=True)
class Actor:
    """The robot or a person: where it is and what it holds."""

    id: str
    label: str
    near: tuple[str, ...] = ()
    holds: tuple[Thing, ...] = ()


@dataclass(frozen=True)
class Picture:
    """A scene at one moment. ``places`` have or had something in or on them; ``others`` do not."""

    title: str
    actors: tuple[Actor, ...] = ()
    places: tuple[Thing, ...] = ()
    others: tuple[Thing, ...] = ()

    @cached_property
    def near(self) -> frozenset[str]:
        """What the robot is at."""
        return frozenset(self.actors[0].near) if self.actors else frozenset()


class Depictor:
    """Makes pictures of one scene."""

    def __init__(self, scene: Scene) -> None:
        self.scene = scene
        self.labels = Labels.of(scene)
        self._possible: dict[str, list[Fluent]] = defaultdict(list)
        for fluent in changeable(scene):
            self._possible[fluent.args[0]].append(fluent)
        self._actors = tuple(key for key in scene.objects if self._is_actor(key))
        self._values = frozenset(scene.domain.constants) - frozenset(self._actors)
        roots = self._roots(_Facts(scene.initial, self._rank))
        self._furnished = frozenset(root.id for root in roots if root.furnished)

    def picture(
        self,
        state: State,
        before: State | None = None,
        doubts: Mapping[Fluent, float] | None = None,
    ) -> Picture:
        """The scene in ``state``; what differs from ``before`` is marked as changed.

        ``doubts`` are the confidences of fluents that the robot is not sure of.
        """
        facts = _Facts(state, self._rank, before, doubts)
        roots = self._roots(facts)
        shown = [root for root in roots if root.furnished or root.id in self._furnished]
        others = [root for root in roots if not (root.furnished or root.id in self._furnished)]
        actors = tuple(
            Actor(key, self.labels[key], facts.near[key], self._things(facts, facts.held[key]))
            for key in self._actors
        )
        return Picture(self.scene.title, actors, tuple(shown), tuple(others))

    @cached_property
    def _rank(self) -> Mapping[str, int]:
        return {key: rank for rank, key in enumerate(self.scene.objects)}

    def _is_actor(self, key: str) -> bool:
        kind = self.scene.objects[key].type
        return key == "Robot" or any(
            self.scene.domain.is_a(kind, name) for name in ("robot", "agent", "person")
        )

    def _roots(self, facts: _Facts) -> list[Thing]:
        hidden = self._values | frozenset(self._actors)
        free = [key for key in self.scene.objects if key not in facts.parent and key not in hidden]
        return [self._thing(facts, key) for key in free]

    def _thing(self, facts: _Facts, key: str) -> Thing:
        relation, part = facts.relation.get(key, ("", False))
        return Thing(
            key,
            self.labels[key],
            relation,
            self._marks(facts, key),
            tuple(self._thing(facts, child) for child in facts.children.get(key, ())),
            key in facts.moved,
            part,
            facts.sure.get(key),
        )

    def _things(self, facts: _Facts, keys: Iterable[str]) -> tuple[Thing, ...]:
        return tuple(self._thing(facts, key) for key in keys)

    def _marks(self, facts: _Facts, key: str) -> tuple[Mark, ...]:
        fluents = dict.fromkeys((*facts.about.get(key, ()), *self._possible.get(key, ())))
        static = self.scene.domain.static
        made = (
            self._mark(facts, fluent)
            for fluent in fluents
            if fluent.predicate not in static or stem(fluent.predicate) in _STUFF
        )
        label = self.labels[key]
        return tuple(mark for mark in made if mark is not None and not _repeats(mark, label))

    def _mark(self, facts: _Facts, fluent: Fluent) -> Mark | None:
        confidence = facts.doubts.get(fluent)
        holds = fluent in facts.state
        made = mark_of(fluent, self.labels, facts.state, fluent in facts.changed)
        if confidence is None:
            return made
        if made is None and not holds:  # it may hold, and has no word for not holding
            made = mark_of(fluent, self.labels, facts.state | {fluent})
            holds = True
        return made and made._replace(sure=confidence if holds else 1.0 - confidence)


def _repeats(mark: Mark, label: str) -> bool:
    """Whether the label says it already: what is in a milk carton."""
    return not mark.changed and mark.word in label and mark.glyph == CONTENT_GLYPH


class _Facts:
    """A state sorted by what it says: who is where, who holds what, how things are."""

    def __init__(
        self,
        state: State,
        rank: Mapping[str, int],
        before: State | None = None,
        doubts: Mapping[Fluent, float] | None = None,
    ) -> None:
        self.state = state
        self.doubts = doubts or {}
        self.sure: dict[str, float] = {}
        self.changed = frozenset() if before is None else state ^ before
        self.parent: dict[str, str] = {}
        self.relation: dict[str, tuple[str, bool]] = {}
        self.children: dict[str, list[str]] = defaultdict(list)
        self.held: dict[str, list[str]] = defaultdict(list)
        self.near: dict[str, tuple[str, ...]] = defaultdict(tuple)
        self.about: dict[str, list[Fluent]] = defaultdict(list)
        self.moved: set[str] = set()
        self._rank = rank
        self._sort()

    def _sort(self) -> None:
        placed: dict[str, tuple[int, str, bool]] = {}
        for fluent in sorted(self.state.union(self.changed, self.doubts)):
            self._take(fluent, placed)
        for child in sorted(placed, key=lambda key: self._rank.get(key, len(self._rank))):
            order, parent, part = placed[child]
            if child in self._above(parent):
                continue  # a ring of things would have no place to be shown at
            word = (*PLACES, *PARTS)[order]
            self.parent[child] = parent
            self.relation[child] = (_WORDS.get(word, word), part)
            self.children[parent].append(child)

    def _above(self, key: str) -> list[str]:
        chain = [key]
        while chain[-1] in self.parent:
            chain.append(self.parent[chain[-1]])
        return chain

    def _take(self, fluent: Fluent, placed: dict[str, tuple[int, str, bool]]) -> None:
        key, holds = stem(fluent.predicate), fluent in self.state
        spatial = len(fluent.args) == 2 and (key in PLACES or key in _HOLDING)
        if spatial and fluent in self.changed and holds:
            self.moved.add(fluent.args[1] if key in _HOLDING else fluent.args[0])
        if len(fluent.args) != 2 or not (spatial or key in _NEAR or key in PARTS):
            if fluent.args:
                self.about[fluent.args[0]].append(fluent)
        elif holds:
            self._relate(key, fluent.args[0], fluent.args[1], placed)
            if spatial and fluent in self.doubts:
                thing = fluent.args[1] if key in _HOLDING else fluent.args[0]
                self.sure[thing] = self.doubts[fluent]

    def _relate(
        self, key: str, first: str, second: str, placed: dict[str, tuple[int, str, bool]]
    ) -> None:
        if key in _HOLDING:
            self.held[first].append(second)
            self.parent[second] = first
        elif key in _NEAR:
            self.near[first] = (*self.near[first], second)
        else:
            order = (*PLACES, *PARTS).index(key)
            known = placed.get(first)
            if first in self._rank and second in self._rank and (known is None or order < known[0]):
                placed[first] = (order, second, key in PARTS)

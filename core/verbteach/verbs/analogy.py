"""What demonstrations would have changed, had they been given for this command in this room.

The lifted change of a demonstration is bound to the command's objects for
every joint grounding. This looks at names and things only, never at the state,
so the bindings are remembered for as long as the command and the room last.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from verbteach.verbs.examples import Example, Memory, Pattern
from verbteach.verbs.lifting import mould_of
from verbteach.verbs.resemblance import Kernel, Said, likeness, overlap
from verbteach.verbs.space import Demonstration
from verbteach.verbs.surroundings import Surroundings
from verbteach.world.fluents import Goal, Literal

Ints = NDArray[np.int64]
Floats = NDArray[np.float64]


POSSIBLE = 2
"""The column of ``alike`` that says how much of a change is possible."""


class Transfer(NamedTuple):
    """One example bound to one command: a row for each way to bind it.

    ``literals`` are literal numbers and ``row`` the row each belongs to;
    ``grounding`` is each row's joint grounding, ``share`` its share of that
    grounding's weight, ``alike`` (rows x 3) how far the very same objects and
    the same kinds of objects are meant, and how much of the change is possible
    here. What no action could bring about is left out of ``literals``.
    """

    literals: Ints
    row: Ints
    grounding: Ints
    share: Floats
    alike: Floats

    @property
    def rows(self) -> int:
        """How many ways there are."""
        return len(self.grounding)


class _Way(NamedTuple):
    """A joint grounding's objects as arguments; ``kinds`` is how many afford what was shown."""

    grounding: int
    arguments: tuple[str, ...]
    share: float
    kinds: float


class Gathered(NamedTuple):
    """All rows that speak about a command: see ``Transfer``; ``words`` is each row's log weight."""

    literals: Ints
    row: Ints
    grounding: Ints
    share: Floats
    alike: Floats
    words: Floats


class Meant(NamedTuple):
    """What a noun phrase may mean: ``things``, and by joint grounding the number of its thing."""

    things: tuple[str, ...]
    number: Ints

    @classmethod
    def of(cls, things: Sequence[str]) -> Meant:
        """From the phrase's object in each joint grounding."""
        distinct = sorted(set(things))
        place = {thing: number for number, thing in enumerate(distinct)}
        return cls(tuple(distinct), np.array([place[thing] for thing in things], dtype=np.int64))


class Analogies:
    """The bindings of one command in one room, made as they are asked for.

    ``groundings`` are the joint groundings, an object for each noun phrase;
    ``meant`` says by noun phrase which object it is in each of them. Literals
    are numbered in the order they turn up; nothing may hang on that order.
    """

    def __init__(
        self, said: Said, groundings: Sequence[tuple[str, ...]], surroundings: Surroundings
    ) -> None:
        self.said = said
        self.groundings = tuple(groundings)
        self.surroundings = surroundings
        self.literals: list[Literal] = []
        self._number: dict[Literal, int] = {}
        self.meant = tuple(Meant.of(things) for things in zip(*self.groundings, strict=True))
        self._ways: dict[tuple[str, ...], list[_Way]] = {}
        self._of_goal: dict[Goal, list[int]] = {}
        self._transfers: dict[Pattern, Transfer] = {}
        self._alike: Floats = np.zeros((0, 4))
        self._last: tuple[Memory, Floats] | None = None

    def gathered(self, memory: Memory, kernel: Kernel, most: int) -> Gathered:
        """Bind the ``most`` examples whose commands are most alike, ties in the memory's order."""
        scores = (self._table(memory) @ kernel.of_words)[memory.command_of]
        chosen = (-scores).argsort(kind="stable")[:most].tolist()
        known, patterns = self._transfers, memory.patterns
        found = []
        for i, score in zip(chosen, scores[chosen].tolist(), strict=True):
            transfer = known.get(patterns[i])
            if transfer is None:
                transfer = known[patterns[i]] = self._bound(memory.examples[i])
            if transfer is not NO_TRANSFER:
                found.append((score, transfer))
        return _joined(found)

    def nearness(self, memory: Memory) -> float:
        """How alike the noun phrases of the command and the nearest example are (Table 3)."""
        if not memory.examples:
            return 0.0
        return float(self._table(memory)[:, 2:].mean(1).max())

    def _table(self, memory: Memory) -> Floats:
        """The likenesses of each of the memory's commands; the last memory's are kept."""
        if self._last is None or self._last[0] is not memory:
            self._last = memory, self._likenesses(memory)
        return self._last[1]

    def _likenesses(self, memory: Memory) -> Floats:
        """The same from what is known, by number: memories mostly have the same commands."""
        numbers = memory.numbers
        more = int(numbers.max(initial=-1)) + 1 - len(self._alike)
        if more > 0:
            self._alike = np.concatenate([self._alike, np.full((more, 4), np.nan)])
        for place in np.isnan(self._alike[numbers, 0]).nonzero()[0].tolist():
            self._alike[numbers[place]] = likeness(self.said, memory.commands[place])
        return np.asarray(self._alike[numbers])

    def number(self, literal: Literal) -> int:
        """The literal's number, a new one if it has none."""
        number = self._number.setdefault(literal, len(self.literals))
        if number == len(self.literals):
            self.literals.append(literal)
        return number

    def _bound(self, example: Example) -> Transfer:
        shown, known = example.demonstration, self.surroundings.affordances
        literals: list[int] = []
        rows: list[int] = []
        kept: list[tuple[int, float, float, float, float]] = []
        if not all(thing in known for thing in example.binding):
            return NO_TRANSFER
        mould = mould_of(example.change)
        same = [self._same_objects(objects, shown) for objects in self.groundings]
        for index, arguments, share, kinds in self._ways_of(shown.grounding):
            goal = mould.filled(arguments, example.binding)
            if goal is not None:
                numbers = self._numbers(goal)
                literals += numbers
                rows += [len(kept)] * len(numbers)
                possible = len(numbers) / max(1, len(goal))
                kept.append((index, share, same[index], kinds, possible))
        return _transfer(literals, rows, kept)

    def _ways_of(self, shown: tuple[str, ...]) -> list[_Way]:
        """The ways to put the command's objects in the places of those that were shown."""
        if shown not in self._ways:
            self._ways[shown] = [
                _Way(index, arguments, 1.0 / len(ways), self._same_kinds(arguments, shown))
                for index, objects in enumerate(self.groundings)
                for ways in (_arguments(objects, shown),)
                for arguments in ways
            ]
        return self._ways[shown]

    def _same_kinds(self, new: Sequence[str], shown: Sequence[str]) -> float:
        known = self.surroundings.affordances
        same = sum(known.get(a) == known.get(b) for a, b in zip(new, shown, strict=True))
        return same / max(1, len(new))

    def _numbers(self, goal: Goal) -> list[int]:
        """The numbers of what can be brought about of a goal, in the literals' order.

        They are remembered: many examples come to the same goal.
        """
        numbers = self._of_goal.get(goal)
        if numbers is None:
            possible = filter(self.surroundings.possible, sorted(goal))
            numbers = self._of_goal[goal] = [self.number(literal) for literal in possible]
        return numbers

    def _same_objects(self, objects: tuple[str, ...], shown: Demonstration) -> float:
        pairs = zip(objects, shown.grounding, self.said.phrases, shown.phrases, strict=False)
        same = sum(mine == old and overlap(p, q) > 0 for mine, old, p, q in pairs)
        return same / max(1, len(objects))


NO_TRANSFER = Transfer(
    np.zeros(0, np.int64),
    np.zeros(0, np.int64),
    np.zeros(0, np.int64),
    np.zeros(0),
    np.zeros((0, 3)),
)
"""Of an example that cannot be bound: one for all, since most of them cannot in most rooms."""


def _transfer(
    literals: list[int], rows: list[int], kept: list[tuple[int, float, float, float, float]]
) -> Transfer:
    if not kept:
        return NO_TRANSFER
    table = np.array(kept, dtype=np.float64)
    return Transfer(
        np.array(literals, dtype=np.int64),
        np.array(rows, dtype=np.int64),
        table[:, 0].astype(np.int64),
        table[:, 1],
        table[:, 2:],
    )


def _joined(found: Sequence[tuple[float, Transfer]]) -> Gathered:
    scores, parts = zip(*(found or [(0.0, NO_TRANSFER)]), strict=True)
    sizes = np.array([part.rows for part in parts], dtype=np.int64)
    offsets = sizes.cumsum() - sizes
    lengths = [len(part.row) for part in parts]
    return Gathered(
        np.concatenate([part.literals for part in parts]),
        np.concatenate([part.row for part in parts]) + offsets.repeat(lengths),
        np.concatenate([part.grounding for part in parts]),
        np.concatenate([part.share for part in parts]),
        np.concatenate([part.alike for part in parts]),
        np.array(scores, dtype=np.float64).repeat(sizes),
    )


def _arguments(objects: tuple[str, ...], shown: tuple[str, ...]) -> list[tuple[str, ...]]:
    """The new objects in the places of the demonstrated ones, in every order-keeping way.

    With too many new objects some are left out, with too few the demonstrated
    ones stay in the places left over.
    """
    if len(shown) <= len(objects):
        return list(combinations(objects, len(shown)))
    found = []
    for places in combinations(range(len(shown)), len(objects)):
        arguments = list(shown)
        for place, thing in zip(places, objects, strict=True):
            arguments[place] = thing
        found.append(tuple(arguments))
    return found

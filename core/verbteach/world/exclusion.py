"""What cannot hold at once: pairs of fluents that no action brings together.

A pair is kept if every action that makes one of the two true leaves the other
false: because it ends it, needs it to be false, or needs something that
excludes it in turn. The largest set of such pairs is found by starting from
all pairs that might be one and striking out (invariants of two facts, the
mutexes of planning; Bonet and Geffner 2001, Helmert 2009). From a state in
which no pair holds no plan leads to one in which some pair does.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import NamedTuple

from verbteach.world.fluents import Fluent
from verbteach.world.relaxed import set_bits
from verbteach.world.task import GroundAction, Task


class Exclusions:
    """The pairs of a task that exclude each other, found once: it takes a tenth of a second.

    Only fluents about a common thing are considered, and only such as an
    action makes true: others are seldom wanted together.
    """

    def __init__(self, task: Task) -> None:
        self._fluents = task.fluents
        self._against = _candidates(task)
        _strike_out(self._against, [way for action in task.actions for way in _ways(action)])

    def pair(self, bits: int, wanted: int) -> tuple[Fluent, Fluent] | None:
        """Two of the ``wanted`` fluents (bits) that can never hold at once, starting from ``bits``.

        None where there are none, or where the start itself is impossible: then anything may be.
        """
        for one in set_bits(wanted):
            other = self._against.get(one, 0) & wanted
            if other:
                return self._named(one, other) if self._is_possible(bits) else None
        return None

    def _named(self, one: int, others: int) -> tuple[Fluent, Fluent]:
        return self._fluents[one], self._fluents[set_bits(others)[0]]

    def _is_possible(self, bits: int) -> bool:
        return not any(self._against.get(one, 0) & bits for one in set_bits(bits))


class _Way(NamedTuple):
    """What an action does where one condition of its effects holds.

    ``needs`` are numbers of fluents that were true, ``out`` bits that are false
    afterwards unless ``may``, what may come about, has them; ``makes`` numbers of what does.
    """

    needs: list[int]
    out: int
    may: int
    makes: list[int]


def _candidates(task: Task) -> dict[int, int]:
    """For each fluent that an action makes true the others about one of its things."""
    made = [task.bit[fluent].bit_length() - 1 for fluent in sorted(task.changeable[0])]
    about: dict[str, int] = {}
    for number in made:
        for word in task.fluents[number].args:
            about[word] = about.get(word, 0) | 1 << number
    return {number: _others(number, task.fluents[number], about) for number in made}


def _others(number: int, fluent: Fluent, about: Mapping[str, int]) -> int:
    found = 0
    for word in fluent.args:
        found |= about[word]
    return found & ~(1 << number)


def _ways(action: GroundAction) -> Iterator[_Way]:
    for true, false, add, delete in ((0, 0, action.add, action.delete), *action.conditional):
        if not add:
            continue
        needs, denied = action.needs_true | true, action.needs_false | false
        may = action.add | add
        for when in action.conditional:
            if not (when.needs_true & denied or when.needs_false & needs):
                may |= when.add
        yield _Way(set_bits(needs), denied | action.delete | delete, may, set_bits(add))


def _strike_out(against: dict[int, int], ways: list[_Way]) -> None:
    """Strike out pairs that some way brings together, until none does."""
    going_on = True
    while going_on:
        going_on = False
        for needs, out, may, makes in ways:
            gone = out
            for need in needs:
                gone |= against.get(need, 0)
            for made in makes:
                together = against[made] & (~gone | may)
                if together:
                    going_on = True
                    _part(against, made, together)


def _part(against: dict[int, int], one: int, others: int) -> None:
    """Take the pairs of one fluent with others out, both ways round."""
    against[one] &= ~others
    for other in set_bits(others):
        against[other] &= ~(1 << one)

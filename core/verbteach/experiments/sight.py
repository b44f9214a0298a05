"""What the robot sees of an instance: one draw of the noise for learning, another for testing.

A draw is a function of the seed, the run, the instance and the occasion, so
that no other instance, fold, policy or worker has a part in it.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Container, Iterable, Mapping
from dataclasses import dataclass, field, replace
from hashlib import sha256
from typing import NamedTuple, TypeAlias, TypeVar

import numpy as np

from verbteach.experiments.workroom import Workroom
from verbteach.perception.belief import Belief, Exclusivity
from verbteach.perception.noise import NoiseModel, perceive, perceive_both
from verbteach.verbs.instance import Instance
from verbteach.world.fluents import Fluent, State

_Look = TypeVar("_Look")
_Remembered: TypeAlias = dict[str, tuple[Instance, _Look]]
"""What was seen of instances, by id."""


class Seen(NamedTuple):
    """Beliefs before and after a demonstration."""

    start: Belief
    end: Belief


@dataclass(frozen=True)
class Sight:
    """A sensor in an experiment.

    ``elsewhere`` are, by document, the fluents that are true somewhere in it:
    with what an action could make true at once they are what phantoms may be.
    ``exclusive`` says what cannot be true at once. What was seen of an instance
    is remembered, and does not travel with it.
    """

    noise: NoiseModel = field(default_factory=NoiseModel)
    seed: int = 0
    run: int = 0
    elsewhere: Mapping[str, frozenset[Fluent]] = field(default_factory=dict)
    exclusive: tuple[Exclusivity, ...] = ()
    _demonstrated: _Remembered[Seen] = field(init=False, repr=False, compare=False)
    _met: _Remembered[Belief] = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        self._remember({}, {})

    def __reduce__(self) -> tuple[type[Sight], tuple[object, ...]]:
        return Sight, (self.noise, self.seed, self.run, self.elsewhere, self.exclusive)

    @classmethod
    def of(
        cls,
        noise: NoiseModel,
        instances: Iterable[Instance],
        seed: int = 0,
        run: int = 0,
        exclusive: tuple[Exclusivity, ...] = (),
    ) -> Sight:
        """Gather what is true elsewhere in each document from the instances' states."""
        found: dict[str, set[Fluent]] = defaultdict(set)
        for instance in instances if noise.phantoms else ():
            found[instance.group] |= instance.start | instance.end
        frozen = {group: frozenset(fluents) for group, fluents in found.items()}
        return cls(noise, seed, run, frozen, exclusive)

    def only(self, groups: Container[str]) -> Sight:
        """The same for the documents of ``groups``; what is seen here is remembered there."""
        narrowed = replace(self, elsewhere={g: f for g, f in self.elsewhere.items() if g in groups})
        narrowed._remember(self._demonstrated, self._met)
        return narrowed

    @property
    def unruled(self) -> Sight:
        """The same draw for who knows no rule about what cannot be true at once."""
        return replace(self, exclusive=()) if self.exclusive else self

    def is_draw(self, noise: NoiseModel, seed: int, run: int) -> bool:
        """Whether this is the draw of that noise, seed and run."""
        return (self.noise, self.seed, self.run) == (noise, seed, run)

    def demonstrated(self, instance: Instance, room: Workroom) -> Seen:
        """Watch the demonstration."""
        return _remembered(self._demonstrated, instance, lambda: self._watch(instance, room))

    def met(self, instance: Instance, room: Workroom) -> Belief:
        """Look around when the command is given, to carry it out."""
        return _remembered(self._met, instance, lambda: self._look(instance, room))

    def _remember(self, demonstrated: _Remembered[Seen], met: _Remembered[Belief]) -> None:
        object.__setattr__(self, "_demonstrated", demonstrated)
        object.__setattr__(self, "_met", met)

    def _watch(self, instance: Instance, room: Workroom) -> Seen:
        states = (instance.start, instance.end)
        possible = self._possible(instance, room, *states)
        rng = stream(self.seed, self.run, instance.id, "demonstration")
        before, after = perceive_both(states, possible, self._noise(room), rng, self.exclusive)
        return Seen(before.weighed(), after.weighed())

    def _look(self, instance: Instance, room: Workroom) -> Belief:
        possible = self._possible(instance, room, instance.start)
        rng = stream(self.seed, self.run, instance.id, "command")
        seen = perceive(instance.start, possible, self._noise(room), rng, self.exclusive)
        return seen.weighed()

    def _noise(self, room: Workroom) -> NoiseModel:
        """What things afford is known: it is not sensed."""
        return self.noise.with_spreads(dict.fromkeys(sorted(room.surroundings.static), 0.0))

    def _possible(self, instance: Instance, room: Workroom, *states: State) -> frozenset[Fluent]:
        if not self.noise.phantoms:
            return frozenset()
        nearby = (room.one_step_away(state) for state in states)
        return self.elsewhere.get(instance.group, frozenset()).union(*nearby)


def _remembered(known: _Remembered[_Look], instance: Instance, look: Callable[[], _Look]) -> _Look:
    """What was seen of an instance, looked at once."""
    kept = known.get(instance.id)
    if kept is None or kept[0] is not instance:
        kept = known[instance.id] = (instance, look())
    return kept[1]


def stream(*names: int | str) -> np.random.Generator:
    """A generator of its own for what the names tell apart."""
    digest = sha256("\0".join(map(str, names)).encode()).digest()
    return np.random.default_rng(np.frombuffer(digest, dtype=np.uint32))

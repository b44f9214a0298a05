"""The grounded task: one domain for one set of objects, states as bits of a Python integer.

Simulator and planner share it, so that no action is written twice. It is
grounded once and serves every state and goal over the same objects. It does
not know what is true now or what is wanted.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, NamedTuple

from verbteach.world.domain import Domain
from verbteach.world.fluents import Fluent, Literal, State
from verbteach.world.grounding import Grounder, SymbolicAction, SymbolicEffect
from verbteach.world.plan import Action
from verbteach.world.scene import Scene

_REMEMBERED = 256
"""So many states' bits."""


class ConditionalEffect(NamedTuple):
    """Bits set and cleared where all of ``needs_true`` and none of ``needs_false`` were set."""

    needs_true: int
    needs_false: int
    add: int
    delete: int


@dataclass(frozen=True, slots=True)
class GroundAction:
    """An action as bit masks. Deletes happen before adds; conditions look at the old state."""

    index: int
    action: Action
    needs_true: int
    needs_false: int
    add: int
    delete: int
    conditional: tuple[ConditionalEffect, ...]

    def applicable(self, bits: int) -> bool:
        """Whether the preconditions hold in the encoded state."""
        return bits & self.needs_true == self.needs_true and not bits & self.needs_false

    def changes(self, bits: int) -> tuple[int, int]:
        """Bits to set and bits to clear in the encoded state; no bit is in both."""
        add, delete = self.add, self.delete
        for needs_true, needs_false, adds, deletes in self.conditional:
            if bits & needs_true == needs_true and not bits & needs_false:
                add |= adds
                delete |= deletes
        return add, delete & ~add

    def result(self, bits: int) -> int:
        """Return the encoded state afterwards, taking the preconditions for granted."""
        if not self.conditional:
            return (bits & ~self.delete) | self.add
        add, delete = self.changes(bits)
        return (bits & ~delete) | add


@dataclass(frozen=True, eq=False)
class Task:
    """A domain grounded for fixed objects (name to type) and fixed static facts.

    ``actions`` are in the domain's order of schemas, then sorted by arguments;
    ``fluents`` are sorted. Fluents that no action reads or changes have no
    bit: they stay as they are in every state.
    """

    domain: Domain
    objects: Mapping[str, str]
    static: frozenset[Fluent]
    fluents: tuple[Fluent, ...] = field(init=False)
    actions: tuple[GroundAction, ...] = field(init=False)
    bit: Mapping[Fluent, int] = field(init=False, repr=False)
    _by_name: Mapping[Action, GroundAction] = field(init=False, repr=False)
    _known: dict[State, int] = field(init=False, repr=False)

    def __post_init__(self) -> None:
        objects = {**self.domain.constants, **self.objects}
        static = frozenset(f for f in self.static if f.predicate in self.domain.static)
        grounder = Grounder(self.domain, objects, static)
        symbolic = [a for schema in self.domain.actions.values() for a in grounder.ground(schema)]
        fluents = sorted({f for action in symbolic for f in _mentioned(action)})
        bit = {fluent: 1 << i for i, fluent in enumerate(fluents)}
        actions = _encoded(symbolic, bit)
        settled = {
            "objects": objects,
            "static": static,
            "fluents": tuple(fluents),
            "bit": bit,
            "actions": actions,
            "_by_name": {ground.action: ground for ground in actions},
            "_known": {},
        }
        for name, value in settled.items():
            object.__setattr__(self, name, value)

    @classmethod
    def from_scene(cls, scene: Scene) -> Task:
        """Ground the scene's domain for its objects and the static facts it starts with."""
        objects = {name: thing.type for name, thing in scene.objects.items()}
        return cls(scene.domain, objects, scene.initial)

    def encode(self, state: State) -> int:
        """Return the state's bits; fluents that no action touches are left out.

        Those of the last few states are remembered: they are asked about again and again.
        """
        bits = self._known.get(state)
        if bits is None:
            if len(self._known) >= _REMEMBERED:
                self._known.clear()
            bits = self._known[state] = self._bits(state)
        return bits

    def _bits(self, state: State) -> int:
        bit = self.bit
        bits = 0
        for fluent in state.difference(self.static):  # most of a state never changes
            bits |= bit.get(fluent, 0)
        return bits

    def decode(self, bits: int) -> State:
        """Return the fluents whose bits are set, with the static facts."""
        return self.static.union(self.named(bits))

    def named(self, bits: int) -> list[Fluent]:
        """Return the fluents whose bits are set, sorted."""
        fluents = self.fluents
        found = []
        while bits:
            low = bits & -bits
            found.append(fluents[low.bit_length() - 1])
            bits ^= low
        return found

    def action(self, action: Action) -> GroundAction | None:
        """Return the ground action; none where names, types, static facts or equality forbid it."""
        return self._by_name.get(action)

    @property
    def changeable(self) -> tuple[State, State]:
        """The fluents that some action makes true, and those that some action makes false."""
        made = ended = 0
        for action in self.actions:
            made |= action.add
            ended |= action.delete
            for effect in action.conditional:
                made |= effect.add
                ended |= effect.delete
        return frozenset(self.named(made)), frozenset(self.named(ended))

    def is_fluent(self, fluent: Fluent) -> bool:
        """Whether the domain has the predicate, for objects of these types."""
        predicate = self.domain.predicates.get(fluent.predicate)
        if predicate is None or len(predicate.parameters) != len(fluent.args):
            return False
        return all(
            arg in self.objects and self.domain.is_a(self.objects[arg], parameter.type)
            for arg, parameter in zip(fluent.args, predicate.parameters, strict=True)
        )


def _mentioned(action: SymbolicAction) -> Iterable[Fluent]:
    for literal in action.precondition:
        yield literal.fluent
    for effect in action.effects:
        yield effect.fluent
        for literal in effect.condition:
            yield literal.fluent


def _encoded(
    symbolic: Iterable[SymbolicAction], bit: Mapping[Fluent, int]
) -> tuple[GroundAction, ...]:
    """Encode the actions whose preconditions do not contradict themselves."""
    found: list[GroundAction] = []
    shared: dict[Any, Any] = {}
    known = shared.setdefault
    for action in symbolic:
        needs = _masks(action.precondition, bit)
        if needs[0] & needs[1]:
            continue
        add, delete, conditional = _effects(action.effects, needs, bit)
        whens = tuple(_once(shared, when) for when in conditional)
        true, false, add, delete = (known(mask, mask) for mask in (*needs, add, delete))
        whens = known(whens, whens)
        found.append(GroundAction(len(found), action.action, true, false, add, delete, whens))
    return tuple(found)


def _once(shared: dict[Any, Any], when: ConditionalEffect) -> ConditionalEffect:
    """The effect of equal ones that was met first, with its masks: a scene has thousands."""
    if when not in shared:
        shared[when] = ConditionalEffect(*(shared.setdefault(mask, mask) for mask in when))
    kept: ConditionalEffect = shared[when]
    return kept


def _masks(literals: Iterable[Literal], bit: Mapping[Fluent, int]) -> tuple[int, int]:
    """Return the bits that must be set and those that must not be."""
    true = false = 0
    for literal in literals:
        if literal.positive:
            true |= bit[literal.fluent]
        else:
            false |= bit[literal.fluent]
    return true, false


def _effects(
    effects: Sequence[SymbolicEffect], needs: tuple[int, int], bit: Mapping[Fluent, int]
) -> tuple[int, int, tuple[ConditionalEffect, ...]]:
    """Gather effects by condition; return what is added, deleted, and what only sometimes is.

    A condition that the precondition implies is dropped, and so is an effect
    whose condition the precondition contradicts. "Where f holds, f ceases" is
    the same as "f ceases", which spares most conditional deletes.
    """
    gathered: dict[tuple[int, int], list[int]] = {(0, 0): [0, 0]}
    for effect in effects:
        true, false = _masks(effect.condition, bit)
        if true & false or true & needs[1] or false & needs[0]:
            continue
        condition = (true & ~needs[0], false & ~needs[1])
        changed = bit[effect.fluent]
        if not effect.positive and condition == (changed, 0):
            condition = (0, 0)
        gathered.setdefault(condition, [0, 0])[0 if effect.positive else 1] |= changed
    add, delete = gathered.pop((0, 0))
    return (
        add,
        delete & ~add,
        tuple(
            ConditionalEffect(*condition, adds, deletes & ~(adds | add))
            for condition, (adds, deletes) in gathered.items()
        ),
    )

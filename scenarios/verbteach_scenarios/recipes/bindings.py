"""Which objects of a scene can play the parts of a task."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import product
from typing import TypeAlias

from verbteach.world.fluents import Fluent, Goal, Literal
from verbteach.world.scene import Scene
from verbteach_scenarios.recipes.tasks import Slot, Stage, Task

Cast: TypeAlias = dict[str, tuple[str, ...]]
"""Slot to objects: one, or several for a slot of many."""


@dataclass(frozen=True)
class Collection:
    """Things that go by one name, for a slot of many; no name where the command names them not."""

    objects: tuple[str, ...]
    name: str = ""


def ground(stage: Stage, cast: Mapping[str, Sequence[str]]) -> Goal:
    """The stage about the cast; a literal over a slot of many is said of each of them."""
    return frozenset(one for literal in stage for one in _instances(literal, cast))


def casts(task: Task, scene: Scene, named: frozenset[str]) -> Iterator[Cast]:
    """All casts in which ``where`` holds and the goal does not yet, in a fixed order.

    ``named`` are the slots that the command names: there, many things must
    share a name, and be all the things of that name that fit.
    """
    for cast in _filled(task, scene, {}, [s for s in task.slots if not s.many]):
        for group in _with_many(task, scene, cast, named):
            goal = ground(task.goal, group)
            if not all(literal.holds(scene.initial) for literal in goal):
                yield group


def _instances(literal: Literal, cast: Mapping[str, Sequence[str]]) -> Iterator[Literal]:
    slots = [arg[1:] for arg in literal.fluent.args if arg.startswith("?")]
    for chosen in product(*(cast[slot] for slot in slots)):
        names = dict(zip(slots, chosen, strict=True))
        args = tuple(names[a[1:]] if a.startswith("?") else a for a in literal.fluent.args)
        yield Literal(Fluent(literal.fluent.predicate, args), literal.positive)


def _filled(task: Task, scene: Scene, cast: Cast, slots: Sequence[Slot]) -> Iterator[Cast]:
    if not slots:
        yield dict(cast)
        return
    slot, *rest = slots
    for candidate in _candidates(task, scene, slot):
        if (candidate,) not in cast.values():
            cast[slot.name] = (candidate,)
            if _holds(task, scene, cast):
                yield from _filled(task, scene, cast, rest)
            del cast[slot.name]


def _with_many(task: Task, scene: Scene, cast: Cast, named: frozenset[str]) -> Iterator[Cast]:
    slots = [slot for slot in task.slots if slot.many]
    choices = [_collections(task, scene, cast, slot, slot.name in named) for slot in slots]
    for chosen in product(*choices):
        extra = {slot.name: c.objects for slot, c in zip(slots, chosen, strict=True)}
        yield {**cast, **extra}


def _collections(
    task: Task, scene: Scene, cast: Cast, slot: Slot, is_named: bool
) -> list[Collection]:
    """The groups of two or more things that fit; a named group is all that share its name."""
    fitting = [
        one
        for one in _candidates(task, scene, slot)
        if (one,) not in cast.values() and _holds(task, scene, {**cast, slot.name: (one,)})
    ]
    if not is_named:
        return [Collection(tuple(fitting))] if len(fitting) > 1 else []
    names = dict.fromkeys(name for one in fitting for name in scene.objects[one].names)
    groups = (
        Collection(tuple(o for o in fitting if name in scene.objects[o].names), name)
        for name in names
    )
    return [group for group in groups if len(group.objects) > 1]


def _holds(task: Task, scene: Scene, cast: Cast) -> bool:
    """Whether the conditions that speak of the slots filled so far hold, and of nothing else."""
    bound = {f"?{name}" for name in cast}
    for literal in task.where:
        variables = {a for a in literal.fluent.args if a.startswith("?")}
        if variables <= bound:
            ground_ones = _instances(literal, cast)
            if not all(one.holds(scene.initial) for one in ground_ones):
                return False
    return True


def _candidates(task: Task, scene: Scene, slot: Slot) -> list[str]:
    found = sorted(
        name
        for name, thing in scene.objects.items()
        if scene.domain.is_a(thing.type, slot.type) and thing.type != "robot"
    )
    return [name for name in found if _fits(task, scene, slot, name)]


def _fits(task: Task, scene: Scene, slot: Slot, name: str) -> bool:
    thing, is_a = scene.objects[name], scene.domain.is_a
    only, without = task.only.get(slot.name, ()), task.without.get(slot.name, ())
    names = task.named.get(slot.name, ())
    return (
        (not only or any(is_a(thing.type, kind) for kind in only))
        and not any(is_a(thing.type, kind) for kind in without)
        and (not names or bool(set(names) & set(thing.names)))
        and task.exactly.get(slot.name, name) == name
    )

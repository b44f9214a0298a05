"""What could be true of an object: fluents that an action changes, as the schemas alone tell.

So a picture knows what can be open or on without the whole task being grounded.
"""

from __future__ import annotations

from collections.abc import Iterator

from verbteach.world.domain import ActionSchema, Effect
from verbteach.world.fluents import Fluent
from verbteach.world.scene import Scene


def changeable(scene: Scene) -> list[Fluent]:
    """The one-place fluents that some action may change, sorted."""
    facts = frozenset(
        (fluent.predicate, place, arg)
        for fluent in scene.initial
        for place, arg in enumerate(fluent.args)
        if fluent.predicate in scene.domain.static
    )
    found = {
        Fluent(effect.predicate, (key,))
        for action in scene.domain.actions.values()
        for effect in action.effects
        if len(effect.args) == 1
        for key in _things(scene, action, effect, facts)
    }
    return sorted(found)


def _things(
    scene: Scene, action: ActionSchema, effect: Effect, facts: frozenset[tuple[str, int, str]]
) -> Iterator[str]:
    """Objects that the effect's variable may stand for: of its type, with its static facts."""
    (variable,) = effect.args
    kinds = {p.name: p.type for p in (*action.parameters, *effect.parameters)}
    needed = [
        (condition.predicate, condition.args.index(variable))
        for condition in (*action.precondition, *effect.condition)
        if condition.positive
        and variable in condition.args
        and condition.predicate in scene.domain.static
    ]
    for key, thing in scene.objects.items():
        fits = scene.domain.is_a(thing.type, kinds.get(variable, thing.type))
        if fits and all((predicate, place, key) in facts for predicate, place in needed):
            yield key

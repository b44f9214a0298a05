"""Pictures of scenes for exports that show them: the same picture as on the screen, as words."""

from __future__ import annotations

from collections.abc import Iterable

from verbteach.world.fluents import State
from verbteach.world.scene import Scene
from verbteach_sessions.exports.sight import Depict, SeenActor, SeenThing, Sight
from verbteach_tui.views.picture import Depictor, Thing


def make_depict() -> Depict:
    """A function that depicts scenes, each made ready once."""
    depictors: dict[str, Depictor] = {}

    def depict(scene: Scene, state: State) -> Sight:
        if scene.id not in depictors:
            depictors[scene.id] = Depictor(scene)
        picture = depictors[scene.id].picture(state)
        actors = tuple(
            SeenActor(actor.label, _labels(depictors[scene.id], actor.near), _seen(actor.holds))
            for actor in picture.actors
        )
        return Sight(picture.title, actors, _seen(picture.places), _seen(picture.others))

    return depict


def _labels(depictor: Depictor, keys: Iterable[str]) -> tuple[str, ...]:
    return tuple(depictor.labels[key] for key in keys)


def _seen(things: Iterable[Thing]) -> tuple[SeenThing, ...]:
    return tuple(
        SeenThing(
            thing.label,
            thing.relation,
            tuple(mark.text for mark in thing.marks),
            _seen(thing.contents),
        )
        for thing in things
    )

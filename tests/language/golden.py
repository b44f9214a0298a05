"""Everything that the robot can say of the bundled rooms, in one text for a person to read.

``python -m tests.language.golden`` writes it anew.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path

from tests.language.rooms import looks
from verbteach.language.distinguish import distinguish, glimpse
from verbteach.language.looks import Looks
from verbteach.language.wording import Wording
from verbteach.world.domain import Parameter
from verbteach.world.fluents import Fluent, Literal
from verbteach.world.plan import Action
from verbteach_scenarios.scenes import scene_ids

FILE = Path(__file__).parent / "data" / "wording.txt"


def text() -> str:
    """The fluents in every form, the actions in every form, and every thing's description."""
    return "\n".join((*_fluents(), *_actions(), *_things(), ""))


def _wording(room: Looks) -> Wording:
    return Wording(room.lexicon, lambda thing: distinguish(thing, room))


def _fluents() -> Iterator[str]:
    yield "FLUENTS"
    for name, predicate in looks().scene.domain.predicates.items():
        room, args = _example(predicate.parameters)
        said, fluent = _wording(room), Fluent(name, args)
        yes, no = Literal(fluent), Literal(fluent, positive=False)
        yield f"\n{fluent}"
        for positive, negative in (
            (said.describe(yes), said.describe(no)),
            (said.should(yes), said.should(no)),
            (said.must(yes), said.must(no)),
            (said.need_not(yes), said.need_not(no)),
            (said.became(yes), said.became(no)),
        ):
            yield f"    {positive} | {negative}"
        yield f"    {said.question(fluent)}"


def _actions() -> Iterator[str]:
    yield "\n\nACTIONS\n"
    for name, schema in looks().scene.domain.actions.items():
        room, args = _example(schema.parameters)
        said, action = _wording(room), Action(name, args)
        yield f"{action}: {said.action(action)} | {said.acting(action)} | {said.acts(action)}"


def _things() -> Iterator[str]:
    for scene in scene_ids():
        room = looks(scene)
        yield f"\n\nTHINGS IN {scene.upper()}\n"
        for thing in room.objects:
            if room.is_thing(thing):
                yield f"{thing}: {distinguish(thing, room)} | {glimpse(thing, room)}"


def _example(parameters: Sequence[Parameter]) -> tuple[Looks, tuple[str, ...]]:
    """The first room that has objects for all parameters, each used once."""
    for scene in scene_ids():
        room = looks(scene)
        chosen: list[str] = []
        for parameter in parameters:
            fitting = (
                thing.id
                for thing in sorted(room.objects.values(), key=lambda o: not room.is_thing(o.id))
                if thing.id not in chosen and room.scene.domain.is_a(thing.type, parameter.type)
            )
            chosen.extend([next(fitting, "")])
        if all(chosen):
            return room, tuple(chosen)
    raise LookupError(f"no bundled room has objects for {parameters}")


if __name__ == "__main__":
    FILE.write_text(text(), encoding="utf-8")

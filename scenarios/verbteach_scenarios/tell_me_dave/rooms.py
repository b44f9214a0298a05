"""The corpus's rooms as scenes and grounded tasks: one task for each set of objects.

Documents whose object lists agree share a task; documents that also begin in
the same state share an environment.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from functools import cache, lru_cache
from hashlib import sha256
from importlib import resources
from pathlib import Path

from verbteach.world.domain import Domain, Parameter, Predicate
from verbteach.world.fluents import Fluent, State
from verbteach.world.scene import Scene, SceneObject
from verbteach.world.task import Task
from verbteach_scenarios.pddl import parse_domain
from verbteach_scenarios.tell_me_dave.documents import Corpus, Document
from verbteach_scenarios.tell_me_dave.fittings import SCOOPFUL, fittings, kind

ROBOT = "Robot"
_STATE = "state"
_KITCHEN = frozenset({"Fridge", "Microwave", "Oven", "Sink", "Stove"})
_LIVING_ROOM = frozenset({"Armchair", "CoffeeTable", "Couch", "Loveseat", "Sofa", "Tv"})
_WORDS = re.compile(r"[A-Z]?[a-z]+|[A-Z]+(?![a-z])|\d+[A-Z]?")


@cache
def corpus_domain() -> Domain:
    """Return the domain of the corpus's actions, as its file has it."""
    file = resources.files(__package__).joinpath("domain.pddl")
    return parse_domain(file.read_text(encoding="utf-8"), Path("tell_me_dave/domain.pddl"))


@dataclass(frozen=True)
class Room:
    """A set of objects: ``key`` names it, ``marks`` are the objects' affordance marks.

    ``values`` are the things that states may say of an object, such as
    ``Water``, beyond the domain's own.
    """

    key: str
    marks: Mapping[str, tuple[str, ...]]
    values: Mapping[str, str]

    @classmethod
    def of(cls, document: Document) -> Room:
        """Read a document's room off its object list and whatever else its trace speaks of."""
        marks = _marks(document)
        values = _new_values(document, marks)
        text = repr((sorted(marks.items()), sorted(values.items())))
        return cls(f"tell-me-dave-{_digest(text)}", marks, values)

    @property
    def title(self) -> str:
        """``kitchen``, ``living room``, or ``room`` where the furniture does not say."""
        kinds = {kind(name) for name in self.marks}
        kitchen, living_room = len(kinds & _KITCHEN), len(kinds & _LIVING_ROOM)
        if kitchen == living_room:
            return "room"
        return "kitchen" if kitchen > living_room else "living room"

    def domain(self) -> Domain:
        """Return the corpus's domain, with the marks and values of this room that it lacks."""
        domain = corpus_domain()
        item = (Parameter("?o", "item"),)
        marks = {m for own in self.marks.values() for m in own if m not in domain.predicates}
        if not marks and not self.values:
            return domain
        return replace(
            domain,
            predicates={**domain.predicates, **{m: Predicate(m, item) for m in sorted(marks)}},
            constants={**domain.constants, **self.values},
        )

    def static(self) -> frozenset[Fluent]:
        """Return the facts that never change here."""
        return fittings(self.marks)

    def scene(self, environment: str, recorded: State) -> Scene:
        """Return the room as a scene that begins in a recorded state."""
        domain = self.domain()
        objects = {name: SceneObject(name, type_) for name, type_ in domain.constants.items()}
        objects |= {name: _scene_object(name) for name in sorted(self.marks)}
        state = whole(recorded, self.static())
        return Scene(environment, self.title, environment, domain, objects, state)


@dataclass(frozen=True)
class Rooms:
    """A corpus's rooms by key, each with its static facts and its task once they are asked for.

    ``of_document`` and ``environments`` map a document's name to its room's
    key and to the name of its environment.
    """

    rooms: Mapping[str, Room]
    of_document: Mapping[str, str]
    environments: Mapping[str, str]
    _static: dict[str, frozenset[Fluent]] = field(default_factory=dict, repr=False, compare=False)
    _tasks: dict[str, Task] = field(default_factory=dict, repr=False, compare=False)

    @classmethod
    def of(cls, corpus: Corpus) -> Rooms:
        """Gather the rooms of all documents."""
        found = {document.name: Room.of(document) for document in corpus.documents}
        return cls(
            rooms={room.key: room for room in found.values()},
            of_document={name: room.key for name, room in found.items()},
            environments={d.name: environment(d, found[d.name]) for d in corpus.documents},
        )

    def static(self, key: str) -> frozenset[Fluent]:
        """Return the facts that never change in a room."""
        if key not in self._static:
            self._static[key] = self.rooms[key].static()
        return self._static[key]

    def task(self, key: str) -> Task:
        """Return the grounded task of a room; raise ``KeyError`` for a key that is none."""
        if key not in self._tasks:
            room = self.rooms[key]
            self._tasks[key] = Task.from_scene(room.scene(key, frozenset()))
        return self._tasks[key]

    def scene(self, document: Document) -> Scene:
        """Return the scene in which a document begins."""
        room = self.rooms[self.of_document[document.name]]
        return room.scene(self.environments[document.name], document.steps[0].state)


def environment(document: Document, room: Room) -> str:
    """Name the room and state a document begins in: equal exactly for equal beginnings."""
    text = repr((room.key, sorted(document.steps[0].state)))
    return f"{room.title.replace(' ', '-')}-{_digest(text)[:6]}"


def whole(recorded: Iterable[Fluent], static: frozenset[Fluent]) -> State:
    """Complete a recorded state, which lists few marks, with everything that never changes."""
    return static.union(fluent for fluent in recorded if len(fluent.args) > 1)


def _marks(document: Document) -> dict[str, tuple[str, ...]]:
    """Marks from the object list and from the first state; objects that only the trace names."""
    found = {name: set(own) for name, own in document.objects.items()}
    for fluent in frozenset().union(*(step.state for step in document.steps)):
        for name in fluent.args[:1] if fluent.predicate == _STATE else fluent.args:
            found.setdefault(name, set())
    for fluent in document.steps[0].state:
        if len(fluent.args) == 1:
            found[fluent.args[0]].add(fluent.predicate)
    found.pop(ROBOT, None)
    return {name: tuple(sorted(found[name])) for name in sorted(found)}


def _new_values(document: Document, marks: dict[str, tuple[str, ...]]) -> dict[str, str]:
    """Values that the domain lacks: what can be poured has contents, all others are modes."""
    known = corpus_domain().constants
    states: State = frozenset().union(*(step.state for step in document.steps))
    pairs = sorted(f.args for f in states if f.predicate == _STATE and len(f.args) == 2)
    found: dict[str, str] = {}
    for name, value in pairs:
        if value not in known and found.get(value) != "content":
            found[value] = "content" if "IsPourable" in marks.get(name, ()) else "mode"
    implied = sorted(_named(tuple(marks.items())) - marks.keys() - known.keys() - found.keys())
    return found | dict.fromkeys(implied, "mode")


@lru_cache(maxsize=64)
def _named(marks: tuple[tuple[str, tuple[str, ...]], ...]) -> frozenset[str]:
    """The words in the facts that never change; many documents have the same objects."""
    return frozenset(word for fact in fittings(dict(marks)) for word in fact.args)


def _scene_object(name: str) -> SceneObject:
    scoopful = kind(name).endswith(SCOOPFUL)
    return SceneObject(name, "scoopful" if scoopful else "item", (spoken_name(name),))


def spoken_name(object_id: str) -> str:
    """Return the words in an object's id: ``bag of chips`` for ``BagOfChips_1``."""
    words = _WORDS.findall(re.sub(r"_\d+", " ", object_id))
    return " ".join(word.lower() for word in words) or object_id.lower()


def _digest(text: str) -> str:
    return sha256(text.encode()).hexdigest()[:10]

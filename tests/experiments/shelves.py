"""A small world for evaluations: boxes on shelves, lamps; and demonstrations by tidy teachers."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache

from verbteach.experiments.evaluation import Grounds
from verbteach.experiments.folds import leave_one_environment_out
from verbteach.experiments.workroom import Workroom
from verbteach.verbs.instance import Instance
from verbteach.world.domain import ActionSchema, Condition, Domain, Effect, Parameter, Predicate
from verbteach.world.fluents import Fluent, State
from verbteach.world.plan import Action
from verbteach.world.planner import SearchPlanner, make_planner
from verbteach.world.simulator import run
from verbteach.world.task import Task

BOX, SHELF, LAMP = Parameter("?b", "box"), Parameter("?s", "shelf"), Parameter("?l", "lamp")
FREE, BUSY = Effect("free", ()), Effect("free", (), False)
DOMAIN = Domain(
    "shelves",
    {"box": "object", "shelf": "object", "lamp": "object"},
    {},
    {
        "on": Predicate("on", (BOX, SHELF)),
        "held": Predicate("held", (BOX,)),
        "lit": Predicate("lit", (LAMP,)),
        "free": Predicate("free", ()),
    },
    {
        "grasp": ActionSchema(
            "grasp",
            (BOX, SHELF),
            (Condition("on", ("?b", "?s")), Condition("free", ())),
            (Effect("held", ("?b",)), Effect("on", ("?b", "?s"), False), BUSY),
        ),
        "put": ActionSchema(
            "put",
            (BOX, SHELF),
            (Condition("held", ("?b",)),),
            (Effect("on", ("?b", "?s")), Effect("held", ("?b",), False), FREE),
        ),
        "light": ActionSchema("light", (LAMP,), (), (Effect("lit", ("?l",)),)),
    },
)  # fmt: skip
OBJECTS: Mapping[str, str] = {
    **{f"Box_{i}": "box" for i in (1, 2, 3)},
    **{f"Shelf_{i}": "shelf" for i in (1, 2, 3)},
    "Lamp_1": "lamp",
}
KEY = "shelves"


@cache
def task() -> Task:
    return Task(DOMAIN, OBJECTS, frozenset())


def planner(for_task: Task) -> SearchPlanner:
    return make_planner(for_task, path="plain")


@cache
def room() -> Workroom:
    return Workroom.of(task(), planner(task()))


def start(first: int, second: int, third: int) -> State:
    places = (first, second, third)
    on = {Fluent("on", (f"Box_{i + 1}", f"Shelf_{at}")) for i, at in enumerate(places)}
    return frozenset({*on, Fluent("free")})


STARTS = {"attic": start(1, 1, 1), "cellar": start(2, 2, 3), "hall": start(3, 1, 1)}


def place_of(box: str, state: State) -> str:
    return next(f.args[1] for f in state if f.predicate == "on" and f.args[0] == box)


def put(box: str, shelf: str, state: State) -> tuple[Action, ...]:
    return Action("grasp", (box, place_of(box, state))), Action("put", (box, shelf))


def instance(name: str, room_name: str, box: str, shelf: str, light: bool = False) -> Instance:
    """ "Put the box on the shelf": sometimes somebody lights the lamp as well."""
    state = STARTS[room_name]
    actions = put(box, shelf, state) + ((Action("light", ("Lamp_1",)),) if light else ())
    return Instance(
        id=name,
        group=f"{room_name}-{name[-1]}",
        environment=room_name,
        verb="put",
        phrases=(f"box {box[-1]}", "shelf"),
        candidates=((box, "Box_3"), (shelf,)) if box != "Box_3" else ((box,), (shelf,)),
        grounding=(box, shelf),
        start=state,
        actions=actions,
        end=run(task(), state, actions)[-1],
        goal=None,
        task_key=KEY,
    )


def instances() -> tuple[Instance, ...]:
    """Demonstrations in three rooms, mostly tidy ones; the box is never on the shelf already."""
    found = []
    for room_name, state in STARTS.items():
        for i, box in enumerate(("Box_1", "Box_2", "Box_3", "Box_1", "Box_2", "Box_3")):
            shelves = [s for s in ("Shelf_1", "Shelf_2", "Shelf_3") if s != place_of(box, state)]
            name = f"{room_name}-{i}"
            found.append(instance(name, room_name, box, shelves[i % 2], light=i == 5))
    return tuple(found)


def grounds() -> Grounds:
    return Grounds(leave_one_environment_out(instances()), {KEY: task()}, planner)

"""A small world for tests, and a naive breadth-first planner to judge by.

Boxes are on tables or held; lamps are lit or not. Moving needs a free hand,
and a lamp under a box cannot be switched.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from functools import cached_property

from verbteach.verbs.surroundings import Surroundings
from verbteach.world.fluents import Fluent, Goal, State, satisfied
from verbteach.world.plan import Action, FailureReason, Plan, PlanFailure


def on(box: str, place: str) -> Fluent:
    return Fluent("on", (box, place))


def lit(lamp: str) -> Fluent:
    return Fluent("lit", (lamp,))


def held(box: str) -> Fluent:
    return Fluent("held", ("Robot", box))


@dataclass(frozen=True)
class Toy:
    boxes: tuple[str, ...]
    tables: tuple[str, ...]
    lamps: tuple[str, ...]

    @cached_property
    def surroundings(self) -> Surroundings:
        kinds = {"box": self.boxes, "table": self.tables, "lamp": self.lamps}
        marks = {o: frozenset({kind, "thing"}) for kind, found in kinds.items() for o in found}
        return Surroundings(frozenset({"heavy"}), marks)

    @property
    def start(self) -> State:
        return frozenset(on(box, self.tables[0]) for box in self.boxes)

    def steps(self, state: State) -> Iterator[tuple[Action, State]]:
        """Applicable actions in a fixed order, with the state after each."""
        in_hand = [box for box in self.boxes if held(box) in state]
        for box in self.boxes if not in_hand else ():
            place = [f for f in state if f.predicate == "on" and f.args[0] == box]
            yield Action("grasp", (box,)), (state - frozenset(place)) | {held(box)}
        for box in in_hand:
            for place_id in (*self.tables, *self.lamps):
                after = (state - {held(box)}) | {on(box, place_id)}
                yield Action("put", (box, place_id)), after
        for lamp in self.lamps:
            if not any(f.predicate == "on" and f.args[1] == lamp for f in state):
                yield Action("switch", (lamp,)), state ^ {lit(lamp)}

    def run(self, state: State, actions: Sequence[Action]) -> State:
        for action in actions:
            state = dict(self.steps(state))[action]
        return state


@dataclass
class NaivePlanner:
    """Breadth-first search: the shortest plan, the first in the order of steps."""

    toy: Toy
    bound: int = 100_000
    asked: list[Goal] = field(default_factory=list)
    _answers: dict[tuple[State, Goal], Plan | PlanFailure] = field(default_factory=dict)

    def plan(self, state: State, goal: Goal) -> Plan | PlanFailure:
        self.asked.append(goal)
        if (state, goal) not in self._answers:
            self._answers[state, goal] = self._search(state, goal)
        return self._answers[state, goal]

    def _search(self, state: State, goal: Goal) -> Plan | PlanFailure:
        came: dict[State, tuple[State, Action] | None] = {state: None}
        queue = deque([state])
        while queue:
            here = queue.popleft()
            if satisfied(goal, here):
                return Plan(_trace(came, here))
            for action, after in self.toy.steps(here):
                if after not in came:
                    came[after] = (here, action)
                    queue.append(after)
            if len(came) > self.bound:
                return PlanFailure(FailureReason.BOUND)
        return PlanFailure(FailureReason.UNREACHABLE)


def _trace(came: dict[State, tuple[State, Action] | None], here: State) -> tuple[Action, ...]:
    actions = []
    while (step := came[here]) is not None:
        here, action = step
        actions.append(action)
    return tuple(reversed(actions))

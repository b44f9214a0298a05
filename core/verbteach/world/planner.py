"""The planner: search on the grounded task, its plans refined, its answers remembered.

One planner serves one task and any number of states and goals. Bounded by
expansions, never by time; the same question has the same answer whatever was
asked before and whichever path, plain or compiled, does the searching.
"""

from __future__ import annotations

from collections import OrderedDict
from dataclasses import dataclass
from typing import Literal as OneOf
from typing import Protocol, TypeAlias

from verbteach.world import compiled
from verbteach.world.exclusion import Exclusions
from verbteach.world.fluents import Goal, Literal, State
from verbteach.world.plan import FailureReason, Plan, PlanFailure
from verbteach.world.refinement import EncodedGoal, refined
from verbteach.world.relaxed import RelaxedTask
from verbteach.world.search import Exhausted, SearchLimits, Steps, search
from verbteach.world.task import Task


@dataclass(frozen=True)
class PlannerConfig:
    """Bounds of the search and size of the memory.

    ``expansions`` is the number of states judged before giving up: 2,000 suit
    a person waiting, 300 to 500 suit training. ``boost`` is how many turns
    progress earns the preferred operators. ``remembered`` answers are kept.
    """

    expansions: int = 2000
    boost: int = 20
    remembered: int = 20_000

    @property
    def limits(self) -> SearchLimits:
        """What the search itself is told."""
        return SearchLimits(self.expansions, self.boost)


class Engine(Protocol):
    """A way to search a task and refine what is found: the plain one here, or the compiled one."""

    def search(self, bits: int, goal: tuple[int, ...], limits: SearchLimits) -> Steps | Exhausted:
        """Return the actions of a refined plan from ``bits`` to the goal, or why there is none."""
        ...


class PlainEngine:
    """The search in plain Python."""

    def __init__(self, task: Task, relaxed: RelaxedTask) -> None:
        self.task = task
        self.relaxed = relaxed

    def search(self, bits: int, goal: tuple[int, ...], limits: SearchLimits) -> Steps | Exhausted:
        """Return the actions of a refined plan from ``bits`` to the goal, or why there is none."""
        found = search(self.task, self.relaxed, bits, goal, limits)
        if isinstance(found, Exhausted):
            return found
        actions, size = self.task.actions, self.relaxed.size
        wanted = EncodedGoal(
            sum(1 << number for number in goal if number < size),
            sum(1 << number - size for number in goal if number >= size),
        )
        return tuple(step.index for step in refined(bits, [actions[i] for i in found], wanted))


class AutoEngine:
    """The compiled search as soon as it is available, the plain one until then.

    It never waits for a compiler: whoever has time to spare calls
    ``compiled.warm_up``, as the command line does before long work and the
    screen in the background.
    """

    def __init__(self, task: Task, relaxed: RelaxedTask) -> None:
        self._plain = PlainEngine(task, relaxed)
        self._compiled: compiled.CompiledEngine | None = None

    def search(self, bits: int, goal: tuple[int, ...], limits: SearchLimits) -> Steps | Exhausted:
        """Return the actions of a refined plan from ``bits`` to the goal, or why there is none."""
        if self._compiled is None and compiled.available():
            self._compiled = compiled.CompiledEngine(self._plain.task, self._plain.relaxed)
        return (self._compiled or self._plain).search(bits, goal, limits)


PlannerPath: TypeAlias = OneOf["auto", "plain", "compiled"]


def make_planner(
    task: Task, config: PlannerConfig = PlannerConfig(), path: PlannerPath = "auto"
) -> SearchPlanner:
    """Make a planner for the task, compiled where that is available.

    ``compiled`` waits for the compiler, and raises ``RuntimeError`` where the
    extra ``fast`` is not installed; ``plain`` never uses it. Plans are the same.
    """
    relaxed = RelaxedTask(task)
    if path == "plain":
        return SearchPlanner(task, config, PlainEngine(task, relaxed), relaxed)
    if path == "compiled":
        compiled.warm_up()
        return SearchPlanner(task, config, compiled.CompiledEngine(task, relaxed), relaxed)
    return SearchPlanner(task, config, AutoEngine(task, relaxed), relaxed)


class SearchPlanner:
    """Plans on one task; satisfies the ``Planner`` protocol."""

    def __init__(
        self,
        task: Task,
        config: PlannerConfig = PlannerConfig(),
        engine: Engine | None = None,
        relaxed: RelaxedTask | None = None,
    ) -> None:
        self.task = task
        self.config = config
        self.relaxed = relaxed or RelaxedTask(task)
        self.engine = engine or PlainEngine(task, self.relaxed)
        self._answers: OrderedDict[tuple[int, Goal], Plan | PlanFailure] = OrderedDict()
        self._open: set[Goal] = set()
        self._exclusions: Exclusions | None = None
        self._judged: tuple[int, dict[Literal, bool]] = (-1, {})

    def plan(self, state: State, goal: Goal) -> Plan | PlanFailure:
        """Plan from ``state`` to a state in which every literal of ``goal`` holds."""
        open_goal = goal if goal in self._open else self._open_goal(state, goal)
        if isinstance(open_goal, PlanFailure):
            return open_goal
        bits = self.task.encode(state)
        key = (bits, open_goal)
        known = self._answers.get(key)
        if known is not None:
            self._answers.move_to_end(key)
            return known
        answer = self._answers[key] = self._search(bits, open_goal)
        if len(self._answers) > self.config.remembered:
            self._answers.popitem(last=False)
        return answer

    def _open_goal(self, state: State, goal: Goal) -> Goal | PlanFailure:
        """Return the literals that actions can change, unless another one rules a plan out."""
        fixed = [literal for literal in goal if literal.fluent not in self.task.bit]
        unknown = [x.fluent for x in fixed if not self.task.is_fluent(x.fluent)]
        if unknown:
            return PlanFailure(FailureReason.UNKNOWN_FLUENT, str(min(unknown)))
        lost = [x for x in fixed if not self._is_settled(x, state)]
        lost += [x for x in goal if not x.positive and Literal(x.fluent) in goal]
        if lost:
            return PlanFailure(FailureReason.UNREACHABLE, str(min(lost)))
        if fixed:
            return goal.difference(fixed)
        self._remember_open(goal)
        return goal

    def _remember_open(self, goal: Goal) -> None:
        """Remember a goal that is open in every state, as most are, whatever is fixed there."""
        if len(self._open) >= self.config.remembered:
            self._open.clear()
        self._open.add(goal)

    def _is_settled(self, literal: Literal, state: State) -> bool:
        """Whether a literal holds that no action touches; static facts are the task's."""
        is_static = literal.fluent.predicate in self.task.domain.static
        return literal.holds(self.task.static if is_static else state)

    def _search(self, bits: int, goal: Goal) -> Plan | PlanFailure:
        wanted = self._encoded(goal)
        if wanted.holds(bits):
            return Plan(())
        if self._exclusions is not None and (failure := self._contradiction(bits, wanted)):
            return failure
        numbers = self.relaxed.propositions(goal)
        found = self.engine.search(bits, numbers, self.config.limits)
        if isinstance(found, Exhausted):
            return self._contradiction(bits, wanted) or self._failure(bits, goal, found)
        actions = self.task.actions
        return Plan(tuple([actions[number].action for number in found]))

    def _contradiction(self, bits: int, wanted: EncodedGoal) -> PlanFailure | None:
        """Say which two wanted fluents exclude each other, which no search would come to know.

        What excludes what is worked out when a search first fails: most tasks need it never.
        """
        if self._exclusions is None:
            self._exclusions = Exclusions(self.task)
        pair = self._exclusions.pair(bits, wanted.true)
        if pair is None:
            return None
        return PlanFailure(FailureReason.UNREACHABLE, f"{pair[0]} with {pair[1]}")

    def _failure(self, bits: int, goal: Goal, found: Exhausted) -> PlanFailure:
        if found.bound:
            return PlanFailure(FailureReason.BOUND, f"{self.config.expansions} states judged")
        return PlanFailure(FailureReason.UNREACHABLE, self._hopeless(bits, goal))

    def _hopeless(self, bits: int, goal: Goal) -> str:
        """Name the first literal that even the relaxed task never reaches, if it is one alone."""
        lost = (str(literal) for literal in sorted(goal) if not self._is_reached(bits, literal))
        return next(lost, "")

    def _is_reached(self, bits: int, literal: Literal) -> bool:
        """Whether the relaxed task reaches the literal; remembered for the last state."""
        judged = self._judged  # held here: another thread may be judging another state
        if judged[0] != bits:
            judged = self._judged = (bits, {})
        known = judged[1]
        if literal not in known:
            numbers = self.relaxed.propositions((literal,))
            known[literal] = self.relaxed.estimate(bits, numbers) is not None
        return known[literal]

    def _encoded(self, goal: Goal) -> EncodedGoal:
        """The bits of an open goal, whose fluents all have one."""
        true = false = 0
        for fluent, positive in goal:
            if positive:
                true |= self.task.bit[fluent]
            else:
                false |= self.task.bit[fluent]
        return EncodedGoal(true, false)

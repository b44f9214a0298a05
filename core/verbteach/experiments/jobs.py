"""The pieces of work of an evaluation: learning demonstrations, judging goals, testing commands.

Each is a function of its job alone, so that jobs may run in any order and in
any process.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import NamedTuple, TypeAlias

from verbteach.collecting import without_collecting
from verbteach.experiments.groundings import GROUNDERS, Grounder, shown
from verbteach.experiments.judging import Judge, Score
from verbteach.experiments.parcels import Parcel
from verbteach.experiments.polling import Lesson, Panel, School
from verbteach.experiments.she16 import Variant
from verbteach.experiments.sight import Sight
from verbteach.experiments.workroom import PlannerMaker, Workroom, furnished
from verbteach.perception.noise import NoiseModel
from verbteach.verbs.application import GroundingBelief, Situation
from verbteach.verbs.criteria import MOST_FREQUENT, Teller
from verbteach.verbs.hypothesis import Learner, Shown
from verbteach.verbs.instance import Instance
from verbteach.verbs.learning import derive
from verbteach.verbs.poll import Poll
from verbteach.verbs.regression import Judged
from verbteach.verbs.selection import best_plan
from verbteach.verbs.space import Demonstration, FrameKey
from verbteach.world.fluents import Goal, State
from verbteach.world.plan import Action, Plan, PlanFailure
from verbteach.world.task import Task


@dataclass(frozen=True)
class Setup:
    """What is evaluated, under which conditions.

    ``grounding`` names a mode; ``grounder`` does it where the mode is not one
    of ``GROUNDERS``. The regression is fitted on one in ``development``
    documents of the training part; at most ``judged_goals`` of each of their
    commands are planned for. Without ``exact_ceiling`` the best goal is found
    as if the robot saw truly, which is much quicker and never finds more.
    """

    variant: Variant
    noise: NoiseModel = field(default_factory=NoiseModel)
    grounding: str = "corpus"
    grounder: Grounder | None = None
    seed: int = 0
    development: int = 5
    judged_goals: int = 100
    exact_ceiling: bool = True

    def __post_init__(self) -> None:
        if self.grounder is None and self.grounding not in GROUNDERS:
            raise ValueError(f"the grounding {self.grounding!r} needs a grounder")

    def ground(self, instance: Instance, experience: Sequence[Demonstration]) -> GroundingBelief:
        """The grounding belief of a new command."""
        return (self.grounder or GROUNDERS[self.grounding])(instance, experience)


@dataclass(frozen=True)
class Site:
    """Where a job works: the setup, the eyes, and the tasks of its instances."""

    setup: Setup
    sight: Sight
    tasks: Mapping[str, Parcel[Task]]
    planner: PlannerMaker

    def room(self, instance: Instance) -> Workroom:
        """The instance's workroom, kept for later jobs of this process."""
        key = instance.task_key
        return furnished(key, self.tasks[key].value, self.planner)

    def only(self, instances: Sequence[Instance]) -> Site:
        """The same, with no more tasks and documents than these instances need."""
        tasks = {i.task_key: self.tasks[i.task_key] for i in instances}
        return replace(self, tasks=tasks, sight=self.sight.only({i.group for i in instances}))


class Trial(NamedTuple):
    """One test command: how the plan did, the goals there were to choose from, and the plan."""

    instance: str
    group: str
    environment: str
    verb: str
    score: Score
    candidates: int
    plan: tuple[str, ...]


LearnJob: TypeAlias = tuple[Site, Sequence[Instance]]
Taught: TypeAlias = tuple[Parcel[School], Sequence[str]]
"""The lessons of a run, and which of them a job learns from, in this order."""
DevelopJob: TypeAlias = tuple[Site, Sequence[Instance], Taught]
Criteria: TypeAlias = Mapping[str, Teller | None]
"""Criteria to choose by, by name; None stands for the answer itself."""
TestJob: TypeAlias = tuple[Site, Sequence[Instance], Taught, Criteria]
Development: TypeAlias = dict[str, Judged]
"""Judged votes by development instance."""


def learn_all(job: LearnJob) -> list[Lesson]:
    """The lessons of some instances."""
    site, instances = job
    with without_collecting():
        return [_lesson(site, instance) for instance in instances]


def develop_all(job: DevelopJob) -> Development:
    """Judge what the lessons' votes for some instances' commands come to."""
    site, instances, taught = job
    with without_collecting():
        panel = _panel(taught)
        return {i.id: _judged(site, i, panel) for i in instances}


def test_all(job: TestJob) -> dict[str, list[Trial]]:
    """Carry out some instances' commands, by each criterion: goals are gathered once for all."""
    site, instances, taught, criteria = job
    found: dict[str, list[Trial]] = {name: [] for name in criteria}
    with without_collecting():
        panel = _panel(taught)
        for instance in instances:
            test = _Test(site, instance, *_polled(site, instance, panel))
            for name, criterion in criteria.items():
                found[name].append(test.trial(criterion))
    return found


def _panel(taught: Taught) -> Panel:
    school, names = taught
    return school.value.panel(names)


def _lesson(site: Site, instance: Instance) -> Lesson:
    room, variant = site.room(instance), site.setup.variant
    seen = site.sight.demonstrated(instance, room)
    start, end = seen.start.believed(), seen.end.believed()
    if variant.reenacts:
        start, end = room.reenact(start, instance.actions)
    demonstration = _demonstration(site.setup, instance, start, end)
    learner = Learner(room.planner, room.surroundings, variant.learning)
    return Lesson(
        demonstration, derive(demonstration, Shown(start, instance.actions, end), learner)
    )


def _demonstration(setup: Setup, instance: Instance, start: State, end: State) -> Demonstration:
    grounding = instance.grounding
    if setup.grounding != "oracle":
        changed = frozenset(word for fluent in start ^ end for word in fluent.args)
        handled = frozenset(word for action in instance.actions for word in action.args)
        grounding = shown(setup.ground(instance, ()), changed, handled)
    return Demonstration(instance.id, instance.verb, instance.phrases, grounding)


def _polled(site: Site, instance: Instance, panel: Panel) -> tuple[State, Poll]:
    """What the robot believes of the scene, and the goals that the command may mean there."""
    room = site.room(instance)
    state = site.sight.met(instance, room).believed()
    belief = site.setup.ground(instance, panel.experience)
    situation = Situation(
        FrameKey(*instance.frame), instance.phrases, belief, state, room.surroundings
    )
    parameters = site.setup.variant.selection.application
    return state, panel.poll(instance.id, situation, parameters)


def _judged(site: Site, instance: Instance, panel: Panel) -> Judged:
    room = site.room(instance)
    state, poll = _polled(site, instance, panel)
    judge = Judge(instance, room)
    rewards = {}
    for wanted in poll.ranked(MOST_FREQUENT.tally(poll), site.setup.judged_goals):
        reward = _worth(room, judge, state, wanted.goal)
        if reward is not None:
            rewards[wanted.number] = reward
    return Judged.of(poll, rewards)


def _worth(room: Workroom, judge: Judge, state: State, goal: Goal) -> float | None:
    """The SJI of planning to the goal from what is believed; None without a plan."""
    answer = room.planner.plan(state, goal)
    if not isinstance(answer, Plan) or not answer.actions:
        return None
    return judge.sji(answer.actions)


@dataclass(frozen=True)
class _Test:
    """A test command with the goals that it may mean, to be chosen from by any criterion."""

    site: Site
    instance: Instance
    state: State
    poll: Poll

    @cached_property
    def _judge(self) -> Judge:
        return Judge(self.instance, self.site.room(self.instance))

    def trial(self, criterion: Teller | None) -> Trial:
        """How the plan does that the criterion chooses; without one the answer itself does."""
        plan = self._best() if criterion is None else self._chosen(criterion)
        return Trial(
            self.instance.id,
            self.instance.group,
            self.instance.environment,
            self.instance.verb,
            self._judge.score(plan),
            len(self.poll.goals),
            tuple(map(str, plan)),
        )

    def _chosen(self, criterion: Teller) -> tuple[Action, ...]:
        parameters = self.site.setup.variant.selection
        wanted = self.poll.ranked(criterion.tally(self.poll), parameters.planned)
        chosen = best_plan(wanted, self.state, self._judge.room.planner, parameters)
        return () if chosen is None else chosen[1].actions

    def _best(self) -> tuple[Action, ...]:
        """The plan of the first goal that comes to the best SJI.

        Where the robot sees truly a plan brings about all of its goal, and goals
        that could not come to more than the best so far need no plan.
        """
        judge, planner = self._judge, self._judge.room.planner
        sees = self.state == self.instance.start or not self.site.setup.exact_ceiling
        bounds = [judge.most(goal) if sees else 1.0 for goal in self.poll.goals]
        best, at = 0.0, len(bounds)
        plan: tuple[Action, ...] = ()
        worths: dict[Plan | PlanFailure, float] = {}
        for index in sorted(range(len(bounds)), key=lambda i: (-bounds[i], i)):
            if (bounds[index], -index) <= (best, -at):
                break
            answer = planner.plan(self.state, self.poll.goals[index])
            actions = answer.actions if isinstance(answer, Plan) else ()
            worth = worths.get(answer)
            if worth is None:
                worth = worths[answer] = judge.sji(actions)
            if worth > 0 and (worth, -index) > (best, -at):
                best, at, plan = worth, index, actions
        return plan

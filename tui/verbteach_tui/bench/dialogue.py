"""How quickly the robot answers: turn by turn in a long session, and as fast as it can go."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

from verbteach.dialogue import acts
from verbteach.dialogue.lesson import Lesson
from verbteach.dialogue.moves import Phase
from verbteach.dialogue.parameters import RobotParameters
from verbteach.dialogue.robot import Robot
from verbteach.dialogue.setting import Setting, Settings
from verbteach.dialogue.simulated import SimulatedTeacher, seeded_order
from verbteach.policy.demonstration_only import DemonstrationOnlyPolicy
from verbteach.world.fluents import Goal, State
from verbteach.world.plan import Plan, PlanFailure, Planner
from verbteach_sessions.header import Header
from verbteach_sessions.replay import verify
from verbteach_sessions.session import Session
from verbteach_tui.bench.clock import per_second, timed

SEED = 1
WARMED = 500  # turns before any is timed
SECONDS = 3.0  # that something is repeated for
TAUGHT = 20  # lessons that the robot has had before episodes are counted


@dataclass
class PlanCounter:
    """Counts how often any planner of these settings was asked."""

    settings: Settings
    calls: int = 0
    _made: dict[str, Setting] = field(default_factory=dict)

    def __call__(self, scene: str) -> Setting:
        """The setting with its planner watched."""
        if scene not in self._made:
            setting = self.settings(scene)
            watched = _Watched(setting.planner, self)
            self._made[scene] = replace(setting, planner=watched)
        return self._made[scene]


@dataclass(frozen=True)
class _Watched:
    planner: Planner
    counter: PlanCounter

    def plan(self, state: State, goal: Goal) -> Plan | PlanFailure:
        self.counter.calls += 1
        return self.planner.plan(state, goal)


@dataclass
class Turns:
    """Milliseconds a turn, from the teacher's act to the robot's answer on the disk."""

    path: Path
    plain: list[float] = field(default_factory=list)
    planned: list[float] = field(default_factory=list)


def long_session(
    folder: Path,
    lessons: Sequence[Lesson],
    settings: Settings,
    timed_turns: int,
    done: Callable[[int], None],
) -> Turns:
    """Teach in one session for ``WARMED`` turns, and then ``timed_turns`` more with a clock."""
    counter = PlanCounter(settings)
    order = seeded_order(lessons, len(lessons) * 50, SEED)
    teacher = SimulatedTeacher(order, counter)
    with Session.create(folder, Header.new(order[0].scene), counter) as session:
        turns = Turns(session.path)
        for number in range(WARMED + timed_turns):
            act = teacher.reply(session.turn, session.robot.state)
            if act is None:
                break
            before = counter.calls
            spent, _ = timed(lambda: session.perform(act, via="simulated"))  # noqa: B023
            if number >= WARMED:
                (turns.planned if counter.calls > before else turns.plain).append(spent)
            done(number + 1)
    return turns


def replayed_per_second(path: Path, settings: Settings) -> float:
    """Events of a session recomputed and compared in a second."""
    spent, found = timed(lambda: verify(path, settings))
    return found.events / spent * 1000


def dialogues_per_second(settings: Settings, scene: str) -> float:
    """Dialogues that need no plan: an unknown verb, and a teacher who does not show it."""
    robot = _robot(settings)
    robot.open(scene)

    def dialogue() -> int:
        robot.receive(acts.Command("frobnicate the mug"))
        while robot.turn.phase is not Phase.COMMAND:
            robot.receive(acts.Skip())
        return 1

    return per_second(dialogue, SECONDS)


def planned_episodes_per_second(lessons: Sequence[Lesson], settings: Settings) -> float:
    """Whole episodes of a robot that has been taught, each planned and judged, a second."""
    robot = _robot(settings)
    some = seeded_order(lessons, TAUGHT, SEED)
    robot.open(some[0].scene)
    for _ in _episodes(robot, some, settings):
        pass
    endless = _episodes(robot, tuple(some) * 1000, settings)
    return per_second(lambda: next(endless), SECONDS)


def _episodes(robot: Robot, lessons: Sequence[Lesson], settings: Settings) -> Iterator[int]:
    """Let the simulated teacher teach; yield how many episodes ended, whenever some have."""
    teacher = SimulatedTeacher(lessons, settings)
    ended = robot.state.totals.episodes
    while (act := teacher.reply(robot.turn, robot.state)) is not None:
        robot.receive(act)
        now = robot.state.totals.episodes
        if now > ended:
            yield now - ended
            ended = now


def _robot(settings: Settings) -> Robot:
    return Robot(settings, DemonstrationOnlyPolicy(), RobotParameters(seed=SEED))

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
from verbteach_scenarios.weights import starting_weights
from verbteach_sessions.header import Header
from verbteach_sessions.method import Method, starting_policy
from verbteach_sessions.replay import verify
from verbteach_sessions.session import Session
from verbteach_tui.bench.allowance import Allowance
from verbteach_tui.bench.clock import per_second, timed

SEED = 1
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
    """Milliseconds a turn, from the teacher's act to the robot's answer on the disk.

    ``before`` turns were not timed. ``longest`` has the teacher's act of the longest turn.
    """

    path: Path
    before: int = 0
    plain: list[float] = field(default_factory=list)
    planned: list[float] = field(default_factory=list)
    longest: tuple[float, str] = (0.0, "")

    def take(self, spent: float, act: acts.TeacherAct, planned: bool) -> None:
        """Note one turn's milliseconds."""
        (self.planned if planned else self.plain).append(spent)
        self.longest = max(self.longest, (spent, type(act).__name__))


def long_session(
    folder: Path,
    lessons: Sequence[Lesson],
    settings: Settings,
    lengths: tuple[int, int],
    allowance: Allowance,
    done: Callable[[int], None],
) -> Turns:
    """Teach a robot as it comes, in one session, and time its turns.

    ``lengths`` is how many turns come before the clock, and how many with it.
    Half of the allowance may go to the former, what is left of it to the latter.
    """
    order = seeded_order(lessons, len(lessons) * 50, SEED)
    counter = PlanCounter(settings)
    teacher = SimulatedTeacher(order, counter)
    before, after = lengths
    with Session.create(folder, _header(order[0].scene), counter) as session:
        turns = Turns(session.path)
        while len(turns.plain) + len(turns.planned) < after and not allowance.over():
            act = teacher.reply(session.turn, session.robot.state)
            if act is None:
                break
            calls = counter.calls
            spent, _ = timed(lambda: session.perform(act, via="simulated"))  # noqa: B023
            if turns.before < before and not allowance.over(0.5):
                turns.before += 1
            else:
                turns.take(spent, act, counter.calls > calls)
            done(turns.before + len(turns.plain) + len(turns.planned))
    return turns


def _header(scene: str) -> Header:
    """Of a session of the robot that people meet: it asks as it was trained to, and learns on."""
    method = starting_policy(starting_weights(), frozen=False)
    parameters = RobotParameters(seed=SEED)
    return Header.new(scene, Method(method, parameters), interface="bench", teacher="simulated")


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


def planned_episodes_per_second(
    lessons: Sequence[Lesson], settings: Settings, allowance: Allowance
) -> float:
    """Whole episodes of a robot that has been taught, each planned and judged, a second."""
    robot = _robot(settings)
    some = seeded_order(lessons, TAUGHT, SEED)
    robot.open(some[0].scene)
    for _ in _episodes(robot, some, settings):
        if allowance.over(0.8):
            break
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

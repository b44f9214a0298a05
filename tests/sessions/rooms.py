"""Sessions in the bundled rooms, and teachers to hold them with."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import suppress
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from verbteach.dialogue import acts
from verbteach.dialogue.acts import TeacherAct
from verbteach.dialogue.moves import TEACHER_MOVES, IllegalMoveError
from verbteach.dialogue.setting import Setting
from verbteach.dialogue.state import RobotState
from verbteach.dialogue.turn import RobotTurn
from verbteach.language.lexicon import Lexicon
from verbteach.world.fluents import Fluent, Literal
from verbteach.world.planner import SearchPlanner
from verbteach.world.simulator import applicable
from verbteach.world.task import Task
from verbteach_scenarios.scenes import load_scene
from verbteach_sessions import session_acts
from verbteach_sessions.driving import ScriptTeacher, drive
from verbteach_sessions.header import Header
from verbteach_sessions.script import ScriptAct
from verbteach_sessions.session import Session

BOIL = """\
command: boil the water
do: moveto Kettle_1
do: grasp Kettle_1
do: moveto Burner_1
do: put-on Kettle_1 Burner_1
do: moveto StoveKnob_1
do: turn StoveKnob_1
done
good
"""
TAUGHT = BOIL + "scene: kitchen-3\ncommand: boil the water\n"


@cache
def settings(scene_id: str) -> Setting:
    """The bundled scenes with few words: all that a session needs."""
    scene = load_scene(scene_id)
    task = Task.from_scene(scene)
    return Setting(scene, task, SearchPlanner(task), Lexicon())


class Clock:
    """A clock that a test turns by hand; each look takes a quarter of a second."""

    def __init__(self, start: float = 1000.0) -> None:
        self.time = start

    def __call__(self) -> float:
        self.time += 0.25
        return self.time


def begin(folder: Path, scene: str = "kitchen-1", **header: Any) -> Session:
    """A new session in ``folder``."""
    return Session.create(folder, Header.new(scene, **header), settings, clock=Clock())


def resumed(path: Path) -> Session:
    """A session opened again."""
    return Session.resume(path, settings, clock=Clock())


def say(session: Session, script: str) -> Session:
    """Say the lines of a script."""
    drive(session, ScriptTeacher(script.splitlines()))
    return session


def recorded(folder: Path, script: str, **header: Any) -> Path:
    """The folder of a session in which a script has been said."""
    with begin(folder, **header) as session:
        return say(session, script).path


class Babbler:
    """Whatever fits, drawn from ``rng``, ``count`` times; undo, redo and notes now and then."""

    def __init__(self, session: Session, rng: np.random.Generator, count: int) -> None:
        self._session = session
        self._rng = rng
        self._left = count

    def reply(self, turn: RobotTurn, state: RobotState) -> ScriptAct | None:
        """A random act."""
        if self._left == 0:
            return None
        self._left -= 1
        if self._rng.random() < 0.3:
            return self._about_the_session()
        return fitting(turn, state, self._rng)

    def _about_the_session(self) -> ScriptAct:
        draw = self._rng.random()
        if draw < 0.5 and self._session.can_undo:
            return session_acts.Undo()
        if draw < 0.8 and self._session.can_redo:
            return session_acts.Redo()
        others = (session_acts.Note("so so"), session_acts.Flag(), session_acts.Why())
        return others[int(self._rng.integers(len(others)))]


def babble(session: Session, seed: int, count: int) -> Session:
    """Say ``count`` random things; what does not fit is passed over."""
    babbler = Babbler(session, np.random.default_rng(seed), count)
    while (act := babbler.reply(session.turn, session.robot.state)) is not None:
        with suppress(IllegalMoveError):
            session.perform(act)
    return session


def teach(session: Session, seed: int, count: int) -> list[TeacherAct]:
    """Let ``count`` random acts be performed, and answer with them."""
    rng, said = np.random.default_rng(seed), list[TeacherAct]()
    while len(said) < count:
        act = fitting(session.turn, session.robot.state, rng)
        with suppress(IllegalMoveError):
            session.perform(act)
            said.append(act)
    return said


def fitting(turn: RobotTurn, state: RobotState, rng: np.random.Generator) -> TeacherAct:
    """A random act of a kind that the robot waits for; demonstrations and praise preferred."""
    kinds = sorted(TEACHER_MOVES[turn.phase], key=lambda kind: kind.name)
    if acts.Do in kinds and rng.random() < 0.7:
        kinds = [acts.Do]
    if acts.Good in kinds and rng.random() < 0.5:
        kinds = [acts.Good]
    kind: Any = kinds[int(rng.integers(len(kinds)))]
    made: TeacherAct = kind(*_arguments(kind, state, rng))
    return made


def _arguments(kind: type[TeacherAct], state: RobotState, rng: np.random.Generator) -> list[Any]:
    setting = settings(state.scene)
    places = [int(place) for place in rng.integers(1, 5, size=2)]
    if kind is acts.Remove or kind is acts.Move:
        return places
    if kind is acts.Insert:
        possible = applicable(setting.task, state.world)
        return [places[0], possible[int(rng.integers(len(possible)))]]
    if kind is acts.RuleOut or kind is acts.Confirm:
        return _known_fluent(state, rng)
    choices: dict[type[TeacherAct], Callable[[], Sequence[Any]]] = {
        acts.Command: lambda: COMMANDS,
        acts.Say: lambda: SAYINGS,
        acts.Point: lambda: sorted(setting.scene.objects),
        acts.Do: lambda: applicable(setting.task, state.world),
        acts.GoToScene: lambda: ("kitchen-1", "kitchen-3"),
        acts.Strike: lambda: _literals(state),
        acts.Keep: lambda: _literals(state),
    }
    if kind not in choices:
        return []
    items = choices[kind]()
    return [items[int(rng.integers(len(items)))]]


COMMANDS = ("boil the water", "open the fridge", "wash the mug", "take the bread", "sing", "")
SAYINGS = ("no", "yes", "the red mug", "Kettle_1", "", "grasp the mug", "no, Mug_1")


def _known_fluent(state: RobotState, rng: np.random.Generator) -> list[Any]:
    frames = sorted(state.knowledge.frames.values(), key=lambda frame: frame.key)
    if not frames:
        return ["boil/1", frozenset(), Literal(Fluent("hot", ("?0",)))]
    frame = frames[int(rng.integers(len(frames)))]
    nodes = list(frame.nodes)
    node = nodes[int(rng.integers(len(nodes)))]
    return [str(frame.key), frozenset(node), node[int(rng.integers(len(node)))]]


def _literals(state: RobotState) -> Sequence[Literal]:
    read_back = state.episode.read_back if state.episode else None
    return sorted(read_back.whole if read_back else ()) or [Literal(Fluent("hot", ("Water",)))]

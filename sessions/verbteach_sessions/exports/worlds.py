"""The true world at every turn, followed from what was done and held against the recorded hashes.

Nothing that the robot thinks is recomputed, so a record of another version can
be followed as well, as long as the scene and its actions are the same.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from verbteach.dialogue.setting import Settings, UnknownSceneError
from verbteach.world.fluents import State
from verbteach.world.plan import Action
from verbteach.world.scene import Scene
from verbteach.world.simulator import run
from verbteach.world.task import Task
from verbteach_sessions.exports.dialogue import ROBOT, TEACHER, Dialogue, Turn
from verbteach_sessions.recording import world_digest


def follow(dialogue: Dialogue, settings: Settings) -> Mapping[str, tuple[Scene, State]]:
    """The worlds of a dialogue by their hashes; one that cannot be followed is left out."""
    follower = _Follower(settings)
    before: Turn | None = None
    for turn in dialogue.turns:
        if turn.kind == ROBOT:
            follower.reach(turn, _act(dialogue, turn), _screen(dialogue, turn) or before)
            before = turn
    return follower.worlds


def _act(dialogue: Dialogue, turn: Turn) -> Turn | None:
    return None if turn.reply_to is None else dialogue.turns[turn.reply_to]


def _screen(dialogue: Dialogue, turn: Turn) -> Turn | None:
    """The robot's turn that was on the screen as the teacher acted."""
    act = _act(dialogue, turn)
    return None if act is None or act.reply_to is None else dialogue.turns[act.reply_to]


class _Follower:
    def __init__(self, settings: Settings) -> None:
        self._settings = settings
        self._scenes: dict[str, tuple[Scene, Task] | None] = {}
        self._shown_from = ""  # the world in which the teacher began to demonstrate
        self.worlds: dict[str, tuple[Scene, State]] = {}

    def reach(self, turn: Turn, act: Turn | None, screen: Turn | None) -> None:
        """Add the world after a turn of the robot, where what was done leads to it."""
        if "request_demonstration" in turn.act_names:
            self._shown_from = turn.world
        place = self._enter(turn.scene)
        if place is None or turn.world in self.worlds:
            return
        scene, task = place
        for begin, actions in (*_deeds(turn, act, screen), *self._edited(turn)):
            if begin in self.worlds and self.worlds[begin][0] is scene:
                for state in run(task, self.worlds[begin][1], actions):
                    self.worlds.setdefault(world_digest(state), (scene, state))

    def _edited(self, turn: Turn) -> Iterator[tuple[str, list[Action]]]:
        """A demonstration whose steps were changed is done again from where it began."""
        for act in turn.acts:
            if act.get("act") == "revise_steps" and isinstance(act.get("steps"), list):
                yield self._shown_from, _actions(act["steps"])

    def _enter(self, scene_id: str) -> tuple[Scene, Task] | None:
        """The scene, its first world known from then on; ``None`` where there is no such scene."""
        if scene_id not in self._scenes:
            try:
                setting = self._settings(scene_id)
            except UnknownSceneError:
                self._scenes[scene_id] = None
                return None
            self._scenes[scene_id] = setting.scene, setting.task
            initial = setting.scene.initial
            self.worlds.setdefault(world_digest(initial), (setting.scene, initial))
        return self._scenes[scene_id]


def _deeds(turn: Turn, act: Turn | None, screen: Turn | None) -> Iterator[tuple[str, list[Action]]]:
    """What may have been done since: the teacher's step, or the robot's plan, and from where."""
    if act is not None and screen is not None and act.speaker == TEACHER:
        texts = [one.get("action") for one in act.acts if one.get("act") == "do"]
        yield screen.world, _actions(texts)
    if turn.trace is not None and turn.trace["worlds"]:
        yield turn.trace["worlds"][0], _actions(turn.trace["done"])


def _actions(texts: list[str | None]) -> list[Action]:
    actions = []
    for text in texts:
        try:
            actions.append(Action.parse(text or ""))
        except ValueError:
            break
    return actions

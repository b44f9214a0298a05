"""A robot in the bundled scenes, and a short way to talk to it."""

from __future__ import annotations

from functools import cache

from verbteach.dialogue import acts
from verbteach.dialogue.acts import TeacherAct
from verbteach.dialogue.robot import Robot
from verbteach.dialogue.setting import Setting
from verbteach.dialogue.turn import RobotTurn
from verbteach.policy.demonstration_only import DemonstrationOnlyPolicy
from verbteach.world.plan import Action
from verbteach_scenarios.settings import make_settings

BOIL = (
    "moveto Kettle_1",
    "grasp Kettle_1",
    "moveto Burner_1",
    "set-on Kettle_1 Burner_1",
    "moveto StoveKnob_1",
    "turn StoveKnob_1",
)


@cache
def _settings(scene_id: str) -> Setting:
    return _provider()(scene_id)


_provider = cache(make_settings)
provider = _settings


def robot(scene: str = "kitchen-1") -> Robot:
    found = Robot(_settings, DemonstrationOnlyPolicy())
    found.open(scene)
    return found


def shown(*steps: str) -> list[TeacherAct]:
    return [*(acts.Do(Action.parse(step)) for step in steps), acts.Done()]


def tell(listener: Robot, *said: TeacherAct) -> RobotTurn:
    for act in said:
        listener.receive(act)
    return listener.turn


def taught_to_boil() -> Robot:
    pupil = robot()
    tell(pupil, acts.Command("boil the water"), *shown(*BOIL), acts.Good())
    return pupil

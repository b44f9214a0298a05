"""Why an action cannot be done now, in words."""

from __future__ import annotations

from verbteach.dialogue.setting import Setting
from verbteach.dialogue.speech import Speech
from verbteach.language.morphology import article, listing
from verbteach.world.fluents import State
from verbteach.world.plan import Action
from verbteach.world.simulator import (
    Obstacle,
    Unequal,
    UnknownAction,
    UnknownObject,
    Unmet,
    WrongNumber,
    WrongType,
    explain,
)


def obstacle(setting: Setting, world: State, action: Action) -> str:
    """What stands in the way of ``action`` in ``world``; empty where it can be done."""
    speech = Speech.of(setting, world)
    reasons = [_reason(one, action, speech) for one in explain(setting.task, world, action)]
    return listing(reasons)


def _reason(reason: Obstacle, action: Action, speech: Speech) -> str:
    match reason:
        case UnknownAction(name=name):
            known = ", ".join(sorted(speech.setting.task.domain.actions))
            return f"there is no action {name}; there are {known}"
        case WrongNumber(name=name, expected=expected, given=given):
            things = "object" if expected == 1 else "objects"
            return f"{name} takes {expected} {things}, not {given}"
        case UnknownObject(name=name):
            return f"there is no object {name} here"
        case WrongType(name=name, expected=expected, actual=actual):
            is_one, takes = (f"{article(kind)} {kind}" for kind in (actual, expected))
            return f"{speech.thing(name)} is {is_one}, and this takes {takes}"
        case Unequal(left=left, right=right, positive=positive):
            both = f"{speech.thing(left)} and {speech.thing(right)}"
            return f"{both} must be the same" if positive else f"{both} cannot be the same"
        case Unmet(literal=literal):
            return speech.words.why_not([literal])

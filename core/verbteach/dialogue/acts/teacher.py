"""What the teacher can say and do, one frozen dataclass a kind."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from verbteach.world.fluents import Goal, Literal
from verbteach.world.plan import Action


@dataclass(frozen=True)
class Command:
    """What the robot should do, in English."""

    text: str
    name: ClassVar[str] = "command"


@dataclass(frozen=True)
class Yes:
    """Yes to the robot's question."""

    name: ClassVar[str] = "yes"


@dataclass(frozen=True)
class No:
    """No to the robot's question."""

    name: ClassVar[str] = "no"


@dataclass(frozen=True)
class Unsure:
    """The teacher does not know."""

    name: ClassVar[str] = "unsure"


@dataclass(frozen=True)
class Skip:
    """The teacher passes over the question, the demonstration or the judgement."""

    name: ClassVar[str] = "skip"


@dataclass(frozen=True)
class Say:
    """Free text; the robot reads it by what it waits for."""

    text: str
    name: ClassVar[str] = "say"


@dataclass(frozen=True)
class Point:
    """Pointing at an object."""

    object: str
    name: ClassVar[str] = "object"


@dataclass(frozen=True)
class Do:
    """One demonstrated action."""

    action: Action
    name: ClassVar[str] = "do"


@dataclass(frozen=True)
class Insert:
    """One more demonstrated action, which becomes step number ``at`` (from 1)."""

    at: int
    action: Action
    name: ClassVar[str] = "insert"


@dataclass(frozen=True)
class Remove:
    """The demonstrated steps from number ``first`` to number ``last`` were not meant."""

    first: int
    last: int
    name: ClassVar[str] = "remove"


@dataclass(frozen=True)
class Move:
    """The demonstrated step number ``at`` belongs at number ``to``."""

    at: int
    to: int
    name: ClassVar[str] = "move"


@dataclass(frozen=True)
class Done:
    """The demonstration is over."""

    name: ClassVar[str] = "done"


@dataclass(frozen=True)
class Good:
    """The execution, or the goal read back, is right."""

    name: ClassVar[str] = "good"


@dataclass(frozen=True)
class Bad:
    """The execution, or the goal read back, is wrong."""

    name: ClassVar[str] = "bad"


@dataclass(frozen=True)
class Stop:
    """Stop the execution after ``step`` of its steps (none given: at once)."""

    step: int = 0
    name: ClassVar[str] = "stop"


@dataclass(frozen=True)
class Strike:
    """The literal does not belong to the goal that was read back."""

    literal: Literal
    name: ClassVar[str] = "strike"


@dataclass(frozen=True)
class Keep:
    """The literal belongs to the goal that was read back."""

    literal: Literal
    name: ClassVar[str] = "keep"


@dataclass(frozen=True)
class RuleOut:
    """A fluent of a learned, lifted hypothesis is no part of what the verb frame asks for."""

    frame: str
    hypothesis: Goal
    literal: Literal
    name: ClassVar[str] = "rule_out"


@dataclass(frozen=True)
class Confirm:
    """A fluent of a learned, lifted hypothesis is part of what the verb frame asks for."""

    frame: str
    hypothesis: Goal
    literal: Literal
    name: ClassVar[str] = "confirm"


@dataclass(frozen=True)
class Show:
    """The teacher takes over and will demonstrate."""

    name: ClassVar[str] = "show"


@dataclass(frozen=True)
class GoToScene:
    """Go to another scene, found as it starts."""

    scene: str
    name: ClassVar[str] = "scene"

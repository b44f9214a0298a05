"""What the person says about the session rather than to the robot; none of it has a price."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, TypeAlias


@dataclass(frozen=True)
class Undo:
    """Take back the last act, or the last ``turns`` of them at once."""

    turns: int = 1
    name: ClassVar[str] = "undo"


@dataclass(frozen=True)
class Redo:
    """Do again what was taken back last, ``turns`` acts of it."""

    turns: int = 1
    name: ClassVar[str] = "redo"


@dataclass(frozen=True)
class Flag:
    """Mark the robot's turn as odd."""

    name: ClassVar[str] = "flag"


@dataclass(frozen=True)
class Note:
    """Write something down beside the turn."""

    text: str
    name: ClassVar[str] = "note"


@dataclass(frozen=True)
class Why:
    """Why do you ask?"""

    name: ClassVar[str] = "why"


@dataclass(frozen=True)
class Repeat:
    """Say that again."""

    name: ClassVar[str] = "repeat"


@dataclass(frozen=True)
class Quit:
    """Leave the session; it can be resumed."""

    name: ClassVar[str] = "quit"


SessionAct: TypeAlias = Undo | Redo | Flag | Note | Why | Repeat | Quit

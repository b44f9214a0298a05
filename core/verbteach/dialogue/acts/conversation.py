"""What both phases share: Table 2, acts 1 and 2, and what keeps the conversation going."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from typing import ClassVar


@dataclass(frozen=True)
class NpGrdWhq:
    """Table 2, act 1: which object is the noun phrase?"""

    np: str
    name: ClassVar[str] = "np_grd_whq"


@dataclass(frozen=True)
class NpGrdYnq:
    """Table 2, act 2: is the noun phrase this object?"""

    np: str
    object: str
    name: ClassVar[str] = "np_grd_ynq"


@dataclass(frozen=True)
class AwaitCommand:
    """The robot is ready for a command."""

    name: ClassVar[str] = "await_command"


@dataclass(frozen=True)
class StartClause:
    """The command had several clauses; the robot turns to this one."""

    clause: str
    name: ClassVar[str] = "start_clause"


@dataclass(frozen=True)
class AskRephrase:
    """The robot could not read the command; ``reason`` says why in words."""

    reason: str
    name: ClassVar[str] = "ask_rephrase"


@dataclass(frozen=True)
class AskAgain:
    """The robot could not read the answer to its question, and asks it once more."""

    reason: str
    name: ClassVar[str] = "ask_again"


class Outcome(Enum):
    """How an episode ended."""

    EXECUTED = "executed"
    LEARNED = "learned"
    UNJUDGED = "unjudged"
    ABANDONED = "abandoned"


@dataclass(frozen=True)
class CloseEpisode:
    """The episode is over; ``outcome`` is one of :class:`Outcome`."""

    outcome: Outcome
    name: ClassVar[str] = "close_episode"

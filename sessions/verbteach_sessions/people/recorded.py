"""A record as people's answers are read from it: what was said in the turns that hold."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from verbteach.dialogue.acts import TeacherAct
from verbteach.dialogue.codec import ActFormatError, teacher_act_from_json
from verbteach.dialogue.setting import Settings
from verbteach_sessions import events as kinds
from verbteach_sessions.content import ContentHash
from verbteach_sessions.errors import LogError
from verbteach_sessions.eventlog import LogReader
from verbteach_sessions.header import Header
from verbteach_sessions.history import History, Node
from verbteach_sessions.lines import Event
from verbteach_sessions.people.standing import Standing, opened, stepped
from verbteach_sessions.recomputing import EventError, check_fields


@dataclass(frozen=True)
class Said:
    """What the teacher said to a robot turn that holds, and how things stood around it.

    ``reply`` is the ``robot`` event that answers it, ``record`` what was learned.
    """

    event: Event
    act: TeacherAct
    before: Standing
    after: Standing
    reply: Event
    record: Mapping[str, Any] | None

    @property
    def seq(self) -> int:
        """The number of the teacher's event."""
        return self.event.seq


@dataclass(frozen=True)
class Recorded:
    """A session: its header, its turns that hold, and the hash of its content.

    ``opening`` are the robot's turns that reply to nobody.
    """

    header: Header
    opening: tuple[Event, ...]
    said: tuple[Said, ...]
    content_hash: str

    @property
    def person(self) -> str:
        """Who taught: the participant's code; without one the session stands for its person."""
        return self.header.participant or self.header.id

    def episodes(self) -> Iterator[tuple[Said, ...]]:
        """What was said from each command to the end of its episode, clause by clause."""
        under_way: list[Said] = []
        for one in self.said:
            under_way.append(one)
            if one.after.outcome is not None:
                yield tuple(under_way)
                under_way = []
        if under_way:
            yield tuple(under_way)


def read_recorded(path: Path, settings: Settings | None = None) -> Recorded:
    """Read a session; nothing is planned or recomputed.

    Without ``settings`` the worlds are not followed, which is quicker.

    Raises the errors of reading a log, and ``UnknownSceneError``.
    """
    reader, following = LogReader(path), _Following(settings)
    for event in reader:
        try:
            following.take(event)
        except UnknownEventError as error:
            raise LogError(reader.path, event.seq + 1, str(error)) from error
    return following.recorded()


def read_header(path: Path) -> Header:
    """A session's header. Raises the errors of reading a log."""
    reader = LogReader(path)
    first = next(iter(reader))
    try:
        check_fields(first)
        return Header.from_json(first.data)
    except ValueError as error:
        raise LogError(reader.path, 1, str(error)) from error


UnknownEventError = (EventError, ActFormatError, ValueError)
"""What is raised by an event that cannot be read."""


class _Following:
    def __init__(self, settings: Settings | None) -> None:
        self._settings = settings
        self._history = History()
        self._content = ContentHash()
        self._robots: dict[int, Event] = {}
        self._standings: dict[int, Standing] = {}

    def take(self, event: Event) -> None:
        check_fields(event)
        before, root = self._history.current, self._history.root
        teacher = self._history.teacher
        self._history.take(event)
        self._content.add(event)
        if event.type != kinds.ROBOT:
            return
        self._robots[event.seq] = event
        if root is not None:
            standing = opened(event.data, root.data["scene"], self._settings)
        elif before is not None and teacher is not None:
            act = teacher_act_from_json(teacher.data["act"])
            standing = stepped(self._standings[before.seq], act, event.data, self._settings)
        self._standings[event.seq] = standing

    def recorded(self) -> Recorded:
        header = self._history.header
        if header is None:
            raise RuntimeError("a log that was read has a header")
        nodes = self._history.effective()
        return Recorded(
            Header.from_json(header.data),
            tuple(self._robots[node.seq] for node in nodes if node.teacher is None),
            tuple(said for node in nodes for said in self._said(node)),
            self._content.hexdigest,
        )

    def _said(self, node: Node) -> Iterator[Said]:
        if node.teacher is not None and node.parent is not None:
            yield Said(
                node.teacher,
                teacher_act_from_json(node.teacher.data["act"]),
                self._standings[node.parent.seq],
                self._standings[node.seq],
                self._robots[node.seq],
                node.record,
            )

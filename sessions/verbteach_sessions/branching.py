"""A branch: a session of its own that shares another's events up to one of them.

Both histories stay. The branch's header names its parent and the line where it
left it; the events they share are the same but for the chain of hashes.
"""

from __future__ import annotations

import os
import shutil
from collections.abc import Callable, Iterator
from contextlib import ExitStack
from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

from verbteach_sessions import events as kinds
from verbteach_sessions.account import Account
from verbteach_sessions.errors import SessionError
from verbteach_sessions.eventlog import Draft, EventLog, LogReader
from verbteach_sessions.files import make_private_folder
from verbteach_sessions.header import Header, Parent
from verbteach_sessions.header_file import write_header
from verbteach_sessions.lines import Event
from verbteach_sessions.names import Now, Random, new_id, utc_now

_AT_ONCE = 256

Heard = Callable[[int], None]


class BranchError(SessionError):
    """There is no such event to branch from."""


class Branch(NamedTuple):
    """A new session: its folder, where it left its parent, and what both hold up to there."""

    path: Path
    parent: Parent
    content_hash: str


def branch(
    path: Path,
    folder: Path,
    at: int | None = None,
    *,
    heard: Heard = lambda _: None,
    now: Now = utc_now,
    random: Random = os.urandom,
) -> Branch:
    """Make a session in ``folder`` that begins as ``path`` did, up to event ``at``.

    Where somebody still owed a reply after that event, the branch ends before
    what was not replied to; without ``at`` it holds all. ``heard`` is told how
    many events were written. Raises the errors of reading a log,
    :class:`BranchError` and ``StorageError``; then there is no new session.
    """
    parent, content = _fork(path, at)
    moment = now()
    own_id = new_id(lambda: moment, random)
    new = folder / own_id
    make_private_folder(new)
    with ExitStack() as undoing:
        undoing.callback(shutil.rmtree, new, ignore_errors=True)
        log = EventLog.create(new)
        with ExitStack() as closing:
            closing.callback(log.close)
            own = _Own(own_id, moment.isoformat(timespec="seconds"), parent)
            header = _copy(LogReader(path), log, own, heard)
            write_header(new, header)
        undoing.pop_all()
    return Branch(new, parent, content)


class _Own(NamedTuple):
    """What a branch's header says of itself."""

    id: str
    created: str
    parent: Parent

    def header(self, event: Event) -> Event:
        old = Header.from_json(event.data)
        machine = replace(old.machine, created=self.created)
        header = replace(old, id=self.id, machine=machine, parent=self.parent)
        return replace(event, data=header.to_json())


def _fork(path: Path, at: int | None) -> tuple[Parent, str]:
    """The last event up to ``at`` after which nobody owed a reply, and the content up to it."""
    account = Account(path)
    reader, history = account.reader, account.history
    found: tuple[int, str, str] | None = None
    for event in _up_to(reader, at):
        account.take(event)
        if history.at_rest:
            found = event.seq, reader.position.prev, account.content.hexdigest
    if history.header is None or found is None:
        raise BranchError(f"{reader.path}: the robot had not spoken by event {at}")
    if at is not None and at >= reader.position.seq:
        raise BranchError(f"{reader.path}: there is no event {at}, only {reader.position.seq}")
    seq, line, content_hash = found
    return Parent(Header.from_json(history.header.data).id, seq, line), content_hash


def _copy(reader: LogReader, log: EventLog, own: _Own, heard: Heard) -> Event:
    """Write the shared events; the branch's header event."""
    drafts: list[Draft] = []
    header: Event | None = None
    for event in _up_to(reader, own.parent.seq):
        if event.type == kinds.HEADER:
            header = own.header(event)
        copied = header if header is not None and event.seq == 0 else event
        drafts.append(Draft(copied.type, copied.at, copied.data))
        if len(drafts) == _AT_ONCE or event.seq == own.parent.seq:
            log.append(drafts)
            drafts = []
            heard(event.seq + 1)
    if header is None or log.position.seq != own.parent.seq + 1:
        raise BranchError(f"{reader.path}: was written to while it was read; try again")
    return header


def _up_to(reader: LogReader, at: int | None) -> Iterator[Event]:
    for event in reader:
        yield event
        if event.seq == at:
            return

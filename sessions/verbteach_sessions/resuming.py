"""Opening a session again: refold it, repair what a crash left, and say what was done.

Where recomputing does not give what was recorded, the record is the authority:
what was learned is rebuilt from it, and the scene begins anew.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from pathlib import Path
from typing import NamedTuple

from verbteach.collecting import without_collecting
from verbteach.dialogue.setting import Settings
from verbteach_sessions import events as kinds
from verbteach_sessions.chain import BrokenChainError, Followed
from verbteach_sessions.checkpoints import Checkpoints, StaleCheckpointError
from verbteach_sessions.errors import LogError
from verbteach_sessions.eventlog import EventLog, Start, log_path
from verbteach_sessions.fold import Fold
from verbteach_sessions.header import Header, Machine
from verbteach_sessions.header_file import header_fits, write_header
from verbteach_sessions.lines import Event, canonical, digest
from verbteach_sessions.method import knowledge_of
from verbteach_sessions.recomputing import Difference, EventError, Recomputing
from verbteach_sessions.recorder import Recorder


class Reopened(NamedTuple):
    """A session that can go on: its recorder, and what to tell the person."""

    recorder: Recorder
    recovered: tuple[str, ...]


def reopen(
    path: Path, settings: Settings, machine: Machine, clock: Callable[[], float]
) -> Reopened:
    """Open a session for writing.

    Raises the errors of reading a log, ``SessionInUseError``, ``StorageError``
    ``UnknownSceneError`` and ``NoSecondReaderError``.
    """
    with without_collecting():
        past, log, warnings = _read(path, settings, machine)
    try:
        opened = clock() - past.last.at
        now = partial(_session_time, clock, opened)
        recorder = Recorder(log, past.fold, now, past.checkpoints)
        return Reopened(recorder, _repair(recorder, past, warnings, machine))
    except BaseException:
        log.close()
        raise


def _session_time(clock: Callable[[], float], opened: float) -> float:
    return round(clock() - opened, 4)


def _read(
    path: Path, settings: Settings, machine: Machine
) -> tuple[_Past, EventLog, tuple[str, ...]]:
    """Read from the last checkpoint on, or all where that does not serve."""
    past = _Past(path, settings, machine)
    try:
        return past, *EventLog.open(path, past.take, past.start)
    except (BrokenChainError, StaleCheckpointError):
        past = _Past(path, settings, machine)
        past.checkpoints.forget()
        return past, *EventLog.open(path, past.take)


class _Past:
    """Recomputes a log as it is read, holding back a ``learned`` event until its reply comes."""

    def __init__(self, path: Path, settings: Settings, machine: Machine) -> None:
        self._path = path
        self._recomputing = Recomputing(settings, brief=True)
        self._held: Event | None = None
        self._last: Event | None = None
        programs = {"Python": machine.python, **machine.software}
        self.checkpoints = Checkpoints(log_path(path), programs)

    def start(self) -> Start | None:
        """Where the last checkpoint stands, if there is one."""
        position = self.checkpoints.start()
        return Start(position, self._passed) if position.seq else None

    def _passed(self, followed: Followed) -> None:
        self.checkpoints.restore(self.fold, followed)
        fold = self.fold
        if fold.header.method.second_opinion:  # refuse now, not at the next command
            fold.header.method.settings(fold.settings)(fold.robot.state.scene)
        self._last = self.fold.history.last

    def take(self, event: Event) -> None:
        held, self._held, self._last = self._held, None, event
        if held is not None:
            self._fold_in(held)
        if event.type == kinds.LEARNED:
            self._held = event
        else:
            self._fold_in(event)

    @property
    def fold(self) -> Fold:
        return self._recomputing.fold

    @property
    def last(self) -> Event:
        if self._last is None:
            raise RuntimeError("a log holds at least one event")
        return self._last

    @property
    def cut_short(self) -> bool:
        """Whether the log ends between what was learned and the reply to it."""
        return self._held is not None

    @property
    def difference(self) -> Difference | None:
        """The first difference, if what was recomputed last does not stand."""
        return self._recomputing.difference if self._recomputing.diverged else None

    def _fold_in(self, event: Event) -> None:
        try:
            self._recomputing.take(event)
        except EventError as error:
            raise LogError(self._path, event.seq + 1, str(error)) from error


def _repair(
    recorder: Recorder, past: _Past, warnings: tuple[str, ...], machine: Machine
) -> tuple[str, ...]:
    history = past.fold.history
    if past.difference is not None:
        _check_rebuildable(recorder)
    if past.cut_short:
        recorder.log.take_back(recorder.log.before_last)
    said = [f"The record's {warning}." for warning in warnings]
    if history.teacher is not None and past.difference is None:
        said.append("Your last act had been kept but not answered; this is the answer to it.")
    if past.difference is not None:
        said.append(_excuse(past, machine))
    recorder.add(kinds.RESUME, {**machine.to_json(), "recovered": said})
    if history.header is not None and not header_fits(recorder.log.path.parent, history.header):
        write_header(recorder.log.path.parent, history.header)
    if past.difference is not None:
        _rebuild(recorder, past.difference)
    elif history.root is not None:
        recorder.begin(history.root)
    elif history.teacher is not None and (problem := recorder.answer(history.teacher)):
        said[-1] = f"Your last act had been kept but could not be answered: {problem}"
    return tuple(said)


def _excuse(past: _Past, machine: Machine) -> str:
    node, old = past.fold.history.current, past.fold.header
    scene = "the scene" if node is None else node.after["scene"]
    return (
        f"This session cannot be recomputed as it was recorded{_why(old, machine)}. All that I had"
        f" learned is kept from the record; {scene} begins anew, and what was said before cannot"
        " be undone."
    )


def _why(old: Header, new: Machine) -> str:
    def of(machine: Machine) -> Mapping[str, str]:
        return {"Python": machine.python, **machine.software}

    before, now = of(old.machine), of(new)
    names = old.changed_software(new.software)
    if old.machine.python != new.python:
        names = ("Python", *names)
    changed = [f"{name} {before.get(name, 'none')}, now {now.get(name, 'none')}" for name in names]
    return f" (it was made with {', '.join(changed)})" if changed else ""


def _rebuild(recorder: Recorder, difference: Difference) -> None:
    history = recorder.fold.history
    if history.teacher is not None:
        recorder.refuse(history.teacher, RuntimeError("the session was rebuilt; say it again"))
    node = history.current
    if node is None:
        raise RuntimeError("a recorded reply differs, so there is one")
    root = recorder.add(
        kinds.REBUILD,
        {"standing": node.seq, "scene": node.after["scene"], "difference": _short(difference)},
    )
    recorder.begin(root)


def _check_rebuildable(recorder: Recorder) -> None:
    """Raise what a rebuild would, before anything of it is written."""
    history, header = recorder.fold.history, recorder.fold.header
    scene = header.scene if history.current is None else history.current.after["scene"]
    recorder.fold.settings(scene)
    try:
        knowledge_of([*header.learned_before, *history.records()])
    except ValueError as error:
        raise LogError(recorder.log.path, 0, f"what was learned cannot be read, {error}") from error


def _short(difference: Difference) -> dict[str, object]:
    return {
        "seq": difference.seq,
        "field": difference.field,
        "recorded": digest(canonical(difference.recorded)),
        "recomputed": digest(canonical(difference.recomputed)),
    }

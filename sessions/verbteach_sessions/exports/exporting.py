"""Exporting sessions: read, redacted, written in a format, and noted in the register."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import asdict, dataclass, field, replace
from importlib import import_module
from pathlib import Path
from typing import Any

from verbteach import __version__
from verbteach.dialogue.setting import Settings
from verbteach_sessions.corpus.folder import corpus_of
from verbteach_sessions.corpus.redactions import Redactions
from verbteach_sessions.corpus.register import Contribution, register
from verbteach_sessions.errors import LogError, NotASessionError
from verbteach_sessions.exports.alias import alias
from verbteach_sessions.exports.dialogue import Dialogue
from verbteach_sessions.exports.errors import ExportError, NothingToExportError
from verbteach_sessions.exports.folder import new_folder, write_manifest
from verbteach_sessions.exports.formats import FORMATS, check_installed
from verbteach_sessions.exports.reading import read_dialogue
from verbteach_sessions.exports.sight import Depict

Heard = Callable[[int], None]


@dataclass(frozen=True)
class Request:
    """What to export: the folders of sessions, the format by name, where to.

    ``splits`` puts sessions, by their aliases, into parts of the corpus. Pages
    show scenes where ``settings`` and ``depict`` are given. With
    ``skip_damaged`` what cannot be read to its end is left out; else it stops
    the export.
    """

    sessions: tuple[Path, ...]
    to: str
    out: Path
    force: bool = False
    splits: Mapping[str, str] = field(default_factory=dict)
    settings: Settings | None = None
    depict: Depict | None = None
    skip_damaged: bool = False


@dataclass(frozen=True)
class LeftOut:
    """A session that could not be read, by its name, and why."""

    session: str
    reason: str


@dataclass(frozen=True)
class Exported:
    """What came of it. ``redacted`` counts texts that were replaced."""

    format: str
    out: Path
    files: tuple[str, ...]
    sessions: int
    turns: int
    participants: tuple[str, ...]
    redacted: int
    warnings: tuple[str, ...]
    left_out: tuple[LeftOut, ...] = ()

    def to_json(self) -> dict[str, Any]:
        """The fields, as plain values."""
        lists = {"files": list(self.files), "participants": list(self.participants)}
        lists |= {"warnings": list(self.warnings)}
        left_out = [asdict(one) for one in self.left_out]
        return {**vars(self), **lists, "out": str(self.out), "left_out": left_out}


def export(request: Request, heard: Heard = lambda done: None) -> Exported:
    """Make an export; ``heard`` is told how many sessions have been read.

    Either the whole export is there in the end or nothing is. Raises
    :class:`ExportError` and its kin, ``StorageError``, and the errors of reading.
    """
    check_installed(request.to)
    reading = _Reading(request, heard)
    module = import_module(f"verbteach_sessions.exports.{FORMATS[request.to].module}")
    more = () if request.to != "html" else (request.settings, request.depict)
    with new_folder(request.out, force=request.force) as folder:
        module.write(reading.dialogues(), folder, *more)
        write_manifest(folder, reading.manifest)
        files = tuple(
            path.relative_to(folder).as_posix()
            for path in sorted(folder.rglob("*"))
            if path.is_file()
        )
        reading.note_people()
    return Exported(
        format=request.to,
        out=request.out,
        files=files,
        sessions=reading.done,
        turns=reading.turns,
        participants=reading.participants,
        redacted=reading.redacted,
        warnings=tuple(reading.warnings),
        left_out=tuple(reading.left_out),
    )


class _Reading:
    """Reads one session after the other, and remembers what the export holds."""

    def __init__(self, request: Request, heard: Heard) -> None:
        self._request = request
        self._heard = heard
        self._redactions: dict[Path, Redactions] = {}
        self._contributions: list[Contribution] = []
        self._names: dict[str, Path] = {}
        self._codes: set[str] = set()
        self.turns = 0
        self.redacted = 0
        self.warnings: list[str] = []
        self.left_out: list[LeftOut] = []

    @property
    def done(self) -> int:
        return len(self._names)

    @property
    def participants(self) -> tuple[str, ...]:
        return tuple(sorted(self._codes))

    @property
    def manifest(self) -> dict[str, Any]:
        """What ``export.json`` says: enough to find a person's data again, and no time of day."""
        return {
            "format": self._request.to,
            "verbteach": __version__,
            "sessions": sorted(self._names),
            "participants": list(self.participants),
            "turns": self.turns,
            "redacted": self.redacted,
            "left_out": sorted(alias(one.session) for one in self.left_out),
        }

    def dialogues(self) -> Iterator[Dialogue]:
        for path in self._request.sessions:
            try:
                yield self._read(path)
            except (LogError, NotASessionError) as error:
                self._leave_out(path, error)
            self._heard(self.done + len(self.left_out))
        if self.left_out and not self.done:
            raise NothingToExportError(f"none of {len(self.left_out)} sessions can be read")

    def note_people(self) -> None:
        """Enter people's sessions in the register of each folder that they came from."""
        register(self._request.to, self._request.out, self._contributions)

    def _leave_out(self, path: Path, error: LogError | NotASessionError) -> None:
        if not self._request.skip_damaged:
            raise error
        self.left_out.append(LeftOut(path.name, str(error)))

    def _read(self, path: Path) -> Dialogue:
        folder = corpus_of(path)
        if folder not in self._redactions:
            self._redactions[folder] = Redactions.of(folder)
        redactions = self._redactions[folder]
        redactor = redactions.redactor(path.name)
        dialogue = read_dialogue(path, redactor)
        if dialogue.id in self._names:
            raise ExportError(f"{path}: is the same session as {self._names[dialogue.id]}")
        self._names[dialogue.id] = path
        self._remember(path, dialogue)
        self.redacted += redactor.count
        return replace(dialogue, split=self._request.splits.get(dialogue.id, dialogue.split))

    def _remember(self, path: Path, dialogue: Dialogue) -> None:
        self.turns += len(dialogue.turns)
        self.warnings += [f"{path.name}: {warning}" for warning in dialogue.warnings]
        self._contributions.append(Contribution(path, dialogue.participant, dialogue.teacher))
        if dialogue.participant is not None:
            self._codes.add(dialogue.participant)

"""A file of the corpus, line by line; every misfit becomes an error with its line."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import NoReturn

from verbteach_scenarios.tell_me_dave.documents import Oddity
from verbteach_scenarios.tell_me_dave.errors import CorpusError


@dataclass
class Lines:
    """A cursor over a text's lines. ``number`` counts the lines taken, so errors count from 1."""

    path: Path
    lines: list[str]
    oddities: list[Oddity]
    number: int = 0

    @classmethod
    def of(cls, path: Path) -> Lines:
        """Read a file; raise ``CorpusError`` where it cannot be read or is not UTF-8."""
        try:
            data = path.read_bytes()
        except OSError as problem:
            raise CorpusError(path, 0, f"cannot be read: {problem.strerror}") from problem
        try:
            text = data.decode("utf-8-sig")
        except UnicodeDecodeError as problem:
            line = data.count(b"\n", 0, problem.start) + 1
            raise CorpusError(path, line, "is not UTF-8 text") from problem
        return cls(path, text.replace("\r\n", "\n").split("\n"), [])

    def fail(self, reason: str, line: int = 0) -> NoReturn:
        """Raise the error of ``line``, or of the line taken last."""
        raise CorpusError(self.path, line or max(1, self.number), reason)

    def note(self, reason: str) -> None:
        """Remember something odd about the line taken last."""
        self.oddities.append(Oddity(self.path, self.number, reason))

    def blank(self) -> None:
        """Skip empty lines."""
        while self.number < len(self.lines) and not self.lines[self.number].strip():
            self.number += 1

    @property
    def finished(self) -> bool:
        """Whether every line has been taken."""
        return self.number >= len(self.lines)

    def take(self, wanted: str) -> str:
        """Take the next line, which must begin with ``wanted``; return the rest of it."""
        if self.finished:
            self.fail(f"the file ends where {wanted!r} should follow")
        line = self.lines[self.number]
        self.number += 1
        if not line.startswith(wanted):
            self.fail(f"{wanted!r} should stand here, not {_shortened(line)!r}")
        return line[len(wanted) :].strip()

    def take_until(self, wanted: str, stop: str) -> str:
        """Take ``wanted`` and the lines after it up to one that begins with ``stop``.

        A line in angle brackets is no running text: it must be ``stop``.
        """
        first = self.take(wanted)
        start = self.number
        while not self.finished and not self.lines[self.number].startswith((stop, "<")):
            self.number += 1
        return "\n".join([first, *self.lines[start : self.number]]).strip()

    def integer(self, wanted: str) -> int:
        """Take a line of ``wanted`` and a whole number."""
        text = self.take(wanted)
        try:
            return int(text)
        except ValueError:
            self.fail(f"{wanted!r} needs a whole number, not {_shortened(text)!r}")


def _shortened(text: str, width: int = 40) -> str:
    return text if len(text) <= width else text[: width - 3] + "..."

"""Reading a folder of the corpus: every ``N.instenv`` with its ``N.clauses``."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TypeAlias

from verbteach_scenarios.tell_me_dave import clauses, traces
from verbteach_scenarios.tell_me_dave.documents import Corpus, Document, Oddity
from verbteach_scenarios.tell_me_dave.errors import CorpusError

Progress: TypeAlias = Callable[[int, int], None]
"""Called with how many documents are done, and of how many."""


def read_corpus(folder: Path, progress: Progress | None = None) -> Corpus:
    """Read every document of ``folder``, in the order of their numbers.

    Other files are ignored, and those whose names begin with a dot: some
    computers leave such a one beside each file that they copy.

    Raise ``CorpusError`` for a folder without documents, for a document of
    which one file is missing, and for a file that is torn, with its line.
    """
    names = _names(folder)
    documents = []
    oddities: list[Oddity] = []
    for done, name in enumerate(names, start=1):
        document, odd = _document(folder, name)
        documents.append(document)
        oddities += odd
        if progress is not None:
            progress(done, len(names))
    return Corpus(folder, tuple(documents), tuple(oddities))


def _names(folder: Path) -> list[str]:
    try:
        found = (path for path in folder.iterdir() if not path.name.startswith("."))
        files = sorted(path for path in found if path.is_file())
    except OSError as problem:
        raise CorpusError(folder, 0, f"cannot be read: {problem.strerror}") from problem
    halves = {
        suffix: {path.stem for path in files if path.suffix == suffix}
        for suffix in (traces.SUFFIX, clauses.SUFFIX)
    }
    for suffix, other in ((traces.SUFFIX, clauses.SUFFIX), (clauses.SUFFIX, traces.SUFFIX)):
        for name in sorted(halves[suffix] - halves[other], key=_order):
            reason = f"has no {name}{other} beside it"
            raise CorpusError(folder / f"{name}{suffix}", 0, reason)
    if not halves[traces.SUFFIX]:
        reason = f"holds no document of the corpus (N{traces.SUFFIX} with N{clauses.SUFFIX})"
        raise CorpusError(folder, 0, reason)
    return sorted(halves[traces.SUFFIX], key=_order)


def _order(name: str) -> tuple[int, str]:
    """Sort by number; names that are no number come last."""
    return (int(name), name) if name.isdecimal() and name.isascii() else (1 << 62, name)


def _document(folder: Path, name: str) -> tuple[Document, tuple[Oddity, ...]]:
    trace = traces.read_trace(folder / f"{name}{traces.SUFFIX}")
    command = clauses.read_command(
        folder / f"{name}{clauses.SUFFIX}", len(trace.steps) - 1, trace.objects
    )
    document = Document(name, trace.objects, trace.steps, command.sentence, command.clauses)
    return document, trace.oddities + command.oddities

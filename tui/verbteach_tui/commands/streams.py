"""Where a command's words go: one JSON document or a person's text out, the rest to errors."""

from __future__ import annotations

import json
import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from shutil import get_terminal_size
from typing import TYPE_CHECKING, Any, Protocol

from verbteach_tui.standard_streams import is_unicode
from verbteach_tui.views.visible import visible

if TYPE_CHECKING:
    from rich.progress import TaskID


def emit(document: Any) -> None:
    """Print ``document`` as the one JSON document on standard output."""
    escaped = not is_unicode(sys.stdout)
    json.dump(document, sys.stdout, ensure_ascii=escaped, indent=2, allow_nan=False)
    print()


def tell(text: str = "") -> None:
    """Print lines that answer the person."""
    print(_visible(text))


def note(text: str) -> None:
    """Print a line beside the answer: a warning, or how to go on."""
    print(_visible(text), file=sys.stderr)


def _visible(text: str) -> str:
    return "\n".join(map(visible, text.split("\n")))


def columns(rows: Sequence[Sequence[object]]) -> str:
    """Rows as aligned columns without boxes; a column of numbers stands to the right.

    Where the first row is a heading and a terminal is too narrow for the
    widest one, each row becomes a few lines, with the heading before each cell.
    """
    made = [_column(column) for column in zip(*rows, strict=True)]
    lines = ["  ".join(line).rstrip() for line in zip(*made, strict=True)]
    if _has_heading(rows) and 0 < _room() < max(map(len, lines)):
        return "\n\n".join(columns([*zip(rows[0], row, strict=True)]) for row in rows[1:])
    return "\n".join(lines)


def _has_heading(rows: Sequence[Sequence[object]]) -> bool:
    return len(rows) > 1 and all(isinstance(cell, str) and cell.isupper() for cell in rows[0])


def _room() -> int:
    """The columns of the terminal that is written to; 0 where it is none."""
    return get_terminal_size((0, 0)).columns if sys.stdout.isatty() else 0


def _column(cells: Sequence[object]) -> list[str]:
    """The cells as texts of one width; the first may be a heading."""
    texts = [_cell(cell) for cell in cells]
    width = max(map(len, texts))
    numeric = len(cells) > 1 and all(_is_number(cell) for cell in cells[1:])
    return [text.rjust(width) if numeric else text.ljust(width) for text in texts]


def _cell(cell: object) -> str:
    if isinstance(cell, bool):
        return "yes" if cell else "no"
    return f"{cell:.3f}" if isinstance(cell, float) else str(cell)


def _is_number(cell: object) -> bool:
    return isinstance(cell, int | float) and not isinstance(cell, bool)


class Progress(Protocol):
    """Says how far something is."""

    def __call__(self, stage: str, done: int, total: int) -> None:
        """``done`` of ``total`` in this stage."""
        ...


@contextmanager
def progress() -> Iterator[Progress]:
    """A bar on standard error while the block runs, shown once it is told of a stage.

    Nothing is shown where standard error is no terminal.
    """
    from rich.console import Console
    from rich.progress import BarColumn, MofNCompleteColumn, TextColumn, TimeElapsedColumn
    from rich.progress import Progress as Bars

    console = Console(stderr=True)
    columns = (
        TextColumn("{task.description}", markup=False),
        BarColumn(),
        MofNCompleteColumn(),
        TimeElapsedColumn(),
    )
    bars = Bars(*columns, console=console, disable=not console.is_terminal, transient=True)
    tasks: dict[str, TaskID] = {}

    def show(stage: str, done: int, total: int) -> None:
        if stage not in tasks:
            tasks[stage] = bars.add_task(stage, total=total)
        bars.update(tasks[stage], completed=done, total=total)

    with bars:
        yield show


def counting(show: Progress, stage: str, total: int) -> Callable[[int], None]:
    """``show`` for one stage: it only needs to be told how much is done."""
    return lambda done: show(stage, done, total)

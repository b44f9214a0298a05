"""The standard streams of this process, whatever it was given for them.

One that was closed (``<&-``) is opened to nowhere: the next file to be opened
would be taken for it. One of an old encoding writes what it lacks as escapes.
"""

from __future__ import annotations

import os
import sys
from io import TextIOWrapper

TYPE_CHECKING = False  # typing would take a tenth of what `--version` may take
if TYPE_CHECKING:
    from typing import Final, Literal, TextIO

_STREAMS: Final[tuple[tuple[int, str, Literal["r", "w"]], ...]] = (
    (0, "stdin", "r"),
    (1, "stdout", "w"),
    (2, "stderr", "w"),
)


def prepare() -> None:
    """Have all three streams, of which the two that are written to take any text."""
    for descriptor, name, mode in _STREAMS:
        if getattr(sys, name) is None:
            setattr(sys, name, _nowhere(descriptor, mode))
    reconfigure = getattr(sys.stdout, "reconfigure", None)
    if reconfigure is not None:
        reconfigure(errors="backslashreplace")


def is_unicode(stream: TextIO) -> bool:
    """Whether any text can be written to ``stream`` as it is."""
    return (stream.encoding or "utf-8").lower().replace("_", "-") in {"utf-8", "utf8"}


def discard_output() -> None:
    """Let what is still to be written to standard output go nowhere: nobody can read it."""
    sys.stdout = _opened(os.open(os.devnull, os.O_WRONLY), "w")


def _nowhere(descriptor: int, mode: Literal["r", "w"]) -> TextIO:
    opened = os.open(os.devnull, os.O_RDWR)
    if opened != descriptor:
        os.dup2(opened, descriptor)
        os.close(opened)
    return _opened(descriptor, mode)


def _opened(descriptor: int, mode: Literal["r", "w"]) -> TextIO:
    return TextIOWrapper(open(descriptor, f"{mode}b", closefd=False), encoding="utf-8")

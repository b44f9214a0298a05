"""Names that are near a name that is not there, offered and never taken silently."""

from __future__ import annotations

from collections.abc import Sequence
from difflib import get_close_matches

from verbteach_tui.conclusion import WrongUseError


def known(name: str, names: Sequence[str], what: str) -> str:
    """``name``, if it is one of ``names``; else an error that offers those near it, or all."""
    if name in names:
        return name
    close = get_close_matches(name.lower(), names, n=3, cutoff=0.5)
    hint = f"did you mean {' or '.join(close)}?" if close else f"there are: {', '.join(names)}"
    raise WrongUseError(f"there is no {what} {name!r}; {hint}")

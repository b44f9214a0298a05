"""Examples of every command, as its help and the command reference show them."""

from __future__ import annotations

from collections.abc import Mapping

EXAMPLES: Mapping[str, tuple[str, ...]] = {
    "verbteach": (
        "verbteach",
        "verbteach teach --scene kitchen-1",
    ),
    "verbteach doctor": (
        "verbteach doctor",
        "verbteach doctor --json",
    ),
}


def epilog(command: str) -> str:
    """The examples of ``command`` as the end of its help text, line for line."""
    return "\n".join(("\b", "Examples:", *(f"  {line}" for line in EXAMPLES[command])))

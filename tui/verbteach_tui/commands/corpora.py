"""What the evaluations say about the folders they read."""

from __future__ import annotations

from typing import TYPE_CHECKING

from verbteach_tui.commands.streams import note

if TYPE_CHECKING:
    from verbteach_scenarios.grounds import EvaluationData


def tell_left_out(data: EvaluationData) -> None:
    """Warn of documents that are not learned from because they are to be tested on."""
    if data.left_out:
        count = len(data.left_out)
        documents = "1 document is" if count == 1 else f"{count} documents are"
        first = ", ".join(data.left_out[:3]) + (", ..." if count > 3 else "")
        note(f"warning: {documents} in both folders ({first}): tested on and not learned from")

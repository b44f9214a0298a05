"""Text from people made safe to show, and cut where it is too long for a screen."""

from __future__ import annotations

from verbteach_sessions.visible import visible

__all__ = ["LONGEST", "shortened", "visible"]

LONGEST = 600


def shortened(text: str, longest: int = LONGEST) -> str:
    """``visible`` text, cut after ``longest`` characters with the number of those left out."""
    shown = visible(text)
    if len(shown) <= longest:
        return shown
    return f"{shown[:longest]} … ({len(shown) - longest:,} more characters)"

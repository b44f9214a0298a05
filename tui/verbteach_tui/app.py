"""The full-screen app: starts it, and holds what all its screens share."""

from __future__ import annotations

from verbteach_tui.options import AppOptions


def run_app(options: AppOptions) -> int:
    """Run the app until the person leaves it; answers the exit status.

    Sessions that it opened are closed when it returns. Needs a terminal: the
    caller has made sure that standard input and output are one.
    """
    raise NotImplementedError(options)

"""The way in: answers what must be quick by itself and hands the rest to the commands.

Typer takes about 100 ms to import, more than `--version` may take as a whole,
so this file imports nothing that costs time.
"""

from __future__ import annotations

import os
import sys

from verbteach import __version__
from verbteach_tui.conclusion import concluded
from verbteach_tui.standard_streams import prepare

# Set by a shell that asks for completions, and then there are no words on the command line.
COMPLETION_VARIABLE = "_VERBTEACH_COMPLETE"


def main(words: list[str] | None = None) -> int:
    """Run the command line in ``words`` (as given to the process without any); the exit status."""
    words = sys.argv[1:] if words is None else words
    prepare()
    if words == ["--version"]:
        return concluded(lambda: print(f"verbteach {__version__}"))
    from verbteach_tui.workers import one_thread

    one_thread()
    if not words and COMPLETION_VARIABLE not in os.environ:
        from verbteach_tui.commands.home import home

        return concluded(home)
    from verbteach_tui.commands.tree import run

    return run(words)

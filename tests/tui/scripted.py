"""A lesson by a script on standard input, as the commands about sessions are tested with."""

from __future__ import annotations

from pathlib import Path

from tests.tui.commandline import Ran, here

SCRIPT = """
# the first lesson
command: fetch the kettle
do: moveto Kettle_1
do: grasp Kettle_1
done
good
note: that went well
"""


def taught(script: str, sessions: Path, *more: object) -> Ran:
    """Teach from standard input in the first kitchen."""
    words = ("teach", "--teacher", "-", "--scene", "kitchen-1", "--sessions", sessions)
    return here(*words, "--json", *more, typed=script)

"""What can be wrong with a file that describes a world: which file, which line, why."""

from __future__ import annotations

from pathlib import Path


class WorldFileError(ValueError):
    """A file that describes a world does not fit.

    ``line`` counts from 1; it is 0 where the file as a whole is meant.
    """

    def __init__(self, path: Path, line: int, reason: str) -> None:
        self.path = path
        self.line = line
        self.reason = reason
        place = f"{path}:{line}" if line else str(path)
        super().__init__(f"{place}: {reason}")


class DomainFileError(WorldFileError):
    """A PDDL domain file does not fit."""


class SceneFileError(WorldFileError):
    """A PDDL problem file, or what else describes one scene, does not fit."""

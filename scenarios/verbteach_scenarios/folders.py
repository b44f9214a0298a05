"""Where worlds lie: a folder with a domain and scenes in PDDL, and what describes them in TOML.

A user's folder looks like the bundled one. One without a ``domain.pddl`` of
its own holds scenes of the bundled household domain.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

from verbteach_scenarios.errors import SceneFileError

BUNDLED = Path(__file__).parent / "data" / "household"

DOMAIN = "domain"


@dataclass(frozen=True)
class WorldFolder:
    """A folder of scenes; ``path`` exists."""

    path: Path

    @property
    def domain_home(self) -> Path:
        """The folder that the domain comes from."""
        own = (self.path / f"{DOMAIN}.pddl").is_file()
        return self.path if own else BUNDLED

    @property
    def scene_ids(self) -> tuple[str, ...]:
        """The names of the problem files, numbers in them in counting order."""
        stems = (p.stem for p in self.path.glob("*.pddl") if p.is_file())
        return tuple(sorted((s for s in stems if s != DOMAIN), key=_counting))

    def problem(self, scene_id: str) -> Path:
        """The PDDL file of a scene."""
        return self.path / f"{scene_id}.pddl"

    def sidecar(self, scene_id: str) -> Path:
        """The TOML file that may lie beside it."""
        return self.path / f"{scene_id}.toml"

    def compiled(self, scene_id: str) -> Path:
        """The compiled file that may lie under it."""
        return self.path / "compiled" / f"{scene_id}.json"


def world_folder(folder: Path | None) -> WorldFolder:
    """The user's folder, or the bundled one; raise ``SceneFileError`` where it is none."""
    if folder is None:
        return WorldFolder(BUNDLED)
    if not folder.is_dir():
        raise SceneFileError(folder, 0, "there is no such folder of scenes")
    return WorldFolder(folder)


def _counting(name: str) -> tuple[tuple[int, str], ...]:
    """``kitchen-2`` before ``kitchen-10``."""
    parts = re.findall(r"\d+|\D+", name)
    return tuple((int(part), "") if part.isdecimal() else (-1, part) for part in parts)

"""Writes the diagrams and tables of architecture.md from the code's own tables.

`python docs/diagrams.py` rewrites the marked blocks; `--check` only says
whether they are current. What a block shows is never edited by hand.
"""

from __future__ import annotations

import ast
import itertools
import re
import sys
import tomllib
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import Any

from verbteach.dialogue.moves import ROBOT_MOVES, TEACHER_MOVES, Phase
from verbteach.dialogue.rewards import Rewards

ROOT = Path(__file__).resolve().parent.parent
ROOMS = ("core", "scenarios", "sessions", "tui")
PAGE = ROOT / "docs" / "architecture.md"
_BLOCK = re.compile(r"(<!-- generated: (?P<name>[a-z ]+) -->\n).*?(<!-- end -->)", re.DOTALL)


def layers() -> str:
    """Every layering contract as a chain: what stands higher may import what stands lower."""
    config = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))
    contracts = config["tool"]["importlinter"]["contracts"]
    chains = [_chain(contract) for contract in contracts if contract["type"] == "layers"]
    return _mermaid("flowchart LR", [line for chain in chains for line in chain])


def _chain(contract: Mapping[str, Any]) -> list[str]:
    rows = [re.split(r"\s*[:|]\s*", layer) for layer in contract["layers"]]
    lines = [f'    subgraph "{contract["name"].split(":")[0]}"', "        direction LR"]
    lines += [f"        {_node(module)}" for row in rows for module in row]
    for above, below in itertools.pairwise(rows):
        lines += [f"        {_id(a)} --> {_id(b)}" for a in above for b in below]
    return [*lines, "    end"]


def _node(module: str) -> str:
    return f'{_id(module)}["{module.rsplit(".", maxsplit=1)[-1]}"]'


def _id(module: str) -> str:
    return module.replace(".", "_") + "_layer"


def packages() -> str:
    """Every package with what its own first line says of it."""
    folders = [path.parent for room in ROOMS for path in sorted((ROOT / room).rglob("__init__.py"))]
    rows = [(f"`{_dotted(folder)}`", _summary(folder / "__init__.py")) for folder in folders]
    return _table(("package", "what it is"), rows)


def _dotted(folder: Path) -> str:
    return ".".join(folder.relative_to(ROOT).parts[1:])


def _summary(file: Path) -> str:
    doc = ast.get_docstring(ast.parse(file.read_text("utf-8"))) or ""
    return " ".join(doc.split("\n\n")[0].split()).replace("``", "`")


def phases() -> str:
    """What the robot waits for, and which teacher acts may lead where."""
    labels: dict[tuple[Phase, Phase], list[str]] = {}
    for phase, moves in TEACHER_MOVES.items():
        for act, following in moves.items():
            for after in following:
                labels.setdefault((phase, after), []).append(act.name)
    lines = [f"    [*] --> {next(iter(Phase)).value}"]
    lines += [
        f"    {before.value} --> {after.value}: {', '.join(names)}"
        for (before, after), names in labels.items()
    ]
    return _mermaid("stateDiagram-v2", lines)


def moves() -> str:
    """For each phase, the robot's acts that bring it about and the teacher's that fit."""
    rows = [
        (
            f"`{phase.value}`",
            _names(act.name for act in ROBOT_MOVES[phase]),
            _names(act.name for act in TEACHER_MOVES[phase]),
        )
        for phase in Phase
    ]
    return _table(("the robot waits for", "after it said", "the teacher may"), rows)


def prices() -> str:
    """What each of the robot's acts costs or earns."""
    rows = [(f"`{act}`", f"{yes:g}", f"{no:g}") for act, (yes, no) in Rewards().prices.items()]
    return _table(("act", "answered yes", "answered otherwise"), rows)


BLOCKS: Mapping[str, Callable[[], str]] = {
    "layers": layers,
    "packages": packages,
    "phases": phases,
    "moves": moves,
    "prices": prices,
}


def _names(names: Iterable[str]) -> str:
    return ", ".join(f"`{name}`" for name in names)


def _mermaid(kind: str, lines: list[str]) -> str:
    return "\n".join(("```mermaid", kind, *lines, "```"))


def _table(head: tuple[str, ...], rows: Iterable[tuple[str, ...]]) -> str:
    lines = [head, ("---",) * len(head), *rows]
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)


def current(page: str) -> str:
    """``page`` with every marked block written anew; a block of unknown name is a KeyError."""
    return _BLOCK.sub(lambda m: f"{m[1]}\n{BLOCKS[m['name']]()}\n\n{m[3]}", page)


def main(words: list[str]) -> int:
    """Rewrite the page, or with ``--check`` answer 1 where it is stale."""
    page = PAGE.read_text("utf-8")
    if words == ["--check"]:
        return int(page != current(page))
    PAGE.write_text(current(page), "utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

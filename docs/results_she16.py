"""Put a grid's tables on the page about learning from demonstrations.

`python docs/results_she16.py GRID`, where GRID is what
`verbteach evaluate --grid --data DIR --out GRID` wrote.
"""

from __future__ import annotations

import sys
from pathlib import Path

PAGE = Path(__file__).with_name("results-she16.md")
PARTS = {"grid": "grid.md", "errors": "errors.md"}


def filled(page: str, name: str, text: str) -> str:
    """The page with the text between the part's two marks."""
    first, last = f"<!-- {name} -->\n", f"<!-- end of {name} -->"
    before, _, rest = page.partition(first)
    _, found, after = rest.partition(last)
    if not found:
        raise SystemExit(f"{PAGE.name} has no part {name!r}")
    return f"{before}{first}\n{text.strip()}\n\n{last}{after}"


def main(folder: Path) -> None:
    """Fill both parts from the folder."""
    page = PAGE.read_text("utf-8")
    for name, file in PARTS.items():
        page = filled(page, name, (folder / file).read_text("utf-8"))
    PAGE.write_text(page, "utf-8")


if __name__ == "__main__":
    main(Path(sys.argv[1]))

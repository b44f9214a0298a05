"""Put the mistakes of a robot that asks on the page of results.

`python docs/results_asking.py PERFECT STD3`, where each folder is what
`verbteach evaluate --policy rl --mistakes --data DIR --noise NOISE --out FOLDER` wrote.
"""

from __future__ import annotations

import re
import sys
from pathlib import Path

PAGE = Path(__file__).with_name("results.md")
TABLES_END = "**By verb**"


def filled(page: str, name: str, text: str) -> str:
    """The page with the text between the part's two marks."""
    marks = re.compile(rf"(?<=<!-- {name} -->\n).*?(?=<!-- end of {name} -->)", re.DOTALL)
    page, found = marks.subn(lambda _: f"\n{text.strip()}\n\n", page)
    if found != 1:
        raise SystemExit(f"{PAGE.name} has {found} parts {name!r}")
    return page


def main(perfect: Path, noisy: Path) -> None:
    """Fill both parts: all of the first, and the tables of the second."""
    page = PAGE.read_text("utf-8")
    page = filled(page, "mistakes", (perfect / "mistakes.md").read_text("utf-8"))
    tables, _, _ = (noisy / "mistakes.md").read_text("utf-8").partition(TABLES_END)
    PAGE.write_text(filled(page, "mistakes under noise", tables), "utf-8")


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))

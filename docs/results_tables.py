"""Put the tables of a reproduction on the page of results.

`python docs/results_tables.py MAIN BESIDE ALL`, where each folder is what
`verbteach reproduce` wrote with `--out`: the paper's tables, what is reported
beside them (`--with phantom --with paper-prices --with harder-teacher`), and
every environment held out in turn (`--folds all`). The curves of the first go
to the pictures.
"""

from __future__ import annotations

import re
import shutil
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent.parent))

from docs.results_asking import PAGE, filled

IMAGES = PAGE.with_name("images")
PICTURES = ("figure5.svg", "questions.svg")
LISTED = ("Figure 5", "SJI against questions asked")
"""Sections that the pictures say better."""


def sections(folder: Path) -> dict[str, str]:
    """The tables by their titles, and first the line that says what was run."""
    text = (folder / "tables.md").read_text("utf-8").removeprefix("# Reproduction\n\n")
    first, *rest = re.split(r"^## ", text, flags=re.MULTILINE)
    parts = (part.partition("\n") for part in rest)
    return {"": first.strip(), **{title: body.strip() for title, _, body in parts}}


def main(folder: Path, beside: Path, in_turn: Path) -> None:
    """Fill the three parts and copy the pictures."""
    own = sections(folder)
    page = PAGE.read_text("utf-8")
    shown = {t: b for t, b in own.items() if t not in LISTED}
    page = filled(page, "tables", _text(shown))
    page = filled(page, "beside", _text(_without(sections(beside), own)))
    page = filled(page, "one in turn", _text(_retitled(sections(in_turn))))
    PAGE.write_text(page, "utf-8")
    for name in PICTURES:
        shutil.copyfile(folder / name, IMAGES / name)


def _without(all_of: dict[str, str], known: dict[str, str]) -> dict[str, str]:
    return {title: body for title, body in all_of.items() if not title or title not in known}


def _retitled(all_of: dict[str, str]) -> dict[str, str]:
    """No two parts of a page have one title."""
    return {title and f"{title}, each environment in turn": body for title, body in all_of.items()}


def _text(parts: dict[str, str]) -> str:
    """The sections one level lower than they were, as a part of a page."""
    lower = (
        f"### {title}\n\n{body.replace('### ', '#### ')}" if title else body
        for title, body in parts.items()
    )
    return "\n\n".join(lower)


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))

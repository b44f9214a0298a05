"""Every command that a page prints can be given as it is printed: its words and options exist."""

from __future__ import annotations

import re
import shlex
from collections.abc import Iterator
from pathlib import Path

import pytest

from docs.diagrams import ROOT
from tests.tui.test_cli_contract import commands, options_of

PAGES = [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]
KNOWN = {tuple(name.split()): options_of(command) for name, command in commands()}
FENCED = re.compile(r"^```[a-z]*\n(.*?)^```", re.M | re.S)
TOP = {"--help", "--version", "--install-completion", "--show-completion"}


def printed(page: Path) -> Iterator[list[str]]:
    """The words after ``verbteach`` of each command on a page, in a block or in a line."""
    text = page.read_text("utf-8")
    blocks = [line for block in FENCED.findall(text) for line in block.splitlines()]
    for code in [*blocks, *re.findall(r"`([^`\n]+)`", FENCED.sub("", text))]:
        for part in re.split(r"&&|\||;", code):
            found = re.match(r"\s*(?:\$ )?(?:\S*/)?verbteach(?:\s+(.*))?$", part)
            if found and "..." not in part and "[" not in part:
                yield shlex.split(found[1] or "", comments=True)


def unknown(words: list[str]) -> list[str]:
    """What of a command there is not."""
    names = [name for name in KNOWN if tuple(words[: len(name)]) == name]
    options = {word.partition("=")[0] for word in words if word.startswith("--")}
    if names:
        return sorted(options - KNOWN[max(names, key=len)])
    groups = {name[0] for name in KNOWN if len(name) > 1}
    begins = not words or words[0].startswith("-") or words[0].isupper()
    begins = begins or (len(words) == 1 and words[0] in groups)
    return sorted(options - TOP) if begins else words[:2]


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_every_command_on_a_page_is_one(page: Path) -> None:
    assert {" ".join(words): unknown(words) for words in printed(page) if unknown(words)} == {}


def test_the_pages_do_print_commands() -> None:
    assert sum(1 for page in PAGES for _ in printed(page)) > 40
    assert unknown(["study", "chekc", "x.toml"])
    assert unknown(["teach", "--no-such-option"])

"""The command reference names every command, option and JSON key that there is, and no other."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any, get_args

import pytest

from docs.diagrams import ROOT
from tests.tui.commandline import here
from tests.tui.test_cli_contract import commands, options_of
from verbteach_sessions.script import PREFIXES, WORDS
from verbteach_tui.commands.sessions_export import FormatName
from verbteach_tui.commands.train import LearnerName

PAGE = ROOT / "docs" / "commands.md"
SECTION = re.compile(r"^## `verbteach(?P<name>[a-z -]*)`\n(?P<text>.*?)(?=^## |\Z)", re.M | re.S)
OPTION = re.compile(r"^\| (`--.*?`) \|", re.M)
SCRIPT = re.compile(r"^## A teacher's script\n.*?```\n(.*?)```", re.M | re.S)
HELP = {"--help", "-h"}


def sections() -> dict[str, str]:
    """The text of each command's section, by its words after ``verbteach``."""
    return {m["name"].strip(): m["text"] for m in SECTION.finditer(PAGE.read_text("utf-8"))}


def documented_options(text: str) -> set[str]:
    """The options in the first column of a section's table."""
    cells = OPTION.findall(text)
    return {spelling for cell in cells for spelling in re.findall(r"--[a-z][a-z-]*", cell)}


def test_every_command_has_its_section_and_no_section_is_left_over() -> None:
    assert set(sections()) == {"", *(name for name, _ in commands())}


@pytest.mark.parametrize(("name", "command"), list(commands()))
def test_every_option_stands_in_the_table_and_no_other(name: str, command: Any) -> None:
    assert documented_options(sections()[name]) == options_of(command) - HELP


@pytest.mark.parametrize(
    ("name", "option", "choices"),
    [("train", "--learner", LearnerName), ("sessions export", "--to", FormatName)],
)
def test_what_grows_has_all_its_names_in_the_table(name: str, option: str, choices: Any) -> None:
    (named,) = re.findall(rf"^\| `{option} ([^`]+)`", sections()[name], re.M)
    assert sorted(named.split("\\|")) == sorted(get_args(choices))


def keys(document: Any) -> Iterator[str]:
    """The names of a document's members, and of the first of each list of objects."""
    if isinstance(document, list):
        yield from keys(document[0]) if document else ()
    elif isinstance(document, dict):
        for name, value in document.items():
            yield name
            yield from keys(value) if isinstance(value, list) else ()


def documented_keys(name: str) -> set[str]:
    """What the command's row for ``--json`` names."""
    (row,) = re.findall(r"^\| `--json` \|(.*)\|$", sections()[name], re.M)
    return set(re.findall(r"`([a-z_0-9]+)`", row))


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("scenes list", ()),
        ("scenes show", ("kitchen-1",)),
        ("scenes check", ()),
        ("parse", ("put the mug on the table",)),
        ("doctor", ()),
    ],
)
def test_every_key_is_documented(name: str, words: tuple[str, ...]) -> None:
    document = here(*name.split(), *words, "--json").document
    assert set(keys(document)) <= documented_keys(name)


WITH_A_PROMISE = {"promise", "rate", "sure", "lessons"}
"""What `teach` reports of a promise, where one was made."""


def test_every_key_about_sessions_is_documented(tmp_path: Path) -> None:
    lesson = "command: fetch the kettle\nskip\n"
    words = ("teach", "--teacher", "-", "--sessions", tmp_path, "--json")
    taught = here(*words, typed=lesson).document
    assert set(keys(taught)) == documented_keys("teach") - WITH_A_PROMISE
    session = taught["session"]
    for name, more in (
        ("replay", (session,)),
        ("sessions list", ("--sessions", tmp_path)),
        ("sessions show", (session,)),
        ("sessions validate", (tmp_path,)),
    ):
        document = here(*name.split(), *more, "--json").document
        assert set(keys(document)) <= documented_keys(name)


def test_the_script_on_the_page_is_read_by_the_parser() -> None:
    (block,) = SCRIPT.findall(PAGE.read_text("utf-8"))
    said = {word.strip() for line in block.splitlines() for word in line.split("#")[0].split("|")}
    named = {word.split(":")[0] for word in said if word and not word.startswith("<")}
    assert named == {*WORDS, *PREFIXES} - {"say"}

"""Names, options and JSON keys that others rely on: added to freely, never renamed.

The table has the rows of the contract whose commands this version has; a
command that comes later gets its row when it comes.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

import pytest

from verbteach_tui.commands.tree import command_line

OPTIONS: Mapping[str, str] = {
    "teach": "--scene --teacher --lessons --plain --noise --noise-reading --policy --from"
    " --participant --study --seed --sessions --resume --json",
    "replay": "--verify --to --speed --plain --policy --json",
    "train": "--data --from --noise --learner --episodes --seed --out --json",
    "reproduce": "--noise-reading --grounding --data --test-data --runs --seed --jobs --cluster"
    " --resume --out --json",
    "sessions list": "--json",
    "sessions show": "--json",
    "sessions validate": "--json",
    "sessions export": "--to --out --force --splits --skip-damaged --json",
    "sessions branch": "--at --sessions --json",
    "sessions fit": "--out --check --json",
    "sessions example": "--out --jobs --seed --json",
    "sessions evaluate-policy": "--policy --weights --minimum --seed --json",
    "sessions stats": "--json",
    "sessions scan": "--names --redact --keep --json",
    "sessions withdraw": "--sessions --yes --json",
    "sessions split": "--out --train --validation --test --seed --json",
    "sessions datasheet": "--out --json",
    "sessions release": "--datasheet --splits --names --json",
    "evaluate": "--policy --noise --noise-reading --grounding --data --test-data --runs"
    " --criterion --objects --mistakes --out --json",
    "benchmark check": "--json",
    "scenes list": "--scenes --json",
    "scenes show": "--scenes --json",
    "scenes check": "--scenes --json",
    "lessons list": "--lessons --json",
    "lessons check": "--lessons --json",
    "parse": "--scene --json",
    "bench": "--peers --json",
    "serve": "--host --port --tokens --study",
    "study new": "--json",
    "study check": "--json",
    "study status": "--sessions --json",
    "study answers": "--sessions --out --json",
    "study tokens": "--count --json",
    "doctor": "--json",
}


def commands() -> Iterator[tuple[str, Any]]:
    """Every command that does something, by its words after ``verbteach``."""

    def below(group: Any, path: tuple[str, ...]) -> Iterator[tuple[str, Any]]:
        for name, command in group.commands.items():
            if hasattr(command, "commands"):
                yield from below(command, (*path, name))
            else:
                yield " ".join((*path, name)), command

    return below(command_line(), ())


def options_of(command: Any) -> set[str]:
    """All spellings of a command's options."""
    spellings = {
        spelling
        for parameter in command.params
        for spelling in (*parameter.opts, *parameter.secondary_opts)
    }
    return {spelling for spelling in spellings if spelling.startswith("-")}


@pytest.mark.parametrize("name", OPTIONS)
def test_the_command_is_there_with_its_options(name: str) -> None:
    command = dict(commands())[name]
    assert set(OPTIONS[name].split()) <= options_of(command)


def test_every_command_has_a_row() -> None:
    assert {name for name, _ in commands()} == set(OPTIONS)


@pytest.mark.parametrize("name", OPTIONS)
def test_every_option_says_what_it_does(name: str) -> None:
    for parameter in dict(commands())[name].params:
        if parameter.opts[0].startswith("--"):
            assert parameter.help, (name, parameter.opts)

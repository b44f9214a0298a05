"""Options that several commands share, so that they read the same everywhere."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Annotated, Literal

import typer

from verbteach_tui.commands.session_names import session_completions, session_named
from verbteach_tui.conclusion import WrongUseError
from verbteach_tui.eyes import NOISE, noise_names, noise_text

SEEDS = 2**63
"""How many seeds there are, from 0 on."""


def scene_names(incomplete: str) -> list[str]:
    """The bundled scenes whose names begin so, for the shell's completion."""
    from verbteach_scenarios.scenes import scene_ids

    return [name for name in scene_ids() if name.startswith(incomplete)]


def policy_names(incomplete: str) -> list[str]:
    """The question policies whose names begin so, for the shell's completion."""
    return [
        name for name in ("rl", "manual", "random", "split", "she16") if name.startswith(incomplete)
    ]


def chosen(values: Sequence[str], choices: Sequence[str], option: str) -> None:
    """Refuse what is none of an option's choices; Typer checks no lists itself."""
    for value in values:
        if value not in choices:
            raise WrongUseError(f"{option} {value}: there are {', '.join(choices)}")


def to_be_written(file: Path) -> None:
    """Refuse a file that could not be written once the long work for it is done."""
    from verbteach_tui.installation import is_writable

    if file.is_dir():
        raise WrongUseError(f"{file}: is a folder; name a file in it")
    folder = file.absolute().parent
    if not folder.is_dir():
        raise WrongUseError(f"{folder}: there is no such folder")
    if not is_writable(folder):
        raise WrongUseError(f"{folder}: cannot be written to")


def seed_of(text: str | int) -> int:
    """The seed that was typed. A range of 19 digits in the help would tell nobody anything."""
    try:
        seed = int(text)
    except ValueError:
        raise typer.BadParameter(f"{text!r} is no whole number.") from None
    if not 0 <= seed < SEEDS:
        raise typer.BadParameter(f"{seed} is not from 0 to {SEEDS - 1}.")
    return seed


JsonFlag = Annotated[
    bool, typer.Option("--json", help="Print exactly one JSON document on standard output.")
]
ScenesFolder = Annotated[
    Path | None,
    typer.Option("--scenes", metavar="DIR", help="Take scenes from this folder, not the bundled."),
]
SceneOption = Annotated[
    str | None,
    typer.Option("--scene", metavar="ID", help="The scene.", autocompletion=scene_names),
]
SessionArgument = Annotated[
    Path,
    typer.Argument(
        metavar="SESSION",
        parser=session_named,
        autocompletion=session_completions,
        help="A session's folder, its events.jsonl, or its name in your own folder.",
    ),
]
SessionsFolder = Annotated[
    Path | None,
    typer.Option(
        "--sessions",
        metavar="FOLDER",
        help="The folder of sessions (else VERBTEACH_SESSIONS, else your data folder).",
    ),
]
NoiseOption = Annotated[
    str | None,
    typer.Option(
        "--noise",
        metavar=NOISE,
        parser=noise_text,
        autocompletion=noise_names,
        help="How unreliable the robot's eyes are (perfect): a level, or a spread such as 0.2;"
        " kinds of fluents may have their own, as in std3,on=perfect.",
    ),
]
NoiseReading = Annotated[
    Literal["literal", "phantom"] | None,
    typer.Option("--noise-reading", help="How the noise is read (literal)."),
]
PolicyOption = Annotated[
    str | None,
    typer.Option(
        "--policy",
        metavar="NAME",
        autocompletion=policy_names,
        help="How it asks: rl, manual, random, split or she16 (rl; she16 for scripts and pipes).",
    ),
]
WeightsOption = Annotated[
    Path | None,
    typer.Option("--weights", metavar="FILE", help="Weights of verbteach train, for --policy rl."),
]
ThemeOption = Annotated[
    str | None, typer.Option("--theme", metavar="NAME", help="The screen's colours (evening).")
]
SeedOption = Annotated[
    int | None,
    typer.Option("--seed", metavar="N", parser=seed_of, help="The seed of all draws (0)."),
]

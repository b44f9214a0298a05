"""What ``--noise`` says of the robot's eyes, read before the work begins.

Imports the noise model only when there is something to read: the command line
is built faster without it.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

import typer

from verbteach_tui.conclusion import WrongUseError

if TYPE_CHECKING:
    from verbteach.perception.noise import NoiseModel
    from verbteach.world.domain import Domain

NOISES = ("perfect", "std3", "std5", "uniform")
NOISE = f"{'|'.join(NOISES)}|SPREAD"


def noise_text(text: str) -> str:
    """What ``--noise`` says, when it says something."""
    from verbteach.perception.noise import NoiseModel

    try:
        NoiseModel.named(text)
    except ValueError as error:
        raise typer.BadParameter(str(error)) from error
    return text


def noise_names(incomplete: str) -> list[str]:
    """The noise levels whose names begin so, for the shell's completion."""
    return [name for name in NOISES if name.startswith(incomplete)]


def check_kinds(noise: NoiseModel, domains: Iterable[Domain]) -> None:
    """Refuse noise of a kind of fluent that none of these domains has."""
    if not noise.spreads:
        return
    try:
        noise.check_kinds({name for domain in domains for name in domain.predicates})
    except ValueError as error:
        raise WrongUseError(f"--noise: {error}") from error

"""The tree of commands, and how it is run."""

from __future__ import annotations

from typing import Annotated

import typer

from verbteach import __version__
from verbteach_tui.commands.doctor import doctor
from verbteach_tui.commands.examples import epilog
from verbteach_tui.commands.home import home
from verbteach_tui.conclusion import WrongUseError, concluded

NAME = "verbteach"


def build() -> typer.Typer:
    """The whole command line as a Typer application."""
    app = typer.Typer(
        name=NAME,
        help="Teach a simulated household robot what verbs mean.",
        epilog=epilog(NAME),
        rich_markup_mode=None,  # plain help reads well in a pipe and to a screen reader
        pretty_exceptions_enable=False,
        context_settings={"help_option_names": ["-h", "--help"]},
    )
    app.callback(invoke_without_command=True)(start)
    for command in (doctor,):
        app.command(epilog=epilog(f"{NAME} {command.__name__}"))(command)
    return app


def start(
    context: typer.Context,
    version: Annotated[bool, typer.Option("--version", help="Print the version.")] = False,
) -> None:
    """Teach a simulated household robot what verbs mean; without a command: the home screen."""
    if version:
        print(f"{NAME} {__version__}")
        raise typer.Exit
    if context.invoked_subcommand is None:
        home()


def run(words: list[str]) -> int:
    """Run the command that ``words`` name; the exit status."""

    def command() -> int | None:
        try:
            status = typer.main.get_command(build()).main(
                words, prog_name=NAME, standalone_mode=False
            )
        except typer.TyperException as error:
            raise WrongUseError(_usage(error)) from error
        return status if isinstance(status, int) else None

    return concluded(command)


def _usage(error: typer.TyperException) -> str:
    """The error in one line, with the command whose help says more."""
    context = getattr(error, "ctx", None)
    path = context.command_path if context is not None else NAME
    return f"{error.format_message()} (see '{path} --help')"

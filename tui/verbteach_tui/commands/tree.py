"""The tree of commands, and how it is run."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from functools import cache
from typing import Annotated, Any, TypeAlias

import typer

from verbteach import __version__
from verbteach_tui.commands import (
    bench,
    benchmark,
    doctor,
    evaluate,
    lessons,
    parse,
    replay,
    reproduce,
    scenes,
    serve,
    sessions,
    sessions_branch,
    sessions_corpus,
    sessions_export,
    sessions_people,
    sessions_teachers,
    study,
    teach,
    train,
)
from verbteach_tui.commands.examples import epilog
from verbteach_tui.commands.home import home
from verbteach_tui.conclusion import WrongUseError, concluded

NAME = "verbteach"

Command: TypeAlias = Callable[..., None]
COMMANDS: Mapping[str, Command] = {
    "teach": teach.teach,
    "replay": replay.replay,
    "parse": parse.parse,
    "train": train.train,
    "evaluate": evaluate.evaluate,
    "reproduce": reproduce.reproduce,
    "serve": serve.serve,
    "bench": bench.bench,
    "doctor": doctor.doctor,
}
GROUPS: Mapping[str, tuple[str, Mapping[str, Command]]] = {
    "sessions": (
        "The records of teaching sessions.",
        {
            "list": sessions.list_sessions,
            "show": sessions.show_session,
            "validate": sessions.validate,
            "branch": sessions_branch.branch,
            "export": sessions_export.export,
            "stats": sessions_corpus.stats,
            "scan": sessions_people.scan,
            "withdraw": sessions_people.withdraw,
            "split": sessions_corpus.split,
            "datasheet": sessions_corpus.make_datasheet,
            "release": sessions_corpus.release,
            "fit": sessions_teachers.fit,
            "evaluate-policy": sessions_teachers.evaluate_policy,
            "example": sessions_teachers.example,
        },
    ),
    "scenes": (
        "The worlds to teach in: the bundled ones, or your own.",
        {"list": scenes.list_scenes, "show": scenes.show_scene, "check": scenes.check},
    ),
    "lessons": (
        "What the simulated teacher teaches.",
        {"list": lessons.list_lessons, "check": lessons.check},
    ),
    "study": (
        "Studies with participants.",
        {
            "new": study.new,
            "check": study.check,
            "status": study.status,
            "answers": study.answers,
            "tokens": study.tokens,
        },
    ),
    "benchmark": ("The Tell Me Dave corpus.", {"check": benchmark.check}),
}

SUMMARIES: Mapping[str, str] = {
    "parse": "Show what the robot reads in a command.",
    "train": "Learn when to ask what, from simulated teachers.",
    "evaluate": "Score a verb model on commands from rooms it has not seen.",
    "reproduce": "Run the paper's experiments, with tables beside its own.",
    "serve": "Serve the app to browsers, one process a visitor.",
    "bench": "Measure speed and memory of this installation.",
    "sessions list": "List sessions, the newest first.",
    "sessions show": "Show what was said in a session, and what came of it.",
    "sessions branch": "Make a session that begins as another did.",
    "sessions export": "Export sessions in the formats of other tools.",
    "sessions stats": "Figures: turns, questions and prices, times, words.",
    "sessions scan": "Look for personal data.",
    "sessions withdraw": "Delete a person's records.",
    "sessions split": "Part sessions into train, validation and test.",
    "sessions datasheet": "Write a datasheet, or bring its figures up to date.",
    "sessions release": "Say whether sessions may go out.",
    "sessions fit": "Fit a simulated user to sessions.",
    "sessions evaluate-policy": "Estimate how another question policy would have done.",
    "sessions example": "Make an example corpus, of made-up people.",
    "scenes show": "Show a scene's objects, and how they are found.",
    "scenes check": "Read every scene and say what does not fit.",
    "lessons list": "List the lessons: scene, command, length.",
    "study new": "Write a study to start from.",
    "study check": "Check a study's file: every misfit with its line.",
    "study status": "Say who is where, and how even the conditions are.",
    "study answers": "Print a table with a row for each session of a study.",
    "study tokens": "Write single-use tokens for `verbteach serve`.",
    "benchmark check": "Read the corpus, run its actions, plan to its changes.",
}
"""What the list of a group says of a command whose first sentence is too long for a line there."""


def build() -> typer.Typer:
    """The whole command line as a Typer application."""
    app = _group(NAME, "Teach a simulated household robot what verbs mean.")
    app.callback(invoke_without_command=True)(start)
    for name, command in COMMANDS.items():
        app.command(name, epilog=epilog(f"{NAME} {name}"), short_help=SUMMARIES.get(name))(command)
    for name, (about, commands) in GROUPS.items():
        group = _group(f"{NAME} {name}", about)
        for inner, command in commands.items():
            path = f"{name} {inner}"
            short = SUMMARIES.get(path)
            group.command(inner, epilog=epilog(f"{NAME} {path}"), short_help=short)(command)
        app.add_typer(group, name=name)
    return app


@cache
def command_line() -> Any:
    """The same as the command that runs; read from all signatures, so made once."""
    return typer.main.get_command(build())


def _group(path: str, about: str) -> typer.Typer:
    return typer.Typer(
        help=about,
        epilog=epilog(path),
        rich_markup_mode=None,  # plain help reads well in a pipe and to a screen reader
        pretty_exceptions_enable=False,
        add_completion=path == NAME,
        context_settings={"help_option_names": ["-h", "--help"]},
    )


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
            status = command_line().main(words, prog_name=NAME, standalone_mode=False)
        except typer.TyperException as error:
            raise WrongUseError(_usage(error)) from error
        except SystemExit as error:
            if isinstance(error.__context__, BrokenPipeError):  # Typer would say 1, a failed check
                raise error.__context__ from None
            raise
        return status if isinstance(status, int) else None

    return concluded(command)


def _usage(error: typer.TyperException) -> str:
    """The error in one line, with the command whose help says more."""
    context = getattr(error, "ctx", None)
    path = context.command_path if context is not None else NAME
    elsewhere = _elsewhere(error.format_message()) if path == NAME else ""
    return f"{error.format_message()}{elsewhere} (see '{path} --help')"


def _elsewhere(message: str) -> str:
    """Where the command that is not there is one of a group."""
    found = re.match(r"No such command '([a-z-]+)'\.$", message)
    name = found[1] if found else ""
    paths = [f"'{group} {name}'" for group, (_, commands) in GROUPS.items() if name in commands]
    return f" Did you mean {', '.join(paths)}?" if paths else ""

"""`verbteach sessions stats|split|datasheet|release`: a folder of sessions as a corpus."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from verbteach_tui.commands.parameters import JsonFlag, ScenesFolder
from verbteach_tui.commands.session_names import session_completions, session_path
from verbteach_tui.commands.streams import columns, counting, emit, note, progress, tell
from verbteach_tui.conclusion import CHECK_FAILED, WrongUseError

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping, Sequence

    from verbteach_sessions.exports.dialogue import Dialogue

SomePaths = Annotated[
    list[Path] | None,
    typer.Argument(
        metavar="PATH",
        parser=session_path,
        autocompletion=session_completions,
        help="Sessions, or folders of them (your own sessions).",
    ),
]
NamesFile = Annotated[
    Path | None,
    typer.Option("--names", metavar="FILE", help="Names to look for as well, one a line."),
]
DATASHEET = Path("DATASHEET.md")


def found_at(paths: Sequence[Path] | None) -> tuple[Path, ...]:
    """The sessions at the paths, or in the folder where sessions go."""
    from verbteach_sessions.catalogue import default_folder
    from verbteach_sessions.corpus.folder import sessions_at

    return sessions_at(paths or [default_folder()])


def names_in(path: Path | None) -> tuple[str, ...]:
    """The names in a file, one a line."""
    if path is None:
        return ()
    try:
        lines = path.read_text("utf-8").splitlines()
    except UnicodeDecodeError as error:
        raise WrongUseError(f"{path}: is not UTF-8") from error
    return tuple(line.strip() for line in lines if line.strip())


def _read(paths: Sequence[Path]) -> Iterator[Dialogue]:
    from verbteach_sessions.exports.reading import read_dialogue

    with progress() as show:
        heard = counting(show, "sessions", len(paths))
        for done, path in enumerate(paths, start=1):
            yield read_dialogue(path)
            heard(done)


def stats(paths: SomePaths = None, as_json: JsonFlag = False) -> None:
    """Figures of sessions: turns, questions and prices, answering times, words, agreement."""
    from verbteach_sessions.corpus.stats import Stats

    figures = Stats()
    for dialogue in _read(found_at(paths)):
        figures.add(dialogue)
    document = figures.to_json()
    if as_json:
        emit(document)
    else:
        _print_stats(document)


def _print_stats(figures: Mapping[str, Any]) -> None:
    kinds = ", ".join(f"{count} {name}" for name, count in figures["teachers"].items())
    questions, verbs = figures["questions"], figures["words_per_learned_verb"]
    agreement = figures["agreement"]
    rows: list[tuple[str, object]] = [
        ("sessions", f"{figures['sessions']} ({kinds})"),
        ("participants", figures["participants"]),
        ("turns", f"{figures['turns']['robot']} robot, {figures['turns']['teacher']} teacher"),
        ("commands", figures["commands"]),
        ("hours", f"{figures['seconds'] / 3600:.2f}"),
        ("questions", f"{questions['count']}, reward {questions['price']:g}"),
        ("seconds per answer", _spread(figures["seconds_per_answer"])),
        ("words per learned verb", _spread(verbs)),
        ("agreement", _agreed(agreement)),
    ]
    tell(columns(rows))
    if questions["by_type"]:
        head = ("QUESTION", "ASKED", "REWARD", "SECONDS", "ANSWERS")
        tell()
        tell(columns([head, *(_question(*pair) for pair in questions["by_type"].items())]))
    if figures["per_participant"]:
        names = ("PARTICIPANT", "SESSIONS", "TURNS", "QUESTIONS", "WORDS", "REWARD", "SECONDS")
        tell()
        tell(columns([names, *(_person(*pair) for pair in figures["per_participant"].items())]))
    if agreement["verbs"]:
        tell()
        each = [(verb, one["people"], one["mean"]) for verb, one in agreement["verbs"].items()]
        tell(columns([("VERB", "TEACHERS", "AGREEMENT"), *each]))


def _spread(one: Mapping[str, Any]) -> str:
    if not one["count"]:
        return "none measured"
    return f"median {one['median']:.1f}, mean {one['mean']:.1f} ({one['count']})"


def _agreed(agreement: Mapping[str, Any]) -> str:
    if agreement["mean"] is None:
        return "no verb taught by two"
    return f"{agreement['mean']:.3f} ({len(agreement['verbs'])} verbs, {agreement['pairs']} pairs)"


def _question(name: str, one: Mapping[str, Any]) -> tuple[object, ...]:
    answers = ", ".join(f"{key} {count}" for key, count in one["answers"].items())
    took = one["seconds"]["median"]
    return name, one["count"], float(one["price"]), "-" if took is None else f"{took:.1f}", answers


def _person(code: str, one: Mapping[str, Any]) -> tuple[object, ...]:
    counts = (one[name] for name in ("sessions", "turns", "questions", "words"))
    return code, *counts, float(one["reward"]), round(one["seconds"])


def split(
    paths: SomePaths = None,
    out: Annotated[
        Path | None,
        typer.Option(
            "--out", metavar="FILE", help="Write the parts to a new file (else they are only told)."
        ),
    ] = None,
    train: Annotated[
        float, typer.Option("--train", metavar="SHARE", help="Its share of the sessions.")
    ] = 0.8,
    validation: Annotated[
        float, typer.Option("--validation", metavar="SHARE", help="Its share.")
    ] = 0.1,
    test: Annotated[float, typer.Option("--test", metavar="SHARE", help="Its share.")] = 0.1,
    seed: Annotated[
        int, typer.Option("--seed", min=0, metavar="N", help="The seed of the draw.")
    ] = 0,
    force: Annotated[bool, typer.Option("--force", help="Replace the file.")] = False,
    as_json: JsonFlag = False,
) -> None:
    """Part sessions into train, validation and test; no person is in two of them."""
    import numpy as np

    from verbteach_sessions.corpus.splits import PARTS, make_splits, member

    if out is not None and out.exists() and not force:
        raise WrongUseError(f"{out}: is there already; name another file, or --force to replace it")
    members = [member(dialogue) for dialogue in _read(found_at(paths))]
    rng = np.random.default_rng(seed)
    document = make_splits(members, rng, seed, (train, validation, test)).to_json()
    if out is not None:
        from verbteach_sessions.exports.folder import write_json

        write_json(out, document)
    if as_json:
        emit(document)
    else:
        rows = [(part, len(document[part])) for part in PARTS]
        tell(columns([*rows, ("groups that stay together", document["groups"])]))


def make_datasheet(
    paths: SomePaths = None,
    out: Annotated[Path, typer.Option("--out", metavar="FILE", help="The datasheet.")] = DATASHEET,
    as_json: JsonFlag = False,
) -> None:
    """Write a datasheet, or bring its figures up to date; what you wrote in it stays."""
    from verbteach_sessions.corpus.datasheet import datasheet, left_to_do, written_in
    from verbteach_sessions.corpus.describing import describe
    from verbteach_sessions.exports.folder import write_text

    found = found_at(paths)
    written = written_in(out.read_text("utf-8")) if out.exists() else {}
    with progress() as show:
        facts = describe(found, counting(show, "sessions", len(found)))
    text = datasheet(facts, written)
    write_text(out, text)
    to_do = left_to_do(text)
    if as_json:
        emit({"datasheet": str(out), "sessions": len(found), "to_do": list(to_do)})
    else:
        tell(f"{out}: {len(found)} sessions, {len(written)} parts kept as you wrote them")
        for title in to_do:
            tell(f"  to do: {title}")


def release(
    paths: SomePaths = None,
    datasheet: Annotated[
        Path, typer.Option("--datasheet", metavar="FILE", help="The datasheet.")
    ] = DATASHEET,
    splits: Annotated[
        Path | None, typer.Option("--splits", metavar="FILE", help="The parts to go out.")
    ] = None,
    names: NamesFile = None,
    scenes: ScenesFolder = None,
    as_json: JsonFlag = False,
) -> None:
    """Say whether sessions may go out; status 1 where something speaks against it."""
    from verbteach_scenarios.nlp.second_opinion import if_installed
    from verbteach_scenarios.settings import make_settings
    from verbteach_sessions.corpus.release import Corpus, check_release

    found = found_at(paths)
    corpus = Corpus(found, datasheet, splits, names_in(names))
    with progress() as show:
        made = check_release(
            corpus,
            make_settings(scenes, if_installed()),
            lambda stage, done: show(stage, done, len(found)),
        )
    if as_json:
        emit(made.to_json())
    else:
        for one in made.problems:
            tell(f"problem: {one.rule}: {_place(one.session)}{one.message}")
        tell("ready" if made.ready else f"NOT READY: {len(made.problems)} problems")
    for one in () if as_json else made.warnings:
        note(f"warning: {one.rule}: {_place(one.session)}{one.message}")
    if not made.ready:
        raise typer.Exit(CHECK_FAILED)


def _place(session: str | None) -> str:
    return "" if session is None else f"{session}: "

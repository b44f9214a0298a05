"""`verbteach study`: a study's file written and checked, its participants, and their answers."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from verbteach_tui.commands.parameters import JsonFlag, ScenesFolder, SessionsFolder
from verbteach_tui.commands.streams import columns, emit, note, tell
from verbteach_tui.conclusion import CHECK_FAILED, WrongUseError

if TYPE_CHECKING:
    from verbteach_sessions.study.design import Study
    from verbteach_sessions.study.status import Row, Status

StudyFile = Annotated[Path, typer.Argument(metavar="FILE", help="The study's file (TOML).")]
NEW_NAME = "study.toml"


def check(file: StudyFile, scenes: ScenesFolder = None, as_json: JsonFlag = False) -> None:
    """Check a study's file as a whole: every misfit with its line; status 1 if there is one."""
    from verbteach_sessions.study.errors import StudyFileError

    try:
        study = read(file, scenes)
    except StudyFileError as error:
        problems = [one._asdict() for one in error.problems]
        if as_json:
            emit({"valid": False, "problems": problems, "study": None})
        else:
            for line, message in error.problems:
                tell(f"{file}:{line}: {message}" if line else f"{file}: {message}")
        raise typer.Exit(CHECK_FAILED) from error
    if as_json:
        emit({"valid": True, "problems": [], "study": _shape(study)})
    else:
        shape = _shape(study).items()
        tell(columns([(name, _listed(value)) for name, value in shape if value != []]))


def new(
    folder: Annotated[
        Path, typer.Argument(metavar="DIR", help="Where to put it; made if need be.")
    ],
    as_json: JsonFlag = False,
) -> None:
    """Write a study to start from: the bundled example, with a comment at everything it says."""
    from verbteach_sessions.study.bundled import EXAMPLE

    path = folder / NEW_NAME
    folder.mkdir(parents=True, exist_ok=True)
    try:
        with path.open("xb") as file:
            file.write(EXAMPLE.read_bytes())
    except FileExistsError as error:
        raise WrongUseError(f"{path}: is there already, and stays as it is") from error
    if as_json:
        emit({"file": str(path)})
    else:
        tell(f"Written: {path}")
        tell("Change it, check it, try it yourself:")
        tell(f"verbteach study check {path}")
        tell(f"verbteach teach --study {path} --sessions {folder / 'trial'}")


def status(
    file: StudyFile,
    sessions: SessionsFolder = None,
    scenes: ScenesFolder = None,
    as_json: JsonFlag = False,
) -> None:
    """Say which participant is where, and how evenly the conditions have come about."""
    from verbteach_sessions.study.status import status_of

    study, folder = read(file, scenes), _folder(sessions)
    found = status_of(study, folder)
    if as_json:
        emit({"study": study.id, "folder": str(folder), **found.to_json()})
        return
    if not found.rows:
        note(f"nobody has begun in {folder}")
        return
    _print(found)


def answers(
    sessions: SessionsFolder = None,
    out: Annotated[
        Path | None, typer.Option("--out", metavar="FILE", help="Write the CSV there.")
    ] = None,
    as_json: JsonFlag = False,
) -> None:
    """Print a table (CSV) with a row for each session of a study: condition, course, answers."""
    from verbteach_sessions.study.answers import answer_rows, as_csv

    folder = _folder(sessions)
    rows, problems = answer_rows(folder)
    for problem in problems:
        note(f"left out: {problem}")
    if out is not None:
        out.write_text(as_csv(rows), "utf-8")
    if as_json:
        emit({"folder": str(folder), "rows": rows, "left_out": list(problems)})
    elif out is not None:
        tell(f"{len(rows)} rows: {out}")
    else:
        print(as_csv(rows), end="")


def tokens(
    file: Annotated[Path, typer.Argument(metavar="FILE", help="A new file for the tokens.")],
    count: Annotated[
        int, typer.Option("--count", min=1, max=10_000, metavar="N", help="How many.")
    ] = 20,
    as_json: JsonFlag = False,
) -> None:
    """Write single-use tokens for `verbteach serve --tokens`, one a line, one for each person."""
    from verbteach_tui.web.tokens import write_tokens

    try:
        made = write_tokens(file, count)
    except FileExistsError as error:
        raise WrongUseError(f"{file}: is there already, and stays as it is") from error
    if as_json:
        emit({"file": str(file), "tokens": len(made)})
    else:
        tell(f"{len(made)} tokens: {file}; keep it to yourself, give each person one line")


def read(file: Path, scenes: Path | None) -> Study:
    """The study in ``file``, checked as a whole. Raises ``StudyFileError``."""
    from verbteach_scenarios.scenes import load_domain, scene_ids
    from verbteach_sessions.study.study_file import read_study

    return read_study(file, scene_ids(scenes), kinds=lambda: load_domain(scenes).predicates)


def _folder(sessions: Path | None) -> Path:
    from verbteach_sessions.catalogue import default_folder

    if sessions is not None and not sessions.is_dir():
        raise WrongUseError(f"{sessions}: there is no such folder")
    return sessions or default_folder()


def _shape(study: Study) -> dict[str, Any]:
    """What a study comes to."""
    from verbteach_sessions.study.counterbalance import orders

    return {
        "id": study.id,
        "title": study.title,
        "design": study.design,
        "conditions": [condition.id for condition in study.conditions],
        "weights": [f"{one.id} {one.weights_hash}" for one in study.conditions if one.weights],
        "orders": len(orders(study)),
        "tasks": len(study.lessons.tasks),
        "scenes": list(study.lessons.scenes),
        "practice": study.practice is not None,
        "questions": len(study.questionnaire.scales) + len(study.questionnaire.questions),
        "consent_hash": study.consent_hash,
        "file_hash": study.file_hash,
    }


def _print(found: Status) -> None:
    head = ("PARTICIPANT", "PLACE", "CONDITIONS", "AT", "STEP", "LAST SEEN", "STATE")
    tell(columns([head, *map(_row, found.rows)]))
    tell()
    balance = [(" > ".join(one.order), one.given, one.finished) for one in found.balance]
    tell(columns([("CONDITIONS", "GIVEN", "FINISHED"), *balance]))


def _row(row: Row) -> tuple[object, ...]:
    if row.problem:
        return (row.participant, "", "", "", "", "", row.problem)
    state = "finished" if row.finished else "here now" if row.here else "away"
    marks = [state, *["stopped early"] * row.stopped, *["file has changed since"] * row.changed]
    place, step = f"{row.slot}", f"{row.done + 1}/{row.steps}"
    return (
        row.participant,
        place,
        " > ".join(row.order),
        row.at,
        step,
        _moment(row.seen),
        ", ".join(marks),
    )


def _moment(iso: str) -> str:
    """As in 2030-01-01 09:00, in UTC as in the record."""
    return iso[:16].replace("T", " ")


def _listed(value: object) -> object:
    return ", ".join(map(str, value)) if isinstance(value, list) else value

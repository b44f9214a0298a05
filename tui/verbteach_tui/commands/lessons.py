"""`verbteach lessons`: what the simulated teacher teaches, and whether it can be taught."""

from __future__ import annotations

from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from verbteach_tui.commands.parameters import JsonFlag, ScenesFolder
from verbteach_tui.commands.streams import columns, emit, progress, tell
from verbteach_tui.conclusion import CHECK_FAILED

if TYPE_CHECKING:
    from verbteach_scenarios.lessons import LessonProblem

LessonsFolder = Annotated[
    Path | None,
    typer.Option("--lessons", metavar="DIR", help="Take lessons from this folder."),
]


def list_lessons(lessons: LessonsFolder = None, as_json: JsonFlag = False) -> None:
    """List the lessons: scene, command, and how long the demonstration is."""
    from verbteach_scenarios.lesson_file import lesson_to_data
    from verbteach_scenarios.lessons import load_lessons

    found = load_lessons(lessons)
    if as_json:
        emit({"lessons": [lesson_to_data(lesson) for lesson in found]})
        return
    rows = [(one.id, one.scene, len(one.demonstration), one.command) for one in found]
    tell(columns([("ID", "SCENE", "STEPS", "COMMAND"), *rows]))


def check(
    lessons: LessonsFolder = None, scenes: ScenesFolder = None, as_json: JsonFlag = False
) -> None:
    """Prove that every demonstration can be done and reaches its goal.

    Exit status 1 where one does not. The paper's own figures stand beside.
    """
    from verbteach_scenarios.lessons import check_lessons

    with progress() as show:
        report = check_lessons(lessons, scenes, lambda done, total: show("lessons", done, total))
    if as_json:
        problems = [{**asdict(one), "path": str(one.path)} for one in report.problems]
        emit({**asdict(report), "problems": problems})
    else:
        length = report.length
        rows = [
            ("", "HERE", "SHE & CHAI 2017"),
            ("lessons", report.lessons, 979),
            ("verbs", report.verbs, 75),
            ("noun phrases", report.noun_phrases, 215),
            ("length", f"{length.mean:.2f} +- {length.sd:.1f}", "4.82 +- 4.8"),
            ("shortest and longest", f"{length.min} and {length.max}", "1 and 51"),
        ]
        tell(columns([tuple(map(str, row)) for row in rows]))
        for problem in report.problems:
            tell(_line(problem))
    if report.problems:
        raise typer.Exit(CHECK_FAILED)


def _line(problem: LessonProblem) -> str:
    place = f"{problem.path}:{problem.line}" if problem.line else str(problem.path)
    return (
        f"{place}: {problem.lesson}: {problem.reason}"
        if problem.lesson
        else (f"{place}: {problem.reason}")
    )

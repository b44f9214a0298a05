"""Writes the files that are made from others: ``python -m verbteach_scenarios.build``.

What it writes is committed; tests fail where a committed file is not what
this would write.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from verbteach_scenarios.compiled import (
    compiled_text,
    digest,
    domain_to_json,
    problem_to_json,
)
from verbteach_scenarios.errors import DomainFileError, SceneFileError
from verbteach_scenarios.folders import BUNDLED, DOMAIN, WorldFolder
from verbteach_scenarios.lesson_file import lesson_to_line
from verbteach_scenarios.pddl import parse_domain, parse_problem
from verbteach_scenarios.pddl.grammar import read_text

RECIPES = BUNDLED / "recipes"
LESSONS = BUNDLED / "lessons.jsonl"


def compiled_files(home: WorldFolder) -> Iterator[tuple[Path, str]]:
    """The compiled files of a folder with their texts: the domain's and each scene's."""
    path = home.path / f"{DOMAIN}.pddl"
    domain_text = read_text(path, DomainFileError)
    domain = parse_domain(domain_text, path)
    yield home.compiled(DOMAIN), compiled_text(domain_to_json(domain), digest(domain_text))
    for scene_id in home.scene_ids:
        text = read_text(home.problem(scene_id), SceneFileError)
        problem = parse_problem(text, domain, home.problem(scene_id))
        made_from = digest(domain_text, text)
        yield home.compiled(scene_id), compiled_text(problem_to_json(problem), made_from)


def lesson_text() -> str:
    """The text of the bundled lessons, written from their recipes; takes about half a minute."""
    from verbteach_scenarios.recipes.generate import generate  # noqa: PLC0415 - only to write
    from verbteach_scenarios.recipes.tasks import read_tasks, read_teachers  # noqa: PLC0415
    from verbteach_scenarios.settings import make_settings  # noqa: PLC0415

    setting = make_settings()
    settings = {scene_id: setting(scene_id) for scene_id in WorldFolder(BUNDLED).scene_ids}
    lessons = generate(read_tasks(RECIPES), read_teachers(RECIPES), settings)
    return "".join(f"{lesson_to_line(lesson)}\n" for lesson in lessons)


def made_files() -> Iterator[tuple[Path, str]]:
    """Every file that is made from others, with its text, in the order of making."""
    yield from compiled_files(WorldFolder(BUNDLED))
    yield LESSONS, lesson_text()


def main() -> None:
    """Write what has changed."""
    for path, text in made_files():
        if not path.is_file() or path.read_text(encoding="utf-8") != text:
            path.parent.mkdir(exist_ok=True)
            path.write_text(text, encoding="utf-8", newline="\n")
            print(path.relative_to(BUNDLED))


if __name__ == "__main__":
    main()

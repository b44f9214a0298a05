"""The compiled form of domains and scenes says the same as the PDDL it was made from."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

from verbteach_scenarios.build import compiled_files
from verbteach_scenarios.compiled import (
    digest,
    domain_from_json,
    domain_to_json,
    problem_from_json,
    problem_to_json,
)
from verbteach_scenarios.folders import BUNDLED, WorldFolder
from verbteach_scenarios.pddl import read_domain, read_problem
from verbteach_scenarios.scenes import load_scene


def test_the_committed_files_are_what_the_build_writes() -> None:
    for path, text in compiled_files(WorldFolder(BUNDLED)):
        assert path.read_text(encoding="utf-8") == text, f"{path.name}: run the build"


def test_a_domain_and_a_problem_survive_the_way_through_json() -> None:
    domain = read_domain(BUNDLED / "domain.pddl")
    again = domain_from_json(json.loads(json.dumps(domain_to_json(domain))))
    assert again == domain
    assert list(again.actions) == list(domain.actions)
    problem = read_problem(BUNDLED / "kitchen-6.pddl", domain)
    assert problem_from_json(json.loads(json.dumps(problem_to_json(problem)))) == problem


def test_compiled_files_of_other_texts_are_passed_over(tmp_path: Path) -> None:
    shutil.copytree(BUNDLED, tmp_path, dirs_exist_ok=True)
    scene = tmp_path / "kitchen-1.pddl"
    scene.write_text(scene.read_text().replace("(dirty Table_1)", ""))
    changed, before = load_scene("kitchen-1", tmp_path), load_scene("kitchen-1")
    assert {str(f) for f in before.initial - changed.initial} == {"(dirty Table_1)"}


def test_torn_compiled_files_are_passed_over(tmp_path: Path) -> None:
    shutil.copytree(BUNDLED, tmp_path, dirs_exist_ok=True)
    for path in (tmp_path / "compiled").iterdir():
        path.write_text(path.read_text()[:100])
    assert load_scene("kitchen-1", tmp_path) == load_scene("kitchen-1")


def test_line_ends_do_not_count() -> None:
    assert digest("a\r\nb\r\n") == digest("a\nb\n") != digest("a\nc\n")

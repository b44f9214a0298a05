"""What a program is: the sources that can have a part in a figure, and no others."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from verbteach_scenarios import programs
from verbteach_scenarios.programs import program, reached

ROOTS = ("verbteach.experiments.grid", "verbteach_scenarios.grounds")


def test_what_is_imported_is_reached_and_nothing_else() -> None:
    found = reached(*ROOTS)
    assert {*ROOTS, "verbteach.verbs.lifting", "verbteach.world.kernel"} <= set(found)
    assert not [name for name in found if name.startswith("verbteach.policy.")]
    assert not [name for name in found if not name.startswith("verbteach")]


def test_no_more_is_reached_than_may_be_imported() -> None:
    found = reached("verbteach.world.task")
    assert set(found) >= {"verbteach.world.domain", "verbteach.world.grounding"}
    assert "verbteach.world.kernel" not in found


def test_a_program_changes_with_its_sources_alone(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    homes = {name: tmp_path / name for name in programs._HOMES}
    for name, home in programs._HOMES.items():
        shutil.copytree(home, homes[name])
    before = program(*ROOTS)
    monkeypatch.setattr(programs, "_HOMES", homes)
    assert program(*ROOTS) == before
    with (homes["verbteach"] / "policy" / "linear.py").open("a") as file:
        file.write("# another\n")
    assert program(*ROOTS) == before
    with (homes["verbteach"] / "verbs" / "lifting.py").open("a") as file:
        file.write("# another\n")
    changed = program(*ROOTS)
    assert changed != before
    with (homes["verbteach_scenarios"] / programs.WORDS[0]).open("a") as file:
        file.write("# another\n")
    assert program(*ROOTS) not in (before, changed)

"""A session is named on the command line as the list prints it, or by where it lies."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.tui.room import said
from verbteach_tui.commands.session_names import (
    session_completions,
    session_named,
    session_path,
)
from verbteach_tui.conclusion import WrongUseError


@pytest.fixture
def own(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A session in the person's own folder, who stands in another one."""
    monkeypatch.setenv("VERBTEACH_SESSIONS", str(tmp_path / "own"))
    (tmp_path / "here" / "my-sessions").mkdir(parents=True)
    monkeypatch.chdir(tmp_path / "here")
    return said(tmp_path / "own")


def test_what_the_list_prints_names_a_session(own: Path) -> None:
    assert session_named(own.name) == own
    assert session_path(str(own)) == own
    assert session_path("my-sessions") == Path("my-sessions")


def test_what_lies_here_comes_before_what_has_that_name_elsewhere(own: Path) -> None:
    Path(own.name).mkdir()
    assert session_named(own.name) == Path(own.name)


@pytest.mark.parametrize("name", ["nosuch", "my-sessions/nosuch", "../own/nosuch"])
def test_what_is_nowhere_is_refused_with_what_to_do(own: Path, name: str) -> None:
    with pytest.raises(WrongUseError, match="sessions list"):
        session_named(name)
    assert session_path(name) == Path(name)


def test_the_shell_completes_names_and_folders(own: Path) -> None:
    assert own.name in session_completions("")
    assert session_completions(own.name[:4]) == [own.name]
    assert session_completions("my") == ["my-sessions"]
    assert session_completions("nowhere/x") == []

"""The person's own keys: what the file says counts; what is wrong is named with its line."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest

from tests.tui.frames import piloted
from tests.tui.room import Room, options
from verbteach.dialogue.moves import Phase
from verbteach_tui.app import VerbteachApp
from verbteach_tui.keymap import BOUND, Keymap, KeymapError, keys_file, read_keymap
from verbteach_tui.keys import SAID, answer_keys, anytime, choose_keys, word_of
from verbteach_tui.options import OpenNew
from verbteach_tui.screens.turns import TurnPicker
from verbteach_tui.screens.verbs import VerbsScreen


@pytest.fixture(autouse=True)
def usual_keys() -> Iterator[None]:
    yield
    choose_keys({})


def written(folder: Path, text: str) -> Path:
    path = folder / "keys.toml"
    path.write_text(text, "utf-8")
    return path


def test_every_single_key_can_be_chosen_by_a_name() -> None:
    keys = {key.key for phase in Phase for key in answer_keys(phase)} | {k.key for k in anytime()}
    assert keys == set(SAID.values())


def test_without_a_file_the_keys_are_as_ever(tmp_path: Path) -> None:
    assert read_keymap(tmp_path / "none.toml") == Keymap()
    assert read_keymap(written(tmp_path, "")) == Keymap()


def test_the_file_stands_where_the_platform_keeps_settings_or_where_it_is_named(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delenv("VERBTEACH_KEYS", raising=False)
    assert keys_file().parts[-2:] == ("verbteach", "keys.toml")
    monkeypatch.setenv("VERBTEACH_KEYS", str(tmp_path / "mine.toml"))
    assert keys_file() == tmp_path / "mine.toml"


def test_what_the_file_says_counts(tmp_path: Path) -> None:
    text = '[keys]\nyes = "j"\nno = "k"\nundo = "z"\nverbs = "f4"\nmind = "f5"\nturns = "ctrl+o"\n'
    keymap = read_keymap(written(tmp_path, text))
    assert keymap.said == {"yes": "j", "no": "k", "undo": "z"}
    assert keymap.bound == {"verbs": "f4", "mind": "f5", "turns": "ctrl+o"}
    choose_keys(keymap.said)
    assert word_of("j", Phase.EXECUTION) == "yes"
    assert word_of("j", Phase.READ_BACK) == "good"
    assert word_of("y", Phase.EXECUTION) is None
    assert word_of("z", Phase.COMMAND) == "undo"


@pytest.mark.parametrize(
    ("text", "line", "problem"),
    [
        ('[keys]\nyes = "n"\n', 2, "'n' is the key of 'no' already"),
        ('[keys]\nyes = "j"\n# so\nno = "j"\n', 4, "'j' is the key of 'yes' already"),
        ('[keys]\nverbs = "f6"\n', 2, "'f6' is the key of 'scenes' already"),
        ('[keys]\nyess = "j"\n', 2, "did you mean yes"),
        ('[keys]\n\nyes = "jj"\n', 3, "one character"),
        ('[keys]\nyes = "7"\n', 2, "meaning of their own"),
        ('[keys]\nyes = "x"\n', 2, "meaning of their own"),
        ("[keys]\nyes = 3\n", 2, "a key is a text"),
        ('[keys]\nhelp = "alt+h"\n', 2, "function key"),
        ('[keys]\nhelp = "ctrl+m"\n', 2, "another key"),
        ('[colours]\nyes = "j"\n', 1, "only the table"),
        ('keys = "j"\n', 1, "is a table"),
    ],
)
def test_what_is_wrong_is_named_with_its_line(
    tmp_path: Path, text: str, line: int, problem: str
) -> None:
    path = written(tmp_path, text)
    with pytest.raises(KeymapError) as error:
        read_keymap(path)
    assert str(error.value).startswith(f"{path}:{line}: ")
    assert problem in str(error.value)


def test_a_file_that_is_no_toml_is_refused_with_where_it_goes_wrong(tmp_path: Path) -> None:
    with pytest.raises(KeymapError, match="line 2"):
        read_keymap(written(tmp_path, "[keys]\nyes = \n"))
    path = tmp_path / "keys.toml"
    path.write_bytes(b"\xff\xfe")
    with pytest.raises(KeymapError, match="cannot be read"):
        read_keymap(path)


async def test_the_app_goes_by_the_persons_own_keys(tmp_path: Path) -> None:
    keymap = Keymap({"yes": "j", "undo": "z"}, {"verbs": "f8", "turns": "f5"})
    app = VerbteachApp(replace(options(tmp_path, OpenNew("kitchen-1")), keymap=keymap))
    async with piloted(app, size=(120, 40)) as pilot:
        here = Room(app, pilot)
        await here.settle()
        here.hurry()
        await here.lines("open the fridge", "go to the fridge", "open the fridge", "done")
        assert here.phase == "read_back"
        await here.key("y")  # which begins a line now
        assert here.phase == "read_back"
        await here.key("backspace", "escape")
        await here.key("j")
        assert here.phase == "command"
        await here.key("f8")
        assert isinstance(app.screen, VerbsScreen)
        await here.key("escape", "f5")
        assert isinstance(app.screen, TurnPicker)
    app.close_sessions()


def test_the_named_functions_are_those_of_the_app() -> None:
    from verbteach_tui.screens.teach import TeachScreen

    bindings = [*VerbteachApp.BINDINGS]
    for kind in TeachScreen.__mro__:
        bindings += getattr(kind, "__dict__", {}).get("BINDINGS", [])
    ids = {getattr(one, "id", None): getattr(one, "key", "") for one in bindings}
    assert {name: ids.get(name) for name in BOUND} == dict(BOUND)

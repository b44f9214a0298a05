"""A word typed where keys answer is told from the name of what the key said."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.tui.room import ASKED, NORMAL, SHOWN, room
from verbteach_sessions.session_acts import Redo, Undo
from verbteach_tui.keyguard import KeyGuard
from verbteach_tui.typed_word import TypedWord
from verbteach_tui.widgets.command_input import CommandInput


@pytest.mark.parametrize(
    ("word", "typed", "beyond"),
    [
        ("yes", "yes", ""), ("yes", "yeah!", ""), ("no", "no, ", ""), ("bad", "nope.", ""),
        ("no", "no, the red one", "no, t"), ("skip", "set it on the table", "se"),
        ("good", "great", ""), ("show", "the red one", "th"), ("why", "why", ""),
    ],
)  # fmt: skip
def test_a_word_goes_beyond_what_its_key_said(word: str, typed: str, beyond: str) -> None:
    found = TypedWord()
    found.begin(typed[0], word)
    passed = next((typed[: i + 1] for i in range(1, len(typed)) if found.goes_beyond(typed[i])), "")
    assert passed == beyond


def test_what_takes_an_answer_back_depends_on_what_was_said() -> None:
    found = TypedWord()
    for word, act in (("no", Undo()), ("undo", Redo()), ("why", None)):
        found.begin("x", word)
        assert found.end()[1] == act
    found.begin("n", "no")
    found.refused()
    assert found.end() == ("n", None)
    assert not found.goes_beyond("o"), "nothing was begun"


@pytest.mark.parametrize(
    ("after", "phase", "text"),
    [
        (ASKED, "read_back", "never mind the door"),
        (SHOWN, "demonstration", "set the mug on the table"),
        (SHOWN, "demonstration", "undo is what I want"),
    ],
)
async def test_what_its_first_letter_said_is_taken_back_and_the_rest_is_typed(
    tmp_path: Path, after: tuple[str, ...], phase: str, text: str
) -> None:
    async with room(tmp_path, patient=True, size=NORMAL, after=after) as here:
        before = here.teach.snapshot.lines
        here.teach.guard = KeyGuard()
        await here.pilot.press(*("space" if c == " " else c for c in text))
        await here.settle()
        line = here.teach.query_one(CommandInput)
        assert line.value == text
        assert line.has_focus
        assert here.phase == phase
        assert here.teach.snapshot.lines == before


async def test_the_rest_of_an_answer_is_no_command(tmp_path: Path) -> None:
    async with room(tmp_path, patient=True, size=NORMAL, after=ASKED) as here:
        here.teach.guard = KeyGuard()
        await here.pilot.press("y")
        await here.settle()
        assert here.phase == "command"
        await here.pilot.press(*"es")
        assert here.teach.query_one(CommandInput).value == ""
        await here.pilot.press("B")
        assert here.teach.query_one(CommandInput).value == "B"
        assert here.phase == "command"

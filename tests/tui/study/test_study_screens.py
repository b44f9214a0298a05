"""A study on the screen: the same record as in plain lines, hidden panels hidden, a way out."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.study.files import SMALL
from tests.tui.room import SETTINGS, WIDE
from tests.tui.study.led import SHOW, WHOLE, Led, on_screen, plainly, sessions_of, visit_events
from tests.tui.test_app_layout import check_nothing_overflows, in_view
from verbteach_sessions.eventlog import LogReader
from verbteach_sessions.session import Session
from verbteach_tui.screens.failure import FailureScreen
from verbteach_tui.screens.verbs import VerbsScreen
from verbteach_tui.study import reading_screen
from verbteach_tui.study.leaving_screen import LeavingScreen
from verbteach_tui.study.lesson_screen import LessonScreen
from verbteach_tui.study.questionnaire_screen import QuestionnaireScreen
from verbteach_tui.study.rating_bar import RatingBar
from verbteach_tui.study.reading_screen import ReadingScreen
from verbteach_tui.study.run import StudyRun
from verbteach_tui.views.rows import plain
from verbteach_tui.widgets.rows_view import RowsView


def shown(here: Led) -> str:
    """The text on a reading screen."""
    return " ".join(plain(row) for row in here.app.screen.query_one("#text", RowsView).rows)


async def to_the_lesson(here: Led) -> None:
    """Consent, instructions, into the practice."""
    await here.come(ReadingScreen)
    for key in ("y", "enter", "enter"):
        await here.press(key)
        await here.come(ReadingScreen if key == "y" else object)
        await here.pilot.pause(0.05)
    await here.come(LessonScreen)


async def teach(here: Led) -> None:
    for line in SHOW:
        await here.line(line)


async def whole(here: Led) -> None:
    await to_the_lesson(here)
    await teach(here)
    await here.come(ReadingScreen)
    assert "last task" in shown(here)
    await here.press("enter")
    await here.come(LessonScreen)
    await teach(here)
    await here.settle()
    assert here.teach.snapshot.scene == "kitchen-2"
    await here.line("open the fridge")
    await here.key("g")
    await here.come(QuestionnaireScreen)
    for keys in ("right", "334", "backspace", "home", "end", "05"):
        await here.press(*(keys if keys.isdigit() else [keys]), "tab")
    bars = {bar.scale.id: bar for bar in here.app.screen.query(RatingBar)}
    bars["physical_demand"].action_mark(35)
    bars["frustration"].action_mark(5)
    bars["mental_demand"].action_mark(50)
    await here.press(*"nothing", "space", *"more", "f9")
    await here.come(ReadingScreen)
    assert "completion code" in shown(here)
    await here.press("enter")


async def test_the_screen_and_plain_lines_leave_the_same_record(tmp_path: Path) -> None:
    (tmp_path / "other").mkdir()
    plainly(tmp_path / "other", WHOLE, code="xxxx")
    async with on_screen(tmp_path, "xxxx") as here:
        await whole(here)
    assert visit_events(tmp_path, "xxxx") == visit_events(tmp_path / "other", "xxxx")
    pairs = zip(sessions_of(tmp_path, "xxxx"), sessions_of(tmp_path / "other", "xxxx"), strict=True)
    for one, other in pairs:
        types = [[e.type for e in LogReader(path)] for path in (one, other)]
        assert types[0] == types[1]
        with Session.resume(one, SETTINGS) as first, Session.resume(other, SETTINGS) as second:
            assert first.content_hash == second.content_hash


async def test_a_refusal_leaves_no_trace(tmp_path: Path) -> None:
    async with on_screen(tmp_path) as here:
        await here.come(ReadingScreen)
        await here.press("escape", "q", "space", "n")
        assert here.study.farewell
    assert not (tmp_path / "records").exists()


async def test_keys_pressed_before_the_text_could_be_read_are_no_consent(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(reading_screen, "TOO_SOON", 3600.0)
    async with on_screen(tmp_path) as here:
        await here.pilot.pause()
        await here.press("y", "enter", "n")
        assert isinstance(here.app.screen, ReadingScreen)
        assert here.app.screen.query_one("#text").has_focus
    assert not (tmp_path / "records").exists()


async def test_a_key_held_down_consents_once(tmp_path: Path) -> None:
    async with on_screen(tmp_path) as here:
        await here.come(ReadingScreen)
        await here.press("y", "y", "y")
        await here.come(ReadingScreen)
    assert [kind for kind, _ in visit_events(tmp_path, "ssss")] == ["enrolled"]


async def test_who_pauses_comes_back_to_the_same_place(tmp_path: Path) -> None:
    async with on_screen(tmp_path) as here:
        await to_the_lesson(here)
        await here.line(SHOW[0])
        await here.press("f10")
        assert isinstance(here.app.screen, LeavingScreen)
        await here.press("escape")
        assert here.phase == "demonstration"
        await here.press("f10", "p")
        await here.pilot.pause(0.3)
        assert any("ssss" in line for line in here.study.farewell)
    async with on_screen(tmp_path) as here:
        await here.come(ReadingScreen)
        await here.press("enter")
        await here.come(LessonScreen)
        assert here.phase == "demonstration"
    assert len(sessions_of(tmp_path, "ssss")) == 1


async def test_who_stops_is_done(tmp_path: Path) -> None:
    async with on_screen(tmp_path) as here:
        await to_the_lesson(here)
        await here.press("f10", "e")
        await here.come(ReadingScreen)
        assert "completion code" in shown(here)


@pytest.mark.parametrize("panels", ['["scene"]', '["mind"]', "[]", '["verbs"]'])
async def test_hidden_panels_cannot_be_called_up(tmp_path: Path, panels: str) -> None:
    text = SMALL.replace('panels = ["scene"]', f"panels = {panels}").replace(
        'policy = "manual"', f'policy = "manual"\npanels = {panels}'
    )
    async with on_screen(tmp_path, text=text, size=WIDE) as here:
        await to_the_lesson(here)
        for key in ("f3", "f4", "f7", "f6", "f5"):
            await here.press(key)
            assert not here.teach._believing
            assert isinstance(here.app.screen, LessonScreen | VerbsScreen)
        assert isinstance(here.app.screen, VerbsScreen) == ("verbs" in panels)
        if "verbs" in panels:
            await here.press("escape")
        for panel in ("scene", "mind"):
            assert in_view(here, f"#{panel}") == (panel in panels)
        titles = [title for title, *_ in here.teach.palette()]
        assert ("Verbs" in titles) == ("verbs" in panels)
        assert not {"Other scene", "Tour", "Robot's view"} & set(titles)
        assert len(titles) == len({*titles})
        check_nothing_overflows(here)


async def test_what_cannot_be_kept_is_said_and_can_be_tried_again(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fails(self: StudyRun) -> None:
        raise OSError(28, "No space left on device")

    async with on_screen(tmp_path) as here:
        await here.come(ReadingScreen)
        with monkeypatch.context() as broken:
            broken.setattr(StudyRun, "consent", fails)
            await here.press("y")
            await here.come(FailureScreen)
            await here.press("escape")
        assert not (tmp_path / "records").exists()
        await here.press("y")
        await here.pilot.pause(0.3)
    assert visit_events(tmp_path, "ssss")

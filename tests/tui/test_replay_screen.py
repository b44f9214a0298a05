"""A record played back in the panels it was taught in, and going to an earlier turn of one."""

from __future__ import annotations

from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager
from pathlib import Path

import pytest
from textual.pilot import Pilot
from textual.widgets import OptionList

from tests.tui.frames import piloted
from tests.tui.room import NARROW, SETTINGS, WIDE, options, room, said
from verbteach_sessions.session import Session
from verbteach_tui.app import VerbteachApp
from verbteach_tui.options import OpenHome, OpenRecord, OpenSession
from verbteach_tui.past import Past
from verbteach_tui.screens.replay import ReplayScreen
from verbteach_tui.screens.turns import TurnPicker
from verbteach_tui.widgets.dialogue_view import DialogueView
from verbteach_tui.widgets.scene_view import SceneView
from verbteach_tui.widgets.stage import Stage

LESSON = (
    "command: wash the mug", "object: Mug_2", "skip", "note: so far",
    "command: open the fridge", "do: moveto Table_1", "undo", "do: moveto Fridge_1",
    "do: open Fridge_1", "done", "good",
)  # fmt: skip


@asynccontextmanager
async def playing(
    path: Path, size: tuple[int, int] = WIDE, at: int = 0, speed: float = 0.0
) -> AsyncIterator[tuple[ReplayScreen, Pilot[None]]]:
    app = VerbteachApp(options(path.parent, OpenRecord(path, at, speed)))
    async with piloted(app, size=size) as pilot:
        await shown_on(pilot, lambda: isinstance(app.screen, ReplayScreen))
        assert isinstance(app.screen, ReplayScreen)
        await pilot.pause()
        yield app.screen, pilot


async def shown_on(pilot: Pilot[None], come: Callable[[], bool]) -> None:
    """Wait for what is to ``come``."""
    for _ in range(400):
        if come():
            return
        await pilot.pause(0.02)
    raise AssertionError("it never came")


def lines(screen: ReplayScreen) -> list[str]:
    return [line.text for line in screen.query_one(DialogueView).lines]


async def test_it_goes_forwards_and_backwards_and_shows_each_turn_as_it_was(tmp_path: Path) -> None:
    path = said(tmp_path, *LESSON)
    async with playing(path) as (screen, pilot):
        assert screen.past.at == 0
        assert lines(screen) == ["I am in a family kitchen in the morning. What should I do?"]
        shown = [lines(screen)]
        for _ in range(4):
            await pilot.press("right")
            await pilot.pause()
            shown.append(lines(screen))
        assert "wash the mug" in shown[1]
        assert shown[3] != shown[4]
        for expected in reversed(shown[:-1]):
            await pilot.press("left")
            await pilot.pause()
            assert lines(screen) == expected
        await pilot.press("e")
        await pilot.pause()
        with Session.resume(path, SETTINGS) as session:
            texts = [line.text for line in session.transcript() if line.speaker == "robot"]
        assert lines(screen)[-len(texts[-3:]) :] == texts[-3:]
        assert screen.snapshot.figures.verbs == 1


async def test_what_was_undone_is_seen_being_said_and_taken_back(tmp_path: Path) -> None:
    path = said(tmp_path, *LESSON)
    past = Past.open(path, SETTINGS)
    held = []
    for stop in range(len(past.stops)):
        past.go(stop)
        episode = past.state.episode
        steps = episode.demonstrated.actions if episode and episode.demonstrated else ()
        held.append([str(step) for step in steps])
    at = held.index(["moveto Table_1"])
    assert held[at + 1] == []
    assert ["moveto Fridge_1", "open Fridge_1"] in held
    for stop in (3, 0, 9, 2):  # the same wherever one comes from
        past.go(stop)
        again = Past.open(path, SETTINGS)
        again.go(stop)
        assert past.transcript() == again.transcript()
        assert past.state == again.state


async def test_a_turn_is_picked_and_the_scene_and_the_stage_follow(tmp_path: Path) -> None:
    path = said(tmp_path, *LESSON)
    async with playing(path) as (screen, pilot):
        await pilot.press("g")
        await shown_on(pilot, lambda: isinstance(screen.app.screen, TurnPicker))
        picker = screen.app.screen
        turns = picker.query_one("#turns", OptionList)
        labels = [str(option.prompt) for option in turns.options]
        turns.highlighted = next(i for i, label in enumerate(labels) if "open the fridge" in label)
        turns.highlighted += 2
        await pilot.press("enter")
        await shown_on(pilot, lambda: screen.app.screen is screen and screen.past.at > 0)
        await pilot.pause()
        assert screen.snapshot.shown == ("go to the fridge", "open the fridge")
        assert "fridge" in screen.query_one(SceneView).text
        assert screen.query_one(Stage).builder.display


async def test_it_plays_by_itself_and_stops_at_the_end(tmp_path: Path) -> None:
    path = said(tmp_path, *LESSON)
    async with playing(path, NARROW, speed=16.0) as (screen, pilot):
        assert screen.playing or screen.past.at > 0, "on a slow machine it may be over by now"
        for _ in range(400):
            if not screen.playing:
                break
            await pilot.pause(0.05)
        assert screen.past.at == len(screen.past.stops) - 1


async def test_it_begins_at_the_event_that_was_named(tmp_path: Path) -> None:
    path = said(tmp_path, *LESSON)
    past = Past.open(path, SETTINGS)
    assert past.stop_at(0) == 0
    assert past.stop_at(10**6) == len(past.stops) - 1
    seq = past.stops[4]
    async with playing(path, at=seq) as (screen, _):
        assert screen.past.event.seq == seq


async def test_the_home_screen_plays_a_session_back(tmp_path: Path) -> None:
    said(tmp_path, *LESSON)
    async with room(tmp_path, OpenHome()) as here:
        await here.pilot.pause(0.3)
        await here.pilot.press("p", "p")
        for _ in range(400):
            if isinstance(here.app.screen, ReplayScreen):
                break
            await here.pilot.pause(0.02)
        assert isinstance(here.app.screen, ReplayScreen)
        await here.pilot.press("f10")
        await here.pilot.pause()
        assert not isinstance(here.app.screen, ReplayScreen)


async def test_an_earlier_turn_is_picked_and_everything_after_it_taken_back(tmp_path: Path) -> None:
    path = said(tmp_path, *LESSON)
    async with room(tmp_path, OpenSession(path)) as here:
        await here.key("f8")
        assert isinstance(here.app.screen, TurnPicker)
        await here.key("up", "up", "up", "enter")
        assert here.teach.snapshot.shown == ("go to the fridge",)
        await here.key("f8", "down", "down", "down", "enter")
        assert here.teach.snapshot.figures.verbs == 1
        events = [line.type for line in Past.open(path, SETTINGS)._events]
        assert events[-2:] == ["undo", "redo"]


async def test_an_answer_is_followed_by_what_it_came_to(tmp_path: Path) -> None:
    async with room(tmp_path) as here:
        await here.line("wash the mug")
        await here.key("2")
        assert 'I am now sure that "the mug" is the blue mug.' in here.dialogue
        assert here.teach.snapshot.consequence.startswith("I am now sure")
        await here.key("u")
        assert "I am now sure" not in here.dialogue


@pytest.mark.parametrize(("line", "problem"), [("undo: 9", "only 1"), ("undo: 0", "turns")])
async def test_too_many_turns_are_refused(tmp_path: Path, line: str, problem: str) -> None:
    async with room(tmp_path) as here:
        await here.lines("open the fridge", line)
        assert here.phase == "demonstration"
        told = [str(one.message) for one in here.app._notifications]
        assert any(problem in text for text in told)

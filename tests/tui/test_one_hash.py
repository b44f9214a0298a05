"""One script gives one content hash: as a script, in plain lines, in the app by key and mouse."""

from __future__ import annotations

import io
from pathlib import Path

from tests.tui.room import AS_STEERED, SETTINGS, Room, room
from verbteach_sessions.driving import ScriptTeacher, drive
from verbteach_sessions.header import Header
from verbteach_sessions.session import Session
from verbteach_tui.plain import run_plain
from verbteach_tui.widgets.key_bar import KeyBar
from verbteach_tui.widgets.read_back_view import ReadBackView
from verbteach_tui.widgets.scene_view import SceneView

SCRIPT = """
command: open the fridge
do: moveto Fridge_1
do: moveto Table_1
undo
do: open Fridge_1
flag
done
why
strike: (open Fridge_1)
keep: (open Fridge_1)
good
note: that was easy
scene: kitchen-2
command: open the fridge
stop: 1
do: moveto Fridge_1
fetch the moon
do: open Fridge_1
done
bad
good
command: open the fridge
skip
scene: kitchen-3
command: open the fridge
good
quit
"""

PLAIN = """
open the fridge
go to the fridge
moveto Table_1
u
open fridge
f
d
w
strike: (open Fridge_1)
keep: (open Fridge_1)
yes
note: that was easy
scene: kitchen-2
open the fridge
stop: 1
go to the fridge
fetch the moon
open the fridge
done
no
y
open the fridge
s
scene: kitchen-3
open the fridge
g
quit
"""


def scripted(folder: Path) -> str:
    with Session.create(folder, Header.new("kitchen-1"), SETTINGS) as session:
        drive(session, ScriptTeacher(SCRIPT.splitlines()))
        assert session.ended
        return session.content_hash


def plainly(folder: Path) -> str:
    header = Header.new("kitchen-1", interface="plain")
    with Session.create(folder, header, SETTINGS) as session:
        assert run_plain(session, io.StringIO(PLAIN), io.StringIO()) == 0
        assert session.ended
        return session.content_hash


async def on_screen(folder: Path) -> str:
    async with room(folder, speed=AS_STEERED) as here:
        session = here.teach.teaching.session
        await first_lesson(here)
        await second_lesson(here)
        await here.line("scene: kitchen-3")
        await here.line("open the fridge")
        await here.click_target(here.teach.query_one(KeyBar), "to_end")
        await here.click_target(here.teach.query_one(KeyBar), "good")
        await here.key("f10")
        assert session.ended
        return session.content_hash


async def first_lesson(here: Room) -> None:
    await here.line("open the fridge")
    await here.choose("actions", "go to …")
    await here.choose("objects", "fridge")
    await here.line("go to the table")
    await here.key("ctrl+z", "tab")
    await here.choose("actions", "open …")
    await here.choose("objects", "fridge")
    await here.key("f")
    await here.key("d", "w")
    await here.key("space")
    view = here.teach.query_one(ReadBackView)
    struck = next(i for i, part in enumerate(here.teach.snapshot.parts) if "open" in part.need_not)
    await here.click_target(view, str(struck))
    await here.key("y")
    here.teach.set_focus(None)
    await here.key("m")
    await here.pilot.press(*"that", "space", *"was", "space", *"easy")
    await here.key("enter")


async def second_lesson(here: Room) -> None:
    await here.key("f6")
    await here.choose("scene-list", "kitchen-2")
    await here.line("open the fridge")
    await here.key("right", "x")
    await here.choose("actions", "go to …")
    await here.click_target(here.teach.query_one(SceneView), "Fridge_1")
    await here.line("fetch the moon")
    await here.line("open the fridge")
    await here.line("done")
    await here.key("n", "g")
    await here.line("open the fridge")
    await here.key("s")


async def test_one_script_gives_one_hash_in_every_interface(tmp_path: Path) -> None:
    hashes = {scripted(tmp_path), plainly(tmp_path), await on_screen(tmp_path)}
    assert len(hashes) == 1


async def test_another_script_gives_another_hash(tmp_path: Path) -> None:
    async with room(tmp_path) as here:
        await first_lesson(here)
        assert here.teach.snapshot.content_hash != scripted(tmp_path)

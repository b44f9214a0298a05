"""What the robot is not sure of is drawn with how sure it is, in signs and words."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from tests.tui.frames import piloted
from tests.tui.room import SETTINGS, options
from tests.tui.room import Room as Here
from verbteach.perception.belief import Belief
from verbteach.perception.noise import NoiseModel
from verbteach.world.fluents import Fluent
from verbteach_sessions.header import Header
from verbteach_sessions.method import Method
from verbteach_sessions.session import Session
from verbteach_tui.app import VerbteachApp
from verbteach_tui.options import OpenNew
from verbteach_tui.plain_words import look_lines
from verbteach_tui.views.believed import Believed
from verbteach_tui.views.cards import picture_rows
from verbteach_tui.views.picture import Depictor
from verbteach_tui.views.rows import plain
from verbteach_tui.widgets.scene_view import SceneView

SCENE = SETTINGS("kitchen-1").scene
ON, OPEN, HOT = (
    Fluent("on", ("Kettle_1", "Counter_1")),
    Fluent("open", ("Fridge_1",)),
    Fluent("hot", ("Kettle_1",)),
)


def drawn(confidences: dict[Fluent, float]) -> str:
    belief = Belief.of({**dict.fromkeys(SCENE.initial, 1.0), **confidences})
    seen = Believed.of(belief)
    rows = picture_rows(Depictor(SCENE).picture(seen.state, doubts=seen.doubts), 100)
    return " ".join(" ".join(plain(row) for row in rows).split())


def test_what_is_certain_is_drawn_as_ever() -> None:
    seen = Believed.of(Belief.certain(SCENE.initial))
    assert seen.state == SCENE.initial
    assert not seen.doubts
    assert "?" not in drawn({})


def test_a_place_and_a_condition_in_doubt_say_how_sure_the_robot_is() -> None:
    text = drawn({ON: 0.62, OPEN: 0.3})
    assert "kettle here? 62%" in text
    assert "fridge ■ shut? 70%" in text
    assert "fridge ◫ open? 80%" in drawn({OPEN: 0.8})


def test_a_thing_is_drawn_where_it_most_likely_is_however_unlikely() -> None:
    elsewhere = Fluent("on", ("Kettle_1", "Table_1"))
    text = drawn({ON: 0.2, elsewhere: 0.3})
    table = text.split("table", 1)[1]
    assert "kettle here? 30%" in table
    assert "20%" not in text


def test_words_say_it_where_no_signs_are() -> None:
    belief = Belief.of({**dict.fromkeys(SCENE.initial, 1.0), ON: 0.62, OPEN: 0.3})
    seen = Believed.of(belief)
    lines = look_lines(Depictor(SCENE).picture(seen.state, doubts=seen.doubts))
    assert any("fridge (shut: 70% sure)" in line for line in lines)
    assert any("kettle" in line and "62% sure that it is there" in line for line in lines)


async def test_a_key_puts_the_robots_view_beside_the_scene_and_takes_it_away(
    tmp_path: Path,
) -> None:
    method = Method.named("manual").with_noise(NoiseModel(0.3))
    header = Header.new("kitchen-1", interface="app", method=method)
    chosen = replace(
        options(tmp_path, OpenNew("kitchen-1")),
        create=lambda scene: Session.create(tmp_path, header, SETTINGS),
    )
    app = VerbteachApp(chosen)
    async with piloted(app, size=(120, 40)) as pilot:
        here = Here(app, pilot)
        await here.settle()
        scene = here.teach.query_one(SceneView)
        await here.key("f7")
        assert "As the robot saw it" not in scene.text, "it has not looked yet"
        await here.line("boil the water")
        assert "As the robot saw it" in scene.text
        assert "%" in scene.text.replace("% dirty", "")
        await here.key("f7")
        assert "As the robot saw it" not in scene.text
    app.close_sessions()

"""The picture of a scene: everything is in it once, where it is, and how it is in words."""

from __future__ import annotations

from collections import Counter
from itertools import pairwise

import pytest

from tests.tui.room import SETTINGS
from tests.tui.strategies import walk
from verbteach.dialogue.setting import Setting
from verbteach.world.fluents import Fluent, State
from verbteach_scenarios.scenes import scene_ids
from verbteach_tui.views.cards import Emphasis, arrange, picture_rows
from verbteach_tui.views.labels import Labels, from_id
from verbteach_tui.views.marks import stem
from verbteach_tui.views.picture import Depictor
from verbteach_tui.views.possible import changeable
from verbteach_tui.views.rows import plain, width_of

WIDTHS = (24, 56, 64, 110, 200)


def depictor(setting: Setting) -> Depictor:
    return Depictor(setting.scene)


@pytest.mark.parametrize("scene", scene_ids())
def test_every_object_is_in_the_picture_exactly_once_wherever_the_robot_puts_it(scene: str) -> None:
    setting = SETTINGS(scene)
    draws = depictor(setting)
    actors = {"Robot", "Person"}
    things = set(setting.scene.objects) - set(setting.scene.domain.constants) | actors
    for state in walk(setting, 60, seed=1)[::6]:
        targets = Counter(
            span.target
            for row in picture_rows(draws.picture(state), 64)
            for span in row
            if span.target
        )
        assert set(targets) | actors == things
        assert set(targets.values()) == {1} or _only_long_names_repeat(targets, draws)


def _only_long_names_repeat(targets: Counter[str], draws: Depictor) -> bool:
    """A name of several words may be broken over two rows, and then is there twice."""
    return all(" " in draws.labels[key] for key, count in targets.items() if count > 1)


@pytest.mark.parametrize("width", WIDTHS)
def test_no_row_is_wider_than_the_panel(width: int) -> None:
    for scene in scene_ids():
        setting = SETTINGS(scene)
        draws = depictor(setting)
        states = walk(setting, 12, seed=2)
        for before, state in pairwise(states):
            rows = picture_rows(draws.picture(state, before), width)
            assert max(width_of(row) for row in rows) <= width


@pytest.mark.parametrize("scene", scene_ids())
def test_labels_tell_all_objects_of_a_scene_apart(scene: str) -> None:
    setting = SETTINGS(scene)
    labels = Labels.of(setting.scene)
    own = [key for key in setting.scene.objects if key not in setting.scene.domain.constants]
    assert len({labels[key].casefold() for key in own}) == len(own)
    assert all(labels.find(labels[key]) is not None for key in own)


@pytest.mark.parametrize("scene", scene_ids())
def test_what_can_be_open_or_on_is_what_the_grounded_task_says(scene: str) -> None:
    setting = SETTINGS(scene)
    shown = {"open", "on", "lit"}
    grounded = {f for f in setting.task.fluents if len(f.args) == 1 and stem(f.predicate) in shown}
    told = {f for f in changeable(setting.scene) if stem(f.predicate) in shown}
    assert told == grounded


def test_an_id_reads_as_words() -> None:
    assert from_id("StoveKnob_1") == "stove knob 1"
    assert from_id("Tv_1PowerButton") == "tv 1 power button"
    assert from_id("\x1b") == "␛"


def shown(state: State, before: State | None = None, width: int = 64) -> str:
    picture = depictor(SETTINGS("kitchen-1")).picture(state, before)
    return "\n".join(plain(row) for row in picture_rows(picture, width))


def marks(state: State, key: str, before: State | None = None) -> list[str]:
    """What stands beside a thing."""
    picture = depictor(SETTINGS("kitchen-1")).picture(state, before)
    found = [thing for place in picture.places for thing in place.contents if thing.id == key]
    return [mark.text for mark in found[0].marks]


def start() -> State:
    return SETTINGS("kitchen-1").scene.initial


def test_what_is_open_on_hot_or_full_says_so_in_words() -> None:
    assert "fridge ■ shut" in shown(start())
    opened = start() | {Fluent("open", ("Fridge_1",)), Fluent("hot", ("Kettle_1",))}
    assert "fridge ◫ open" in shown(opened)
    assert marks(opened, "Kettle_1") == ["≈ water", "▲ hot"]


def test_what_just_changed_is_marked_in_the_place_where_it_now_is() -> None:
    before = start()
    moved = (before - {Fluent("on", ("Kettle_1", "Counter_1"))}) | {
        Fluent("on", ("Kettle_1", "Burner_1"))
    }
    assert "✱kettle" in shown(moved, before)
    assert "✱kettle" not in shown(moved)
    assert "left burner" in shown(moved).split("Also here")[0], "it has a card of its own now"


def test_what_ceased_is_told_once() -> None:
    wet = start() | {Fluent("has", ("Mug_1", "Water"))}
    assert marks(start(), "Mug_1", wet) == ["– no longer water"]
    assert marks(start(), "Mug_1") == []


def test_what_the_robot_holds_stands_with_the_robot() -> None:
    held = (start() - {Fluent("on", ("Kettle_1", "Counter_1"))}) | {
        Fluent("grasping", ("Robot", "Kettle_1"))
    }
    assert shown(held).splitlines()[0].startswith("robot holds kettle")


def test_a_question_marks_what_it_is_about_with_a_sign_or_a_digit() -> None:
    picture = depictor(SETTINGS("kitchen-1")).picture(start())
    emphasis = Emphasis({"Kettle_1"}, {"Mug_1": "1"})
    rows = picture_rows(picture, 64, None, emphasis)
    text = "\n".join(plain(row) for row in rows)
    assert "?kettle" in text
    assert f"[1] {Labels.of(SETTINGS('kitchen-1').scene)['Mug_1'].split()[0]}" in text


def test_furniture_keeps_its_place_when_things_move() -> None:
    setting = SETTINGS("kitchen-1")
    draws = depictor(setting)
    columns = arrange(draws.picture(setting.scene.initial), 64)
    for state in walk(setting, 40, seed=3):
        rows = picture_rows(draws.picture(state), 64, columns)
        titles = [plain(row) for row in rows if plain(row).startswith(("╭", "├"))]
        left = [title.split(" ")[1] for title in titles]
        names = [draws.labels[key].split()[0] for key in columns[0]]
        assert left[: len(names)] == names


def test_things_in_a_ring_are_shown_all_the_same() -> None:
    ring = (start() - {Fluent("on", ("Kettle_1", "Counter_1"))}) | {
        Fluent("on", ("Kettle_1", "Sponge_1")),
        Fluent("on", ("Sponge_1", "Kettle_1")),
    }
    text = shown(ring - {Fluent("on", ("Sponge_1", "Counter_1"))})
    assert "kettle" in text
    assert "sponge" in text

"""`scenes` and `parse`: worlds listed, shown and checked, and commands read."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from tests.tui.commandline import assert_refused, here
from verbteach_scenarios.folders import BUNDLED
from verbteach_scenarios.scenes import load_scene, scene_ids


@pytest.fixture
def own(tmp_path: Path) -> Path:
    """A person's folder with one scene of the bundled domain."""
    shutil.copy(BUNDLED / "kitchen-1.pddl", tmp_path / "mine.pddl")
    return tmp_path


def test_list_has_a_row_for_every_scene() -> None:
    document = here("scenes", "list", "--json").document
    assert [row["id"] for row in document["scenes"]] == list(scene_ids())
    for row in document["scenes"]:
        assert row["objects"] > 30
        assert row["room"] in ("kitchen", "living room")


def test_list_as_text_names_the_same_scenes() -> None:
    lines = here("scenes", "list").out.splitlines()
    assert [line.split()[0] for line in lines[1:]] == list(scene_ids())


def test_show_names_every_object() -> None:
    document = here("scenes", "show", "kitchen-1", "--json").document
    scene = load_scene("kitchen-1")
    own = set(scene.objects) - set(scene.domain.constants)
    assert {thing["id"] for thing in document["things"]} == own
    assert document["scenes"][0]["objects"] == len(own)
    assert len(document["initial"]) == len(scene.initial)
    text = here("scenes", "show", "kitchen-1").out
    assert all(name in text for name in own)


def test_check_finds_nothing_wrong_with_the_bundled_scenes() -> None:
    ran = here("scenes", "check", "--json")
    assert ran.status == 0
    assert ran.document["problems"] == []


def test_own_scenes_stand_in_their_folder(own: Path) -> None:
    assert [s["id"] for s in here("scenes", "list", "--scenes", own, "--json").document["scenes"]]
    assert here("scenes", "show", "mine", "--scenes", own).status == 0


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("- cup", "- chalice", "chalice"),
        ("(dirty Mug_2)", "(haunted Mug_2)", "haunted"),
    ],
)
def test_check_says_file_line_and_reason(own: Path, old: str, new: str, said: str) -> None:
    file = own / "mine.pddl"
    text = file.read_text("utf-8")
    assert old in text
    file.write_text(text.replace(old, new), "utf-8")
    ran = here("scenes", "check", "--scenes", own, "--json")
    assert ran.status == 1
    (problem,) = ran.document["problems"]
    assert problem["path"] == str(file)
    assert said in text.replace(old, new).splitlines()[problem["line"] - 1]
    assert said in problem["reason"]
    assert_refused(here("scenes", "show", "mine", "--scenes", own), f"mine.pddl:{problem['line']}")


def test_an_unreachable_goal_is_named(own: Path) -> None:
    file = own / "mine.pddl"
    text = file.read_text("utf-8")
    assert "(:goal (and))" in text
    file.write_text(text.replace("(:goal (and))", "(:goal (openable Mug_1))"), "utf-8")
    ran = here("scenes", "check", "--scenes", own)
    assert ran.status == 1
    assert "cannot be reached" in ran.out


def test_an_unknown_scene_is_offered_a_near_one() -> None:
    assert_refused(here("scenes", "show", "kitchn-1"), "kitchn-1", "kitchen-1")
    assert_refused(here("parse", "boil the water", "--scene", "Kitchen-2"), "kitchen-2")


def test_a_name_like_no_other_gets_the_whole_list() -> None:
    assert_refused(here("scenes", "show", "zzzz"), *scene_ids())


def test_a_missing_folder_is_one_line(tmp_path: Path) -> None:
    for command in (("list",), ("check",), ("show", "kitchen-1")):
        assert_refused(here("scenes", *command, "--scenes", tmp_path / "none"), "none")


def test_parse_reads_verb_particle_roles_and_heads() -> None:
    assert here(
        "parse", "Put the red mugs in the sink, and turn the tap on", "--json"
    ).document == [
        {
            "verb": "put",
            "arguments": [
                {"role": "obj", "head": "mug", "modifiers": ["red"], "text": "the red mugs"},
                {"role": "in", "head": "sink", "modifiers": [], "text": "the sink"},
            ],
        },
        {
            "verb": "turn on",
            "arguments": [{"role": "obj", "head": "tap", "modifiers": [], "text": "the tap"}],
        },
    ]


@pytest.mark.parametrize(
    "text", ["", "   ", "?!", "\x00\x1b[31m", "水を沸かして", "is the water hot?"]
)
def test_what_cannot_be_read_is_an_empty_list(text: str) -> None:
    ran = here("parse", text, "--json")
    assert ran.status == 0
    assert ran.document == []
    assert "\x1b" not in here("parse", text).err


def test_a_very_long_command_is_read_or_not_but_answered() -> None:
    ran = here("parse", "put the mug on the table and " * 400, "--json")
    assert ran.status == 0
    assert all(frame["verb"] for frame in ran.document)

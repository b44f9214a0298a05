"""Scenes by name, from the bundled folder and from a user's."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from verbteach.dialogue.setting import UnknownSceneError
from verbteach.world.fluents import Fluent
from verbteach_scenarios.errors import DomainFileError, SceneFileError
from verbteach_scenarios.folders import BUNDLED
from verbteach_scenarios.scenes import check_scenes, load_domain, load_scene, scene_ids

TINY_DOMAIN = """(define (domain tiny)
(:requirements :typing)
(:types box lid - object)
(:constants Red - lid)
(:predicates (shut ?b - box) (under ?b ?c - box))
(:action shut :parameters (?b - box) :precondition (not (shut ?b)) :effect (shut ?b)))
"""

TINY_SCENE = """(define (problem attic)
(:domain tiny)
(:objects SmallBox_1 BigBox_2 - box)
(:init (under SmallBox_1 BigBox_2))
(:goal (and)))
"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "domain.pddl").write_text(TINY_DOMAIN)
    (tmp_path / "attic-10.pddl").write_text(TINY_SCENE)
    return tmp_path


def failure(folder: Path, scene_id: str = "attic-10") -> SceneFileError:
    with pytest.raises(SceneFileError) as caught:
        load_scene(scene_id, folder)
    return caught.value


def test_the_bundled_folder_holds_at_least_six_rooms_of_each_kind() -> None:
    ids = scene_ids()
    for number in range(1, 7):
        assert f"kitchen-{number}" in ids
        assert f"living-room-{number}" in ids


def test_names_are_listed_in_counting_order(folder: Path) -> None:
    for number in (2, 1, 11):
        (folder / f"attic-{number}.pddl").write_text(TINY_SCENE)
    assert scene_ids(folder) == ("attic-1", "attic-2", "attic-10", "attic-11")


def test_an_unknown_name_is_answered_with_those_there_are(folder: Path) -> None:
    with pytest.raises(UnknownSceneError, match=r"'cellar'.*attic-10"):
        load_scene("cellar", folder)
    with pytest.raises(UnknownSceneError, match=r"\.\./attic-10"):
        load_scene("../attic-10", folder)


def test_a_scene_without_sidecar_is_named_after_its_file_and_its_objects(folder: Path) -> None:
    scene = load_scene("attic-10", folder)
    assert (scene.title, scene.room) == ("attic 10", "attic")
    assert scene.objects["SmallBox_1"].names == ("small box",)
    assert scene.objects["Red"].names == ("red",)
    assert scene.initial == {Fluent("under", ("SmallBox_1", "BigBox_2"))}


def test_a_sidecar_says_how_things_look(folder: Path) -> None:
    (folder / "attic-10.toml").write_text(
        'title = "The attic"\nroom = "loft"\n'
        '[objects.SmallBox_1]\nnames = ["chest", "box"]\ncolour = "red"\n'
    )
    (folder / "domain.toml").write_text('[objects.Red]\nnames = ["scarlet"]\n')
    scene = load_scene("attic-10", folder)
    assert (scene.title, scene.room) == ("The attic", "loft")
    assert scene.objects["SmallBox_1"].names == ("chest", "box")
    assert scene.objects["SmallBox_1"].attributes == {"colour": "red"}
    assert scene.objects["BigBox_2"].names == ("big box",)
    assert scene.objects["Red"].names == ("scarlet",)


def test_a_folder_without_a_domain_holds_scenes_of_the_household(tmp_path: Path) -> None:
    shutil.copy(BUNDLED / "kitchen-1.pddl", tmp_path / "mine-1.pddl")
    shutil.copy(BUNDLED / "kitchen-1.toml", tmp_path / "mine-1.toml")
    mine, bundled = load_scene("mine-1", tmp_path), load_scene("kitchen-1")
    assert mine.domain == bundled.domain
    assert mine.objects == bundled.objects
    assert mine.initial == bundled.initial


def test_an_undeclared_type_is_named_with_its_line(folder: Path) -> None:
    (folder / "attic-10.pddl").write_text(TINY_SCENE.replace("- box)", "- crate)"))
    error = failure(folder)
    assert (error.path.name, error.line) == ("attic-10.pddl", 3)
    assert "crate" in error.reason


def test_an_unknown_predicate_is_named_with_its_line(folder: Path) -> None:
    (folder / "attic-10.pddl").write_text(TINY_SCENE.replace("(under", "(above"))
    error = failure(folder)
    assert (error.line, "above" in error.reason) == (4, True)


def test_an_unreachable_goal_is_named_with_its_line(folder: Path) -> None:
    goal = "(:goal (and (shut BigBox_2) (under BigBox_2 SmallBox_1)))"
    (folder / "attic-10.pddl").write_text(TINY_SCENE.replace("(:goal (and))", goal))
    error = failure(folder)
    assert error.line == 5
    assert "(under BigBox_2 SmallBox_1)" in error.reason


def test_a_reachable_goal_is_no_obstacle(folder: Path) -> None:
    goal = "(:goal (and (shut BigBox_2) (shut SmallBox_1)))"
    (folder / "attic-10.pddl").write_text(TINY_SCENE.replace("(:goal (and))", goal))
    assert load_scene("attic-10", folder).room == "attic"


@pytest.mark.parametrize(
    ("sidecar", "line", "word"),
    [
        ('title = "A"\n\n[objects.Tub_1]\nnames = ["tub"]\n', 3, "Tub_1"),
        ('title = "A"\n[objects.SmallBox_1\n', 2, "TOML"),
        ('title = "A"\n[objects.SmallBox_1]\ncolour = "re', 3, "TOML"),
        ('[objects.SmallBox_1]\nnames = "box"\n', 1, "names"),
        ("[objects.SmallBox_1]\nsize = 3\n", 1, "size"),
        ('\ntitel = "A"\n', 2, "titel"),
        ("objects = 3\n", 0, "objects"),
        ("room = 3\n", 0, "room"),
    ],
)
def test_a_sidecar_that_does_not_fit_is_named_with_its_line(
    folder: Path, sidecar: str, line: int, word: str
) -> None:
    (folder / "attic-10.toml").write_text(sidecar)
    error = failure(folder)
    assert (error.path.name, error.line) == ("attic-10.toml", line)
    assert word in error.reason


def test_a_domain_sidecar_may_only_speak_of_constants(folder: Path) -> None:
    (folder / "domain.toml").write_text('[objects.SmallBox_1]\nnames = ["box"]\n')
    error = failure(folder)
    assert (error.path.name, error.line) == ("domain.toml", 1)


def test_a_check_lists_what_can_be_used_and_what_cannot(folder: Path) -> None:
    (folder / "attic-2.pddl").write_text(TINY_SCENE.replace("SmallBox_1 BigBox_2", "SmallBox_1"))
    report = check_scenes(folder)
    assert [(row.id, row.room, row.objects) for row in report.scenes] == [("attic-10", "attic", 2)]
    assert [(p.path.name, p.line) for p in report.problems] == [("attic-2.pddl", 4)]


def test_a_broken_domain_is_reported_once(folder: Path) -> None:
    (folder / "attic-2.pddl").write_text(TINY_SCENE)
    (folder / "domain.pddl").write_text("(define (domain tiny)\n(:types box - crate))")
    report = check_scenes(folder)
    assert (report.scenes, [p.line for p in report.problems]) == ((), [2])
    with pytest.raises(DomainFileError):
        load_domain(folder)


def test_a_folder_without_scenes_or_none_at_all_is_said_to_be_so(tmp_path: Path) -> None:
    assert "no scene" in check_scenes(tmp_path).problems[0].reason
    with pytest.raises(SceneFileError, match="no such folder"):
        scene_ids(tmp_path / "nowhere")


def test_an_edited_file_is_read_anew(folder: Path) -> None:
    load_scene("attic-10", folder)
    (folder / "attic-10.pddl").write_text(TINY_SCENE.replace("BigBox_2", "Bin_2"))
    assert "Bin_2" in load_scene("attic-10", folder).objects

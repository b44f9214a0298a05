"""The bundled rooms make sense: everything is somewhere, once, and looks like something."""

from __future__ import annotations

from collections import Counter
from itertools import combinations

import pytest

from verbteach.world.fluents import Fluent
from verbteach.world.scene import Scene
from verbteach_scenarios.scenes import load_scene, scene_ids, scene_row

SCENES = {scene_id: load_scene(scene_id) for scene_id in scene_ids()}
PLACES = ("on", "in")


@pytest.fixture(params=sorted(SCENES))
def scene(request: pytest.FixtureRequest) -> Scene:
    return SCENES[request.param]


def own(scene: Scene, ancestor: str) -> list[str]:
    domain = scene.domain
    return sorted(
        name
        for name, thing in scene.objects.items()
        if domain.is_a(thing.type, ancestor) and name not in domain.constants
    )


def places(scene: Scene, item: str) -> list[Fluent]:
    return [f for f in scene.initial if f.predicate in PLACES and f.args[0] == item]


def test_a_room_has_35_to_60_objects(scene: Scene) -> None:
    assert 35 <= scene_row(scene).objects <= 60


def test_every_item_is_in_one_place(scene: Scene) -> None:
    assert {item: len(places(scene, item)) for item in own(scene, "item")} == dict.fromkeys(
        own(scene, "item"), 1
    )


def test_only_food_lies_in_or_on_dishes(scene: Scene) -> None:
    kinds = scene.domain
    for item in own(scene, "item"):
        where = places(scene, item)[0].args[1]
        if kinds.is_a(scene.objects[where].type, "item"):
            assert kinds.is_a(scene.objects[item].type, "food"), item


def test_what_is_stowed_is_what_a_storage_holds(scene: Scene) -> None:
    storages = set(own(scene, "storage"))

    def inside(item: str) -> bool:
        where = places(scene, item)[0].args[1]
        return where in storages or (where in set(own(scene, "item")) and inside(where))

    stowed = {f.args[0] for f in scene.initial if f.predicate == "stowed"}
    assert stowed == {item for item in own(scene, "item") if inside(item)}


def test_storages_and_screens_and_landmarks_are_complete(scene: Scene) -> None:
    facts = scene.initial
    for storage in own(scene, "storage"):
        assert Fluent("openable", (storage,)) in facts
    for screen in own(scene, "screen"):
        kinds = Counter(f.predicate for f in facts if f.args[0] == screen)
        assert (kinds["channel"], kinds["volume"]) == (1, 1)
    for landmark in (f.args[0] for f in facts if f.predicate == "landmark"):
        assert any(f.predicate == "stands-on" and f.args[0] == landmark for f in facts)
    for burner in own(scene, "burner"):
        assert any(f.predicate == "controls" and f.args[1] == burner for f in facts)
    for sink in own(scene, "sink"):
        assert any(f.predicate == "feeds" and f.args[1] == sink for f in facts)


def test_what_stands_beside_a_landmark_is_on_the_same_support(scene: Scene) -> None:
    for item, landmark in (f.args for f in scene.initial if f.predicate == "beside"):
        support = places(scene, item)[0].args[1]
        assert Fluent("stands-on", (landmark, support)) in scene.initial


def test_everything_has_names_and_most_things_look_like_something(scene: Scene) -> None:
    things = [scene.objects[name] for name in own(scene, "thing")]
    assert all(thing.names for thing in scene.objects.values())
    assert all(name == name.strip() and name for thing in things for name in thing.names)
    with_looks = sum(bool(thing.attributes) for thing in things)
    assert with_looks >= 0.9 * len(things)


def test_attributes_tell_some_things_of_a_kind_apart_and_leave_some_in_doubt(scene: Scene) -> None:
    """Somewhere a colour decides, and somewhere the same words fit two things."""
    pairs = list(combinations((scene.objects[name] for name in own(scene, "thing")), 2))
    same_name = [(a, b) for a, b in pairs if a.names[0] == b.names[0] or a.names[-1] == b.names[-1]]
    assert any(a.attributes.get("colour") != b.attributes.get("colour") for a, b in same_name)
    assert any(a.attributes.get("colour") == b.attributes.get("colour") for a, b in same_name)


def test_no_two_rooms_are_alike() -> None:
    for one, other in combinations(SCENES.values(), 2):
        mine, theirs = set(one.objects), set(other.objects)
        shared = mine & theirs - set(one.domain.constants)
        assert len(shared) < 0.8 * min(len(mine), len(theirs)), (one.id, other.id)
        assert len(one.initial ^ other.initial) >= 40, (one.id, other.id)


def test_kitchen_1_has_a_kettle_with_water() -> None:
    scene = SCENES["kitchen-1"]
    assert scene.objects["Kettle_1"].attributes["colour"] == "silver"
    assert Fluent("has", ("Kettle_1", "Water")) in scene.initial

from __future__ import annotations

import pytest

from verbteach.world.fluents import Fluent
from verbteach.world.plan import Action
from verbteach.world.simulator import InapplicableError, apply, run
from verbteach.world.task import Task
from verbteach_scenarios.tell_me_dave.documents import Document, Step
from verbteach_scenarios.tell_me_dave.fittings import fittings, hosts
from verbteach_scenarios.tell_me_dave.instructions import Instructions, instruction
from verbteach_scenarios.tell_me_dave.rooms import Room, corpus_domain, spoken_name, whole

G, P = "IsGraspable", "IsPourable"
KITCHEN = {
    "Robot": (),
    "Sink": ("IsPlaceableOn",),
    "SinkKnob": ("IsTurnable",),
    "Stove": ("Turnable",),
    "StoveKnob_2": (),
    "StoveFire_2": ("IsPlaceableOn",),
    "Microwave": ("Openable", "Pressable", "IsPlaceableIn"),
    "MicrowaveDoor": (),
    "MicrowaveButton": (),
    "Fridge": ("Pressable", "Openable", "IsPlaceableIn"),
    "FridgeLeftDoor": (),
    "FridgeRightDoor": (),
    "FridgeButton": (),
    "Mug_1": (G, P),
    "Kettle": (G, P),
    "Bowl_1": (G,),
    "Plate_1": (G,),
    "Spoon_1": (G, "IsPlacable", "IsScoopable"),
    "IceCream_1": (G,),
    "IceCreamScoop": (),
    "BoiledEgg_1": (G, "IsAddable"),
    "Syrup_2": (G, "IsSqueezeable"),
}
LIVING_ROOM = {
    "Robot": (),
    "Loveseat_1": ("IsPlaceableOn",),
    "GarbageBag_1": (G, "IsPlaceableIn"),
    "Tv_1": ("Pressable",),
    "Tv_1PowerButton": (),
    "Tv_1ChannelUpButton": (),
    "Tv_1ChannelDownButton": (),
    "Tv_1VolumeDownButton": (),
    "Tv_1Remote_1": (G,),
    "Tv_1Remote_1PowerButton": (),
    "Tv_1Remote_1ChannelUpButton": (),
    "BagOfChips_1": (G,),
    "Cd_2": (G,),
    "Xbox_1": (G,),
    "Pillow_1": (G,),
}


def document(objects: dict[str, tuple[str, ...]], start: str) -> Document:
    state = frozenset(map(Fluent.parse, start.split(", ") if start else []))
    return Document("1", objects, (Step(state, None),), "", ())


_TASKS: dict[str, Task | None] = {}
"""Grounding takes a tenth of a second, so each room is grounded once."""


class Play:
    """A room in which the corpus's instructions are carried out, one after the other."""

    def __init__(self, objects: dict[str, tuple[str, ...]], start: str) -> None:
        first = document(objects, start)
        room = Room.of(first)
        scene = room.scene("room", first.steps[0].state)
        self.task = _TASKS.setdefault(room.key, None) or Task.from_scene(scene)
        _TASKS[room.key] = self.task
        self.state = scene.initial
        self.reader = Instructions.among(objects)

    def does(self, *instructions: str) -> list[str]:
        """Carry out instructions; return what changed by then, sorted."""
        before = self.state
        for words in instructions:
            self.state = apply(self.task, self.state, self.reader.action(words.split()))
        gone = [f"-{f}" for f in sorted(before - self.state)]
        return [f"+{f}" for f in sorted(self.state - before)] + gone

    def refuses(self, words: str) -> bool:
        with pytest.raises(InapplicableError):
            apply(self.task, self.state, self.reader.action(words.split()))
        return True


def test_moving_keeps_the_robot_near_what_it_was_near() -> None:
    play = Play(KITCHEN, "(Near Robot Sink), (Near Mug_1 Sink)")
    assert play.does("moveto Mug_1") == ["+(Near Robot Mug_1)", "-(Near Mug_1 Sink)"]


def test_grasping_ends_every_relation_to_others_and_only_those() -> None:
    start = "(Near Robot Bowl_1), (On Bowl_1 Sink), (In Mug_1 Bowl_1), (In Bowl_1 Bowl_1)"
    play = Play(KITCHEN, start)
    assert play.does("grasp Bowl_1") == [
        "+(Grasping Robot Bowl_1)",
        "-(In Mug_1 Bowl_1)",
        "-(Near Robot Bowl_1)",
        "-(On Bowl_1 Sink)",
    ]
    assert Fluent("In", ("Bowl_1", "Bowl_1")) in play.state


def test_only_what_is_near_and_graspable_is_grasped() -> None:
    play = Play(KITCHEN, "(Near Robot Stove)")
    assert play.refuses("grasp Mug_1")
    assert play.refuses("grasp Stove")


def test_what_is_let_go_has_no_place() -> None:
    play = Play(KITCHEN, "(Grasping Robot Mug_1)")
    assert play.does("release Mug_1") == ["-(Grasping Robot Mug_1)"]
    assert play.refuses("release Mug_1")


@pytest.mark.parametrize(
    ("thing", "filled"), [("Mug_1", True), ("Plate_1", False), ("Spoon_1", False)]
)
def test_the_tap_fills_what_can_be_poured(thing: str, filled: bool) -> None:
    water = [f"+(state {thing} Water)"] if filled else []
    play = Play(KITCHEN, f"(On {thing} Sink), (Near Robot Sink)")
    assert sorted(play.does("turn SinkKnob")) == sorted(["+(state SinkKnob TapIsOn)", *water])
    running = f"(Grasping Robot {thing}), (Near Robot Sink), (state SinkKnob TapIsOn)"
    assert Play(KITCHEN, running).does(f"keep {thing} On Sink") == [
        f"+(On {thing} Sink)",
        *water,
        f"-(Grasping Robot {thing})",
    ]


def test_turning_the_tap_off_fills_nothing() -> None:
    play = Play(KITCHEN, "(On Mug_1 Sink), (Near Robot Sink), (state SinkKnob TapIsOn)")
    assert play.does("turn SinkKnob") == ["-(state SinkKnob TapIsOn)"]


def test_a_stove_knob_toggles_its_own_fire_from_beside_the_stove() -> None:
    play = Play(KITCHEN, "(Near Robot Stove)")
    assert play.does("turn StoveKnob_2") == ["+(state Stove StoveFire2)"]
    assert play.does("turn StoveKnob_2") == ["-(state Stove StoveFire2)"]
    assert Play(KITCHEN, "(Near Robot StoveKnob_2)").refuses("turn StoveKnob_2")


def test_the_microwave_takes_things_while_open_and_runs_while_shut() -> None:
    play = Play(KITCHEN, "(Near Robot Microwave), (Grasping Robot Mug_1)")
    assert play.does("keep Mug_1 In Microwave") == []
    assert play.does("open Microwave") == ["+(state Microwave DoorIsOpen)"]
    assert play.does("press MicrowaveButton") == []
    assert play.does("keep Mug_1 In Microwave") == [
        "+(In Mug_1 Microwave)",
        "-(Grasping Robot Mug_1)",
    ]
    assert play.does("close Microwave", "press MicrowaveButton") == [
        "+(state Microwave MicrowaveIsOn)",
        "-(state Microwave DoorIsOpen)",
    ]
    assert play.does("open Microwave") == [
        "+(state Microwave DoorIsOpen)",
        "-(state Microwave MicrowaveIsOn)",
    ]


def test_inside_only_lets_go_and_near_puts_beside() -> None:
    start = "(Near Robot Microwave), (Grasping Robot Mug_1), (Grasping Robot Bowl_1)"
    play = Play(KITCHEN, start)
    assert play.does("keep Mug_1 Inside Microwave") == ["-(Grasping Robot Mug_1)"]
    assert play.does("keep Bowl_1 Near Microwave") == [
        "+(Near Bowl_1 Microwave)",
        "-(Grasping Robot Bowl_1)",
    ]


@pytest.mark.parametrize("side", ["Left", "Right"])
def test_either_door_of_the_fridge_will_do(side: str) -> None:
    play = Play(KITCHEN, "(Near Robot Fridge), (Grasping Robot Mug_1)")
    assert play.does(f"open Fridge{side}Door") == [f"+(state Fridge {side}DoorIsOpen)"]
    assert "+(In Mug_1 Fridge)" in play.does("keep Mug_1 In Fridge")
    assert play.does(f"close Fridge{side}Door") == [f"-(state Fridge {side}DoorIsOpen)"]


def test_the_dispenser_fills_what_is_held_and_stops_for_the_left_door() -> None:
    start = "(Near Robot Fridge), (Grasping Robot Mug_1), (Grasping Robot Plate_1)"
    play = Play(KITCHEN, start)
    assert play.does("press FridgeButton") == [
        "+(state Fridge WaterDispenserIsOpen)",
        "+(state Mug_1 Water)",
    ]
    assert play.does("open FridgeRightDoor") == ["+(state Fridge RightDoorIsOpen)"]
    assert play.does("open FridgeLeftDoor") == [
        "+(state Fridge LeftDoorIsOpen)",
        "-(state Fridge WaterDispenserIsOpen)",
    ]
    on = "(Near Robot Fridge), (Grasping Robot Mug_1), (state Fridge WaterDispenserIsOpen)"
    assert Play(KITCHEN, on).does("press FridgeButton") == ["-(state Fridge WaterDispenserIsOpen)"]


def test_pouring_out_empties_and_pouring_into_copies() -> None:
    start = "(Grasping Robot Mug_1), (Grasping Robot Kettle), (state Mug_1 Coffee)"
    play = Play(KITCHEN, start)
    assert play.does("pour Mug_1 Kettle") == ["+(state Kettle Coffee)"]
    assert play.does("pour Mug_1") == ["-(state Mug_1 Coffee)"]
    assert play.refuses("pour Plate_1")


@pytest.mark.parametrize(
    ("into", "shows"), [("Plate_1", True), ("Bowl_1", False), ("Kettle", False)]
)
def test_an_ingredient_shows_unless_the_thing_hides_it(into: str, shows: bool) -> None:
    play = Play(KITCHEN, f"(Grasping Robot BoiledEgg_1), (Grasping Robot {into})")
    egg = [f"+(state {into} Egg)"] if shows else []
    assert play.does(f"add BoiledEgg_1 {into}") == [
        f"+(In BoiledEgg_1 {into})",
        *egg,
        "-(Grasping Robot BoiledEgg_1)",
    ]


def test_ice_cream_goes_by_the_spoon() -> None:
    start = (
        "(Grasping Robot Spoon_1), (Grasping Robot IceCream_1), (Grasping Robot Mug_1), "
        "(state IceCream_1 ScoopsLeft)"
    )
    play = Play(KITCHEN, start)
    assert play.does("add IceCreamScoop Mug_1") == []
    assert play.does("scoop Spoon_1 IceCream_1") == ["+(state Spoon_1 ScoopsLeft)"]
    assert play.does("add IceCreamScoop Mug_1") == [
        "+(state Mug_1 IceCream)",
        "-(state Spoon_1 ScoopsLeft)",
    ]


def test_squeezing_gives_the_flavour() -> None:
    start = "(Grasping Robot Syrup_2), (Grasping Robot Mug_1), (state Syrup_2 Chocolate)"
    assert Play(KITCHEN, start).does("squeeze Syrup_2 Mug_1") == ["+(state Mug_1 Chocolate)"]


def test_the_television_obeys_its_buttons_only_while_on() -> None:
    play = Play(LIVING_ROOM, "(Near Robot Tv_1), (state Tv_1 Channel6), (state Tv_1 Volume)")
    assert play.does("press Tv_1ChannelUpButton", "press Tv_1VolumeDownButton") == []
    assert play.does("press Tv_1PowerButton") == ["+(state Tv_1 IsOn)"]
    assert play.does("press Tv_1ChannelUpButton") == [
        "+(state Tv_1 Channel1)",
        "-(state Tv_1 Channel6)",
    ]
    assert play.does("press Tv_1VolumeDownButton") == ["-(state Tv_1 Volume)"]
    assert play.does("press Tv_1ChannelDownButton") == [
        "+(state Tv_1 Channel6)",
        "-(state Tv_1 Channel1)",
    ]


def test_the_remote_works_in_the_hand() -> None:
    play = Play(LIVING_ROOM, "(Near Robot Tv_1Remote_1)")
    assert play.refuses("press Tv_1Remote_1PowerButton")
    play.does("grasp Tv_1Remote_1")
    assert play.does("press Tv_1Remote_1PowerButton") == ["+(state Tv_1 IsOn)"]


def test_bags_open_in_the_hand_and_take_things_without_a_door() -> None:
    start = "(Grasping Robot BagOfChips_1), (Grasping Robot Pillow_1), (Near Robot GarbageBag_1)"
    play = Play(LIVING_ROOM, start)
    assert play.does("open BagOfChips_1") == ["+(state BagOfChips_1 IsOpen)"]
    assert play.does("close BagOfChips_1") == ["-(state BagOfChips_1 IsOpen)"]
    assert "+(In Pillow_1 GarbageBag_1)" in play.does("keep Pillow_1 In GarbageBag_1")


def test_a_disc_goes_into_the_player() -> None:
    play = Play(LIVING_ROOM, "(Grasping Robot Cd_2), (Grasping Robot Xbox_1)")
    assert play.does("insert Cd_2 Xbox_1") == [
        "+(In Cd_2 Xbox_1)",
        "+(state Xbox_1 CD)",
        "-(Grasping Robot Cd_2)",
    ]
    assert play.refuses("insert Pillow_1 Xbox_1")


def test_waiting_changes_nothing() -> None:
    assert Play(KITCHEN, "(Near Robot Stove)").does("wait") == []


@pytest.mark.parametrize("objects", [KITCHEN, LIVING_ROOM], ids=["kitchen", "living room"])
def test_every_action_of_a_task_is_an_instruction_and_back(
    objects: dict[str, tuple[str, ...]],
) -> None:
    play = Play(objects, "")
    assert len(play.task.actions) > 100
    for ground in play.task.actions:
        if ground.action.name in ("open", "close") and ground.action.args[0] == "MicrowaveDoor":
            assert instruction(ground.action) == f"{ground.action.name} MicrowaveDoor"
        assert play.reader.action(instruction(ground.action).split()) == ground.action


@pytest.mark.parametrize(
    ("words", "action"),
    [
        ("keep Mug_1 On Sink", "keep-on Mug_1 Sink"),
        ("keep Mug_1 Inside Microwave", "keep-inside Mug_1 Microwave"),
        ("pour Mug_1", "pour Mug_1"),
        ("pour Mug_1 Kettle", "pour-into Mug_1 Kettle"),
        ("add IceCreamScoop Mug_1", "add-scoop IceCreamScoop Mug_1"),
        ("turn StoveKnob_2", "turn StoveKnob_2 Stove"),
        ("open Microwave", "open Microwave Microwave"),
        ("dance Mug_1", "dance Mug_1"),
        ("keep Mug_1 Under Sink", "keep Mug_1 Under Sink"),
    ],
)
def test_instructions_and_actions(words: str, action: str) -> None:
    read = Instructions.among(KITCHEN).action(words.split())
    assert str(read) == action
    assert instruction(read) == words


def test_parts_belong_to_the_longest_host() -> None:
    found = hosts([*LIVING_ROOM, "Cd_21"])
    assert found["Tv_1Remote_1PowerButton"] == "Tv_1Remote_1"
    assert found["Tv_1PowerButton"] == "Tv_1"
    assert "Cd_21" not in found


def test_objects_never_seen_before_follow_the_same_rules() -> None:
    objects = {
        "Robot": (),
        "Stove_2": ("Turnable",),
        "Stove_2Knob_7": (),
        "Dishwasher_1": ("Openable", "IsPlaceableIn"),
        "Dishwasher_1Door": (),
        "Chest_1": ("Openable", "IsPlaceableIn"),
        "Jug_9": (G, P, "IsTippable"),
    }
    start = "(Near Robot Stove_2), (Near Robot Dishwasher_1), (Grasping Robot Jug_9), "
    play = Play(objects, start + "(state Jug_9 Lemonade)")
    assert play.does("turn Stove_2Knob_7") == ["+(state Stove_2 StoveFire7)"]
    assert play.does("pour Jug_9") == ["-(state Jug_9 Lemonade)"]
    assert play.does("open Dishwasher_1Door") == ["+(state Dishwasher_1 DoorIsOpen)"]
    assert "+(In Jug_9 Dishwasher_1)" in play.does("keep Jug_9 In Dishwasher_1")
    assert play.does("moveto Chest_1", "open Chest_1") == [
        "+(Near Robot Chest_1)",
        "+(state Chest_1 DoorIsOpen)",
    ]


def test_marks_and_values_that_the_domain_lacks_join_it() -> None:
    room = Room.of(document({"Robot": (), "Jug_9": (G, P, "IsTippable")}, "(state Jug_9 Milk)"))
    domain = room.domain()
    assert domain.constants["Milk"] == "content"
    assert "IsTippable" in domain.static
    assert corpus_domain().predicates.keys() < domain.predicates.keys()
    scene = room.scene("here", frozenset())
    assert scene.affordances("Jug_9") == {"item", G, P, "IsTippable"}


def test_objects_that_only_the_trace_names_are_there() -> None:
    seen = document({"Robot": (), "Mug_1": (G,)}, "(On Mug_1 Shelf_9), (IsGraspable Mug_1)")
    assert Room.of(seen).marks == {"Mug_1": (G,), "Shelf_9": ()}


def test_static_facts_complete_a_recorded_state() -> None:
    recorded = frozenset({Fluent("IsGraspable", ("Mug_1",)), Fluent("On", ("Mug_1", "Sink"))})
    static = fittings({k: v for k, v in KITCHEN.items() if k != "Robot"})
    assert whole(recorded, static) - static == {Fluent("On", ("Mug_1", "Sink"))}
    task = Task(corpus_domain(), {}, static)
    assert run(task, static, [Action("wait")])[-1] == static


@pytest.mark.parametrize(
    ("object_id", "name"),
    [
        ("BagOfChips_1", "bag of chips"),
        ("Tv_1Remote_1", "tv remote"),
        ("StoveFire_2", "stove fire"),
        ("XboxController_1", "xbox controller"),
    ],
)
def test_names_are_spoken_as_words(object_id: str, name: str) -> None:
    assert spoken_name(object_id) == name

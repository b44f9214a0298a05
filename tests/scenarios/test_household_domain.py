"""What the household's actions do, each rule once, in the bundled rooms."""

from __future__ import annotations

from functools import cache

import pytest

from verbteach.world.fluents import Fluent, Goal, Literal, State
from verbteach.world.plan import Action, Plan
from verbteach.world.planner import SearchPlanner
from verbteach.world.simulator import InapplicableError, Unmet, apply, run
from verbteach.world.task import Task
from verbteach_scenarios.scenes import load_scene, scene_ids


@cache
def task(scene_id: str) -> Task:
    return Task.from_scene(load_scene(scene_id))


@cache
def planner(scene_id: str) -> SearchPlanner:
    return SearchPlanner(task(scene_id))


def after(scene_id: str, *steps: str) -> State:
    state = load_scene(scene_id).initial
    for step in steps:
        state = apply(task(scene_id), state, Action.parse(step))
    return state


def refused(scene_id: str, *steps: str) -> str:
    state = after(scene_id, *steps[:-1])
    with pytest.raises(InapplicableError) as caught:
        apply(task(scene_id), state, Action.parse(steps[-1]))
    unmet = (o for o in caught.value.obstacles if isinstance(o, Unmet))
    return " ".join(str(obstacle.literal) for obstacle in unmet)


def holds(state: State, *facts: str) -> bool:
    return all(Literal.parse(fact).holds(state) for fact in facts)


BOIL = (
    "moveto Kettle_1",
    "grasp Kettle_1",
    "moveto Burner_1",
    "set-on Kettle_1 Burner_1",
    "moveto StoveKnob_1",
    "turn StoveKnob_1",
)


def test_water_boils_on_a_burning_burner() -> None:
    """The paper's Figure 1: the water's temperature is high afterwards."""
    state = after("kitchen-1", *BOIL)
    assert holds(state, "(hot Water)", "(hot Kettle_1)", "(is-on Burner_1)")
    assert not holds(after("kitchen-1", *BOIL[:-1]), "(hot Water)")


def test_a_burner_that_burns_already_heats_what_is_set_on_it() -> None:
    steps = (*BOIL[4:], *BOIL[:4])
    assert holds(after("kitchen-1", *steps), "(hot Water)", "(hot Kettle_1)")


def test_a_knob_turns_its_burner_on_and_off() -> None:
    state = after("kitchen-1", *BOIL, "turn StoveKnob_1")
    assert holds(state, "(not (is-on Burner_1))", "(hot Water)")


def test_what_comes_into_a_hot_pot_later_needs_time() -> None:
    steps = (
        *BOIL,
        "moveto Fridge_1",
        "open Fridge_1",
        "take-out Egg_1 Fridge_1",
        "moveto Kettle_1",
        "add Egg_1 Kettle_1",
    )
    assert not holds(after("kitchen-1", *steps), "(hot Egg_1)")
    assert holds(after("kitchen-1", *steps, "wait"), "(hot Egg_1)", "(not (cold Egg_1))")


def test_a_microwave_heats_a_dish_and_what_is_in_it_once_it_is_shut() -> None:
    steps = (
        "moveto Ramen_1",
        "grasp Ramen_1",
        "moveto Cupboard_1",
        "take-out Bowl_1 Cupboard_1",
        "add Ramen_1 Bowl_1",
        "moveto Microwave_1",
        "open Microwave_1",
        "put-in Bowl_1 Microwave_1",
    )
    inside = after("kitchen-2", *steps)
    assert holds(inside, "(stowed Bowl_1)", "(stowed Ramen_1)")
    assert "(open Microwave_1)" in refused("kitchen-2", *steps, "start Microwave_1")
    state = after("kitchen-2", *steps, "close Microwave_1", "start Microwave_1")
    assert holds(state, "(hot Bowl_1)", "(hot Ramen_1)", "(is-on Microwave_1)")
    opened = (*steps, "close Microwave_1", "start Microwave_1", "open Microwave_1")
    assert holds(after("kitchen-2", *opened), "(not (is-on Microwave_1))")
    out = after("kitchen-2", *opened, "take-out Bowl_1 Microwave_1")
    assert holds(out, "(not (stowed Ramen_1))", "(in Ramen_1 Bowl_1)")


def test_one_must_open_a_door_to_reach_inside() -> None:
    shut = refused("kitchen-1", "moveto Fridge_1", "take-out MilkCarton_1 Fridge_1")
    assert shut == "(open Fridge_1)"
    assert "stowed" in refused("kitchen-1", "moveto MilkCarton_1", "grasp MilkCarton_1")
    put = refused(
        "kitchen-1", "moveto Beer_1", "grasp Beer_1", "moveto Fridge_1", "put-in Beer_1 Fridge_1"
    )
    assert "(open Fridge_1)" in put


def test_a_fridge_cools_things_and_the_drink_in_them() -> None:
    steps = ("moveto Mug_2", "grasp Mug_2", "moveto Fridge_1", "open Fridge_1")
    state = after("kitchen-2", *steps, "put-in Mug_2 Fridge_1")
    assert holds(state, "(cold Mug_2)", "(cold Coffee)", "(stowed Mug_2)")


def test_two_hands_hold_two_things() -> None:
    two = ("moveto Mug_2", "grasp Mug_2", "moveto Bowl_1", "grasp Bowl_1")
    assert holds(after("kitchen-1", *two), "(hands-full Robot)")
    assert "hands-full" in refused("kitchen-1", *two, "moveto Beer_1", "grasp Beer_1")
    one = after("kitchen-1", *two, "moveto Table_1", "put-on Mug_2 Table_1")
    assert holds(one, "(not (hands-full Robot))", "(carrying Robot)")
    none = after(
        "kitchen-1", *two, "moveto Table_1", "put-on Mug_2 Table_1", "put-on Bowl_1 Table_1"
    )
    assert holds(none, "(not (carrying Robot))", "(in Apple_1 Bowl_1)")


def test_held_things_stay_near_and_others_do_not() -> None:
    state = after("kitchen-1", "moveto Mug_2", "grasp Mug_2", "moveto Sink_1", "moveto Table_1")
    near = {f.args[1] for f in state if f.predicate == "near"}
    assert near == {"Mug_2", "Table_1"}


def test_a_running_tap_fills_and_rinses() -> None:
    steps = ("moveto Mug_2", "grasp Mug_2", "moveto Tap_1", "turn-on Tap_1")
    filled = after("kitchen-1", *steps, "fill Mug_2 Tap_1")
    assert holds(filled, "(has Mug_2 Water)", "(dirty Mug_2)")
    rinsed = after("kitchen-1", *steps, "moveto Sink_1", "drop-in Mug_2 Sink_1")
    assert holds(rinsed, "(has Mug_2 Water)", "(not (dirty Mug_2))", "(in Mug_2 Sink_1)")
    assert "(is-on Tap_1)" in refused("kitchen-1", *steps, "turn-off Tap_1", "fill Mug_2 Tap_1")


def test_turning_on_a_tap_reaches_what_lies_in_the_sink() -> None:
    state = after("kitchen-2", "moveto Tap_1", "turn-on Tap_1")
    assert holds(state, "(not (dirty Pot_1))", "(has Pot_1 Water)", "(not (dirty Bowl_2))")


def test_supplies_do_not_run_out_and_vessels_do() -> None:
    steps = ("moveto Jug_1", "grasp Jug_1", "moveto Mug_3", "pour Jug_1 Mug_3")
    poured = after("kitchen-3", *steps)
    assert holds(poured, "(has Mug_3 Milk)", "(not (has Jug_1 Milk))")
    steps = ("moveto Syrup_1", "grasp Syrup_1", "moveto Mug_1", "squeeze Syrup_1 Mug_1")
    twice = after("kitchen-1", *steps, "moveto Bowl_1", "squeeze Syrup_1 Bowl_1")
    assert holds(twice, "(has Mug_1 Syrup)", "(has Bowl_1 Syrup)")


def test_emptying_a_vessel_leaves_food_in_the_bin() -> None:
    steps = ("moveto Bowl_1", "grasp Bowl_1", "moveto Bin_1", "empty Bowl_1 Bin_1")
    state = after("kitchen-1", *steps)
    assert holds(
        state, "(in Apple_1 Bin_1)", "(not (in Apple_1 Bowl_1))", "(grasping Robot Bowl_1)"
    )


def test_instant_coffee_is_made_by_stirring_it_into_a_hot_cup() -> None:
    steps = (
        *BOIL,
        "moveto Cupboard_1",
        "open Cupboard_1",
        "take-out CoffeeJar_1 Cupboard_1",
        "moveto Mug_1",
        "pour CoffeeJar_1 Mug_1",
        "moveto Table_1",
        "put-on CoffeeJar_1 Table_1",
        "moveto Kettle_1",
        "grasp Kettle_1",
        "moveto Mug_1",
        "pour Kettle_1 Mug_1",
        "moveto Ladle_1",
        "grasp Ladle_1",
        "moveto Mug_1",
    )
    assert holds(after("kitchen-1", *steps), "(hot Mug_1)", "(not (has Mug_1 Coffee))")
    state = after("kitchen-1", *steps, "stir Mug_1 Ladle_1")
    assert holds(state, "(has Mug_1 Coffee)", "(hot Coffee)", "(not (has Mug_1 Water))")


def test_buttons_change_a_screen_only_while_it_is_on() -> None:
    dark = after("living-room-3", "moveto ChannelUp_1", "press ChannelUp_1")
    assert holds(dark, "(channel Tv_1 Sports)")
    steps = ("moveto Remote_1", "grasp Remote_1", "click Remote_1 Tv_1", "moveto ChannelUp_1")
    state = after("living-room-3", *steps, "press ChannelUp_1", "press ChannelUp_1")
    assert holds(state, "(is-on Tv_1)", "(channel Tv_1 Music)", "(not (channel Tv_1 Sports))")
    quieter = after("living-room-3", *steps, "moveto VolumeDown_1", "press VolumeDown_1")
    assert holds(quieter, "(volume Tv_1 Normal)", "(not (volume Tv_1 Loud))")
    assert holds(after("living-room-3", *steps, "click Remote_1 Tv_1"), "(not (is-on Tv_1))")


def test_a_washer_cleans_what_is_in_it() -> None:
    state = after("kitchen-4", "moveto Dishwasher_1", "start Dishwasher_1")
    assert holds(state, "(not (dirty Mug_4))", "(dirty Mug_3)")


def test_things_change_hands() -> None:
    steps = ("moveto Mug_1", "grasp Mug_1", "moveto Person", "hand-over Mug_1 Person")
    given = after("kitchen-1", *steps)
    assert holds(given, "(grasping Person Mug_1)", "(not (carrying Robot))")
    back = after("kitchen-1", *steps, "grasp Mug_1")
    assert holds(back, "(grasping Robot Mug_1)", "(not (grasping Person Mug_1))")


def test_candles_are_lit_with_something_that_burns() -> None:
    steps = ("moveto Lighter_1", "grasp Lighter_1", "moveto Candle_1", "light Candle_1 Lighter_1")
    assert holds(after("living-room-5", *steps), "(lit Candle_1)")
    assert holds(
        after("living-room-5", "moveto Candle_2", "extinguish Candle_2"), "(not (lit Candle_2))"
    )
    assert refused("living-room-5", "moveto Candle_1", "light Candle_1 Lighter_1")


def test_a_plant_takes_the_water() -> None:
    steps = ("moveto Glass_1", "grasp Glass_1", "moveto Flower_1", "water Flower_1 Glass_1")
    state = after("living-room-1", *steps)
    assert holds(state, "(watered Flower_1)", "(not (has Glass_1 Water))")


def test_putting_something_next_to_a_lamp_puts_it_on_the_lamps_table() -> None:
    steps = ("moveto Remote_1", "grasp Remote_1", "moveto Lamp_1", "put-near Remote_1 Lamp_1")
    state = after("living-room-1", *steps)
    assert holds(state, "(beside Remote_1 Lamp_1)", "(on Remote_1 TvTable_1)")
    away = after("living-room-1", *steps, "grasp Remote_1")
    assert holds(away, "(not (beside Remote_1 Lamp_1))", "(not (on Remote_1 TvTable_1))")


GOALS = {
    "kitchen-1": ["(hot Water)", "(hot Milk)", "(has Mug_1 Coffee)", "(in Beer_1 Bin_1)"],
    "kitchen-2": ["(hot Ramen_1)", "(not (dirty Pot_1))", "(volume Radio_1 Loud)"],
    "kitchen-3": ["(hot Bread_1)", "(sliced Cheese_1)", "(lit Candle_1)", "(watered Plant_1)"],
    "kitchen-4": ["(has Mug_1 Coffee)", "(has Mug_1 Tea)", "(not (dirty Mug_3))"],
    "kitchen-5": ["(hot Dough_1)", "(has Bowl_3 Flour)", "(topped Cake_1 Honey)"],
    "kitchen-6": ["(hot Pasta_1)", "(has WineGlass_1 Wine)", "(not (is-on Tap_1))"],
    "living-room-1": ["(in Dvd_2 DvdPlayer_1)", "(channel Tv_1 News)", "(folded Blanket_1)"],
    "living-room-6": ["(is-on FairyLights_1)", "(in Newspaper_1 Bin_1)", "(watered Fern_1)"],
}


@pytest.mark.parametrize("scene_id", sorted(GOALS))
def test_everyday_goals_are_within_reach(scene_id: str) -> None:
    start = load_scene(scene_id).initial
    for text in GOALS[scene_id]:
        goal: Goal = frozenset({Literal.parse(text)})
        answer = planner(scene_id).plan(start, goal)
        assert isinstance(answer, Plan), text
        end = run(task(scene_id), start, answer.actions)[-1]
        assert holds(end, text)


@pytest.mark.parametrize("scene_id", scene_ids())
def test_rooms_ground_to_a_size_that_plans_fast(scene_id: str) -> None:
    assert len(task(scene_id).actions) < 6000


def test_every_action_can_be_done_in_some_room() -> None:
    domain = load_scene("kitchen-1").domain
    found = {a.action.name for scene_id in scene_ids() for a in task(scene_id).actions}
    assert found == set(domain.actions)


def test_the_robot_is_no_place_to_go() -> None:
    assert task("kitchen-1").action(Action("moveto", ("Robot",))) is None
    assert task("kitchen-1").action(Action("moveto", ("Kettle_1",))) is not None


def test_facts_that_never_change_are_static() -> None:
    domain = load_scene("kitchen-1").domain
    assert {"openable", "contains", "controls", "landmark"} <= domain.static
    assert not {"near", "on", "has", "hot"} & domain.static
    assert Fluent("contains", ("MilkCarton_1", "Milk")) in task("kitchen-1").static

"""Steps in people's own words: what a newcomer types is the action meant, a question, or a hint."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import pytest

from verbteach.dialogue.setting import Setting
from verbteach.dialogue.speech import Speech
from verbteach.language.step_patterns import step_words, ways_in, ways_of_saying
from verbteach.language.steps import StepReader
from verbteach.world.plan import Action
from verbteach.world.simulator import run
from verbteach_scenarios.scenes import scene_ids
from verbteach_scenarios.settings import make_settings

AT_KETTLE = ("moveto Kettle_1",)
WITH_KETTLE = (*AT_KETTLE, "grasp Kettle_1")
AT_BURNER = (*WITH_KETTLE, "moveto Burner_1")
SET_DOWN = (*AT_BURNER, "set-on Kettle_1 Burner_1", "moveto StoveKnob_1")
AT_FRIDGE = ("moveto Fridge_1", "open Fridge_1")

_settings = cache(make_settings)


@cache
def setting(scene: str) -> Setting:
    return _settings()(scene)


def reader(*done: str, scene: str = "kitchen-1") -> StepReader:
    """Reads steps in the scene after the steps ``done``."""
    here = setting(scene)
    steps = [Action.parse(step) for step in done]
    world = run(here.task, here.scene.initial, steps)[-1]
    named = [thing for step in steps for thing in step.args]
    latest_last = tuple(dict.fromkeys(reversed(named)))[::-1]
    speech = Speech.of(here, world)
    return StepReader(here.task, speech.looks, speech.words, here.vocabulary, latest_last)


@pytest.mark.parametrize(
    ("done", "text", "meant"),
    [
        ((), "walk to the kettle", "moveto Kettle_1"),
        ((), "could you please go over to the kettle now?", "moveto Kettle_1"),
        ((), "then you approach the left burner", "moveto Burner_1"),
        (AT_KETTLE, "pick up the kettle", "grasp Kettle_1"),
        (AT_KETTLE, "pick the kettle up", "grasp Kettle_1"),
        (AT_KETTLE, "pick it up", "grasp Kettle_1"),
        (AT_KETTLE, "grab the kettle from the counter", "grasp Kettle_1"),
        (AT_BURNER, "put the kettle on the left burner", "set-on Kettle_1 Burner_1"),
        (AT_BURNER, "put it down", "set-on Kettle_1 Burner_1"),
        (SET_DOWN, "turn on the left burner", "turn StoveKnob_1"),
        (SET_DOWN, "switch the knob on the left on", "turn StoveKnob_1"),
        (SET_DOWN, "turn it on", "turn StoveKnob_1"),
        (("moveto Fridge_1",), "pull open the fridge", "open Fridge_1"),
        (AT_FRIDGE, "take the egg", "take-out Egg_1 Fridge_1"),
        (AT_FRIDGE, "take the egg from the fridge", "take-out Egg_1 Fridge_1"),
        (AT_FRIDGE, "shut it", "close Fridge_1"),
        ((), "wait a moment", "wait"),
    ],
)
def test_what_people_type_is_the_action_they_mean(
    done: tuple[str, ...], text: str, meant: str
) -> None:
    found = reader(*done).read(text)
    assert (str(found.action), found.problem) == (str(Action.parse(meant)), "")


def test_what_could_be_several_is_asked_and_settled_by_naming_one_of_them() -> None:
    here = reader(*WITH_KETTLE)
    found = here.read("put it on the stove")
    assert found.action is None
    assert found.open
    assert "on the left burner or" in found.problem
    for which, meant in (
        ("the right one", "Burner_2"),
        ("left", "Burner_1"),
        ("the left burner", "Burner_1"),
    ):
        settled = here.read(which, before="put it on the stove")
        assert settled.action == Action("set-on", ("Kettle_1", meant)), which


def test_an_action_that_cannot_be_done_is_read_all_the_same() -> None:
    assert reader().read("pick up the kettle").action == Action("grasp", ("Kettle_1",))
    assert reader().read("open the apple").action == Action("open", ("Apple_1",))


@pytest.mark.parametrize(
    ("text", "hint"),
    [
        ("take the ketle", "If you mean the kettle, please say it like that."),
        ("go to ze kettle", "If you mean the kettle, please say it like that."),
        ("take the unicorn", 'nothing here that I would call "the unicorn"'),
        ("put the kettle", '"put … on …"'),
        ("tkae the kettle", 'If you mean "take"'),
        ("boil the water", 'no step that begins with "boil"'),
        ("take it", 'What do you mean by "it"'),
        ("", "one step after the other"),
    ],
)
def test_what_cannot_be_read_gets_a_hint_and_is_never_guessed(text: str, hint: str) -> None:
    found = reader().read(text)
    assert found.action is None
    assert hint in found.problem


def test_a_noun_phrase_takes_in_all_that_was_said() -> None:
    found = reader().read("take the kettle and open the fridge")
    assert found.action is None


def test_several_steps_in_a_line_are_taken_apart() -> None:
    parts = reader().parts("go to the kettle, take it, and then walk to the left burner")
    assert [" ".join(step_words(part)) for part in parts] == [
        "go to the kettle", "take it", "walk to the left burner",
    ]  # fmt: skip
    assert reader().parts("go to the salt and pepper") == ("go to the salt and pepper",)
    assert len(reader().parts("go to the kettle and put it down there")) == 2


@pytest.mark.parametrize("scene", ["kitchen-1", "living-room-1"])
def test_every_action_is_read_from_the_words_that_the_robot_uses(scene: str) -> None:
    """What the lists and the completion offer is among what is understood."""
    here = setting(scene)
    patterns = ways_of_saying(here.task.domain, here.lexicon)
    words = Speech.of(here, here.scene.initial).words
    for ground in here.task.actions[::37]:
        ways = ways_in(step_words(words.action(ground.action)), patterns)
        assert any(way.name == ground.action.name for way in ways), ground.action


def test_the_patterns_name_actions_of_the_domain_and_slots_that_these_have() -> None:
    here = setting(scene_ids()[0])
    assert set(here.lexicon.steps) <= set(here.task.domain.actions)
    for name, patterns in here.lexicon.steps.items():
        arity = len(here.task.domain.actions[name].parameters)
        slots = {word for pattern in patterns for word in pattern.split() if word[0] == "{"}
        assert slots <= {f"{{{place}}}" for place in range(arity)}, name


def test_a_pattern_with_a_slot_too_many_is_left_out() -> None:
    here = setting("kitchen-1")
    lexicon = replace(
        here.lexicon, steps={"wait": ("wait for {0}", "linger"), "open": ("ope {7}",)}
    )
    patterns = ways_of_saying(here.task.domain, lexicon)
    assert ways_in(("linger",), patterns)[0].name == "wait"
    assert ways_in(("ope", "it"), patterns) == ()

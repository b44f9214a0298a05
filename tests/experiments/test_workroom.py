"""Rooms of experiments, what is seen in them, and actions carried out in the mind."""

from __future__ import annotations

import pickle
from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.experiments.shelves import DOMAIN, KEY, OBJECTS, STARTS, instances, planner, room, task
from verbteach.experiments.sight import Sight, stream
from verbteach.experiments.workroom import furnish, furnished
from verbteach.perception.belief import Exclusivity
from verbteach.perception.noise import NoiseModel
from verbteach.verbs.instance import Instance
from verbteach.world.fluents import Fluent, State
from verbteach.world.plan import Action
from verbteach.world.task import Task

shown = st.sampled_from(instances())


@given(shown)
def test_what_is_seen_whole_is_reenacted_as_it_was(instance: Instance) -> None:
    assert room().reenact(instance.start, instance.actions) == (instance.start, instance.end)


@given(shown, st.data())
def test_reenacting_mends_what_the_actions_prove(instance: Instance, data: st.DataObject) -> None:
    """Take any fluent away: where the actions needed it, it is back; else only it is missing."""
    lost = data.draw(st.sampled_from(sorted(instance.start)))
    start, end = room().reenact(instance.start - {lost}, instance.actions)
    needed = lost.predicate == "free" or lost.args[:1] == instance.grounding[:1]
    if needed and len(instance.actions) > 1:
        assert (start, end) == (instance.start, instance.end)
    else:
        assert start == instance.start - {lost}
        assert end == instance.end - {lost}


def test_actions_that_nobody_knows_are_left_out() -> None:
    state = STARTS["attic"]
    assert room().reenact(state, (Action("fly", ("Box_1",)),)) == (state, state)


def test_one_step_away_is_what_some_action_makes_true() -> None:
    found = room().one_step_away(STARTS["attic"])
    assert found == {Fluent("lit", ("Lamp_1",))} | {
        Fluent("held", (f"Box_{i}",)) for i in (1, 2, 3)
    }


def test_a_room_is_furnished_once_for_copies_of_a_task() -> None:
    copy = Task(DOMAIN, OBJECTS, frozenset())
    first = furnished(KEY, task(), planner)
    assert furnished(KEY, copy, planner) is first
    smaller = Task(DOMAIN, {"Box_1": "box", "Shelf_1": "shelf"}, frozenset())
    assert furnished(KEY, smaller, planner).task is smaller
    assert set(furnish({KEY: task()}, planner)) == {KEY}


def believed(sight: Sight, instance: Instance) -> tuple[State, State, State]:
    seen = sight.demonstrated(instance, room())
    return seen.start.believed(), seen.end.believed(), sight.met(instance, room()).believed()


def test_a_draw_is_the_instances_own() -> None:
    found = instances()
    noise = NoiseModel.named("std5", "phantom")
    one, whole = Sight.of(noise, found[:1]), Sight.of(noise, found)
    assert believed(one, found[0]) == believed(whole, found[0])
    assert believed(whole, found[0]) != believed(replace(whole, run=1), found[0])
    assert believed(whole, found[0]) != believed(replace(whole, seed=1), found[0])
    twin = replace(found[0], id="twin")
    assert believed(whole, twin) != believed(whole, found[0])


def test_who_knows_no_rules_sees_what_the_eyes_see() -> None:
    noise = NoiseModel.named("std5", "phantom")
    plain = Sight.of(noise, instances())
    ruled = Sight.of(noise, instances(), exclusive=(Exclusivity((("on", 0),), joint=True),))
    assert ruled.unruled == plain
    assert plain.unruled is plain


def test_what_was_seen_is_remembered_by_a_part_of_the_draw_and_by_no_copy() -> None:
    sight, first = Sight.of(NoiseModel.named("std5"), instances()), instances()[0]
    seen = sight.met(first, room())
    assert sight.only({first.group}).met(first, room()) is seen
    assert replace(sight, run=1).met(first, room()) != seen
    posted = pickle.loads(pickle.dumps(sight))
    assert posted.met(first, room()) == seen
    assert posted.met(first, room()) is not seen


def test_perfect_eyes_see_the_truth() -> None:
    first = instances()[0]
    assert believed(Sight(), first) == (first.start, first.end, first.start)


def test_looking_before_a_demonstration_and_before_a_command_differ() -> None:
    noise = NoiseModel.named("uniform")
    looks = [believed(Sight(noise), i) for i in instances()]
    assert any(look[0] != look[2] for look in looks)


@pytest.mark.parametrize("phantoms", [False, True])
def test_phantoms_come_from_elsewhere_in_the_document_and_one_step_away(phantoms: bool) -> None:
    found = instances()
    noise = NoiseModel(0.5, clipped=True, phantoms=phantoms)
    sight = Sight.of(noise, found)
    first = found[0]
    seen = {f for f, _ in sight.met(first, room()).items()}
    possible = sight.elsewhere.get(first.group, frozenset()) | room().one_step_away(first.start)
    assert seen <= first.start | possible
    assert (seen <= first.start) == (not phantoms)


def test_streams_are_told_apart_by_every_name() -> None:
    names = [(0, 0, "a"), (0, 1, "a"), (1, 0, "a"), (0, 0, "b"), (0, 0)]
    draws = {float(stream(*name).random()) for name in names}
    assert len(draws) == len(names)

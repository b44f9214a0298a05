from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from tests.scenarios.tell_me_dave_folder import (
    CLAUSES,
    FILLING,
    OBJECTS,
    REAL,
    needs_corpus,
    write_document,
)
from verbteach.experiments.gold import gold_sequence, whole_change
from verbteach.verbs.instance import Instance
from verbteach.world.fluents import Fluent, State
from verbteach.world.plan import Action
from verbteach.world.planner import SearchPlanner
from verbteach.world.simulator import run
from verbteach_scenarios.tell_me_dave.corpus import read_corpus
from verbteach_scenarios.tell_me_dave.instances import FILTERS, CorpusInstance, instances
from verbteach_scenarios.tell_me_dave.instructions import instruction
from verbteach_scenarios.tell_me_dave.rooms import Rooms
from verbteach_scenarios.tell_me_dave.splits import environments, leave_one_environment_out


def of_folder(folder: Path) -> tuple[CorpusInstance, ...]:
    return instances(read_corpus(folder))


def test_an_instance_holds_what_its_clause_says(tmp_path: Path) -> None:
    put, fill = of_folder(write_document(tmp_path))
    assert put.instance.id == "0007-00"
    assert put.instance.group == "7"
    assert put.instance.frame == ("put", 2)
    assert put.instance.phrases == ("cup", "sink")
    assert put.instance.candidates == (("Mug_1", "Bowl_1"), ("Sink",))
    assert put.instance.grounding == ("Mug_1", "Sink")
    assert put.instance.goal is None
    assert put.noun_phrases == ("cup", "sink")
    assert [instruction(a) for a in fill.instance.actions] == ["turn SinkKnob", "wait"]
    assert [instruction(a) for a in fill.instance.gold] == ["turn SinkKnob"]
    assert fill.instance.end - fill.instance.start == {
        Fluent("state", ("Mug_1", "Water")),
        Fluent("state", ("SinkKnob", "TapIsOn")),
    }
    assert put.instance.task_key == fill.instance.task_key
    assert put.instance.environment == fill.instance.environment


def test_the_actions_of_an_instance_lead_from_its_start_to_its_end(tmp_path: Path) -> None:
    corpus = read_corpus(write_document(tmp_path))
    rooms = Rooms.of(corpus)
    for one in instances(corpus, rooms=rooms):
        task = rooms.task(one.instance.task_key)
        assert run(task, one.instance.start, one.instance.actions)[-1] == one.instance.end


def test_the_gold_object_is_one_that_changed(tmp_path: Path) -> None:
    clauses = [(0, 3, "put the cup away", "put", "(cup,Bowl_1) (cup,Mug_1) (knob,SinkKnob)")]
    (one,) = of_folder(write_document(tmp_path, clauses=clauses))
    assert one.instance.narrowed == (("Mug_1",), ("SinkKnob",))
    assert one.instance.grounding == ("Mug_1", "SinkKnob")
    assert "Bowl_1" not in one.instance.changed_objects


def test_filters_choose_clauses(tmp_path: Path) -> None:
    clauses = [*CLAUSES, (2, 3, "so", "so", ""), (5, 5, "wait for it", "wait", "(it,Mug_1)")]
    corpus = read_corpus(write_document(tmp_path, clauses=clauses))
    verbs = {
        name: [one.instance.verb for one in instances(corpus, chosen)]
        for name, chosen in FILTERS.items()
    }
    assert verbs == {
        "acted": ["put", "fill", "so", "wait"],
        "acted-on-phrase": ["put", "fill", "so", "wait"],
        "acted-on-object": ["put", "fill", "wait"],
        "changed-something": ["put", "fill"],
    }


def test_equal_beginnings_are_one_environment(tmp_path: Path) -> None:
    write_document(tmp_path, "1")
    write_document(tmp_path, "2", clauses=CLAUSES[:1])
    elsewhere = [(state.replace("Counter_1", "Bowl_1"), words) for state, words in FILLING]
    write_document(tmp_path, "3", steps=elsewhere)
    write_document(tmp_path, "4", objects=OBJECTS + " (Stove:Turnable)")
    corpus = read_corpus(tmp_path)
    rooms = Rooms.of(corpus)
    one, two, three, four = (rooms.environments[name] for name in "1234")
    assert one == two
    assert len({one, three, four}) == 3
    assert rooms.of_document["1"] == rooms.of_document["3"] != rooms.of_document["4"]
    assert rooms.task(rooms.of_document["1"]) is rooms.task(rooms.of_document["3"])
    assert rooms.scene(corpus.documents[0]).id == one


def test_each_environment_is_held_out_once(tmp_path: Path) -> None:
    write_document(tmp_path, "1")
    write_document(tmp_path, "2", objects=OBJECTS + " (Stove:Turnable)")
    write_document(tmp_path, "3", objects=OBJECTS + " (Fridge:)")
    found = [one.instance for one in of_folder(tmp_path)]
    folds = list(leave_one_environment_out(found))
    assert tuple(fold.environment for fold in folds) == environments(found)
    assert sorted(i.id for fold in folds for i in fold.test) == [i.id for i in found]
    for fold in folds:
        assert {i.environment for i in fold.test} == {fold.environment}
        assert fold.environment not in environments(fold.train)
        assert len(fold.train) + len(fold.test) == len(found)


def test_one_environment_cannot_be_held_out(tmp_path: Path) -> None:
    found = [one.instance for one in of_folder(write_document(tmp_path))]
    with pytest.raises(ValueError, match="none can be held out"):
        next(leave_one_environment_out(found))


def steps_of(*instructions: str) -> list[tuple[str, str]]:
    """A trace of moves of a mug between counter and sink; its states are worked out here."""
    facts = {"(On Mug_1 Counter_1)"}
    found = []
    for words in instructions:
        found.append((",".join(sorted(facts)), words))
        name, *args = words.split()
        if name == "moveto":
            facts.add(f"(Near Robot {args[0]})")
        elif name == "grasp":
            facts = {f for f in facts if "Mug_1" not in f} | {"(Grasping Robot Mug_1)"}
        elif name == "keep":
            facts.discard("(Grasping Robot Mug_1)")
            facts.add(f"(On Mug_1 {args[2]})")
    return [*found, (",".join(sorted(facts)), "")]


TAKE, BACK, SINK = "moveto Mug_1|grasp Mug_1", "keep Mug_1 On Counter_1", "keep Mug_1 On Sink"


@pytest.mark.parametrize(
    ("recorded", "left"),
    [
        pytest.param("moveto Mug_1|wait|grasp Mug_1", TAKE, id="waiting"),
        pytest.param(
            f"moveto Sink|{TAKE}|moveto Counter_1|{BACK}", "moveto Sink", id="put back again"
        ),
        pytest.param(
            f"moveto Counter_1|{TAKE}|{BACK}|{TAKE}|moveto Sink|{SINK}",
            f"moveto Counter_1|{TAKE}|moveto Sink|{SINK}",
            id="put back before the real move",
        ),
        pytest.param(f"{TAKE}|{TAKE}", TAKE, id="taking what is held"),
        pytest.param(
            f"{TAKE}|moveto Sink|{SINK}|moveto Sink", f"{TAKE}|moveto Sink|{SINK}", id="going"
        ),
        pytest.param(
            f"{TAKE}|moveto Sink|{SINK}|{TAKE}|moveto Counter_1|{BACK}",
            f"{TAKE}|moveto Sink|{SINK}|{TAKE}|moveto Counter_1|{BACK}",
            id="there and back is no single move",
        ),
        pytest.param("wait|wait", "wait|wait", id="nothing would be left"),
    ],
)
def test_needless_moves_are_taken_out(tmp_path: Path, recorded: str, left: str) -> None:
    steps = steps_of(*recorded.split("|"))
    clauses = [(0, len(steps) - 2, "move the cup", "move", "(cup,Mug_1)")]
    (one,) = of_folder(write_document(tmp_path, steps=steps, clauses=clauses))
    assert [instruction(a) for a in one.instance.gold] == left.split("|")
    assert [instruction(a) for a in one.instance.actions] == recorded.split("|")


def planned(instance: Instance, rooms: Rooms) -> tuple[Action, ...]:
    task = rooms.task(instance.task_key)
    return gold_sequence(instance, task, SearchPlanner(task))


def test_the_planners_order_stands_where_it_is_as_short(tmp_path: Path) -> None:
    steps = [
        ("(On Mug_1 Counter_1)", "moveto Sink"),
        ("(On Mug_1 Counter_1),(Near Robot Sink)", "moveto Mug_1"),
        ("(On Mug_1 Counter_1),(Near Robot Sink),(Near Robot Mug_1)", "grasp Mug_1"),
        ("(Near Robot Sink),(Grasping Robot Mug_1)", "keep Mug_1 On Sink"),
        ("(Near Robot Sink),(On Mug_1 Sink)", ""),
    ]
    clauses = [(0, 3, "put the cup in the sink", "put", "(cup,Mug_1)")]
    corpus = read_corpus(write_document(tmp_path, steps=steps, clauses=clauses))
    rooms = Rooms.of(corpus)
    (one,) = instances(corpus, rooms=rooms)
    own = planned(one.instance, rooms)
    assert [instruction(a) for a in own] == [
        "moveto Mug_1",
        "grasp Mug_1",
        "moveto Sink",
        "keep Mug_1 On Sink",
    ]
    assert run(rooms.task(one.instance.task_key), one.instance.start, own)[-1] == one.instance.end
    longer = replace(one.instance, gold=(*one.instance.gold, Action("wait")))
    assert planned(longer, rooms) == longer.gold


def test_the_demonstration_stands_where_no_plan_reaches_its_change(tmp_path: Path) -> None:
    corpus = read_corpus(write_document(tmp_path))
    rooms = Rooms.of(corpus)
    put, _ = instances(corpus, rooms=rooms)
    task = rooms.task(put.instance.task_key)
    magic: State = put.instance.end | {Fluent("state", ("Bowl_1", "HasChips"))}
    odd = replace(put.instance, end=magic)
    assert len(whole_change(odd, task)) == len(whole_change(put.instance, task)) + 1
    assert planned(odd, rooms) == odd.gold


def test_an_instance_with_a_gold_object_outside_the_candidates_is_refused(tmp_path: Path) -> None:
    put, _ = of_folder(write_document(tmp_path))
    with pytest.raises(ValueError, match="not a candidate"):
        replace(put.instance, grounding=("SinkKnob", "Sink"))
    with pytest.raises(ValueError, match="one of each a phrase"):
        replace(put.instance, grounding=("Mug_1",))


@needs_corpus
def test_the_real_instances_have_the_known_figures() -> None:
    corpus = read_corpus(REAL)
    rooms = Rooms.of(corpus)
    found = instances(corpus, rooms=rooms)
    assert len(found) == 786
    assert len(environments(one.instance for one in found)) == 16
    assert len(rooms.rooms) == 9
    assert len({one.instance.verb for one in found}) == 76
    several = [one for one in found if any(len(c) > 1 for c in one.instance.candidates)]
    assert len(several) == 382
    assert max(len(one.instance.actions) for one in found) == 51
    assert [one.instance.id for one in found] == sorted(one.instance.id for one in found)
    sizes = {name: len(instances(corpus, chosen, rooms)) for name, chosen in FILTERS.items()}
    assert sizes == {
        "acted": 853,
        "acted-on-phrase": 834,
        "acted-on-object": 786,
        "changed-something": 771,
    }

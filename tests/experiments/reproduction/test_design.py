from __future__ import annotations

from collections import Counter

import pytest

from tests.experiments.reproduction.small import BASE, design
from verbteach.experiments.instance_split import InstanceSplit
from verbteach.experiments.reproduction.design import MATCHED, NOISES, POLICIES, Design
from verbteach.experiments.reproduction.rows import Row
from verbteach.experiments.reproduction.task import Task

NAMES = tuple(f"room-{number:02d}" for number in range(16))


def test_groups_hold_every_environment_out_once_a_cycle() -> None:
    whole = Design(NAMES, runs=20)
    for cycle in range(4):
        held = [name for turn in range(5) for name in whole.held_out(5 * cycle + turn)]
        assert Counter(held) == Counter(NAMES)
    assert {len(whole.held_out(run)) for run in range(20)} == {3, 4}
    assert whole.held_out(0) != whole.held_out(5)
    assert whole.held_out(3) == Design(NAMES, runs=1).held_out(3)


def test_a_few_environments_are_held_out_one_by_one() -> None:
    few = Design(("a", "b", "c"))
    assert sorted(few.held_out(run) for run in range(3)) == [("a",), ("b",), ("c",)]
    with pytest.raises(ValueError, match="only one"):
        Design(("a",))


def test_test_data_is_held_out_whole_and_from_everyone() -> None:
    tasks = Design(("a",), apart=("b", "c"), runs=2).sections()["main"]
    assert {task.config.held_out for task in tasks} == {("b", "c")}
    assert all(task.config.together for task in tasks)


def test_each_in_turn() -> None:
    tasks = Design(NAMES, folds="all", runs=1).sections()["main"]
    assert {(task.config.held_out, task.config.together) for task in tasks} == {((), False)}


def test_table_4_has_every_policy_at_every_level_and_table_5_one_level() -> None:
    cells = [(t.config.policy, t.config.noise) for t in Design(NAMES, runs=1).sections()["main"]]
    assert Counter(cells) == Counter((p, n) for p in POLICIES for n in NOISES)
    only = Design(NAMES, ("table5",), runs=1).sections()["main"]
    assert [(t.config.policy, t.config.noise) for t in only] == [(p, "std3") for p in POLICIES]
    assert not any(task.config.checkpoints for task in only)


def test_who_can_be_stopped_is_followed_and_the_learned_policy_where_curves_are_drawn() -> None:
    followed = {
        (t.config.policy, t.config.noise)
        for t in Design(NAMES, runs=1).sections()["main"]
        if t.config.trace
    }
    everywhere = {(policy, noise) for policy in MATCHED for noise in NOISES}
    assert followed == everywhere | {("rl", "std3")}


def test_policies_of_a_run_share_everything_but_the_policy() -> None:
    for task in design().sections()["main"]:
        twin = next(
            t
            for t in design().sections()["main"]
            if t.config.policy == "rl" and t.config.run == task.config.run
        )
        assert InstanceSplit.of((), task.config) == InstanceSplit.of((), twin.config)
        assert (task.config.seed, task.config.held_out) == (twin.config.seed, twin.config.held_out)


def test_what_is_reported_beside_is_asked_for() -> None:
    assert set(design().sections()) == {"main"}
    sections = design(extras=("phantom", "harder-teacher")).sections()
    assert {t.config.human.error for t in sections["harder_teacher"]} == {0.2}
    assert {t.config.trust for t in sections["harder_teacher"]} == {1.0}
    assert {t.config.trust for t in sections["harder_teacher_doubted"]} == {0.8}
    cheaper = sections["harder_teacher_paper_prices"]
    assert {(t.config.policy, t.config.training.price) for t in cheaper} == {("rl", 1.0)}
    main = {t.key for t in sections["main"]}
    assert main.isdisjoint(t.key for t in sections["harder_teacher"])
    for task in sections["phantom"]:
        perfect = task.config.noise == "perfect"
        assert task.config.reading == ("literal" if perfect else "phantom")
        assert (task.key in main) == perfect, "perfect eyes see no phantoms"


def test_keys_tell_apart_what_rows_hang_on_and_survive_a_file() -> None:
    one, other = Task(BASE, {"data": "a"}), Task(BASE, {"data": "b"})
    assert one.key != other.key
    assert one.key == Task(BASE, {"data": "a"}).key
    assert Row(one.to_json(), (), {}, 0, 0.0).key == one.key

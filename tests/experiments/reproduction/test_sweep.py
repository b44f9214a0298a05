from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from dataclasses import replace

import pytest

from tests.experiments.reproduction.small import design, laboratory, rows
from verbteach.experiments.reproduction.design import CHECKPOINTS, DEMONSTRATION_ONLY
from verbteach.experiments.reproduction.rows import Row
from verbteach.experiments.reproduction.sweep import sweep
from verbteach.experiments.reproduction.task import Task

TASKS = design(targets=("table5", "figure5")).sections()["main"]


def quick(task: Task) -> Row:
    """The row that was made before; so the sweep itself is tested, not the learner."""
    return rows()[task.key]


def test_rows_survive_a_file() -> None:
    for row in rows().values():
        read = Row.from_json(json.loads(json.dumps(row.to_json())))
        assert read == row
        assert read.seconds == row.seconds


def test_a_row_of_another_configuration_is_refused() -> None:
    data = next(iter(rows().values())).to_json()
    data["settings"] = {**data["settings"], "run": 99}
    with pytest.raises(ValueError, match="another configuration"):
        Row.from_json(data)
    wrong: list[object] = [{"key": "x"}, [], {**data, "commands": [[1]]}, None]
    for broken in wrong:
        with pytest.raises(ValueError, match="not a row"):
            Row.from_json(broken)


def test_a_killed_sweep_goes_on_without_a_lost_or_doubled_row() -> None:
    kept: list[Row] = []

    def dying(function: object, bundles: Sequence[Sequence[Task]], /) -> Iterator[Row]:
        yield from map(quick, bundles[0][:3])
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        sweep(TASKS, quick, keep=kept.append, mapper=dying)
    assert len(kept) == 3
    resumed = sweep(TASKS, quick, done=kept, keep=kept.append)
    assert resumed == rows()
    assert sorted(row.key for row in kept) == sorted(rows())


def test_the_order_of_work_changes_nothing() -> None:
    def backwards(function: object, bundles: Sequence[Sequence[Task]], /) -> Iterator[Row]:
        return (quick(task) for bundle in reversed(bundles) for task in reversed(bundle))

    assert list(sweep(TASKS, quick, mapper=backwards)) == [task.key for task in TASKS]


def test_tasks_of_one_draw_of_the_noise_are_a_bundle() -> None:
    draws: list[set[tuple[int, str, str]]] = []

    def noting(function: object, bundles: Sequence[Sequence[Task]], /) -> Iterator[Row]:
        for bundle in bundles:
            draws.append({(t.config.run, t.config.reading, t.config.noise) for t in bundle})
            yield from map(quick, bundle)

    sweep(TASKS, quick, mapper=noting)
    assert len(draws) == 2
    assert all(len(draw) == 1 for draw in draws)


def test_whole_runs_come_first_and_in_a_run_what_takes_longest() -> None:
    tasks = design(targets=("table4", "figure5")).sections()["main"]
    draws: list[tuple[int, str]] = []

    def noting(function: object, bundles: Sequence[Sequence[Task]], /) -> Iterator[Row]:
        draws.extend((bundle[0].config.run, bundle[0].config.noise) for bundle in bundles)
        return iter(())

    with pytest.raises(KeyError):
        sweep(tasks, quick, mapper=noting)
    assert [run for run, _ in draws] == sorted(run for run, _ in draws)
    assert next(noise for run, noise in draws if run == 1) == "std3"
    assert len(draws) == 8


def test_a_row_that_nobody_asked_for_is_refused() -> None:
    def wrong(function: object, bundles: Sequence[Sequence[Task]], /) -> Iterator[Row]:
        return iter([rows()[TASKS[0].key]] * 2)

    with pytest.raises(ValueError, match="came twice"):
        sweep(TASKS, quick, mapper=wrong)


def test_every_policy_meets_the_same_lessons_and_commands() -> None:
    by_run: dict[int, set[tuple[str, ...]]] = {}
    for row in rows().values():
        by_run.setdefault(row.run, set()).add(tuple(c.instance for c in row.commands))
        assert row.lessons == next(r for r in rows().values() if r.run == row.run).lessons
    assert all(len(found) == 1 for found in by_run.values())


def test_checkpoints_grow_and_the_last_is_the_whole() -> None:
    for row in rows().values():
        lessons = [one.lessons for one in row.growth]
        assert lessons == sorted(set(lessons))
        assert len(lessons) == len(CHECKPOINTS) + 1
        whole = [(c.document, c.ied, c.sji) for c in row.commands]
        assert [tuple(score) for score in row.growth[-1].scores] == whole


@pytest.mark.parametrize("policy", DEMONSTRATION_ONLY)
def test_learners_from_demonstrations_alone_take_the_same_part(policy: str) -> None:
    own = [row for row in rows().values() if row.policy == policy]
    assert len(own) == 2
    assert all(c.total == 0 and not c.trace for row in own for c in row.commands)
    assert all(row.learned("total") == 0 for row in own)
    task = next(t for t in TASKS if t.config.policy == policy)
    few = replace(task, config=replace(task.config, checkpoints=(), verb_share=0.25))
    scores = [(c.document, c.ied, c.sji) for c in laboratory().row(few).commands]
    assert [tuple(s) for s in rows()[task.key].checkpoints[1].scores] == scores


def test_each_environment_in_turn_is_tested_without_its_own_lessons() -> None:
    task = design(folds="all", runs=1, targets=("table5",)).sections()["main"][-1]
    row = laboratory().row(task)
    assert [c.instance for c in row.commands] == [i.id for i in laboratory().bench.instances]

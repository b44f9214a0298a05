from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np
import pytest

from tests.experiments.interactive_room import bench
from verbteach.experiments.figures import Observation
from verbteach.experiments.interactive_protocol import Config, run
from verbteach.experiments.significance import holm, paired_permutation
from verbteach.experiments.sweep import (
    Row,
    figure5_configs,
    key_of,
    plain,
    row_of,
    sweep,
    table4_configs,
)
from verbteach.experiments.tables import (
    comparisons,
    figure5,
    markdown4,
    markdown5,
    per_question,
    table4,
    table5,
)

BASE = Config(policy="silent", noise="std3")
CONFIGS = table4_configs(BASE, ("silent", "manual"), ("perfect", "std3"), runs=2)
BENCH = bench()


def score(config: Config) -> Row:
    return row_of(config, run(BENCH, config))


@pytest.fixture(scope="module")
def rows() -> tuple[Row, ...]:
    return sweep(CONFIGS, score)


def test_rows_survive_a_file(rows: tuple[Row, ...]) -> None:
    for row in rows:
        assert Row.from_json(json.loads(json.dumps(row.to_json()))) == row


def test_a_row_of_another_configuration_is_refused(rows: tuple[Row, ...]) -> None:
    data = rows[0].to_json()
    data["config"] = {**data["config"], "run": 99}
    with pytest.raises(ValueError, match="another configuration"):
        Row.from_json(data)
    with pytest.raises(ValueError, match="not a row"):
        Row.from_json({"key": "x"})


def test_a_killed_sweep_goes_on_without_a_lost_or_doubled_row(rows: tuple[Row, ...]) -> None:
    kept: list[Row] = []

    def dying(function: object, configs: Sequence[Config], /) -> Iterator[Row]:
        for config in configs[:3]:
            yield score(config)
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        sweep(CONFIGS, score, keep=kept.append, mapper=dying)
    assert len(kept) == 3
    resumed = sweep(CONFIGS, score, done=kept, keep=kept.append)
    assert resumed == rows
    assert sorted(row.key for row in kept) == sorted(row.key for row in rows)


def test_the_order_of_work_changes_nothing(rows: tuple[Row, ...]) -> None:
    def backwards(function: object, configs: Sequence[Config], /) -> Iterator[Row]:
        return (score(config) for config in reversed(configs))

    assert sweep(CONFIGS, score, mapper=backwards) == rows


def test_keys_tell_configurations_apart() -> None:
    configs = [*CONFIGS, replace(BASE, run=5), replace(BASE, split_cap=2.5)]
    keys = [key_of(plain(config)) for config in configs]
    assert len(set(keys)) == len(keys)


def test_table_4_has_every_cell_beside_the_papers(rows: tuple[Row, ...]) -> None:
    table = table4(rows, resamples=50)
    cell = table["manual"]["std3"]
    own = [row for row in rows if row.policy == "manual" and row.config["noise"] == "std3"]
    means = [np.mean([c.sji for c in row.commands]) for row in own]
    assert cell["sji"]["mean"] == pytest.approx(np.mean(means))
    assert (
        cell["questions_execution"]["mean"] > table["silent"]["std3"]["questions_execution"]["mean"]
    )
    assert markdown4(table).count("\n") == 2 + 4


def test_table_5_counts_kinds_of_questions(rows: tuple[Row, ...]) -> None:
    std3 = [row for row in rows if row.config["noise"] == "std3"]
    table = table5(std3, resamples=50)
    execution = table["manual"]["execution"]
    parts = sum(execution[kind]["mean"] for kind in ("ground", "env", "goal"))
    assert execution["total"]["mean"] == pytest.approx(parts)
    assert table["silent"]["execution"]["total"]["mean"] == 0
    assert "(6.792)" in markdown5(table)


def test_figure_5_grows_with_the_lessons() -> None:
    configs = figure5_configs(BASE, ("silent",), (0.3, 1.0), runs=1)
    points = figure5(sweep(configs, score), resamples=20)["silent"]
    assert points[0][0] < points[1][0]


def test_comparisons_are_paired_and_corrected(rows: tuple[Row, ...]) -> None:
    found = comparisons(rows, policy="manual", flips=200)
    assert {(one["other"], one["noise"]) for one in found} == {
        ("silent", "perfect"),
        ("silent", "std3"),
    }
    assert all(one["difference"] > 0 and 0 < one["p"] <= 1 for one in found)
    assert set(per_question(rows)) == {"silent", "manual"}


def test_a_permutation_test_finds_a_difference_and_only_a_difference() -> None:
    rng = np.random.default_rng(0)
    noise = rng.normal(size=40)
    base = [[Observation(f"d{i}", value) for i, value in enumerate(noise)]]
    better = [[Observation(o.group, o.value + 0.5) for o in base[0]]]
    other = [[Observation(o.group, o.value + rng.normal()) for o in base[0]]]
    assert paired_permutation(better, base, rng, 999) == pytest.approx(0.001)
    assert paired_permutation(base, base, rng, 99) == 1.0
    assert paired_permutation(other, base, rng, 999) > 0.01


def test_permutations_need_the_same_commands() -> None:
    one, two = [[Observation("a", 1.0)]], [[Observation("b", 1.0)]]
    with pytest.raises(ValueError, match="same commands"):
        paired_permutation(one, two, np.random.default_rng(0), 9)


def test_holm_multiplies_the_smallest_most_and_never_falls() -> None:
    assert holm([0.01, 0.04, 0.03]) == pytest.approx((0.03, 0.06, 0.06))
    assert holm([0.9, 0.8]) == (1.0, 1.0)

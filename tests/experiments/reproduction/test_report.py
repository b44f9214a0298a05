from __future__ import annotations

import json
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from tests.experiments.reproduction.small import design, rows
from verbteach.experiments.figures import Observation
from verbteach.experiments.reproduction.comparisons import Pair, compared, mean_questions
from verbteach.experiments.reproduction.curves import asking, figure5, per_question, stopped_at
from verbteach.experiments.reproduction.design import CHECKPOINTS, POLICIES
from verbteach.experiments.reproduction.markdown import markdown
from verbteach.experiments.reproduction.paper import TABLE5
from verbteach.experiments.reproduction.report import Report, matched
from verbteach.experiments.reproduction.rows import Command, Row
from verbteach.experiments.reproduction.tables import table4, table5


def main() -> list[Row]:
    return list(rows().values())


def own(policy: str) -> list[Row]:
    return [row for row in main() if row.policy == policy]


@pytest.fixture(scope="module")
def document() -> dict[str, Any]:
    found = Report.of(design(targets=("table5", "figure5")), rows()).to_json()
    whole: dict[str, Any] = json.loads(json.dumps(found, allow_nan=False))
    return whole


def row_with(*traces: list[float], policy: str = "split", run: int = 0) -> Row:
    """A row whose commands come to these scores after no question, one and so on."""
    commands = tuple(
        Command(str(i), str(i), 0.0, t[-1], False, 0.0, 0, 0, 0, tuple((0.0, s) for s in t))
        for i, t in enumerate(traces)
    )
    settings = {"policy": policy, "noise": "std3", "seed": 0, "run": run}
    return Row(settings, commands, {}, 0, 0.0)


def test_table_4_is_the_mean_over_runs_beside_the_papers() -> None:
    cell = table4(main(), resamples=50)["manual"]["std3"]
    means = [np.mean([c.sji for c in row.commands]) for row in own("manual")]
    assert cell["sji"]["mean"] == pytest.approx(np.mean(means))
    assert cell["sji"]["runs"] == 2
    assert table4(main(), resamples=50)["rl"]["std3"]["paper"] == {"ied": 0.420, "sji": 0.431}


def test_table_5_has_the_shape_that_others_rely_on() -> None:
    table = table5(main(), "std3", resamples=50)
    assert set(table) == set(POLICIES)
    for cells in table.values():
        assert set(cells) == {"learning", "execution", "ied", "sji", "paper"}
        assert set(cells["learning"]) == {"ground", "env", "total"}
        parts = sum(cells["execution"][kind]["mean"] for kind in ("ground", "env", "goal"))
        assert cells["execution"]["total"]["mean"] == pytest.approx(parts)
        assert set(cells["sji"]) == {"mean", "sd", "ci95", "runs"}
    assert table["manual"]["paper"]["execution"] == TABLE5["manual"]["execution"]


def test_equal_rows_of_another_version_have_the_same_intervals() -> None:
    later = [replace(row, settings={**row.settings, "program": "later"}) for row in main()]
    assert {row.key for row in later}.isdisjoint(row.key for row in main())
    assert table5(later, "std3", resamples=50) == table5(main(), "std3", resamples=50)
    assert figure5(later, resamples=50) == figure5(main(), resamples=50)


def test_figure_5_has_a_point_for_every_checkpoint() -> None:
    curves = figure5(main(), resamples=20)
    assert set(curves) == set(POLICIES)
    for points in curves.values():
        assert len(points) == len(CHECKPOINTS) + 1
        assert [lessons for lessons, _ in points] == sorted(lessons for lessons, _ in points)


def test_stopped_after_no_question_nothing_was_asked() -> None:
    curve = per_question(main(), "std3", resamples=20)
    assert set(curve) == {"rl", "manual", "random", "split"}
    for policy, points in curve.items():
        assert points[0][0] == 0.0
        asked = [questions for questions, _ in points]
        assert asked == sorted(asked)
        first = [np.mean([c.trace[0][1] for c in row.commands]) for row in own(policy)]
        assert points[0][1]["mean"] == pytest.approx(np.mean(first))


def test_a_limit_between_two_whole_numbers_is_in_proportion() -> None:
    row = row_with([0.0, 1.0, 0.5], [0.4])
    stopped = stopped_at([row], 0.25)
    assert stopped.questions == pytest.approx(0.125)
    assert [o.value for o in stopped.observations(row, "sji")] == pytest.approx([0.25, 0.4])
    assert [o.value for o in stopped_at([row], 1.5).observations(row, "sji")] == [0.75, 0.4]


def test_rules_are_stopped_so_that_they_ask_as_much() -> None:
    row = row_with([0.0, 1.0, 0.5, 0.5], [0.4], [0.0, 0.0])
    stopped = asking([row], 1.0)
    assert stopped.questions == pytest.approx(1.0)
    assert stopped.limit == pytest.approx(2.0)
    assert asking([row], 9.0).limit == 3.0  # it has no more to ask
    wanted = mean_questions(own("rl"))
    for policy, by_noise in matched(main()).items():
        most = stopped_at(own(policy), 8.0).questions
        assert by_noise["std3"]["questions_execution"] == pytest.approx(min(wanted, most), abs=1e-6)


def test_comparisons_find_what_differs_and_correct_for_their_number() -> None:
    rng = np.random.default_rng(0)
    base = [[Observation(f"d{i}", float(v)) for i, v in enumerate(rng.normal(1.0, size=40))]]
    better = [[Observation(o.group, o.value + 0.5) for o in base[0]]]
    pairs = [
        Pair("rl", "split", "std3", "sji", better, base),
        Pair("rl", "manual", "std3", "sji", base, base),
    ]
    first, second = compared(pairs, flips=999)
    assert first.p == pytest.approx(0.002)
    assert first.difference == pytest.approx(0.5)
    assert first.improvement == pytest.approx(0.5 / second.theirs)
    assert second.p == 1.0


def test_the_document_and_its_markdown_name_every_policy(document: dict[str, Any]) -> None:
    text = markdown(document)
    for heading in ("## Table 5", "## Figure 5", "## SJI against questions asked"):
        assert heading in text
    assert "(6.792)" in text
    assert "She16, paper's" in text
    widths = [line.count("|") for line in text.splitlines() if line.startswith("| RL")]
    assert len(widths) == 2 + len(CHECKPOINTS) + len(document["per_question"]["rl"])
    assert "table4" not in document
    assert document["runs"] == 2


def test_table_4s_document_compares_rl_with_everyone() -> None:
    only = design(targets=("table4",))
    by_cell = {(row.policy, row.run): row for row in main()}
    stand_ins = {
        t.key: Row(
            t.to_json(),
            by_cell[t.config.policy, t.config.run].commands,
            by_cell[t.config.policy, t.config.run].learning,
            30,
            1.0,
        )
        for t in only.sections()["main"]
    }
    document = Report.of(only, stand_ins).to_json()
    others = {one["other"] for one in document["comparisons"]}
    assert others == {
        *(p for p in POLICIES if p != "rl"),
        *(f"{p} (same questions)" for p in ("split", "manual", "random")),
    }
    assert "% improvement" in markdown(document)
    assert "(9.9 %" in markdown(document)

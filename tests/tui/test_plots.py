"""Charts: the same curves in files and in the terminal."""

from __future__ import annotations

from pathlib import Path

import pytest

from verbteach_tui.plots import files, terminal
from verbteach_tui.plots.curves import Chart, Line, Point, lines
from verbteach_tui.plots.paper import charts

RISING = Line("rl", "RL", (Point(0, 0.1, 0.0, 0.2), Point(10, 0.9, 0.8, 1.0)))
FLAT = Line("split", "split", (Point(0, 0.5, 0.4, 0.6), Point(10, 0.5, 0.4, 0.6)))
CHART = Chart("a title", "instances", "SJI", (RISING, FLAT), {"rl": Point(5, 0.5, 0.4, 0.6)})
FIGURE = {"mean": 0.5, "sd": 0.1, "ci95": [0.4, 0.6], "runs": 2}


@pytest.mark.parametrize(("width", "height"), [(80, 20), (40, 10), (120, 30), (10, 4)])
def test_a_chart_keeps_to_its_cells(width: int, height: int) -> None:
    drawn = terminal.draw(CHART, width, height).plain.splitlines()
    assert drawn[0] == "a title"
    assert len(drawn) == max(4, height - 3) + 3
    assert all(len(line) <= max(width, 30) for line in drawn)


def test_a_rising_curve_rises_and_a_flat_one_stays() -> None:
    rows = terminal.draw(CHART, 60, 15).plain.splitlines()[1:-2]
    dotted = [[x for x, sign in enumerate(row) if "⠀" < sign <= "⣿"] for row in rows]
    found = [row for row in dotted if row]
    assert max(found[0]) > max(found[-1])  # what is highest lies to the right
    assert sum("split" in row for row in rows) == 1
    assert sum("RL" in row for row in rows) == 1
    assert any("★" in row for row in rows)


def test_names_of_curves_that_meet_do_not_cover_each_other() -> None:
    same = [Line(name, name, FLAT.points) for name in ("rl", "manual", "split", "random")]
    drawn = terminal.draw(Chart("t", "x", "y", tuple(same), {}), 60, 12).plain
    assert all(drawn.count(f" {line.label}") == 1 for line in same)


def test_a_curve_of_one_point_and_a_chart_of_none_are_drawn() -> None:
    one = Line("rl", "RL", (Point(3, 0.3, 0.3, 0.3),))
    assert "RL" in terminal.draw(Chart("t", "x", "y", (one,), {}), 60, 12).plain
    assert "t" in terminal.draw(Chart("t", "x", "y", (), {}), 60, 12).plain


def test_files_are_the_same_each_time(tmp_path: Path) -> None:
    first = [path.read_bytes() for path in files.draw(CHART, tmp_path / "one")]
    second = [path.read_bytes() for path in files.draw(CHART, tmp_path / "two")]
    assert first == second
    assert first[0].startswith(b"\x89PNG")
    assert b"<svg" in first[1]


def test_charts_are_made_of_what_the_document_has() -> None:
    curve = {"rl": [[1, FIGURE], [2, FIGURE]]}
    assert charts({}) == {}
    found = charts({"figure5": curve, "per_question": curve})
    assert set(found) == {"figure5", "questions"}
    assert found["figure5"].lines == tuple(lines(curve, {"rl": "RL"}))
    assert found["questions"].marks == {}
    own = {"execution": {"total": {**FIGURE, "mean": 3.0}}, "sji": FIGURE}
    with_stops = charts({"per_question": curve, "table5": {"rl": own, "she16": own}})
    assert with_stops["questions"].marks == {"rl": Point(3.0, 0.5, 0.4, 0.6)}

"""The panels' rows: the dialogue, the mind, an execution, a goal read back, a hypothesis graph."""

from __future__ import annotations

from itertools import combinations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.tui.strategies import NASTY, texts
from verbteach.world.fluents import Literal
from verbteach_tui.views.braille import BrailleCanvas
from verbteach_tui.views.dialogue import DialogueLine, common, dialogue_rows, line_rows
from verbteach_tui.views.execution import SPEEDS, Playback, playback_rows, speed_text
from verbteach_tui.views.graph import (
    GraphNode,
    HypothesisGraph,
    describe_node,
    draw_graph,
    node_name,
    uncrossed,
)
from verbteach_tui.views.mind import (
    ActValue,
    GoalBelief,
    KnownVerb,
    Mind,
    PhraseBelief,
    Share,
    bar,
    mind_rows,
)
from verbteach_tui.views.read_back import GoalPart, read_back_rows
from verbteach_tui.views.rows import Row, plain, width_of

SPEAKERS = ("robot", "teacher", "note")


def text_of(rows: list[Row]) -> str:
    return "\n".join(map(plain, rows))


@given(
    st.lists(st.builds(DialogueLine, st.sampled_from(SPEAKERS), texts()), max_size=6),
    st.integers(20, 90),
)
def test_the_dialogue_fits_and_is_the_same_drawn_line_by_line(
    lines: list[DialogueLine], width: int
) -> None:
    rows = dialogue_rows(lines, width)
    assert all(width_of(row) <= width for row in rows)
    speakers = ["", *(line.speaker for line in lines)]
    piecewise = [
        row
        for line, before in zip(lines, speakers, strict=False)
        for row in line_rows(line, before, width)
    ]
    assert rows == piecewise


def test_the_dialogue_names_the_speaker_once_and_the_kind_and_price_of_a_question() -> None:
    lines = [
        DialogueLine("robot", "Which mug?", "np_grd_whq", "−6.5"),
        DialogueLine("teacher", "the red one"),
        DialogueLine("teacher", "no, the blue one"),
    ]
    assert text_of(dialogue_rows(lines, 44)).splitlines() == [
        "Robot  Which mug?            np_grd_whq −6.5",
        "",
        "You    the red one",
        "       no, the blue one",
    ]


def test_only_what_is_new_in_the_dialogue_differs() -> None:
    old = [DialogueLine("robot", "a"), DialogueLine("teacher", "b")]
    assert common(old, [*old, DialogueLine("robot", "c")]) == 2
    assert common(old, [old[0], DialogueLine("teacher", "x")]) == 1
    assert common(old, []) == 0


MIND = Mind(
    (
        PhraseBelief("the mug", (Share("red mug", 0.62, 0.5, "Mug_1"), Share("blue mug", 0.38))),
        PhraseBelief("it", (), settled=True),
    ),
    (
        GoalBelief(0.7, ("the water is hot", "the stove is on")),
        GoalBelief(0.3, ("the water is hot",), ()),
    ),
    (ActValue("np_grd_whq", 12.5, chosen=True), ActValue("ask to be shown", None)),
    (KnownVerb("boil X", 3, 1, ("X is hot",), news=True, target="boil/1"),),
)


@pytest.mark.parametrize("width", [24, 40, 64, 120])
def test_the_mind_fits_its_panel(width: int) -> None:
    assert all(width_of(row) <= width for row in mind_rows(MIND, width))
    assert all(width_of(row) <= width for row in mind_rows(Mind(), width))


def test_the_mind_says_what_it_promises() -> None:
    text = "acts when at least .73 sure: promised 80%, calibrated on 214 lessons"
    assert text_of(mind_rows(Mind(promise=text), 80)).startswith(f"It {text}")
    assert all(width_of(row) <= 24 for row in mind_rows(Mind(promise=text), 24))
    assert "promised" not in text_of(mind_rows(MIND, 80))


def test_the_mind_says_what_changed_what_is_settled_and_what_is_new() -> None:
    text = text_of(mind_rows(MIND, 64))
    assert "red mug  " in text
    assert "62% ↑ was 50%" in text
    assert '"it"  ✓ you said so' in text
    assert "▸  70%  the water is hot; the stove is on" in text
    assert "✱ boil X  3 hypotheses, 1 lesson" in text
    assert "None yet" in text_of(mind_rows(Mind(), 64))


@given(st.floats(0, 1), st.integers(1, 30))
def test_a_bar_is_as_long_as_its_share(share: float, cells: int) -> None:
    full, rest = bar(share, cells)
    assert width_of([full, rest]) == cells
    assert abs(len(full.text) - share * cells) <= 1


def test_an_execution_shows_what_is_done_what_is_shown_and_what_is_to_come() -> None:
    playback = Playback(("go to the tap", "turn on the tap", "wait"), at=2, failed="could not wait")
    assert text_of(playback_rows(playback, 60)).splitlines() == [
        "► running step 2 of 3, 2 steps a second",
        "  1 ✓ go to the tap",
        "  2 ► turn on the tap",
        "  3 · wait",
    ]
    over = text_of(playback_rows(playback.to_end(), 60))
    assert "■ all shown step 3 of 3" in over
    assert over.endswith("✗ could not wait")


def test_the_speed_goes_through_all_speeds_and_stays_at_the_ends() -> None:
    playback = Playback(("a",), speed=SPEEDS[0])
    seen = []
    for _ in range(len(SPEEDS) + 2):
        seen.append(playback.speed)
        playback = playback.faster(1)
    assert seen == [*SPEEDS, SPEEDS[-1], SPEEDS[-1]]
    assert playback.faster(-1).speed == SPEEDS[-2]
    assert {speed_text(s) for s in SPEEDS} >= {"all at once", "a step in 2 s", "1 step a second"}


def test_a_struck_part_of_a_goal_looks_struck_without_colour() -> None:
    literal = Literal.parse("(hot Kettle_1)")
    parts = [
        GoalPart(literal, kept, "it must be hot", "need not: it is hot") for kept in (True, False)
    ]
    rows = [plain(row) for part in read_back_rows(parts, 0, 60) for row in part]
    assert rows == ["▸ [✓] it must be hot", "  [ ] need not: it is hot"]


def lattice(size: int) -> HypothesisGraph:
    """All non-empty subsets of ``size`` conditions, linked by one condition less."""
    letters = [f"c{n}" for n in range(size)]
    sets = [frozenset(c) for k in range(size, 0, -1) for c in combinations(letters, k)]
    names = {s: node_name(i) for i, s in enumerate(sets)}
    levels = tuple(
        tuple(GraphNode(names[s], tuple(sorted(s))) for s in sets if len(s) == k)
        for k in range(size, 0, -1)
    )
    links = tuple((names[a], names[b]) for a in sets for b in sets if b < a and len(a - b) == 1)
    return HypothesisGraph("boil X", levels, links, ("boil the water",))


@pytest.mark.parametrize("size", [1, 2, 3, 4, 6])
@pytest.mark.parametrize("width", [20, 60, 120])
def test_every_hypothesis_is_drawn_where_it_is_said_to_be(size: int, width: int) -> None:
    graph = lattice(size)
    drawing = draw_graph(graph, width, "A")
    assert set(drawing.places) == set(graph.nodes)
    for name, (row, column, cells) in drawing.places.items():
        text = plain(drawing.rows[row])
        assert text[column : column + cells] == graph.nodes[name].label
        targets = [span for span in drawing.rows[row] if span.target == name]
        assert len(targets) == 1


def test_links_are_drawn_between_the_levels() -> None:
    drawing = draw_graph(lattice(3), 60)
    between = [plain(row) for row in drawing.rows if "×" not in plain(row)]
    assert len(between) == 4
    assert all(any("\u2801" <= c <= "\u28ff" for c in row) for row in between)


def test_a_hypothesis_tells_its_conditions_its_sources_and_its_neighbours() -> None:
    graph = lattice(3)
    text = text_of(describe_node(graph, "B", 60))
    assert "● c0" in text
    assert "More specific: A" in text
    assert "More general: E F" in text
    assert "no hypothesis" in text_of(describe_node(HypothesisGraph("x"), "A", 60)).lower()


def test_levels_are_ordered_by_what_they_hang_from() -> None:
    links = (("a", "y"), ("b", "x"))
    assert uncrossed([["a", "b"], ["x", "y"]], links) == (("a", "b"), ("y", "x"))


def test_a_line_of_dots_ends_where_it_should() -> None:
    canvas = BrailleCanvas(4, 2)
    canvas.line((0, 0), (3.9, 1.9), "border")
    assert canvas.cell(0, 0)[0] != " "
    assert canvas.cell(3, 1) != (" ", "")
    assert canvas.cell(0, 1) == (" ", "")


@pytest.mark.parametrize("text", NASTY)
def test_what_people_said_is_shown_safely_everywhere(text: str) -> None:
    drawn = [
        *dialogue_rows([DialogueLine("teacher", text)], 60),
        *mind_rows(Mind((PhraseBelief(text, (Share("mug", 1.0),)),)), 60),
        *describe_node(HypothesisGraph("x", ((GraphNode("A", ("c",), 1, (text,)),),)), "A", 60),
    ]
    assert all(c.isprintable() for row in drawn for c in plain(row))
    assert all(width_of(row) <= 60 for row in drawn)

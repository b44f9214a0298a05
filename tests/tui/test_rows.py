"""Rows: nothing is wider than its room, and no word is lost on the way."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st
from rich.cells import cell_len

from tests.tui.strategies import spans, texts
from verbteach_tui.views.rows import GLUE, Span, clipped, padded, plain, width_of, wrapped
from verbteach_tui.views.visible import shortened, visible


@given(spans(), st.integers(2, 40), st.integers(0, 6))
def test_wrapped_rows_fit_and_keep_every_letter(
    given_spans: list[Span], width: int, hanging: int
) -> None:
    rows = wrapped(given_spans, width, min(hanging, width - 2))
    assert all(width_of(row) <= width for row in rows)
    letters = "".join(span.text for span in given_spans).replace(" ", "")
    assert "".join(map(plain, rows)).replace(" ", "") == letters


@given(spans(), st.integers(2, 40))
def test_wrapped_rows_keep_styles(given_spans: list[Span], width: int) -> None:
    def styles(row: list[Span]) -> list[tuple[str, str]]:
        return [(c, span.style) for span in row for c in span.text if c != " "]

    assert styles([s for row in wrapped(given_spans, width) for s in row]) == styles(given_spans)


def test_words_are_broken_between_and_only_where_they_must_be_within() -> None:
    rows = wrapped([Span("put the kettle on the stove")], 12, 2)
    assert [plain(row) for row in rows] == ["put the", "  kettle on", "  the stove"]
    assert [plain(row) for row in wrapped([Span("a hippopotamus")], 6)] == ["a", "hippop", "otamus"]


def test_glued_words_stay_together_and_come_out_with_a_blank() -> None:
    rows = wrapped([Span(f"kettle ■{GLUE}shut now")], 12)
    assert [plain(row) for row in rows] == ["kettle", "■ shut now"]


@given(spans(), st.integers(1, 30))
def test_clipped_rows_fit_and_say_that_something_is_missing(
    given_spans: list[Span], width: int
) -> None:
    row = clipped(given_spans, width)
    assert width_of(row) <= width
    assert (plain(row) == plain(tuple(given_spans))) == (width_of(given_spans) <= width)


@given(spans(), st.integers(0, 40))
def test_padded_rows_are_as_wide_as_asked_or_were_wider(
    given_spans: list[Span], width: int
) -> None:
    assert width_of(padded(given_spans, width)) == max(width, width_of(given_spans))


@given(texts())
def test_nothing_invisible_or_acting_is_left_in_visible_text(text: str) -> None:
    shown = visible(text)
    assert all(c == " " or c.isprintable() for c in shown)
    assert visible(shown) == shown, "what is visible stays as it is"


def test_control_characters_print_as_themselves() -> None:
    assert visible("\x1b[31m\x00\n\t\x7f") == "␛[31m␀␊␉␡"
    assert visible("a\u202eb\x9b") == "a\\u202eb\\u009b"
    assert visible("[bold]x[/]") == "[bold]x[/]"


def test_a_long_text_says_how_much_of_it_is_not_shown() -> None:
    assert shortened("x" * 10_000, 100) == "x" * 100 + " … (9,900 more characters)"
    assert cell_len(shortened("日" * 700, 100)) < 250

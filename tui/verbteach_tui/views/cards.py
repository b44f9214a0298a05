"""The picture drawn as rows: a card for each piece of furniture, each staying in its column."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, TypeAlias

from verbteach_tui.views.marks import sureness
from verbteach_tui.views.rows import GLUE, Row, Span, clipped, padded, unglued, width_of, wrapped

if TYPE_CHECKING:
    from verbteach_tui.views.marks import Mark
    from verbteach_tui.views.picture import Actor, Picture, Thing

NARROWEST = 30
"""Cells a card needs before there is another column."""

CHANGED, ASKED = "✱", "?"
"""What stands before a thing that just changed, and before one a question is about."""

SEPARATOR = Span(f"{GLUE}· ", "muted")

_GUTTER = 4
_GAP = 1

Arrangement: TypeAlias = tuple[tuple[str, ...], ...]
"""For each column the ids of its cards, top to bottom."""


@dataclass(frozen=True)
class Emphasis:
    """What stands out: ``asked`` objects, the digits that pick them, and where the robot is."""

    asked: Collection[str] = frozenset()
    digits: Mapping[str, str] = field(default_factory=dict)
    near: Collection[str] = frozenset()


def arrange(picture: Picture, width: int) -> Arrangement:
    """Deal the cards into columns, each to the shortest; keep the answer, so that cards stay."""
    count = max((width + _GAP) // (NARROWEST + _GAP), 1)
    columns: list[list[str]] = [[] for _ in range(count)]
    heights = [0] * count
    for place in picture.places:
        shortest = heights.index(min(heights))
        columns[shortest].append(place.id)
        heights[shortest] += len(_card(place, _card_width(width, count), Emphasis()))
    return tuple(tuple(column) for column in columns)


def picture_rows(
    picture: Picture,
    width: int,
    arrangement: Arrangement | None = None,
    emphasis: Emphasis | None = None,
) -> list[Row]:
    """The whole scene; ``arrangement`` comes from :func:`arrange` for the same width."""
    handy = emphasis or Emphasis()
    emphasis = replace(handy, near=picture.near)
    columns = _with_newcomers(arrangement or arrange(picture, width), picture)
    room = _card_width(width, len(columns))
    places = {place.id: place for place in picture.places}
    drawn = [
        _column([places[key] for key in column if key in places], room, emphasis)
        for column in columns
    ]
    actors = [row for actor in picture.actors for row in _actor(actor, width, handy)]
    return [*actors, *_side_by_side(drawn, room), *_others(picture, width, emphasis)]


def beside(
    truth: Sequence[Row], belief: Sequence[Row], width: int, titles: tuple[str, str]
) -> list[Row]:
    """Two drawings side by side, each as wide as :func:`half` of ``width``, under their titles."""
    room = half(width)
    rule = Span(" │ ", "border")
    head = [(clipped([Span(title, "accent")], room),) for title in titles]
    left, right = ([row[0], *rows] for row, rows in zip(head, (truth, belief), strict=True))
    return [
        (*padded(left[y] if y < len(left) else (), room), rule, *(right[y : y + 1] or [()])[0])
        for y in range(max(len(left), len(right)))
    ]


def half(width: int) -> int:
    """How wide each of two drawings side by side is."""
    return max((width - 3) // 2, 1)


def _with_newcomers(arrangement: Arrangement, picture: Picture) -> list[list[str]]:
    columns = [list(column) for column in arrangement]
    known = {key for column in columns for key in column}
    for place in picture.places:
        if place.id not in known:
            min(columns, key=len).append(place.id)
    return columns


def _card_width(width: int, columns: int) -> int:
    return (width - _GAP * (columns - 1)) // columns


def _side_by_side(columns: Sequence[Sequence[Row]], room: int) -> list[Row]:
    height = max((len(column) for column in columns), default=0)
    rows = []
    for y in range(height):
        spans: list[Span] = []
        for index, column in enumerate(columns):
            spans += [Span(" " * _GAP)] if index else []
            spans += padded(column[y] if y < len(column) else (), room)
        rows.append(tuple(spans))
    return rows


def _actor(actor: Actor, width: int, emphasis: Emphasis) -> list[Row]:
    """As in: robot holds kettle. A person is worth a row only with something in hand."""
    if not actor.holds and actor.id != "Robot":
        return []
    holds: list[Span] = []
    for thing in actor.holds:
        holds += [SEPARATOR] if holds else []
        holds += _inline(thing, emphasis)
    spans = [Span(actor.label, "robot"), Span(" holds ", "muted"), *(holds or [Span("nothing")])]
    return wrapped(spans, width, 2)


def _column(places: Sequence[Thing], width: int, emphasis: Emphasis) -> list[Row]:
    """Cards one below the other, each standing on the next, like shelves of one cabinet."""
    rows: list[Row] = []
    for place in places:
        rows += _card(place, width, emphasis, first=not rows)
    return [*rows, (Span("╰" + "─" * (width - 2) + "╯", "border"),)] if rows else []


def _card(place: Thing, width: int, emphasis: Emphasis, first: bool = True) -> list[Row]:
    inner = width - 4
    near = [Span(" ◂ robot", "robot")] if place.id in emphasis.near else []
    left, right = "╭╮" if first else "├┤"
    name = [*_name(place, emphasis, "strong"), *_marks(place.marks), *near]
    title = clipped(unglued(name), inner)
    line = Span(" " + "─" * (inner - width_of(title)) + right, "border")
    rows: list[Row] = [(Span(f"{left} ", "border"), *title, line)]
    for row in _contents(place, inner, emphasis):
        rows.append((Span("│ ", "border"), *padded(row, inner), Span(" │", "border")))
    return rows


def _contents(place: Thing, width: int, emphasis: Emphasis) -> list[Row]:
    if not place.contents:
        return [(Span("empty", "muted"),)]
    rows: list[Row] = []
    for relation, things in _by_relation(place.contents):
        spans: list[Span] = []
        for thing in things:
            spans += [SEPARATOR] if spans else []
            spans += _inline(thing, emphasis)
        lead = padded([Span(relation, "muted")], _GUTTER)
        rows += wrapped(spans, width, _GUTTER, lead)
    return rows


def _by_relation(things: Iterable[Thing]) -> list[tuple[str, list[Thing]]]:
    groups: dict[str, list[Thing]] = {}
    for thing in things:
        groups.setdefault("has" if thing.part else _SHORT.get(thing.relation, thing.relation), [])
        groups["has" if thing.part else _SHORT.get(thing.relation, thing.relation)].append(thing)
    return sorted(groups.items(), key=lambda group: (group[0] == "has", group[0] != "on"))


_SHORT = {"beside": "by", "under": "low"}


def _inline(thing: Thing, emphasis: Emphasis) -> list[Span]:
    here = [Span(f" ◂{GLUE}robot", "robot")] if thing.id in emphasis.near else []
    spans = [*_name(thing, emphasis, "text"), *_marks(thing.marks), *here]
    for index, inside in enumerate(thing.contents):
        spans += [Span(" (" if index == 0 else ", ", "muted"), *_inline(inside, emphasis)]
    return [*spans, Span(")", "muted")] if thing.contents else spans


def _name(thing: Thing, emphasis: Emphasis, style: str) -> list[Span]:
    named = _called(thing, emphasis, style)
    if thing.sure is None:
        return named
    return [*named, Span(f"{GLUE}here{sureness(thing.sure).replace(' ', GLUE)}", "warn")]


def _called(thing: Thing, emphasis: Emphasis, style: str) -> list[Span]:
    digit = emphasis.digits.get(thing.id)
    if digit is not None:
        return [Span(f"[{digit}] {thing.label}", "asked", thing.id)]
    if thing.id in emphasis.asked:
        return [Span(f"{ASKED}{thing.label}", "asked", thing.id)]
    if thing.moved:
        return [Span(f"{CHANGED}{thing.label}", "new", thing.id)]
    return [Span(thing.label, style, thing.id)]


def _marks(marks: Iterable[Mark]) -> list[Span]:
    spans = []
    for mark in marks:
        star = CHANGED if mark.changed else ""
        style = "new" if mark.changed else "warn" if mark.sure is not None else "muted"
        spans.append(Span(f" {star}{mark.text.replace(' ', GLUE)}", style))
    return spans


def _others(picture: Picture, width: int, emphasis: Emphasis) -> list[Row]:
    """What has nothing in or on it and never had, in one paragraph."""
    if not picture.others:
        return []
    spans: list[Span] = []
    for thing in picture.others:
        spans += [SEPARATOR] if spans else [Span("Also here  ", "muted")]
        spans += _inline(thing, emphasis)
    return wrapped(spans, width, 2)

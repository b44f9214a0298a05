"""The datasheet of a corpus: what the records can say is filled in, the rest is for people.

After Gebru et al., "Datasheets for Datasets". Made again, it keeps what people
have written and brings the figures up to date.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple

TO_DO = "TO DO"
_FIGURES = ("<!-- from the records -->", "<!-- end -->")
_HEADING = re.compile(r"^### (.+)$", re.MULTILINE)


class Item(NamedTuple):
    """A heading, and what a person should write under it; empty where the records say all."""

    title: str
    ask: str = ""


SECTIONS: Mapping[str, tuple[Item, ...]] = {
    "Why it was made": (
        Item("Purpose", "what question the sessions were collected for"),
        Item("Makers", "who collected them, at which institution, and who paid"),
    ),
    "What is in it": (
        Item("Contents"),
        Item("People", "who the teachers are: how they were found, age range, languages"),
        Item("Questions asked"),
        Item("Agreement between teachers"),
        Item("Gaps", "what is missing, and which sessions were left out and why"),
    ),
    "How it was collected": (
        Item("Method"),
        Item("Setting", "where and when people taught, how long, what they were told and paid"),
        Item("Consent", "what people agreed to, and how they can withdraw"),
        Item("Ethics", "the review board's decision, or why none was needed"),
    ),
    "What was done to it": (
        Item("Personal data"),
        Item("Changes", "what was cleaned or changed beyond the redactions, and by whom"),
    ),
    "What it may be used for": (
        Item("Uses", "what it has been used for and is fit for"),
        Item("Not for", "what it must not be used for, and what harm that could do"),
    ),
    "How it is passed on": (
        Item("Licence", "under which licence, and who holds the rights"),
        Item("Maintenance", "who keeps it, whom to write to, and how corrections are made"),
    ),
}


def datasheet(facts: Mapping[str, list[str]], written: Mapping[str, str]) -> str:
    """The datasheet: ``facts`` by heading, and what people wrote under headings before."""
    return "\n".join(_lines(facts, written)) + "\n"


def written_in(text: str) -> dict[str, str]:
    """What people wrote in a datasheet, by heading, figures and open parts apart."""
    found = {}
    parts = _HEADING.split(text)[1:]
    for title, body in zip(parts[::2], parts[1::2], strict=True):
        own = _own(body)
        if own and TO_DO not in own:
            found[title.strip()] = own
    return found


def left_to_do(text: str) -> tuple[str, ...]:
    """The headings under which something is left to do, those that are missing included."""
    parts = _HEADING.split(text)
    bodies = dict(zip((title.strip() for title in parts[1::2]), parts[2::2], strict=True))
    asked = [item for items in SECTIONS.values() for item in items]
    open_ones = [item.title for item in asked if _is_open(item, bodies.get(item.title))]
    if TO_DO in parts[0]:
        open_ones.insert(0, "the beginning")
    others = [title for title in bodies if title not in open_ones and TO_DO in bodies[title]]
    return (*open_ones, *others)


def figures_in(text: str) -> tuple[str, ...]:
    """The parts that come from the records, as they stand in a datasheet."""
    begin, end = map(re.escape, _FIGURES)
    return tuple(re.findall(rf"{begin}\n(.*?)\n{end}", text, re.DOTALL))


def _is_open(item: Item, body: str | None) -> bool:
    if body is None or TO_DO in body:
        return True
    return bool(item.ask) and not _own(body)


def _own(body: str) -> str:
    """What stands under a heading apart from the figures and the next section's title."""
    begin, end = map(re.escape, _FIGURES)
    without = re.sub(rf"{begin}.*?{end}", "", body, flags=re.DOTALL)
    return re.sub(r"(?m)^## .*$", "", without).strip()


def _lines(facts: Mapping[str, list[str]], written: Mapping[str, str]) -> Iterator[str]:
    yield from ("# Datasheet", "")
    yield "What stands between the marks comes from the records and is brought up to date by"
    yield "`verbteach sessions datasheet`; all else is yours and stays as you write it."
    for section, items in SECTIONS.items():
        yield from ("", f"## {section}")
        for item in items:
            yield from ("", f"### {item.title}", "")
            yield from _item(item, facts.get(item.title, []), written.get(item.title))


def _item(item: Item, facts: list[str], written: str | None) -> Iterator[str]:
    if facts:
        yield from (_FIGURES[0], *facts, _FIGURES[1])
    if facts and (item.ask or written):
        yield ""
    if written is not None:
        yield written
    elif item.ask:
        yield f"**{TO_DO}**: {item.ask}."


def facts_of(stats: Mapping[str, Any], described: Mapping[str, Any]) -> dict[str, list[str]]:
    """What the records say under each heading, as Markdown.

    ``stats`` are those of :class:`verbteach_sessions.corpus.stats.Stats`;
    ``described`` tells of methods, studies and redactions.
    """
    return {
        "Contents": list(_contents(stats)),
        "People": [f"- participants, by their random codes: {stats['participants']}"],
        "Questions asked": list(_questions(stats)),
        "Agreement between teachers": list(_agreement(stats)),
        "Method": [f"- {name}: {told}" for name, told in described["method"].items()],
        "Consent": [f"- {name}: {told}" for name, told in described["consent"].items()],
        "Personal data": [f"- {name}: {told}" for name, told in described["personal"].items()],
    }


def _contents(stats: Mapping[str, Any]) -> Iterator[str]:
    kinds = ", ".join(f"{count} {name}" for name, count in stats["teachers"].items())
    yield f"- sessions: {stats['sessions']} (taught by: {kinds})"
    if stats["teachers"].get("simulated"):
        yield "- **simulated teachers are programs, not people**"
    turns = stats["turns"]
    yield f"- turns that hold: {turns['robot']} of the robot, {turns['teacher']} of teachers"
    yield f"- commands: {stats['commands']}"
    yield f"- session time: {stats['seconds'] / 3600:.2f} hours"
    verbs = stats["words_per_learned_verb"]["verbs"]
    yield f"- verbs learned: {', '.join(verbs) or 'none'}"


def _questions(stats: Mapping[str, Any]) -> Iterator[str]:
    by_type = stats["questions"]["by_type"]
    if not by_type:
        yield "The robot asked no question."
        return
    yield "| question | asked | reward | answers | seconds, median |"
    yield "|---|---|---|---|---|"
    for name, one in by_type.items():
        answers = ", ".join(f"{key} {count}" for key, count in one["answers"].items())
        took = one["seconds"]["median"]
        shown = "not measured" if took is None else f"{took:.1f}"
        yield f"| `{name}` | {one['count']} | {one['price']:g} | {answers} | {shown} |"


def _agreement(stats: Mapping[str, Any]) -> Iterator[str]:
    agreement = stats["agreement"]
    if agreement["mean"] is None:
        yield "No verb was taught by two people."
        return
    yield (
        f"Goals that different teachers had the robot keep for one verb overlap by"
        f" {agreement['mean']:.2f} (Jaccard index of literals; {len(agreement['verbs'])} verb"
        f" frames, {agreement['pairs']} pairs of teachers)."
    )

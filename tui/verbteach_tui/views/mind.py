"""What the robot has in mind, as rows: what words refer to, which goal it sees, what it knows."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import NamedTuple

from verbteach_tui.views.rows import GLUE, Row, Span, clipped, padded, unglued, width_of, wrapped
from verbteach_tui.views.visible import shortened

_BAR = 12
_EIGHTHS = " ▏▎▍▌▋▊▉"
_FEWEST, _MOST = 3, 5
_PARTS = 3


class Share(NamedTuple):
    """An object a phrase may mean, and how likely; ``before`` is what it was a turn ago."""

    label: str
    share: float
    before: float | None = None
    target: str = ""


class PhraseBelief(NamedTuple):
    """A noun phrase with the objects it may mean; ``settled``: the teacher has answered for it."""

    phrase: str
    shares: tuple[Share, ...]
    settled: bool = False


class GoalBelief(NamedTuple):
    """A goal the command may mean. ``differs``: what it has and the likeliest goal has not."""

    share: float
    conditions: tuple[str, ...]
    differs: tuple[str, ...] = ()


class ActValue(NamedTuple):
    """An act the robot could choose, its value under the policy, and whether it chose it.

    ``shares`` are the features' parts of the value, weight times feature, the largest first.
    """

    text: str
    value: float | None
    chosen: bool = False
    shares: tuple[tuple[str, float], ...] = ()


class KnownVerb(NamedTuple):
    """A verb frame the robot has hypotheses for.

    ``meaning`` are the conditions of the one it would go by, all else being
    equal; ``news``: the last learning touched the frame.
    """

    title: str
    hypotheses: int
    demonstrations: int
    meaning: tuple[str, ...] = ()
    news: bool = False
    target: str = ""

    @property
    def hypotheses_held(self) -> str:
        """How many hypotheses, in words."""
        return f"{self.hypotheses} hypothes{'is' if self.hypotheses == 1 else 'es'}"


@dataclass(frozen=True)
class Mind:
    """All of it at one moment.

    ``promise`` says what it promises of its executions, if anything, and ``promised`` the same
    in two words.
    """

    phrases: tuple[PhraseBelief, ...] = ()
    goals: tuple[GoalBelief, ...] = ()
    acts: tuple[ActValue, ...] = ()
    verbs: tuple[KnownVerb, ...] = ()
    promise: str = ""
    promised: str = ""


def mind_rows(mind: Mind, width: int) -> list[Row]:
    """The panel's rows; each section has a heading, and nothing is left unexplained."""
    rows: list[Row] = []
    if mind.promise:
        rows += wrapped([Span(f"It {mind.promise}", "muted")], width, 2)
    if mind.phrases:
        rows += _section("What the words refer to", rows, width)
        for phrase in mind.phrases:
            rows += _phrase(phrase, width)
    if mind.goals:
        rows += _section("What should hold afterwards", rows, width)
        for rank, goal in enumerate(mind.goals[:_MOST]):
            rows += _goal(goal, rank, width)
        rows += _more(len(mind.goals) - _MOST, "less likely goal", width)
    if mind.acts:
        rows += _section("What it weighed doing", rows, width)
        for act in mind.acts[:_FEWEST]:
            rows += _act(act, width)
        rows += _more(len(mind.acts) - _FEWEST, "act worth less", width, "acts worth less")
    return rows + _verbs(mind.verbs, rows, width)


def _section(title: str, above: Sequence[Row], width: int) -> list[Row]:
    gap: list[Row] = [()] if above else []
    return [*gap, clipped([Span(title, "accent")], width)]


def _phrase(belief: PhraseBelief, width: int) -> list[Row]:
    settled = Span("  ✓ you said so", "good") if belief.settled else Span("")
    rows = [clipped([Span(f'"{shortened(belief.phrase, 60)}"', "strong"), settled], width)]
    if not belief.shares:
        return [*rows, (Span("  nothing here fits", "warn"),)]
    names = max(len(share.label) for share in belief.shares[:_MOST])
    room = min(names, max(width - _BAR - 18, 8))
    rows += [_share(share, room, width) for share in belief.shares[:_MOST]]
    return rows + _more(len(belief.shares) - _MOST, "less likely object", width)


def _share(share: Share, room: int, width: int) -> Row:
    label = padded(clipped([Span(share.label, "text", share.target)], room), room)
    percent = f" {share.share:4.0%}"
    return clipped(
        (Span("  "), *label, Span(" "), *bar(share.share), Span(percent), _was(share)), width
    )


def _was(share: Share) -> Span:
    if share.before is None or abs(share.before - share.share) < 0.005:
        return Span("")
    arrow = "↑" if share.share > share.before else "↓"
    return Span(f" {arrow} was {share.before:.0%}", "new")


def bar(share: float, cells: int = _BAR) -> tuple[Span, Span]:
    """A share of one as a bar of ``cells`` cells."""
    eighths = round(min(max(share, 0.0), 1.0) * cells * 8)
    full, part = divmod(eighths, 8)
    drawn = "█" * full + (_EIGHTHS[part] if part else "")
    return Span(drawn, "bar"), Span("·" * (cells - len(drawn)), "border")


def _goal(goal: GoalBelief, rank: int, width: int) -> list[Row]:
    prefix = [Span("▸ " if rank == 0 else "  ", "accent"), Span(f"{goal.share:4.0%}  ", "strong")]
    told = goal.conditions if rank == 0 else goal.differs or goal.conditions
    lead = "" if rank == 0 or not goal.differs else "also: "
    text = lead + "; ".join(told) if told else "only what the goal above has, and less"
    return wrapped([Span(text)], width, width_of(prefix), prefix)


def _act(act: ActValue, width: int) -> list[Row]:
    """The act with its value, and below it what the value is made of."""
    value = "     –" if act.value is None else f"{act.value:6.2f}"
    style = "strong" if act.chosen else "text"
    mark = Span("▸ " if act.chosen else "  ", "accent")
    prefix = [mark, Span(value, style), Span("  ")]
    rows = wrapped([Span(act.text, style)], width, width_of(prefix), prefix)
    parts = [f"{share:+.2f}{GLUE}{name}" for name, share in act.shares[:_PARTS]]
    rest = sum(share for _, share in act.shares[_PARTS:])
    parts += [f"{rest:+.2f}{GLUE}others"] if abs(rest) >= 0.005 else []
    if not parts:
        return rows
    indent = width_of(prefix)
    told = wrapped([Span(" ".join(parts), "muted")], width, indent, [Span(" " * indent)])
    return [*rows, *map(unglued, told)]


def _verbs(verbs: Iterable[KnownVerb], above: Sequence[Row], width: int) -> list[Row]:
    rows = _section("Verbs it knows", above, width)
    known = [row for verb in verbs for row in _verb(verb, width)]
    if known:
        return [*rows, *known]
    return rows + wrapped(
        [Span("None yet. Give a command, and show what it means.", "muted")], width
    )


def _verb(verb: KnownVerb, width: int) -> list[Row]:
    mark = Span("✱ ", "new") if verb.news else Span("  ")
    shown = f"{verb.demonstrations} lesson{'s' * (verb.demonstrations != 1)}"
    title = Span(verb.title, "strong", verb.target)
    rows = [clipped([mark, title, Span(f"  {verb.hypotheses_held}, {shown}", "muted")], width)]
    if verb.meaning:
        rows += wrapped([Span("; ".join(verb.meaning))], width, 4, [Span("    ")])
    return rows


def _more(count: int, what: str, width: int, plural: str = "") -> list[Row]:
    if count <= 0:
        return []
    told = what if count == 1 else plural or f"{what}s"
    return [clipped([Span(f"  and {count} {told}", "muted")], width)]

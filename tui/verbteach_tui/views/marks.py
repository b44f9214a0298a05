"""How a condition of an object shows beside it: a glyph with its word, never a colour alone.

Signs for the predicates that scenes commonly have; a predicate that is not in
the table shows under its own name, so that users' own domains show as well.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from verbteach.world.fluents import Fluent, State
from verbteach_tui.views.labels import Labels, from_id
from verbteach_tui.views.visible import visible


class Sign(NamedTuple):
    """What is shown where a predicate holds, and where it could hold and does not."""

    glyph: str
    word: str
    off_glyph: str = ""
    off_word: str = ""


class Mark(NamedTuple):
    """A condition of an object as shown; ``changed``: it is not what it was a moment ago.

    ``sure``: how sure the robot is of it, where it is not sure.
    """

    glyph: str
    word: str
    changed: bool = False
    sure: float | None = None

    @property
    def text(self) -> str:
        """Glyph and word, and how sure the robot is."""
        return f"{self.glyph} {self.word}{sureness(self.sure)}"


def sureness(sure: float | None) -> str:
    """As in: ? 62%; empty where there is no doubt."""
    return "" if sure is None else f"? {sure:.0%}"


SIGNS: Mapping[str, Sign] = {
    "open": Sign("◫", "open", "■", "shut"),
    "on": Sign("●", "on", "○", "off"),
    "lit": Sign("▲", "lit", "△", "out"),
    "hot": Sign("▲", "hot"),
    "cold": Sign("▼", "cold"),
    "full": Sign("◆", "full"),
    "empty": Sign("◇", "empty"),
    "wet": Sign("≈", "wet"),
    "watered": Sign("≈", "watered"),
    "clean": Sign("+", "clean"),
    "dirty": Sign("%", "dirty"),
    "mixed": Sign("@", "stirred"),
    "folded": Sign("=", "folded"),
    "sliced": Sign("#", "sliced"),
    "cooked": Sign("▲", "cooked"),
    "locked": Sign("■", "locked", "◫", "unlocked"),
    "playing": Sign("►", "playing"),
}
"""By the predicate's stem: its name in lower case without "is", "turned", "switched"."""

HIDDEN = frozenset({"stowed", "carrying", "handsfull"})
"""Book-keeping of a domain that says nothing a person does not see anyway."""

CONTENT_GLYPH, OTHER_GLYPH, CEASED_GLYPH = "≈", "•", "–"

_CONTENT = frozenset({"contains", "has", "filledwith", "content"})
_LEADS = {"topped": "with"}
_PREFIXES = ("is", "has", "turned", "switched")
_ALIASES = {"temphigh": "hot", "temperaturehigh": "hot", "opened": "open", "filled": "full"}


def stem(predicate: str) -> str:
    """The key of ``predicate`` in ``SIGNS``: ``is-open`` and ``IsOpen`` are both ``open``."""
    word = predicate.lower().replace("-", "").replace("_", "")
    for prefix in _PREFIXES:
        if word.startswith(prefix) and word.removeprefix(prefix) in SIGNS:
            word = word.removeprefix(prefix)
    return _ALIASES.get(word, word)


def mark_of(fluent: Fluent, labels: Labels, state: State, changed: bool = False) -> Mark | None:
    """The mark of ``fluent`` beside its first argument in ``state``; ``None`` where it has none.

    Where the fluent does not hold, it has a mark only if its sign has a word
    for that, or if it held a moment ago.
    """
    if stem(fluent.predicate) in HIDDEN:
        return None
    holds = fluent in state
    if len(fluent.args) != 1:
        word = _relation(fluent, labels, state)
        glyph = CONTENT_GLYPH if stem(fluent.predicate) in _CONTENT else OTHER_GLYPH
        return _made(glyph, word, holds, changed)
    sign = SIGNS.get(stem(fluent.predicate))
    if sign is None:
        return _made(OTHER_GLYPH, from_id(fluent.predicate), holds, changed)
    if not holds and sign.off_word:
        return Mark(sign.off_glyph, sign.off_word, changed)
    return _made(sign.glyph, sign.word, holds, changed)


def _made(glyph: str, word: str, holds: bool, changed: bool) -> Mark | None:
    if holds:
        return Mark(glyph, word, changed)
    return Mark(CEASED_GLYPH, f"no longer {word}", changed=True) if changed else None


def _relation(fluent: Fluent, labels: Labels, state: State) -> str:
    """As in: hot water for ``(has Kettle_1 Water)`` while the water is hot."""
    key = stem(fluent.predicate)
    others = " ".join(_qualified(arg, labels, state) for arg in fluent.args[1:])
    if key in _CONTENT or key in ("state", "channel", "volume"):
        return others
    return visible(f"{_LEADS.get(key, from_id(fluent.predicate))} {others}")


def _qualified(thing: str, labels: Labels, state: State) -> str:
    for fluent in (Fluent("hot", (thing,)), Fluent("cold", (thing,))):
        if fluent in state:
            return f"{fluent.predicate} {labels[thing]}"
    return labels[thing]

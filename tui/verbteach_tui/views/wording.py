"""Fluents and actions in words, with the short names that the scene shows."""

from __future__ import annotations

from collections.abc import Iterable
from string import Formatter

from verbteach.language.lexicon import Lexicon
from verbteach.world.domain import Domain
from verbteach.world.fluents import Literal
from verbteach.world.plan import Action
from verbteach_tui.views.labels import Labels, from_id
from verbteach_tui.views.visible import visible


class Wording:
    """Words for one scene. A predicate or action that the lexicon lacks reads as its own name."""

    def __init__(self, labels: Labels, lexicon: Lexicon, domain: Domain | None = None) -> None:
        self.labels = labels
        self.lexicon = lexicon
        self.domain = domain

    def holds(self, literal: Literal) -> str:
        """As in: the mug is on the table."""
        return self._fluent(literal, "is_true", "is_false")

    def became(self, literal: Literal) -> str:
        """As in: the mug is now on the table."""
        return self._fluent(literal, "became", "ceased")

    def should(self, literal: Literal) -> str:
        """As in: the mug should be on the table."""
        return self._fluent(literal, "should", "should_not")

    def action(self, action: Action) -> str:
        """As in: go to the table."""
        return self.phrase(action.name, [self._named(arg) for arg in action.args])

    def phrase(self, name: str, words: Iterable[str]) -> str:
        """An action's phrase with ``words`` in its slots; slots without a word show an ellipsis."""
        given = list(words)
        pattern = self.lexicon.actions.get(name)
        if pattern is None:
            return " ".join((from_id(name), *given))
        slots = 1 + max([-1, *(int(f) for _, f, _, _ in Formatter().parse(pattern) if f)])
        padding = ["…"] * (slots - len(given))
        return pattern.format(*given, *padding)

    def _named(self, object_id: str) -> str:
        return f"the {self.labels[object_id]}"

    def _fluent(self, literal: Literal, positive: str, negative: str) -> str:
        fluent = literal.fluent
        wording = self.lexicon.fluents.get(fluent.predicate)
        if wording is None:
            named = " ".join((from_id(fluent.predicate), *(self.labels[a] for a in fluent.args)))
            return visible(named if literal.positive else f"not: {named}")
        pattern: str = getattr(wording, positive if literal.positive else negative)
        return pattern.format(*(self._named(arg) for arg in fluent.args))

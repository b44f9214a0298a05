"""Two readings of one command: whether they agree, and what to ask where they do not."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from typing import Protocol

from verbteach.language.frames import NounPhrase, VerbFrame


class NoSecondReaderError(RuntimeError):
    """A second reader is wanted and there is none, or it fails; the message says what to do."""


class SecondReader(Protocol):
    """Another way to read commands, such as a statistical parser."""

    def read(self, text: str) -> tuple[VerbFrame, ...]:
        """The frames of ``text``; the same for the same text.

        Raises ``NoSecondReaderError`` where it cannot read at all.
        """
        ...


def view(frame: VerbFrame) -> tuple[str, Counter[tuple[str, str]]]:
    """A frame as far as verb, roles and heads go: what two readings are compared by."""
    return frame.verb, Counter((a.role, a.phrase.head) for a in frame.arguments)


def flat(frame: VerbFrame) -> tuple[str, Counter[tuple[str, str]]]:
    """The same with attached phrases beside the others: what they belong to is left open."""
    links = [link for a in frame.arguments for link in _links(a.role, a.phrase)]
    return frame.verb, Counter(links)


def _links(role: str, phrase: NounPhrase) -> Iterator[tuple[str, str]]:
    yield role, phrase.head
    for name, inner in phrase.relations:
        yield from _links(name, inner)


def agree(one: Sequence[VerbFrame], other: Sequence[VerbFrame]) -> bool:
    """Whether both found the same verbs in the same order, with the same roles and heads.

    Where a phrase of place is attached makes no difference: the scene decides that.
    """
    return list(map(flat, one)) == list(map(flat, other))


def disputed(one: Sequence[VerbFrame], other: Sequence[VerbFrame]) -> tuple[int, ...]:
    """The clauses of ``one`` that ``other`` does not have; all where their numbers differ."""
    if len(one) != len(other):
        return tuple(range(len(one)))
    return tuple(i for i, (a, b) in enumerate(zip(one, other, strict=True)) if flat(a) != flat(b))

"""Names with a particle inside ("volume up button"): read as one word, then taken apart again.

The grammar would otherwise hear "up" as the verb's particle. It knows tokens
and frames, and nothing of how clauses are read.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace

from verbteach.language.frames import Argument, NounPhrase, VerbFrame
from verbteach.language.words import PARTICLES

_JOINT = "\N{NO-BREAK SPACE}"


def fixed_names(vocabulary: Iterable[str]) -> tuple[tuple[str, ...], ...]:
    """The names that hold a particle between other words, the longest first."""
    split = {tuple(name.lower().split()) for name in vocabulary}
    held = (words for words in split if PARTICLES.intersection(words[1:-1]))
    return tuple(sorted(held, key=lambda words: (-len(words), words)))


def joined(tokens: Sequence[str], names: Sequence[tuple[str, ...]]) -> list[str]:
    """The tokens with each such name as one token."""
    found: list[str] = []
    index = 0
    while index < len(tokens):
        name = next((n for n in names if tuple(tokens[index : index + len(n)]) == n), None)
        found.append(_JOINT.join(name) if name else tokens[index])
        index += len(name) if name else 1
    return found


def taken_apart(frame: VerbFrame) -> VerbFrame:
    """The frame with the names' words as modifiers and head again."""
    arguments = (Argument(a.role, _apart(a.phrase)) for a in frame.arguments)
    return VerbFrame(frame.verb, tuple(arguments))


def _apart(phrase: NounPhrase) -> NounPhrase:
    *before, head = phrase.head.split(_JOINT)
    return replace(
        phrase,
        text=phrase.text.replace(_JOINT, " "),
        head=head,
        modifiers=(*phrase.modifiers, *before),
        relations=tuple((preposition, _apart(inner)) for preposition, inner in phrase.relations),
    )

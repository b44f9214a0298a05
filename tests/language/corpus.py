"""The Tell Me Dave corpus as this room's tests read it: grounded phrases, clauses with frames."""

from __future__ import annotations

from functools import cache

from tests.scenarios.tell_me_dave_folder import REAL, needs_corpus
from verbteach.experiments.frame_agreement import Parsed
from verbteach.experiments.grounding_scores import Case
from verbteach.language.frames import NounPhrase, VerbFrame
from verbteach.language.grammar import parse
from verbteach.language.looks import Looks
from verbteach.language.morphology import is_plural, singular
from verbteach_scenarios.lexicon_file import load_lexicon
from verbteach_scenarios.tell_me_dave.clauses import noun_phrases
from verbteach_scenarios.tell_me_dave.corpus import read_corpus
from verbteach_scenarios.tell_me_dave.documents import Corpus
from verbteach_scenarios.tell_me_dave.instances import instances
from verbteach_scenarios.tell_me_dave.rooms import Rooms

__all__ = ["cases", "corpus", "needs_corpus", "readings"]


@cache
def corpus() -> Corpus:
    """All shared documents."""
    return read_corpus(REAL)


@cache
def cases() -> tuple[Case, ...]:
    """Every grounded noun phrase of every instance, in the state its clause begins in."""
    rooms, found = Rooms.of(corpus()), []
    for one in instances(corpus(), rooms=rooms):
        instance = one.instance
        looks = Looks(rooms.scene(one.document), instance.start, load_lexicon())
        for text, objects in zip(instance.phrases, instance.candidates, strict=True):
            phrase = _phrase(text)
            found.append(Case(phrase, looks, objects, instance.group, instance.environment))
    return tuple(found)


@cache
def readings() -> tuple[tuple[Parsed, tuple[VerbFrame, ...]], ...]:
    """Every clause as the corpus's parser framed it, and as the grammar reads it."""
    return tuple(
        (
            Parsed(clause.sentence, clause.verb.lower(), noun_phrases(clause.frame)),
            parse(clause.sentence),
        )
        for document in corpus().documents
        for clause in document.clauses
    )


def _phrase(text: str) -> NounPhrase:
    *before, head = text.split() or [text]
    return NounPhrase(text, singular(head), tuple(before), plural=is_plural(head))

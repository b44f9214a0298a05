"""Verb frames from a dependency parse (the labels of ClearNLP, as spaCy's English models use them).

Knows no parser: any will do that gives words with a part of speech, a label and a head.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import NamedTuple

from verbteach.language import household, words
from verbteach.language.frames import Argument, NounPhrase, VerbFrame
from verbteach.language.morphology import is_plural, singular
from verbteach.language.particles import PARTICLES_OF

_CONTROL = frozenset({"want", "need", "like", "love", "mind", "ask", "wonder", "try", "help"})
_ASPECT = frozenset({"keep", "start", "begin", "continue", "go", "come", "finish"})
_DESCRIBING = frozenset({"relcl", "acl", "amod", "aux", "auxpass", "compound", "pobj", "csubj"})
_MODIFIERS = frozenset({"amod", "compound", "poss", "nummod", "nmod"})
_INNER = frozenset({"top", "front", "left", "right", "middle"})


class Word(NamedTuple):
    """One word of a parse; ``head`` is the index of its head, its own for the root."""

    text: str
    lemma: str
    pos: str
    dep: str
    head: int


@dataclass(frozen=True)
class _Tree:
    words: Sequence[Word]

    def children(self, index: int, *labels: str) -> Iterator[int]:
        for child, word in enumerate(self.words):
            if word.head == index and child != index and (not labels or word.dep in labels):
                yield child

    def conjoined(self, index: int) -> Iterator[int]:
        """The word and everything coordinated with it."""
        yield index
        for child in self.children(index, "conj"):
            yield from self.conjoined(child)


def frames_of(parsed: Sequence[Word]) -> tuple[VerbFrame, ...]:
    """The frames of the commands in a parsed text."""
    tree = _Tree(parsed)
    frames = [_frame(tree, index) for index in range(len(parsed)) if _is_command(tree, index)]
    return tuple(_sharing(frames))


def _is_command(tree: _Tree, index: int) -> bool:
    """Whether the word is a verb that is asked for, not one that asks or describes."""
    word = tree.words[index]
    governs = any(tree.children(index, "dobj", "prt", "dative"))
    if word.pos != "VERB" and not (word.head == index and governs):
        return False
    if word.dep in _DESCRIBING or _is_subordinate(tree, index) or _has_other_subject(tree, index):
        return False
    return not _asks(tree, index)


def _is_subordinate(tree: _Tree, index: int) -> bool:
    marks = (tree.words[i].text.lower() for i in tree.children(index, "mark", "advmod"))
    return not words.SUBORDINATORS.isdisjoint(set(marks) - {"so"})


def _has_other_subject(tree: _Tree, index: int) -> bool:
    subjects = [tree.words[i].text.lower() for i in tree.children(index, "nsubj", "nsubjpass")]
    return any(subject not in {"you", "us", "we", "i", "'s", "robot"} for subject in subjects)


def _asks(tree: _Tree, index: int) -> bool:
    """``want`` in "I want you to go", ``go`` in "go and get", ``use`` in "use it to wipe"."""
    word = tree.words[index]
    inner = [i for i in tree.children(index, "xcomp", "ccomp") if tree.words[i].pos == "VERB"]
    if word.lemma in _CONTROL | _ASPECT | {"use", "let"} and inner:
        return True
    bare = not any(tree.children(index, "dobj", "prep", "prt", "advmod"))
    return word.lemma in {"go", "come"} and bare and any(tree.children(index, "conj", "advcl"))


def _frame(tree: _Tree, index: int) -> VerbFrame:
    word = tree.words[index]
    particle = _particle(tree, index)
    negated = "not" if any(tree.children(index, "neg")) else ""
    name = " ".join(filter(None, (negated, word.lemma.lower(), particle.lower())))
    places = [a for a in _places(tree, index) if a.role]
    if particle and not any(tree.children(index, "prt")):
        places = [Argument("obj", a.phrase) if a.role == particle else a for a in places]
    arguments = [*_objects(tree, index), *places, *_recipients(tree, index)]
    governor = tree.words[word.head]
    if governor.lemma == "use" and word.dep in {"xcomp", "advcl"}:
        arguments += [Argument("with", a.phrase) for a in _objects(tree, word.head)]
    return VerbFrame(name, tuple(arguments))


def _particle(tree: _Tree, index: int) -> str:
    """A particle, be it labelled as one, as an adverb, or as a preposition without any object."""
    for child in tree.children(index, "prt"):
        return tree.words[child].text.lower()
    for child in tree.children(index, "advmod"):
        word = tree.words[child].text.lower()
        if word in words.PARTICLES and not any(tree.children(child)):
            return word
    known = PARTICLES_OF.get(tree.words[index].lemma, frozenset())
    direct = [tree.words[i].text.lower() for i in tree.children(index, "prep") if i == index + 1]
    without_object = not any(tree.children(index, "dobj"))
    return next((word for word in direct if word in known and without_object), "")


def _objects(tree: _Tree, index: int) -> Iterator[Argument]:
    for child in tree.children(index, "dobj"):
        for one in tree.conjoined(child):
            yield Argument("obj", _phrase(tree, one))


def _recipients(tree: _Tree, index: int) -> Iterator[Argument]:
    verb = tree.words[index].lemma
    role = "for" if verb in household.FOR_DATIVE - household.TO_DATIVE else "to"
    for child in tree.children(index, "dative"):
        if not any(tree.children(child, "pobj")):
            yield Argument(role, _phrase(tree, child))


def _places(tree: _Tree, index: int) -> Iterator[Argument]:
    for child in tree.children(index):
        word = tree.words[child]
        if word.dep == "prep" or (word.dep == "dative" and any(tree.children(child, "pobj"))):
            for role, phrase in _prepositional(tree, child):
                yield Argument(role, phrase)
        elif word.dep == "advmod" and word.text.lower() in words.PLACE_ADVERBS:
            yield Argument("loc", NounPhrase(word.text.lower(), word.text.lower()))
        elif word.dep == "advmod":
            for inner in tree.children(child, "prep"):
                for role, phrase in _prepositional(tree, inner):
                    yield Argument(f"{word.text.lower()} {role}", phrase)


def _prepositional(tree: _Tree, index: int) -> Iterator[tuple[str, NounPhrase]]:
    """The phrases behind a preposition, with compound ones ("out of", "on top of") as one."""
    role = tree.words[index].text.lower()
    for inner in tree.children(index, "prep"):
        for name, phrase in _prepositional(tree, inner):
            yield f"{role} {name}", phrase
    for child in tree.children(index, "pobj"):
        noun = tree.words[child].text.lower()
        below = list(tree.children(child, "prep"))
        if noun in _INNER and below and tree.words[below[0]].text.lower() == "of":
            the = "the " if any(tree.children(child, "det")) else ""
            for _, phrase in _prepositional(tree, below[0]):
                yield f"{role} {the}{noun} of", phrase
        else:
            for one in tree.conjoined(child):
                yield role, _phrase(tree, one)


def _phrase(tree: _Tree, index: int) -> NounPhrase:
    word = tree.words[index]
    text = word.text.lower()
    before = [i for i in tree.children(index, *sorted(_MODIFIERS)) if i < index]
    modifiers = tuple(tree.words[i].text.lower() for i in before)
    relations = tuple(
        found for child in tree.children(index, "prep") for found in _prepositional(tree, child)
    )
    determiner = next((tree.words[i].text.lower() for i in tree.children(index, "det")), "")
    said = " ".join(filter(None, (determiner, *modifiers, text)))
    return NounPhrase(said, singular(text), modifiers, determiner, is_plural(text), relations)


def _sharing(frames: Sequence[VerbFrame]) -> list[VerbFrame]:
    """``wash and dry the plates``: a bare verb takes the objects of the next one."""
    found = list(frames)
    for index in range(len(found) - 2, -1, -1):
        bare = found[index]
        if not bare.arguments and bare.verb not in household.INTRANSITIVE:
            objects = (a for a in found[index + 1].arguments if a.role == "obj")
            found[index] = VerbFrame(bare.verb, tuple(objects))
    return found

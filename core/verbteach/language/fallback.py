"""English for predicates and actions that no lexicon words: made from their names alone.

Good enough to be understood ("the box is inside the crate"); a lexicon reads better.
"""

from __future__ import annotations

import re

from verbteach.language import household, words
from verbteach.language.inflection import base_of_gerund, base_of_participle, third_person
from verbteach.language.lexicon import FluentWording
from verbteach.language.morphology import listing

_PARTS = re.compile(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+|\d+")


def split_name(name: str) -> tuple[str, ...]:
    """The lower-case words of an identifier: ``is-on``, ``IsGraspable``, ``moveto``."""
    found = [part.lower() for part in _PARTS.findall(name)]
    if len(found) == 1:
        for preposition in ("into", "onto", "to", "in", "on", "at", "from", "off", "out"):
            stem = found[0].removesuffix(preposition)
            if stem != found[0] and stem in household.VERBS:
                return stem, preposition
    return tuple(found) or (name.lower(),)


def fluent_wording(predicate: str, arity: int) -> FluentWording:
    """How a predicate of ``arity`` arguments reads, judged by its name."""
    said = split_name(predicate)
    said = said[1:] if said[0] in {"is", "has", "are"} and len(said) > 1 else said
    if arity == 0:
        return _being("it", " ".join(said))
    if arity == 1:
        return _being("{0}", " ".join(said))
    return _relating(said, listing([f"{{{index}}}" for index in range(1, arity)]))


def _relating(said: tuple[str, ...], others: str) -> FluentWording:
    """A relation: "is next to", "is holding", "contains", "the colour of the cup is"."""
    name, last = " ".join(said), said[-1]
    related = name in words.LOCATIVES or last in words.PREPOSITIONS
    if related or base_of_gerund(last, household.VERBS):
        return _being("{0}", f"{name} {others}")
    if base_of_participle(last, household.VERBS) and last.endswith("ed"):
        return _being("{0}", f"{name} with {others}")
    for verb in (last.removesuffix("s"), last.removesuffix("es")):
        if verb in household.VERBS | {"contain", "control"} and third_person(verb) == last:
            before = " ".join(said[:-1])
            return _doing(" ".join(filter(None, (before, verb))), others)
    return _being(f"the {name} of {{0}}", others)


def _being(subject: str, rest: str) -> FluentWording:
    return FluentWording(
        is_true=f"{subject} is {rest}",
        is_false=f"{subject} is not {rest}",
        question=f"is {subject} {rest}?",
        should=f"{subject} should be {rest}",
        should_not=f"{subject} should not be {rest}",
        became=f"{subject} is now {rest}",
        ceased=f"{subject} is no longer {rest}",
    )


def _doing(verb: str, rest: str) -> FluentWording:
    does = third_person(verb)
    return FluentWording(
        is_true=f"{{0}} {does} {rest}",
        is_false=f"{{0}} does not {verb} {rest}",
        question=f"does {{0}} {verb} {rest}?",
        should=f"{{0}} should {verb} {rest}",
        should_not=f"{{0}} should not {verb} {rest}",
        became=f"{{0}} now {does} {rest}",
        ceased=f"{{0}} no longer {does} {rest}",
    )


def action_wording(name: str, arity: int) -> str:
    """A template for a primitive action, judged by its name: ``put-on`` is "put {0} on {1}"."""
    verb, *rest = split_name(name)
    slots = [f"{{{i}}}" for i in range(arity)]
    last = rest[-1] if rest else ""
    if arity > 1 and last in words.PREPOSITIONS:
        return " ".join((verb, *rest[:-1], slots[0], last, ", ".join(slots[1:])))
    return " ".join(filter(None, (verb, *rest, " with ".join(slots))))

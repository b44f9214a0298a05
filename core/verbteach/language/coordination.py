"""What a conjunction joins a phrase to, judged by what its clause holds so far."""

from __future__ import annotations

from verbteach.language import household, words
from verbteach.language.assembly import OBJECT, PLACE, Clause, attaches_to_noun
from verbteach.language.frames import NounPhrase


def verb_level_role(clause: Clause) -> str | None:
    """The role of the last phrase that belongs to the verb and not to a noun."""
    before: NounPhrase | None = None
    role = None
    for piece in clause.pieces:
        free = piece.role not in {OBJECT, PLACE}
        if free and not attaches_to_noun(clause.verb, before, piece.role, piece.phrase):
            role = piece.role
        before = piece.phrase
    return role


def same_kind(role: str, other: str | None) -> bool:
    """Whether two roles are the same, or both of place."""
    places = words.LOCATIVES | words.DIRECTIONALS
    return other is not None and (role == other or (role in places and other in places))


def has_recipient(clause: Clause) -> bool:
    """Whether the clause has somebody who receives: ``give mary the book``."""
    first_two = clause.pieces[:2]
    return len(first_two) == 2 and all(p.role == OBJECT and not p.joined for p in first_two)


def joined_role(clause: Clause, phrase: NounPhrase, *, nested: bool) -> str:
    """What a phrase behind a conjunction is: one more object, or one more of the last role.

    ``nested``: not one more content, as in "a bowl of chips and a bag of chips".
    """
    pieces = list(clause.pieces)
    while nested and pieces and pieces[-1].role == "of":
        pieces.pop()
    if not pieces:
        return OBJECT
    last = pieces[-1]
    if last.role in {OBJECT, PLACE} or not clause.objects:
        return OBJECT if last.role == PLACE else last.role
    before = pieces[-2].phrase if len(pieces) > 1 else None
    if attaches_to_noun(clause.verb, before, last.role, last.phrase):
        whole = bool(phrase.determiner) or phrase.is_pronoun
        return OBJECT if whole else last.role
    is_place = phrase.head in household.PLACES
    mismatched = last.phrase.head in household.PLACES and not is_place
    return OBJECT if mismatched else last.role

"""From the pieces of one clause to its frame: who receives, and what each phrase belongs to.

Without a scene a prepositional phrase goes where its verb usually wants it;
``attachment`` lists the other readings and lets the scene decide.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from itertools import pairwise
from typing import NamedTuple

from verbteach.language import household, words
from verbteach.language.frames import Argument, NounPhrase, VerbFrame

OBJECT = "obj"
PLACE = "loc"
_MOST_NESTED = 6
_OPEN_PRONOUNS = frozenset({"one", "those", "that", "something", "anything", "everything"})
_GOALS = frozenset({"to", "into", "onto"})


class Piece(NamedTuple):
    """A phrase with its role; ``joined`` where a conjunction ties it to the piece before."""

    role: str
    phrase: NounPhrase
    joined: bool = False


@dataclass
class Clause:
    """A verb with what was said after it, in order, not yet settled.

    ``trailing`` pieces were said elsewhere ("use the sponge to ...") and come last.
    ``purpose``: said as what for; ``bare``: a conjunction follows the verb.
    """

    verb: str
    negative: bool = False
    particle: str = ""
    pieces: list[Piece] = field(default_factory=list)
    trailing: list[Piece] = field(default_factory=list)
    purpose: bool = False
    bare: bool = False

    @property
    def name(self) -> str:
        """The verb as the frame names it: "turn on", "not open"."""
        return " ".join(filter(None, ("not" if self.negative else "", self.verb, self.particle)))

    @property
    def objects(self) -> list[NounPhrase]:
        """The direct objects so far."""
        return [piece.phrase for piece in self.pieces if piece.role == OBJECT]

    def settled(self) -> VerbFrame:
        """The frame of this clause."""
        return VerbFrame(
            self.name, tuple(_arguments(self.verb, [*_with_recipient(self), *self.trailing]))
        )


def attaches_to_noun(
    verb: str,
    before: NounPhrase | None,
    preposition: str,
    phrase: NounPhrase,
    *,
    placed: bool = False,
    goal_follows: bool = False,
) -> bool:
    """Whether ``preposition phrase`` belongs to the noun phrase ``before`` it.

    ``placed`` says that the verb already has its place; ``goal_follows`` that
    a goal ("into the sink") comes later in the clause.
    """
    if before is None or _is_closed(before):
        return preposition == "of" and before is not None
    if preposition == "of":
        return True
    if preposition == "with":
        return _with_tells_which(verb, phrase)
    if preposition == "to":
        return before.head in household.APPROACHES and verb not in household.TRANSFERRING
    if preposition not in words.LOCATIVES or phrase.head in words.TIME_NOUNS:
        return False
    return placed or _place_tells_which(verb, before, phrase, goal_follows)


def _is_closed(phrase: NounPhrase) -> bool:
    """Whether nothing can be said about the phrase any more: "it", "me"."""
    pronoun = phrase.is_pronoun and phrase.head not in _OPEN_PRONOUNS
    return pronoun or phrase.head in words.PERSONS


def _with_tells_which(verb: str, phrase: NounPhrase) -> bool:
    if phrase.head in household.PARTS:
        return True
    return phrase.head not in household.TOOLS and verb in household.FETCHING


def _place_tells_which(
    verb: str, before: NounPhrase, phrase: NounPhrase, goal_follows: bool
) -> bool:
    if phrase.head in {"left", "right"} or before.head in household.CONTROLS:
        return True
    if verb in household.PLACING:
        return goal_follows
    return verb in household.VERBS and verb not in household.PROCESSING | household.INTRANSITIVE


def attached(
    phrase: NounPhrase, preposition: str, inner: NounPhrase, *, beside: bool = False, depth: int = 0
) -> NounPhrase:
    """``phrase`` with ``preposition inner`` on its last noun ("the charger next to the bed").

    ``beside``: next to the phrase that was attached last ("contents of cups and pots").
    A measured content ("a cup of tea") takes nothing: that belongs to the cup.
    """
    relations = phrase.relations
    if relations and depth < _MOST_NESTED:
        name, last = relations[-1]
        deeper = bool(last.relations) if beside else name != "of" or bool(last.determiner)
        if deeper:
            nested = attached(last, preposition, inner, beside=beside, depth=depth + 1)
            return _extended(phrase, preposition, inner, (*relations[:-1], (name, nested)))
    if preposition == "of" and not inner.determiner and inner.relations:
        bare = replace(inner, relations=())
        return _extended(phrase, preposition, inner, (*relations, ("of", bare), *inner.relations))
    return _extended(phrase, preposition, inner, (*relations, (preposition, inner)))


def _extended(
    phrase: NounPhrase,
    preposition: str,
    inner: NounPhrase,
    relations: tuple[tuple[str, NounPhrase], ...],
) -> NounPhrase:
    text = f"{phrase.text} {preposition} {inner.text}"
    return replace(phrase, text=text, relations=relations)


def _with_recipient(clause: Clause) -> list[Piece]:
    """The pieces with "bring me the mug" turned into "bring the mug to me"."""
    pieces = _without_extent([_measured(piece) for piece in clause.pieces])
    for index, (first, second) in enumerate(pairwise(pieces)):
        if first.role == second.role == OBJECT and not (first.joined or second.joined):
            if not _receives(clause.verb, first.phrase):
                return pieces
            role = "for" if clause.verb in household.FOR_DATIVE - household.TO_DATIVE else "to"
            recipient = Piece(role, first.phrase, joined=True)
            return [*pieces[:index], *pieces[index + 1 :], recipient]
    return pieces


def _without_extent(pieces: list[Piece]) -> list[Piece]:
    """The pieces without how far or how much: "fill it up three quarters of the way"."""
    kept: list[Piece] = []
    dropped = False
    for piece in pieces:
        measures = piece.role == OBJECT and piece.phrase.head in words.UNITS and not piece.joined
        follows = bool(kept) and kept[-1].role == OBJECT
        dropped = (measures and follows) or (dropped and piece.role == "of")
        if not dropped:
            kept.append(piece)
    return kept


def _receives(verb: str, phrase: NounPhrase) -> bool:
    datives = household.TO_DATIVE | household.FOR_DATIVE
    return phrase.head in words.PERSONS | {"them"} or verb in datives


def _measured(piece: Piece) -> Piece:
    """``wait two minutes`` lasts for two minutes."""
    counted = bool(piece.phrase.modifiers or piece.phrase.determiner in {"a", "an"})
    timed = piece.phrase.head in {"second", "minute", "hour", "moment", "while"} and counted
    return Piece("for", piece.phrase, joined=True) if piece.role == OBJECT and timed else piece


def _arguments(verb: str, pieces: Sequence[Piece]) -> list[Argument]:
    arguments: list[Argument] = []
    tied = ""
    placed = False
    goals = [i for i, p in enumerate(pieces) if p.role in _GOALS]
    for index, (role, phrase, joined) in enumerate(pieces):
        before = arguments[-1].phrase if arguments and arguments[-1].role != PLACE else None
        follows = bool(goals) and goals[-1] > index
        if role in {OBJECT, PLACE} or (joined and role != tied):
            to_noun = False
        else:
            to_noun = joined or attaches_to_noun(
                verb, before, role, phrase, placed=placed, goal_follows=follows
            )
        if to_noun and before is not None:
            last = arguments[-1]
            arguments[-1] = Argument(last.role, attached(last.phrase, role, phrase, beside=joined))
            tied = role
        else:
            arguments.append(Argument(role, phrase))
            tied = ""
            placed = placed or role in words.LOCATIVES | words.DIRECTIONALS
    return arguments

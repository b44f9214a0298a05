"""What pronouns point back to, among the phrases said before.

Works on words alone: "fill the cup with milk and put it on the table" gives the
cup. What cannot be told so is left as it is, for the scene or the person.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from verbteach.language import household, words
from verbteach.language.assembly import OBJECT, PLACE
from verbteach.language.frames import Argument, NounPhrase, VerbFrame

_ONE_THING = frozenset({"it", "this", "that", "itself"})
_SEVERAL = frozenset({"them", "these", "those", "themselves"})
_UNTHINGS = words.PERSONS | words.UNITS | words.TIME_NOUNS


def resolve(
    frames: Sequence[VerbFrame], earlier: Sequence[VerbFrame] = ()
) -> tuple[VerbFrame, ...]:
    """The frames with "it", "them", "one" and "there" replaced by what they point back to.

    ``earlier`` are frames of former commands, the latest last. "Them" may
    become several arguments. An object left out ("grab the pot and bring to the
    sink") is filled in.
    """
    said = list(earlier)
    found: list[VerbFrame] = []
    for frame in frames:
        filled = _with_object(frame, said)
        arguments: list[Argument] = []
        for argument in filled.arguments:
            arguments += _resolved(argument, said, arguments)
        found.append(replace(frame, arguments=tuple(arguments)))
        said.append(found[-1])
    return tuple(found)


def _with_object(frame: VerbFrame, said: Sequence[VerbFrame]) -> VerbFrame:
    """The frame with the object that it leaves out: a verb of putting has one."""
    verb = frame.verb.removeprefix("not ").partition(" ")[0]
    takes_one = verb in household.PLACING | household.FETCHING - household.INTRANSITIVE
    has_one = any(argument.role in {OBJECT, PLACE} for argument in frame.arguments)
    if not takes_one or has_one or not frame.arguments or not said:
        return frame
    objects = [a for a in said[-1].arguments if a.role == OBJECT and _is_thing(a.phrase)]
    return replace(frame, arguments=(*objects, *frame.arguments))


def _resolved(
    argument: Argument, said: Sequence[VerbFrame], before: Sequence[Argument]
) -> list[Argument]:
    phrase = argument.phrase
    found: Sequence[NounPhrase] = ()
    if argument.role == PLACE and phrase.head == "there":
        return [_place(said) or argument]
    if phrase.head in _ONE_THING and not phrase.modifiers:
        found = _one_thing(argument.role, said)
    elif phrase.head in _SEVERAL and not phrase.modifiers:
        found = _several(said)
    elif phrase.head == "one" and phrase.modifiers and not _is_open(said):
        found = [_like(phrase, n) for n in _nouns(said, before)][:1]
    return [replace(argument, phrase=antecedent) for antecedent in found] or [argument]


def _is_open(said: Sequence[VerbFrame]) -> bool:
    """Whether the last clause is about an "it" of which only the scene may say what it is."""
    objects = [a.phrase for a in said[-1].arguments if a.role == OBJECT] if said else []
    return any(phrase.is_pronoun and not phrase.modifiers for phrase in objects)


def _one_thing(role: str, said: Sequence[VerbFrame]) -> list[NounPhrase]:
    """The last clause's phrase of the same role, else its object, else what came before."""
    for frame in reversed(said):
        things = [a for a in frame.arguments if _is_thing(a.phrase) and not a.phrase.plural]
        alike = [a for a in things if _same_kind(a.role, role)] if role != OBJECT else []
        objects = [a for a in things if a.role == OBJECT]
        for group in (alike, objects, things):
            if group:
                return [group[-1].phrase]
    return []


def _several(said: Sequence[VerbFrame]) -> list[NounPhrase]:
    """The last clause's plural or coordinated objects, else the objects of all clauses."""
    for frame in reversed(said):
        objects = _objects(frame)
        if len(objects) > 1 or any(phrase.plural for phrase in objects):
            return objects
    gathered = [phrase for frame in said for phrase in _objects(frame)]
    return gathered if len(gathered) > 1 else []


def _objects(frame: VerbFrame) -> list[NounPhrase]:
    return [a.phrase for a in frame.arguments if a.role == OBJECT and _is_thing(a.phrase)]


def _place(said: Sequence[VerbFrame]) -> Argument | None:
    """Where the last phrase of place led to."""
    for frame in reversed(said):
        for argument in reversed(frame.arguments):
            if argument.role == PLACE and argument.phrase.head not in {"here", "there"}:
                return argument
            if argument.role in words.LOCATIVES and _is_thing(argument.phrase):
                return argument
            if argument.role in {"to", "into", "onto"} and _is_thing(argument.phrase):
                return replace(argument, role={"into": "in", "onto": "on"}.get(argument.role, "at"))
    return None


def _nouns(said: Sequence[VerbFrame], before: Sequence[Argument]) -> Iterator[NounPhrase]:
    """Phrases with a noun of their own, the latest clause first, in it the objects first."""
    for arguments in (before, *(frame.arguments for frame in reversed(said))):
        things = [a for a in reversed(arguments) if _is_thing(a.phrase)]
        yield from (a.phrase for a in things if a.role == OBJECT)
        yield from (a.phrase for a in things if a.role != OBJECT)


def _like(phrase: NounPhrase, antecedent: NounPhrase) -> NounPhrase:
    """``the blue one`` after ``the red coffee mug``: the blue coffee mug."""
    kind = [word for word in antecedent.modifiers if word in household.NOUNS]
    text = phrase.text.replace("ones", antecedent.head).replace("one", antecedent.head)
    return replace(phrase, text=text, head=antecedent.head, modifiers=(*phrase.modifiers, *kind))


def _is_thing(phrase: NounPhrase) -> bool:
    return not phrase.is_pronoun and phrase.head not in _UNTHINGS


def _same_kind(role: str, other: str) -> bool:
    places = words.LOCATIVES | words.DIRECTIONALS
    return role == other or (role in places and other in places)

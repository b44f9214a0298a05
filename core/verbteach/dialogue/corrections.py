"""A correction of what was done, offered unasked: "no, the other pot", "I meant the back burner".

What was taken wrongly is an object that the command named, or one that the
robot chose itself because its goal needed a thing of that kind.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from typing import NamedTuple

from verbteach.dialogue.draft import Draft
from verbteach.dialogue.referring import fitting_objects, looks_now, read_noun_phrase
from verbteach.language.assembly import OBJECT
from verbteach.language.corrections import Correction
from verbteach.language.frames import PRONOUNS, NounPhrase
from verbteach.language.looks import Looks
from verbteach.language.refer import Candidates, refer
from verbteach.language.words import PREPOSITIONS
from verbteach.world.fluents import Fluent, Goal, Literal

_ELSEWHERE = PREPOSITIONS | {"next"}
"""Begin where something should be, and no name: "no, next to the sink"."""


class Exchanged(NamedTuple):
    """The goal that was carried out, about the thing ``now`` in the place of ``was``."""

    was: str
    now: str
    goal: Goal


def another_reference(draft: Draft, correction: Correction) -> tuple[str, Candidates] | None:
    """A noun phrase of the command and what it should have meant: "no, the other pot".

    Of several things those that the phrase itself fits.
    """
    told = _told(draft, correction.meant)
    if told is None or correction.meant.split()[0] in _ELSEWHERE:
        return None
    looks = looks_now(draft)
    for argument in draft.episode.frame.arguments:
        phrase = argument.phrase.text
        was = draft.episode.grounding.best(phrase)
        found = _best(refer(told, looks, [was] if was else []))
        others = [
            row for row in found if row[0] != was and _alike(looks, phrase, was, row[0], told)
        ]
        fitting = {thing for thing, _ in fitting_objects(draft, argument, looks)}
        among = tuple(row for row in others if row[0] in fitting) or tuple(others)
        if among:
            return phrase, among
    return None


def another_noun(draft: Draft, correction: Correction) -> tuple[str, Candidates] | None:
    """The command's only phrase that could be meant, about a thing of another name.

    "No, the microwave" after "open the fridge". ``None`` where it could be said of
    several phrases, or of none.
    """
    told, looks = _told(draft, correction.meant), looks_now(draft)
    elsewhere = correction.meant.split()[0] in _ELSEWHERE
    if told is None or told.head in PRONOUNS or elsewhere:
        return None
    found = tuple(row for row in _best(refer(told, looks)) if looks.is_thing(row[0]))
    called = _called(draft, correction.wrong, looks)
    best = draft.episode.grounding.best
    arguments = [
        argument.phrase.text
        for argument in draft.episode.frame.arguments
        if (argument.role != OBJECT) == correction.place
        and (was := best(argument.phrase.text)) is not None
        and looks.is_thing(was)
        and (was in called if called else not _same_name(looks, was, found))
    ]
    return (arguments[0], found) if found and len(arguments) == 1 else None


def _same_name(looks: Looks, was: str, found: Candidates) -> bool:
    """Whether it is what the words name already: "no, the fridge" corrects nothing then."""
    return any(thing == was for thing, _ in found)


def _best(found: Candidates) -> Candidates:
    """Those that the words fit best: "the glass" is no mug where there is a glass."""
    return tuple(row for row in found if row[1] == found[0][1])


def other_things(draft: Draft, correction: Correction) -> tuple[Exchanged, ...]:
    """The executed goal about another thing that nobody had named: "no, the back burner".

    Empty where the words mean no thing that could stand in for one of the
    goal's; several where they do not settle which for which.
    """
    told, execution = _told(draft, correction.meant), draft.episode.execution
    if told is None or execution is None:
        return ()
    found = tuple(_exchanges(draft, execution.goal, told, correction.wrong))
    if not _is_the_other(told):
        return found
    counts = Counter(exchange.was for exchange in found)
    of_two = tuple(exchange for exchange in found if counts[exchange.was] == 1)
    return of_two if len(of_two) == 1 else found


def _exchanges(draft: Draft, goal: Goal, told: NounPhrase, wrong: str) -> Iterator[Exchanged]:
    """Every way in which the words may correct the goal."""
    looks = looks_now(draft)
    named = set(draft.episode.best_objects)
    held = {thing for one in goal if one.positive for thing in one.fluent.args}
    chosen = sorted(held & set(looks.objects))
    called = _called(draft, wrong, looks)
    for was in (thing for thing in chosen if thing not in named):
        if called and was not in called:
            continue
        kin = [o for o in sorted(looks.objects) if _same_kind(looks, was, o) and o not in chosen]
        if _is_the_other(told):
            meant = kin
        else:
            meant = [thing for thing, _ in refer(told, looks, [was]) if thing in kin]
        for now in meant:
            yield Exchanged(was, now, _exchanged(goal, was, now))


def _is_the_other(told: NounPhrase) -> bool:
    """Whether it says no more than that it is the other one, of two."""
    return told.head == "one" and told.modifiers == ("other",) and not told.relations


def _same_kind(looks: Looks, was: str, now: str) -> bool:
    one, other = looks.objects[was], looks.objects[now]
    return one.type == other.type and looks.is_thing(now)


def _called(draft: Draft, words: str, looks: Looks) -> frozenset[str]:
    told = _told(draft, words) if words else None
    return frozenset(thing for thing, _ in refer(told, looks)) if told else frozenset()


def _told(draft: Draft, words: str) -> NounPhrase | None:
    """The noun phrase; "the other" is the other one."""
    last = words.split()[-1:]
    return read_noun_phrase(draft, f"{words} one" if last in (["other"], ["another"]) else words)


def _exchanged(goal: Goal, was: str, now: str) -> Goal:
    """Each for the other: what should no longer be at ``now`` should then not be at ``was``."""
    other = {was: now, now: was}
    return frozenset(
        Literal(Fluent(fluent.predicate, tuple(other.get(a, a) for a in fluent.args)), positive)
        for fluent, positive in goal
    )


def _alike(looks: Looks, phrase: str, was: str | None, now: str, told: NounPhrase) -> bool:
    """Whether the correction speaks of the same kind of thing as the phrase did."""
    if told.head in phrase.lower().split():
        return True
    if was is None:
        return told.head == "one"
    shared = not set(looks.objects[was].names).isdisjoint(looks.objects[now].names)
    return shared or (told.head == "one" and _same_kind(looks, was, now))

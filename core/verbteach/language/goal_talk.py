"""What people say about a goal that was read to them: "only the kettle", "everything but the tap".

It tells whether parts are put to it, left out or all that there is, and in
which words they are named; which parts those are is settled elsewhere.
"""

from __future__ import annotations

from collections.abc import Sequence
from enum import Enum
from typing import NamedTuple

from verbteach.language.tokens import COMMA, STOP, spelled_out, tokenise, trimmed
from verbteach.language.wordlist import phrase_list, word_set


class How(Enum):
    """What is to become of the parts that are named."""

    SAYS = "says"
    ONLY = "only"
    ALL_BUT = "all_but"
    ALL = "all"
    WITHOUT = "without"
    WITH = "with"


class GoalTalk(NamedTuple):
    """``tokens`` name parts; ``said_no``, ``said_yes``: a label came before them."""

    how: How
    tokens: tuple[str, ...]
    said_no: bool = False
    said_yes: bool = False


_NO = phrase_list("""
    no, nope, nah, wrong, incorrect, not quite, not really, not exactly, not right, bad, almost,
    not like that, not like this, not there, not here, not so, not that, not that way, not yet,
    that is wrong, that 's wrong, that is not right, that 's not right, that is not it,
    that 's not it, that is not quite right, that 's not quite right
""")
_YES = phrase_list("""
    yes, yeah, yep, yup, right, correct, ok, okay, exactly, good, fine, true, sure, that is right,
    that 's right, that is correct, that 's correct, y, that is exactly right,
    that 's exactly right,
    perfect, well done, great, that is fine, that 's fine
""")
_MARKS = frozenset({COMMA, STOP})
_BEFORE = _MARKS | word_set("but please oh well um uh so sorry robot hm")
_ALL = frozenset(
    phrase_list("""
        everything, all, all of it, all of them, all of that, everything matters, keep everything,
        all of it matters, everything is important, keep all of it, keep all, all of these,
        everything counts, everything that changed, all that changed, keep them all,
        everything should hold, everything must hold, it all matters, all matters
    """)
)
_ALL_LEADS = phrase_list("""
    keep everything, everything, all of it, all of that, all of them, all, anything, keep all,
    the whole thing, keep all of it, i want everything, the rest
""")
_BUT = phrase_list("""
    except, except for, except that, but, but not, apart from, besides, other than, save, without,
    except of, expect, excepting, excluding, only not, just not
""")
_ONLY = phrase_list("""
    only, only that, just, just that, solely, nothing but, keep only, i want only, i only want,
    it is only important that, it is only, it 's only, only keep, just keep, it only matters that,
    only it matters that, it just, all that matters is, all that matters is that, the only thing is,
    what matters is, what matters is that, all i want is, all i want is that, i just want, simply,
    the only thing that matters is, the only thing that matters is that, i only care about,
    i care only about, the goal is only, the goal is just, the goal is only that, i care about,
    i only care that
""")
_ONLY_TAILS = phrase_list(
    "only, nothing else, and nothing else, nothing more, and nothing more, and that is all, "
    "that is all, that 's all, and that 's all, alone, the rest does not matter, "
    "nothing else matters, the rest is not important, everything else does not matter, "
    "the others do not matter, the rest is irrelevant, and the rest does not matter, "
    "and nothing else matters, everything else is not important, the rest do not matter, "
    "not the rest"
)
_WITHOUT = phrase_list("""
    not, without, except, except for, leave out, drop, strike, strike out, remove, forget,
    forget about, ignore, never mind, skip, exclude, take out, but not, do not include, not that,
    delete, cross out, get rid of, do not keep, do not need, i do not need, i do not care about,
    do not care about, leave away, omit, you can forget, you can ignore, do not mind, no need for,
    i do not care if, i do not care whether, i do not care that
""")
_WITH = phrase_list("""
    also, and, and also, plus, add, add that, keep, include, with, too, keep also, also keep,
    i should only add that, i should add that, i would add that, i would only add that,
    add only that,
    you forgot, you forgot that, you left out, do not forget, and you forgot, additionally,
    in addition, and it matters that, do not forget that, you missed, you missed that
""")
_WITH_TAILS = phrase_list("too, also, as well, in addition, additionally, included")
_PLACE = word_set("in on at from into onto of next")


def read_goal_talk(text: str) -> GoalTalk | None:
    """How ``text`` speaks of a goal; ``None`` where no words are left besides a yes or a no."""
    tokens = _behind(_before_thanks(tokenise(spelled_out(text))))
    said_no, tokens = _after(tokens, _NO)
    said_yes, tokens = _after(tokens, () if said_no else _YES)
    if not tokens:
        return None
    how, named = _how(tokens)
    return GoalTalk(how, tuple(named), said_no, said_yes)


def _how(tokens: list[str]) -> tuple[How, list[str]]:
    bare = tuple(token for token in tokens if token not in {COMMA, STOP})
    if bare in _ALL:
        return How.ALL, []
    for lead in _ALL_LEADS:
        behind = tokens[len(lead) :]
        found = next((but for but in _BUT if tuple(behind[: len(but)]) == but), None)
        if tuple(tokens[: len(lead)]) == lead and found and behind[len(found) :]:
            return How.ALL_BUT, behind[len(found) :]
    for how, leads, tails in (
        (How.ONLY, _ONLY, _ONLY_TAILS),
        (How.WITHOUT, _WITHOUT, ()),
        (How.WITH, _WITH, _WITH_TAILS),
    ):
        named = _without_tail(_without_lead(tokens, leads), tails)
        if named != tokens and named:
            return how, named
    return How.SAYS, tokens


def _without_lead(tokens: list[str], leads: Sequence[tuple[str, ...]]) -> list[str]:
    for lead in leads:
        behind = tokens[len(lead) :]
        if tuple(tokens[: len(lead)]) == lead and behind:
            return behind
    return tokens


def _without_tail(tokens: list[str], tails: Sequence[tuple[str, ...]]) -> list[str]:
    for tail in tails:
        before = trimmed(tokens[: -len(tail)], _MARKS)
        if tuple(tokens[-len(tail) :]) == tail and before:
            return before
    return tokens


def _before_thanks(tokens: list[str]) -> list[str]:
    """Without what is said for politeness at the end."""
    tokens = trimmed(tokens, _MARKS)
    while tokens[-1:] in (["please"], ["thanks"], ["robot"]):
        tokens = trimmed(tokens[:-1], _MARKS)
    return tokens


def _behind(tokens: list[str]) -> list[str]:
    """What comes behind the small words."""
    while tokens and tokens[0] in _BEFORE and tokens[:2] != ["well", "done"]:
        tokens = tokens[1:]
    return tokens


def _after(tokens: list[str], phrases: Sequence[tuple[str, ...]]) -> tuple[bool, list[str]]:
    """Whether some of the phrases begin the words, and what comes after them all."""
    for phrase in phrases:
        goes_on = tokens[len(phrase) : len(phrase) + 1]
        if tuple(tokens[: len(phrase)]) == phrase and not _PLACE.intersection(goes_on):
            return True, _after(_behind(tokens[len(phrase) :]), phrases)[1]
    return False, tokens

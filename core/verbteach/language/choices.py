"""Reading which of several things is meant: "blue, please", "not the red one", "the first two".

Says in which words the thing is, or that all or any of them are meant. What the
words refer to is settled elsewhere; what says none of this is left unread.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from enum import Enum
from itertools import pairwise

from verbteach.language.tokens import spelled_out, tokenise
from verbteach.language.wordlist import phrase_list, word_set
from verbteach.language.words import (
    DETERMINERS,
    OBJECT_PRONOUNS,
    ORDINALS,
    PARTICLES,
    POSSESSIVES,
    PREPOSITIONS,
    QUESTION_WORDS,
)


class Chosen(Enum):
    """What kind of choice the words make."""

    NAMED = "named"
    ANY = "any"
    ALL = "all"
    POINTED = "pointed"
    OTHER = "other"
    ABSENT = "absent"
    NONE = "none"


@dataclass(frozen=True)
class Choice:
    """``named`` are words for things, any one of which is meant; ``denied`` are not meant.

    ``index``: one by its number in the list that was offered, from 0.
    """

    kind: Chosen
    named: tuple[str, ...] = ()
    denied: tuple[str, ...] = ()
    index: int | None = None


_KINDS = {
    Chosen.ANY: """
        any, any one, anyone, any of them, any of these, any of those, either, either one,
        either of them, either is fine, any is fine, any will do, any one will do, either will do,
        whichever, whichever one, whichever you like, whichever you want, whatever, you choose,
        choose, you decide, you pick, pick one, choose one, pick any, take any, just one,
        one of them, just pick one, just take one, does not matter which,
        it does not matter which, it does not matter, does not matter, all the same,
        it is all the same, i do not care, i do not mind
    """,
    Chosen.ALL: """
        all, both, all of them, both of them, all of these, all of those, both of these, all three,
        all two, all four, them all, them both, every one, everyone, every one of them, each,
        each of them, each one, all the things, everything, the lot, them, these, those, the two,
        two of them, three of them, all but one
    """,
    Chosen.POINTED: """
        it, this, that, this one, that one, here, there, this here, that there, that one there,
        this one here, over there, that thing, this thing, the thing, the one
    """,
    Chosen.OTHER: """
        something else, something different, another thing, some other thing, anything else,
        something other, none of those, none of these, none of them, not any of them, neither,
        neither of them, nothing of that, a different one, a different thing
    """,
}
_TABLE = {words: kind for kind, text in _KINDS.items() for words in phrase_list(text)}
_LEADS = phrase_list("""
    it is, it 's, that is, that 's, this is, they are, it was, it should be, it would be, should be,
    i mean, i meant, i was thinking of, i was talking about, i said, i want, i wanted, i think,
    i think it is, i guess, i believe, i suppose, i would say, i would like, i would take,
    i would prefer, i prefer, use, take, grab, try, choose, pick, get, go for, go with, let us take,
    let us use, you should take, you should use, you can take, you can use, the answer is,
    of course, no, yes, it looks like, you mean, with
""")
_TRAILS = phrase_list("""
    i think, i guess, i believe, i suppose, i would say, i mean, i meant, of course, thank you,
    if you like, if possible, instead, then, would be better, would be best, will do, is fine,
    is better, is what i meant, is what i mean, is the one, is it
""")
_AROUND = word_set(
    "please thanks oh well hm hmm um uh er ah sorry actually probably maybe perhaps definitely "
    "surely certainly just rather ok okay so then now only and but"
)
_BUT = phrase_list(
    "anything but, any but, all but, everything but, anything except, any except, except, without"
)
_WHICH_IS = (("that", "'s"), ("that", "is"), ("which", "is"), ("that", "are"), ("which", "are"))
_INSTEAD = phrase_list("instead of, rather than, and not, but not, not")
_ABSENT = phrase_list("there is no, there are no, there 's no, i have no, we have no, i see no")
_NUMBERED = word_set("number no option choice nr")
_COUNTED = ("one", "two", "three", "four", "five", "six", "seven", "eight", "nine")
_NUMBERS = {word: number for number, word in enumerate(_COUNTED)}
_SIDES = word_set("left right middle top bottom front back")


def read_choice(text: str, verbs: Iterable[str] = ()) -> Choice:
    """What ``text`` chooses. Words that begin with one of ``verbs`` ask for something else."""
    tokens = _bare(_words(text))
    kind = _TABLE.get(tuple(tokens))
    if kind is not None:
        return Choice(kind)
    if any(_begins(tokens, words) for words in _ABSENT):
        return Choice(Chosen.ABSENT)
    asks = tokens[:1] and tokens[0] in QUESTION_WORDS | {"is", "are", "do", "does"}
    if not tokens or asks or (tokens[0] in frozenset(verbs) and _takes_object(tokens)):
        return Choice(Chosen.NONE)
    if (index := _index(tokens)) is not None:
        return Choice(Chosen.NAMED, index=index)
    return _named(tokens)


def _words(text: str) -> list[str]:
    said = tokenise(spelled_out(text.replace(" 's", "'s")))
    return [token for token in said if token[:1].isalnum() or token == "'s"]


def _takes_object(tokens: Sequence[str]) -> bool:
    """Whether it goes on as behind a verb: "open the fridge", but not "open ones"."""
    objects = DETERMINERS | OBJECT_PRONOUNS | POSSESSIVES | PARTICLES
    return len(tokens) > 1 and tokens[1] in objects - {"one", "ones"}


def _named(tokens: Sequence[str]) -> Choice:
    """Words for things: with what is denied, and with alternatives."""
    excepted = next((words for words in _BUT if _begins(tokens, words)), ())
    if excepted or tokens[:1] == ["not"]:
        denied, named = _split(tokens[max(len(excepted), 1) :], [("but",)])
        return Choice(Chosen.NAMED, _one(named), _one(denied))
    named, denied = _split(tokens, _INSTEAD)
    listed = _several(named)
    if listed == [named] or "or" in named:
        return Choice(Chosen.NAMED, tuple(t for one in listed for t in _one(one)), _one(denied))
    return Choice(Chosen.ALL, tuple(" ".join(one) for one in listed))


def _several(tokens: list[str]) -> list[list[str]]:
    """The parts between "and" and "or"; a count of several ("the first two") has no parts."""
    counted = len(tokens) > 1 and tokens[-2] in {"first", "last", "other"}
    if counted and _NUMBERS.get(tokens[-1], 0) > 0:
        return []
    parts: list[list[str]] = [[]]
    for token in tokens:
        if token in {"and", "or"}:
            parts.append([])
        else:
            parts[-1].append(token)
    return [part for part in parts if part]


def _one(tokens: Sequence[str]) -> tuple[str, ...]:
    """The words as a noun phrase: "on the table" is the one on the table, "left" the left one."""
    if not tokens:
        return ()
    for at, pair in enumerate(pairwise(tokens)):
        if pair in _WHICH_IS:
            return _one([*tokens[:at], *tokens[at + 2 :]])
    if tokens[0] in PREPOSITIONS and len(tokens) > 1:
        return (" ".join(["the one", *tokens]),)
    if len(tokens) == 1 and (tokens[0] in ORDINALS or tokens[0] in _SIDES):
        return (f"the {tokens[0]} one",)
    return (" ".join(tokens),)


def _index(tokens: list[str]) -> int | None:
    """The number in "number two", "option 3" or "two", from 0."""
    numbered = [*tokens[1:]] if tokens[0] == "the" else tokens
    if len(numbered) == 2 and numbered[0] in _NUMBERED:
        numbered = numbered[1:]
    if len(numbered) != 1:
        return None
    word = numbered[0]
    if word.isdecimal() and len(word) < 3 and int(word) > 0:
        return int(word) - 1
    return _NUMBERS.get(word)


def _split(tokens: Sequence[str], marks: Iterable[tuple[str, ...]]) -> tuple[list[str], list[str]]:
    """What stands before the first of the marks, and behind it."""
    found = [
        (at, -len(words))
        for words in marks
        for at in range(1, len(tokens))
        if _begins(tokens[at:], words)
    ]
    if not found:
        return list(tokens), []
    at, length = min(found)
    return _bare(tokens[:at]), _bare(tokens[at - length :])


def _begins(tokens: Sequence[str], words: tuple[str, ...]) -> bool:
    return tuple(tokens[: len(words)]) == words


def _bare(tokens: Sequence[str]) -> list[str]:
    """Without what people put around a choice; a choice itself is left whole."""
    kept, before = list(tokens), list[str]()
    while kept != before and tuple(kept) not in _TABLE:
        before = kept
        kept = kept[1:] if kept[:1] and kept[0] in _AROUND else kept
        kept = kept[:-1] if kept[-1:] and kept[-1] in _AROUND else kept
        lead = next((words for words in _LEADS if _leads(kept, words)), ())
        kept = kept[len(lead) :]
        trail = next((words for words in _TRAILS if _trails(kept, words)), ())
        kept = kept[: len(kept) - len(trail)]
    return kept


def _leads(tokens: Sequence[str], words: tuple[str, ...]) -> bool:
    """Whether the words stand in front; a "no" before a number is that of "no. 2"."""
    numbered = words == ("no",) and len(tokens) == 2 and _index([tokens[1]]) is not None
    return len(tokens) > len(words) and _begins(tokens, words) and not numbered


def _trails(tokens: Sequence[str], words: tuple[str, ...]) -> bool:
    return len(tokens) > len(words) and tuple(tokens[-len(words) :]) == words

"""Reading an answer: yes, no or don't know, and whatever else was said.

Polarity is never guessed. A label is read only where a phrase that means it
begins the answer and nothing said right after it means another; the rest ("the
red one") is left for whoever knows what was asked.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from enum import Enum

from verbteach.language.tokens import COMMA, STOP, spelled_out, tokenise
from verbteach.language.wordlist import phrase_list, word_set


class Label(Enum):
    """What an answer says to a yes/no question."""

    YES = "yes"
    NO = "no"
    UNSURE = "unsure"


@dataclass(frozen=True)
class AnswerReading:
    """``label`` is None where none was said or two were; ``rest`` is what else was said.

    ``contradictory`` tells the two apart: "yes and no" says too much, "the red
    one" too little.
    """

    label: Label | None
    rest: str = ""
    contradictory: bool = False


_YES = """
    yes, yeah, yep, yup, ya, yah, aye, sure, surely, right, correct, exactly, precisely, indeed,
    certainly, definitely, absolutely, of course, for sure, ok, okay, fine, true, affirmative,
    agreed, naturally, you bet, i think so, i believe so, i guess so, i suppose so, please do,
    go ahead, uh-huh, mhm, it is, it does, it should, they are, they do, they should, that is
    right, that is correct, that 's right, that 's correct, that 's it, that is it, that 's the
    one, that is the one, you are right, very good, well done, perfect, good, great, y,
    sure thing, you should, you must, it should be, they should be, it must be, it has to, it has to
    be, it is so, it has, it was, it will, they have, so it is, i am sure, sounds good, yea, you got
    it, i would say so, i would say yes, that is the right one, that 's the right one
"""
_NO = """
    no, nope, nah, nay, never, wrong, incorrect, false, negative, not really, not at all, not
    quite, not yet, no way, by no means, of course not, certainly not, definitely not,
    absolutely not, surely not, probably not, i think not, i do not think so, i do not believe
    so, i guess not, i suppose not, it is not, it does not, it should not, it need not, they are
    not, they do not, they should not, that is wrong, that 's wrong, that is not right, that 's
    not right, that is not it, that 's not it, that is not the one, that 's not the one, you are
    wrong, you do not have to, you do not need to, do not, not necessary, not necessarily, no
    need, not that one, not this one, not that, not it, not good, not correct, not right, bad,
    n, not so, it 's not, you should not, you must not, it should not be, it must not be,
    they should not be, it has not, it was not, not exactly, not now, not anymore, no longer,
    i am afraid not, do not think so, i do not think it is, i do not think it does, i do not think
    it should, i would say no, i would say not, it does not have to, it does not have to be, it does
    not need to, that is the wrong one, that 's the wrong one
"""
_UNSURE = """
    i do not know, do not know, dunno, i dunno, no idea, i have no idea, no clue, i have no
    clue, not sure, i am not sure, i 'm not sure, unsure, i am unsure, not certain, i am not
    certain, maybe, perhaps, possibly, hard to say, hard to tell, can not tell, i can not tell,
    can not say, i can not say, can not see, i can not see, who knows, it depends, depends,
    could be, might be, it could be, it might be, idk, whatever, i have not looked, i forgot, i
    do not remember, i do not care, it does not matter, i can not see it, i do not see it, i could
    not say, beats me, how should i know, ask me something else, could not say, could not tell you,
    i could not tell you, can not tell you, i can not tell you
"""
_NEITHER = phrase_list(
    "no problem, no worries, no matter, not only, not just, right away, right now, sure enough"
)
"""Begin like a yes or a no and are none."""
_BETWEEN = frozenset({COMMA, STOP}) | word_set(
    "please thanks well oh hm hmm mm um uh er erm ah eh sorry"
)
_CANDID = word_set("honestly actually frankly")
"""May stand anywhere and change nothing."""
_LINKS = frozenset({"but", "and", "because", "since", "as", "so", "rather", "instead"})


def _table() -> Mapping[tuple[str, ...], Label]:
    rows = ((_YES, Label.YES), (_NO, Label.NO), (_UNSURE, Label.UNSURE))
    return {words: label for texts, label in rows for words in phrase_list(texts)}


# A lone "n" is a no here; the tokens of commands take it for "and".
_LETTER_N = re.compile(r"(?<![\w'])n(?![\w'])")
_PHRASES = _table()
_LONGEST = max(map(len, _PHRASES))


def read_answer(text: str) -> AnswerReading:
    """Read the label that begins ``text``, and the rest. Never raises; takes any text."""
    stripped = text.strip()
    if stripped and set(stripped) == {"?"}:
        return AnswerReading(Label.UNSURE)
    said = tokenise(_LETTER_N.sub("no", spelled_out(text.lower())))
    tokens = _after([token for token in said if token not in _CANDID], _BETWEEN)
    labels: list[Label] = []
    while found := _leading(tokens):
        label, length = found
        labels.append(label)
        tokens = _after(tokens[length:], _BETWEEN)
        tokens = _after(tokens, _LINKS) if _leading(_after(tokens, _LINKS)) else tokens
    rest = _text(tokens)
    if len(set(labels)) > 1:
        return AnswerReading(None, rest, contradictory=True)
    return AnswerReading(labels[0] if labels else None, rest)


def _leading(tokens: Sequence[str]) -> tuple[Label, int] | None:
    """The longest phrase that begins ``tokens``, unless the words go on in the same breath.

    "it is the red one" and "right of the sink" say neither yes nor no.
    """
    if any(tuple(tokens[: len(words)]) == words for words in _NEITHER):
        return None
    for length in range(min(_LONGEST, len(tokens)), 0, -1):
        label = _PHRASES.get(tuple(tokens[:length]))
        if label is not None:
            return None if _goes_on(tokens[:length], tokens[length:]) else (label, length)
    return None


def _goes_on(phrase: Sequence[str], after: Sequence[str]) -> bool:
    ends = not after or after[0] in _BETWEEN | _LINKS or _leading(after) is not None
    return not ends and tuple(phrase) not in _ALONE


# Words that say yes or no whatever follows; the others do so only where nothing follows.
_ALONE = frozenset(
    {
        (word,)
        for word in (
            "yes",
            "yeah",
            "yep",
            "yup",
            "no",
            "nope",
            "nah",
            "exactly",
            "maybe",
            "perhaps",
        )
    }
)


def _after(tokens: Sequence[str], skipped: frozenset[str]) -> Sequence[str]:
    start = 0
    while start < len(tokens) and tokens[start] in skipped:
        start += 1
    if tuple(tokens[start : start + 2]) == ("thank", "you"):
        return _after(tokens[start + 2 :], skipped)
    return tokens[start:]


def _text(tokens: Sequence[str]) -> str:
    tokens = _after(tokens, _LINKS)
    return " ".join(token for token in tokens if token not in {COMMA, STOP})

"""Reading an answer: yes, no or don't know, and whatever else was said.

Polarity is never guessed. A label is read only where a phrase that means it
begins the answer and nothing said right after it means another; the rest ("the
red one") is left for whoever knows what was asked.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from enum import Enum
from typing import TypeAlias

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
    one" too little. ``reserved``: a yes with something against it or beside it, "yes,
    but not the burner".
    """

    label: Label | None
    rest: str = ""
    contradictory: bool = False
    reserved: bool = False


_YES = """
    yes, ye, yeah, yep, yup, ya, yah, aye, sure, surely, right, correct, exactly, precisely, indeed,
    certainly, definitely, absolutely, of course, for sure, ok, okay, fine, true, affirmative,
    agreed, naturally, you bet, i think so, i believe so, i guess so, i suppose so, please do,
    go ahead, uh-huh, mhm, it is, it does, it should, they are, they do, they should, that is
    right, that is correct, that 's right, that 's correct, that is exactly right,
    that 's exactly right, that is quite right, that is absolutely right, that 's it, that is it,
    that 's the
    one, that is the one, you are right, very good, well done, perfect, good, great, y,
    sure thing, you should, you must, it should be, they should be, it must be, it has to, it has to
    be, it is so, it has, it was, it will, they have, so it is, i am sure, sounds good, yea, you got
    it, i would say so, i would say yes, that is the right one, that 's the right one, i do, i did,
    of course i do, of course it is, of course it should, it must, must be, should be, has to be,
    obviously, always, okey, oki, okie, yeahh, exactly right, quite right, k, kk, sure why not, i
    guess, i suppose, i think
    yes, i think it is, i think it does, i think it should, i believe it is, it matters, it is
    important, that is important, important, that is what i meant, that 's what i meant, that is
    what i mean, that 's what i mean, i meant that, i mean that, that is so, necessarily, very much
    so, indeed it is, why yes, yessir, yes sir, totally, fair enough, fine by me, fine with me
"""
_PRAISE = """
    that was right, that was correct, that was good, that was great, that was perfect, that is
    great, that 's great, that is good, that 's good, that is perfect, that 's perfect, nice, very
    nice, nice work, nice job, good work, good job, good robot, great job, excellent, awesome,
    bravo, cool, brilliant, wonderful, lovely, super, it worked, that worked, it works, that works,
    that will do, that does it, good enough, you did it, you did well, you did it right, you did
    right, i like it, i like that, that is fine, that 's fine, it is fine, it 's fine, it is ok, it
    's ok, it is okay, it 's okay, that is ok, that 's ok, that is okay, that 's okay, not bad, not
    bad at all, just right, as i wanted, that is what i wanted, that 's what i wanted, just what i
    wanted, all good, all right, alright, as it should be,
    that is the goal, that 's the goal, looks good, looks good to me,
    that looks good, that looks right, looks right, seems right, that seems right, that was lovely,
    that was wonderful, that was excellent,
    that was nice, that was very good, that was really good, that was brilliant, that was fantastic,
    that was awesome, that was amazing, that was fine, that was well done, that was ok,
    that is lovely, that is wonderful, that is excellent, that is nice, that is very good,
    that is brilliant, that is fantastic, that is awesome, that is amazing, amazing, fantastic,
    you are great, you are good, thank you so much, that is very kind, splendid, yay, hooray,
    it is good, it is right, it is correct, is right, is correct, is good, all correct,
    all right now
"""
_BLAME = """
    that was wrong, that was not right, that was not it, that was bad, that was not correct, not
    what i wanted, not what i meant, not what i said, that is not what i wanted, that 's not what i
    wanted, that is not what i meant, that 's not what i meant, that is not what i said, that 's
    not what i said, this is not what i wanted, this is not what i meant, that was not what i
    wanted, that was not what i meant, i did not mean that, i did not mean it, i did not want that,
    i did not say that, awful, terrible, horrible, it did not work, that did not work, i do not like
    it, i do not like that, you did it wrong, you did wrong, wrong one, the wrong one, not good
    enough, not quite what i wanted, not what i had in mind, not quite what i had in mind,
    that was not what i had in mind, that is not what i had in mind,
    that was not quite what i had in mind, that was not quite what i wanted,
    that was not quite right, is wrong, is not right, is not correct, nothing happened,
    not like that, you made a mistake, bad robot
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
    not need to, that is the wrong one, that 's the wrong one, it need not be, need not be, need
    not,
    does not have to, does not have to be, does not need to, does not need to be, no need to, no
    need for that, not needed, it is not needed, that is not needed, not important, it is not
    important, that is not important, irrelevant, it is irrelevant, that is irrelevant, that 's
    irrelevant, unimportant, unnecessary, it is unnecessary, i do not, i did not, should not be,
    it must not, must not be, i think it is not, i think it does not, i think it should not, i
    think no, something else, anything but that, not any more, not likely, hardly, no more
"""
_UNSURE = """
    i do not know, do not know, dunno, i dunno, no idea, i have no idea, no clue, i have no
    clue, not sure, i am not sure, i 'm not sure, unsure, i am unsure, not certain, i am not
    certain, maybe, perhaps, possibly, hard to say, hard to tell, can not tell, i can not tell,
    can not say, i can not say, can not really say, can not see, i can not see, who knows, it
    depends, depends,
    could be, might be, it could be, it might be, idk, whatever, i have not looked, i forgot, i
    do not remember, i do not care, do not care, it does not matter, does not matter, either,
    either way, either is fine, whichever, as you like, if you like, if you want, as you want, up to
    you, it is up to you, you decide, you choose, your choice, no preference, i do not mind, do not
    mind, next question, no more questions, enough questions, stop asking, stop asking questions,
    stop asking me, stop asking me questions, ask something else, sometimes, i am not certain about
    it, i do not really know, i really do not know, i wish i knew, no comment, i can not see it, i
    do not see it, i could not say, beats me, how should i know, ask me something else, could not
    say, could not tell you,
    i could not tell you, can not tell you, i can not tell you
"""
_NEITHER = phrase_list(
    "no problem, no worries, no matter, not only, not just, right away, right now, sure enough, "
    "important question"
)
"""Begin like a yes or a no and are none."""
_BETWEEN = frozenset({COMMA, STOP}) | word_set(
    "please thanks well oh hm hmm mm um uh er erm ah eh sorry robot"
)
_CANDID = word_set("honestly actually frankly oops perfectly completely entirely")
"""May stand anywhere and change nothing."""
_SECOND_THOUGHTS = phrase_list(
    "i mean, i meant, wait, no wait, hold on, hang on, scratch that, or rather, on second thought, "
    "on second thoughts, let me think, make that"
)
"""Before another label: what was said first may not be meant."""
_INDIFFERENT = frozenset(
    phrase_list("it does not matter, does not matter, i do not care, i do not mind, do not care")
)
"""Behind a no they say why: what was asked about is not wanted."""
_ADDING = word_set("but and except also plus though although unless if only however not without")
"""Words behind a yes that take some of it back, or put more to it."""
_LINKS = frozenset({"but", "and", "because", "since", "as", "so", "rather", "instead"})


_Table: TypeAlias = Mapping[tuple[str, ...], Label]


def _table(*rows: tuple[str, Label]) -> _Table:
    return {words: label for texts, label in rows for words in phrase_list(texts)}


# A lone "n" is a no here; the tokens of commands take it for "and".
_LETTER_N = re.compile(r"(?<![\w'])n(?![\w'])")
_DRAWN_OUT = re.compile(r"([a-z])\1{2,}")
_HUMS = (
    (re.compile(r"\b(?:n[au]h[ -]?uh|uh[ -]uh)\b"), "no"),
    (re.compile(r"\b(?:uh|a)[ -]?huh\b|\bm+[ -]?hm+\b"), "yes"),
)
_ANSWERS = _table((_YES, Label.YES), (_NO, Label.NO), (_UNSURE, Label.UNSURE))
_VERDICTS = {**_table((_PRAISE, Label.YES), (_BLAME, Label.NO)), **_ANSWERS}
_LONGEST = max(map(len, _VERDICTS))


def read_answer(text: str, *, verdict: bool = False) -> AnswerReading:
    """Read the label that begins ``text``, and the rest. Never raises; takes any text.

    ``verdict``: it says whether something done was right, so praise and blame count.
    """
    phrases = _VERDICTS if verdict else _ANSWERS
    stripped = text.strip()
    if stripped and set(stripped) == {"?"}:
        return AnswerReading(Label.UNSURE)
    said = tokenise(_LETTER_N.sub("no", spelled_out(_without_hums(text.lower()))))
    tokens = _after([token for token in said if token not in _CANDID], _BETWEEN)
    labels: list[Label] = []
    while found := _leading(tokens, phrases):
        label, length = found
        why = labels[-1:] == [Label.NO] and tuple(tokens[:length]) in _INDIFFERENT
        labels += [] if why else [label]
        tokens = _after(tokens[length:], _BETWEEN)
        tokens = next((t for t in _past(tokens) if _leading(t, phrases)), tokens)
    rest = _text(tokens)
    if len(set(labels)) > 1:
        return AnswerReading(None, rest, contradictory=True)
    adds = bool(rest) and (tokens[0] in _ADDING or rest.endswith((" too", " also", " as well")))
    reserved = labels[:1] == [Label.YES] and adds
    return AnswerReading(labels[0] if labels else None, rest, reserved=reserved)


def _without_hums(text: str) -> str:
    for hum, word in _HUMS:
        text = hum.sub(word, text)
    return _DRAWN_OUT.sub(r"\1", text)


def _past(tokens: Sequence[str]) -> Iterator[Sequence[str]]:
    """The tokens behind what may stand between two labels."""
    yield _after(tokens, _LINKS)
    for words in _SECOND_THOUGHTS:
        if tuple(tokens[: len(words)]) == words:
            yield _after(tokens[len(words) :], _BETWEEN)


def _leading(tokens: Sequence[str], phrases: _Table) -> tuple[Label, int] | None:
    """The longest phrase that begins ``tokens``, unless the words go on in the same breath.

    "it is the red one" and "right of the sink" say neither yes nor no.
    """
    if any(tuple(tokens[: len(words)]) == words for words in _NEITHER):
        return None
    for length in range(min(_LONGEST, len(tokens)), 0, -1):
        label = phrases.get(tuple(tokens[:length]))
        if label is not None:
            goes_on = _goes_on(tokens[:length], tokens[length:], phrases)
            return None if goes_on else (label, length)
    return None


def _goes_on(phrase: Sequence[str], after: Sequence[str], phrases: _Table) -> bool:
    ends = not after or after[0] in _BETWEEN | _LINKS or _leading(after, phrases) is not None
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
    for words in _POLITE:
        rest = tokens[start + len(words) :]
        if tuple(tokens[start : start + len(words)]) == words and rest[:1] not in (["not"], ["so"]):
            return _after(rest, skipped)
    return tokens[start:]


_POLITE = phrase_list(
    "thank you, thank you very much, thank you so much, thanks a lot, i am afraid, i 'm afraid, "
    "i am sorry, i 'm sorry, i am afraid that, i am sorry but"
)


def _text(tokens: Sequence[str]) -> str:
    tokens = _after(tokens, _LINKS)
    return " ".join(token for token in tokens if token not in {COMMA, STOP})

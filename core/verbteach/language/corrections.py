"""Reading a correction: "no, the other pot", "I meant the back burner", "the pot, not the pan".

Says in which words the thing is that was meant, and the one that was taken
instead if it was named. What they refer to is settled elsewhere.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import NamedTuple

from verbteach.language.tokens import COMMA, STOP, spelled_out, tokenise, trimmed
from verbteach.language.wordlist import phrase_list, word_set


class Correction(NamedTuple):
    """The words for what was meant, and for what it was taken for, which may be left unsaid.

    ``place``: the words say where something belongs, "no, in the fridge".
    """

    meant: str
    wrong: str = ""
    place: bool = False


_MARKS = frozenset({COMMA, STOP})
_NOES = phrase_list("""
    no, nope, nah, wrong, incorrect, bad, not quite, not really, not exactly, not right, not that,
    not that one, not this one, not it, that is wrong, that 's wrong, that was wrong, that is not
    it, that 's not it, that is not right, that 's not right, that was not it, that was not right,
    that is not the one, that 's not the one, the wrong one, wrong one, that is the wrong one,
    that 's the wrong one, that was the wrong one
""")
_OPENERS = phrase_list("""
    i meant, i mean, i said, i wanted, i want, i was thinking of, you should have used, you should
    have taken, you should use, you should take, it should be, it should have been, should be,
    should have been, it is, it 's, it was, that is, use, take, try, put it on, put it onto,
    put it in, put it into, with, on, onto, in, into, rather, instead, better, you need, you want
""")
_AROUND = _MARKS | word_set("but please sorry oh well and rather instead actually then um uh so")
_ENDERS = phrase_list("i meant, i mean, i said, not that one, not that, not this one")
_INSTEAD = phrase_list("instead of, rather than, and not, but not, not")
_PLACING = word_set("on onto in into")
_POINTING = word_set("the that this my our your his her another other")


def read_correction(text: str) -> Correction | None:
    """What ``text`` says should have been meant; ``None`` where it corrects nothing.

    Without a no, or words such as "I meant", it must begin with an article or
    the like: any other words may be about something else.
    """
    tokens = _trimmed(tokenise(spelled_out(text)))
    said_no, tokens = _after_any(tokens, _NOES)
    if tokens[:1] == ["not"]:
        return _not_this_but(tokens[1:])
    before = tokens
    opened, tokens = _after_any(tokens, _OPENERS)
    meant, wrong = _parted(_without_end(tokens))
    if not meant or not (said_no or opened or meant[0] in _POINTING):
        return None
    passed = before[: len(before) - len(tokens)]
    return Correction(" ".join(meant), " ".join(wrong), not _PLACING.isdisjoint(passed))


def _not_this_but(tokens: list[str]) -> Correction | None:
    """Of "not the left one, the right one": both, which a comma or a "but" parts."""
    at = next((i for i, token in enumerate(tokens) if token in {COMMA, STOP, "but"}), len(tokens))
    wrong, rest = tokens[:at], _trimmed(tokens[at:])
    _, wrong = _after_any(wrong, _OPENERS)
    _, meant = _after_any(rest, _OPENERS)
    meant = _without_end(meant)
    return Correction(" ".join(meant), " ".join(wrong)) if meant and wrong else None


def _parted(tokens: list[str]) -> tuple[list[str], list[str]]:
    """What was meant, and after "instead of", "not" and the like what was not."""
    for at in range(1, len(tokens)):
        for words in _INSTEAD:
            if tuple(tokens[at : at + len(words)]) == words:
                _, wrong = _after_any(tokens[at + len(words) :], _OPENERS)
                return _trimmed(tokens[:at]), wrong
    return _trimmed(tokens), []


def _after_any(tokens: list[str], phrases: Iterable[tuple[str, ...]]) -> tuple[bool, list[str]]:
    """Whether some of the phrases begin the words, and what comes after them all."""
    found, going = False, True
    while going:
        going = False
        for words in phrases:
            if tuple(tokens[: len(words)]) == words:
                found, going, tokens = True, True, _trimmed(tokens[len(words) :])
                break
    return found, tokens


def _without_end(tokens: list[str]) -> list[str]:
    """Without an "I meant" that comes last."""
    for words in _ENDERS:
        if tuple(tokens[-len(words) :]) == words:
            return _trimmed(tokens[: -len(words)])
    return tokens


def _trimmed(tokens: Sequence[str]) -> list[str]:
    """Without the commas and small words around."""
    return trimmed(tokens, _AROUND)

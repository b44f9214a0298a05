"""Commands that lean on the last one: "again", "same with the mug", "now the plastic one".

Says only what is put in the place of what; which command that was is not known here.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from verbteach.language.assembly import OBJECT
from verbteach.language.frames import Argument, NounPhrase, VerbFrame
from verbteach.language.tokens import spelled_out, tokenise, trimmed
from verbteach.language.wordlist import phrase_list, word_set
from verbteach.language.words import COPULAS


@dataclass(frozen=True)
class Ellipsis:
    """The last command once more; ``about`` are the words for another thing, or empty."""

    about: str = ""


_AGAIN = frozenset(
    phrase_list("""
        again, once more, once again, one more time, another time, do it again, do that again,
        do this again, do it once more, do that once more, do it one more time, do it once again,
        the same again, same again, do the same, do the same again, do the same thing again,
        the same, same, same thing, the same thing, same thing again, the same thing again,
        and again, repeat it, repeat that, do that one more time, try again, try it again, try that
        again, repeat the last command, repeat the command, repeat my last command, do the last
        thing again, do the last command again, do what you did last, do that last thing again
    """)
)
_LEADS = phrase_list("""
    same with, same for, same to, same on, the same with, the same for, the same to, the same on,
    do the same with, do the same for, do the same to, do the same on, do the same thing with,
    do the same thing for, do the same thing to, same thing with, same thing for, likewise with,
    do that to, do it to, likewise, what about, how about, also with, also for
""")
_NEXT = word_set("now and next then also")
_MORE = phrase_list("too, as well, also, next, now")
_AROUND = word_set("please thanks ok okay well good great so robot , .")
_DETERMINERS = word_set("the a an another my this that these those some both all one")


def read_ellipsis(text: str) -> Ellipsis | None:
    """The last command again, perhaps about another thing; ``None`` where it is no such thing.

    Whether the words behind "now" or "and" are words for a thing is for the reader of
    commands to say: only what has an article may be one here.
    """
    tokens = _trimmed(tokenise(spelled_out(text)))
    if tuple(tokens) in _AGAIN:
        return Ellipsis()
    lead = next((words for words in _LEADS if tuple(tokens[: len(words)]) == words), ())
    about, more = _without_more(_trimmed(tokens[len(lead) :]))
    if not lead:
        about, announced = _behind_next(about)
        alone = about in (["another", "one"], ["one", "more"], ["another"])
        if not alone and not (about[:1] and about[0] in _DETERMINERS and (announced or more)):
            return None
    says_more = not ({",", "."} | COPULAS).isdisjoint(about)
    return Ellipsis(" ".join(about)) if about and not says_more else None


def applied(frame: VerbFrame, phrase: NounPhrase) -> VerbFrame:
    """The frame about another thing: in the place of its object, else of its first argument."""
    roles = [argument.role for argument in frame.arguments]
    if not roles:
        return VerbFrame(frame.verb, (Argument(OBJECT, phrase),))
    at = roles.index(OBJECT) if OBJECT in roles else 0
    arguments = list(frame.arguments)
    arguments[at] = replace(arguments[at], phrase=phrase)
    return replace(frame, arguments=tuple(arguments))


def _trimmed(tokens: Sequence[str]) -> list[str]:
    """Without the commas and small words around."""
    return trimmed(tokens, _AROUND)


def _behind_next(tokens: list[str]) -> tuple[list[str], bool]:
    start = 0
    while start < len(tokens) and tokens[start] in _NEXT | {","}:
        start += 1
    return tokens[start:], start > 0


def _without_more(tokens: list[str]) -> tuple[list[str], bool]:
    for words in _MORE:
        if len(tokens) > len(words) and tuple(tokens[-len(words) :]) == words:
            return _trimmed(tokens[: -len(words)]), True
    return tokens, False

"""What should be so, in a person's words: "the mug should be in the sink and the tap closed".

A statement has words for a thing, words for what is said of it, and whether
that must hold, must not, or does not matter. What they refer to, and where the
first end and the second begin if no verb stands between, is settled elsewhere.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from verbteach.language.tokens import COMMA, STOP
from verbteach.language.wordlist import phrase_list, word_set

Words = tuple[str, ...]


class Statement(NamedTuple):
    """``said`` of ``subject``; without a verb between them both are in ``said``.

    ``positive``: it must hold, else it must not. ``needed``: it matters at all.
    ``observed``: it may only say how things are, with a bare "is".
    """

    subject: Words
    said: Words
    positive: bool = True
    needed: bool = True
    observed: bool = False

    @property
    def loose(self) -> bool:
        """Whether no verb says where the subject ends."""
        return not self.subject


_BETWEEN = frozenset({COMMA, STOP}) | word_set("and but while plus whereas")
_LEADS = phrase_list("""
    i want, i wanted, i would like, i need, i needed, i meant, i mean, i said, i wish, i think,
    make sure, be sure, see to it, that, it is important, it 's important, it matters,
    the goal is, my goal is, the point is, what i want is, what matters is, please, so, because,
    also, then, at the end, in the end, afterwards, after that, finally, actually, rather, instead,
    only, just, really, robot, well, oh, sorry, no, yes, in my opinion, of course
""")
_TAILS = phrase_list("""
    please, too, also, as well, at the end, in the end, afterwards, after that, again, instead,
    now, then, robot, at least, thanks, thank you, of course, in the beginning, sorry, ok, okay,
    though, actually, anyway, when you are done
""")
_BE = r"(?: (?:also|always|still|be|been|stay|stays|remain|end up|stand|sit|lie|get|become|go))*"
_NOT = r"(?P<{}> (?:not|never|no longer))?"
_IRRELEVANT = re.compile(
    r"(?P<subject>.+?)(?: really)? (?:(?:does|do|did|would|should|must) not (?:really )?"
    r"(?:matter|count)|(?:is|are|'s)(?: really)? not (?:really |so |that |at all )?"
    r"(?:important|needed|necessary|required|relevant|part of it|the point|the goal)"
    r"|(?:is|are|'s)(?: really)? (?:irrelevant|unimportant|unnecessary|optional|superfluous))"
    r"(?: at all)?(?P<said>)"
)
_RELEVANT = re.compile(
    r"(?P<subject>.+?)(?: really)? (?:matters?|counts?|(?:is|are|'s)(?: \w+)? "
    r"(?:important|needed|necessary|required|relevant|part of it))(?P<said>)"
)
_OPTIONAL = re.compile(
    r"(?P<subject>.+?) (?:(?:does|do) not (?:have to|need to|have|need)|needs? not|may|can)"
    rf"(?: to)?{_BE} (?P<said>.+)"
)
_NEEDED = re.compile(
    r"(?P<subject>.+?) (?P<verb>should|must|(?:has|have|needs?|ought)(?: got)? to|needs|shall"
    r"|will|would|(?:is|are|'s|was|were) (?:supposed|meant) to|(?:is|are|was|were) to|to be"
    r"|is|are|'s|belongs?|goes|stays?|remains?|has been|have been)"
    rf"{_NOT.format('no')}{_BE}{_NOT.format('never')} (?P<said>.+)"
)


_IS = frozenset({"is", "are", "'s"})
_BARE = word_set("should must has needs belongs goes shall")
"""Of these the subject is often left out: "should be in the sink"."""


def read_statements(tokens: Sequence[str]) -> tuple[Statement, ...]:
    """The statements in the words, in the order said; those without a verb are loose."""
    return tuple(_statement(part) for part in _parts(tokens) if part)


def without_leads(words: Words) -> Words:
    """Without what announces a statement, and what stands behind it: "i want the mug clean too"."""
    going = True
    while going:
        going = False
        for phrase in _LEADS:
            if words[: len(phrase)] == phrase and len(words) > len(phrase):
                words, going = words[len(phrase) :], True
                break
        for phrase in _TAILS:
            if words[-len(phrase) :] == phrase and len(words) > len(phrase):
                words, going = words[: -len(phrase)], True
                break
    return words


def _parts(tokens: Sequence[str]) -> Iterator[Words]:
    part: list[str] = []
    for token in (*tokens, STOP):
        if token in _BETWEEN:
            yield without_leads(tuple(part))
            part = []
        else:
            part.append(token)


def _statement(words: Words) -> Statement:
    text = " ".join(("it", *words) if words[0] in _BARE else words)
    if found := _IRRELEVANT.fullmatch(text) or _OPTIONAL.fullmatch(text):
        return Statement(_words(found["subject"]), _words(found["said"]), needed=False)
    if found := _RELEVANT.fullmatch(text):
        return Statement(_words(found["subject"]), ())
    if found := _NEEDED.fullmatch(text):
        denied = bool(found["no"]) != bool(found["never"])
        observed = found["verb"] in _IS
        return Statement(
            _words(found["subject"]), _words(found["said"]), not denied, observed=observed
        )
    if words[:1] == ("not",):
        return Statement((), words[1:], positive=False)
    return Statement((), words)


def _words(text: str) -> Words:
    return tuple(text.split())

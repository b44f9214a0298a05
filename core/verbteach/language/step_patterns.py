"""Ways of saying a primitive action, and where a person's words fit one of them.

A pattern is an action's wording with its slots: ``walk|go to {0}``. ``|`` stands
between words that do as well, ``-`` for none. A slot that a pattern leaves out
may be anything: "light {0}" says nothing of the lighter. What the words in a
slot refer to is not known here.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import product

from verbteach.language.fallback import action_wording
from verbteach.language.lexicon import Lexicon
from verbteach.language.openers import OPENERS, Mood
from verbteach.language.tokens import COMMA, STOP, tokenise
from verbteach.language.wordlist import phrase_list, word_set
from verbteach.world.domain import Domain

Words = tuple[str, ...]

_BEFORE = frozenset({COMMA, STOP, "or"}) | word_set(
    "please now then and next so ok okay just well robot you i first finally again also to should "
    "yes sure certainly alright right fine good great afterwards just thanks oh um hm yay lastly"
)
_LEADS = phrase_list("""
    first of all, after that, after this, to begin with, to start with, last of all, in the end,
    at the end, next up, of course, if you do not mind, if you please, if you want,
    you will have to,
    you would have to, be so kind and, be so kind as to, what you do is, what you do now is,
    i want you to, you just, please to, you must to, you need
""")
_AFTER = frozenset({COMMA, STOP}) | word_set("please now then thanks robot first again")


@dataclass(frozen=True)
class Way:
    """One way in which words say the action ``name``: by slot, the words that fill it."""

    name: str
    filled: Mapping[int, Words] = field(default_factory=dict)


def ways_of_saying(domain: Domain, lexicon: Lexicon) -> Mapping[str, tuple[Words, ...]]:
    """The patterns of every action as words and slots, the robot's own wording first.

    One with a slot that the action does not have is left out.
    """
    return {
        name: tuple(
            pattern
            for pattern in _patterns(name, len(schema.parameters), lexicon)
            if _slots(pattern) <= set(range(len(schema.parameters)))
        )
        for name, schema in domain.actions.items()
    }


def _patterns(name: str, arity: int, lexicon: Lexicon) -> tuple[Words, ...]:
    """Each way of saying the action once, whether or not it has the slots for it."""
    said = lexicon.actions.get(name) or action_wording(name, arity)
    listed = (said, *lexicon.steps.get(name, ()))
    return tuple(dict.fromkeys(words for pattern in listed for words in _expanded(pattern)))


def step_words(text: str) -> Words:
    """The words of a step without what politeness and narration put around it."""
    words = tuple(tokenise(text))
    while words and (words[0] in _BEFORE or _opener(words) or _lead(words)):
        words = words[max(_opener(words), _lead(words), 1) :]
    while words and words[-1] in _AFTER:
        words = words[:-1]
    return words


def ways_in(words: Words, patterns: Mapping[str, tuple[Words, ...]]) -> tuple[Way, ...]:
    """Every way in which ``words`` say an action, by the actions' and patterns' order."""
    return tuple(
        Way(name, filled)
        for name, listed in patterns.items()
        for pattern in listed
        for filled in _fits(pattern, words)
    )


def _lead(words: Words) -> int:
    """How many words narrate before the step: "after that", "first of all"."""
    return next((len(lead) for lead in _LEADS if words[: len(lead)] == lead), 0)


def _opener(words: Words) -> int:
    """How many words open a request: "could you" in "could you take the mug"."""
    for opener, mood in OPENERS.get(words[0], ()):
        if mood is Mood.PLAIN and words[: len(opener)] == opener and len(words) > len(opener):
            # "go and take the mug" asks for the mug, but "go to the mug" is a step itself.
            return 0 if opener in _STEPS else len(opener)
    return 0


_STEPS = frozenset({("go",), ("come",)})


def _expanded(pattern: str) -> Iterator[Words]:
    choices = [word.split("|") for word in pattern.split()]
    for words in product(*choices):
        yield tuple(word for word in words if word != "-")


def _fits(pattern: Words, words: Words) -> Iterator[dict[int, Words]]:
    """Each way to spread ``words`` over the pattern; a slot takes one word or more."""
    if not pattern:
        if not words:
            yield {}
        return
    first, rest = pattern[0], pattern[1:]
    slot = _slot(first)
    if slot is None:
        if words[:1] == (first,):
            yield from _fits(rest, words[1:])
        return
    for length in range(1, len(words) - len(rest) + 1):
        for others in _fits(rest, words[length:]):
            yield {slot: words[:length], **others}


def _slots(pattern: Words) -> set[int]:
    return {slot for word in pattern if (slot := _slot(word)) is not None}


def _slot(word: str) -> int | None:
    return int(word[1:-1]) if word.startswith("{") else None


def fixed_words(patterns: Sequence[Words]) -> frozenset[str]:
    """The words that begin the patterns: the verbs of an action."""
    return frozenset(pattern[0] for pattern in patterns if pattern and _slot(pattern[0]) is None)

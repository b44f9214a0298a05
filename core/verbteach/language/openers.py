"""What people put before the verb of a command, politeness first, as a table.

Each opener is a sequence of words and a mood: what form of the verb follows,
and whether it is forbidden instead of asked for.
"""

from __future__ import annotations

from enum import Enum
from itertools import product


class Mood(Enum):
    """What an opener says about the verb behind it."""

    PLAIN = "plain"
    GERUND = "gerund"
    NEGATIVE = "negative"


_PATTERNS = {
    Mood.PLAIN: (
        "can|could|will|would|may|might|shall|should|must you|we|i",
        "i want|need|wanted|require|wish|expect you to",
        "i would|should like|love|prefer you to",
        "i would like|want|need for you to",
        "i ask|order|tell|beg you to",
        "i|we want|need to",
        "i|we would like|love to",
        "you|we need|have|ought to",
        "you|we have got to",
        "you are to",
        "have|make|let the|our|your|- robot",
        "get|tell|ask|order the|our|your|- robot to",
        "i|we want|need|wanted the robot to",
        "i|we would like|love the robot to",
        "the robot should|must|shall",
        "do you think|suppose|reckon you can|could|might|would",
        "do you want to",
        "would you like to",
        "would|could you be so kind as|and to|-",
        "would|could you be kind|good enough to",
        "be so kind as|and to|-",
        "be kind enough to",
        "are you able to",
        "is it possible for|- you|- to",
        "would it be possible for|- you|- to",
        "i was wondering if|whether you could|can|would|might perhaps|maybe|possibly|-",
        "i wonder if|whether you could|can|would|might perhaps|maybe|possibly|-",
        "can|could|will|would you perhaps|maybe|possibly|kindly|quickly",
        "can|could|may|might i ask|trouble|bother you to",
        "i would appreciate it if you could|would|can",
        "i would be grateful|glad|happy|pleased|delighted if you could|would",
        "you will|would have to",
        "please to",
        "i hope you can|could",
        "why do not you|we",
        "why not",
        "let us",
        "go ahead and|-",
        "try to|and",
        "make|be sure to|that|- you|-",
        "remember|proceed|begin|start|continue to",
        "do not forget to",
        "feel free to",
        "help me|us to|-",
        "go|come and|-",
        "it is time to",
        "your job|task is to",
        "the next step is to",
        "what i want|need you to do is to|-",
        "you|we can|could|may|should|must|will|might",
        "i want|need that you",
        "you had|would better",
        "do please|-",
        "be a dear|darling|sweetheart and",
        "do me|us a favour|favor and|-",
        "going to",
        "you|we",
    ),
    Mood.GERUND: (
        "would|do you mind",
        "how|what about",
        "keep|carry|go on|-",
        "start|begin|continue|finish|try|resume by|-",
        "i would appreciate you",
    ),
    Mood.NEGATIVE: (
        "do|does not",
        "never",
        "you|we must|should|shall|can|may|will|would|need not",
        "make|be sure not to",
        "make sure you do not",
        "try not to",
        "i do not want|need you to",
        "i want|need you not to",
        "i would prefer you not to",
        "let us not",
        "you are not to",
    ),
}

Opener = tuple[tuple[str, ...], Mood]


def _expanded(pattern: str) -> list[tuple[str, ...]]:
    choices = [word.split("|") for word in pattern.split()]
    return [tuple(word for word in words if word != "-") for words in product(*choices)]


def _table() -> dict[str, tuple[Opener, ...]]:
    rows = [
        (words, mood)
        for mood, patterns in _PATTERNS.items()
        for pattern in patterns
        for words in _expanded(pattern)
    ]
    rows.sort(key=lambda row: (-len(row[0]), row[0]))
    firsts = dict.fromkeys(words[0] for words, _ in rows)
    return {first: tuple(row for row in rows if row[0][0] == first) for first in firsts}


OPENERS = _table()
"""First word -> openers, the longest first."""

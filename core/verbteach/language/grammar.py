"""``parse``: from a command to verb frames, by a chunk grammar of English imperatives.

Pure and quick: no model, no file, time in proportion to the text's length. It
never raises and never guesses a verb: where nothing can be read it answers
with an empty tuple, and ``explain_unread`` says why.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from enum import Enum
from functools import lru_cache
from itertools import pairwise

from verbteach.language import household, words
from verbteach.language.assembly import OBJECT, Clause, Piece
from verbteach.language.clauses import SentenceReader
from verbteach.language.frames import VerbFrame
from verbteach.language.lexicon import Lexicon
from verbteach.language.tokens import sentences, tokenise
from verbteach.language.wordclass import WordClasses

EMPTY_LEXICON = Lexicon()


class Unread(Enum):
    """Why a text gives no frame."""

    EMPTY = "empty"
    NO_WORDS = "no_words"
    NOT_ENGLISH = "not_english"
    QUESTION = "question"
    NO_VERB = "no_verb"


def parse(
    text: str, lexicon: Lexicon = EMPTY_LEXICON, vocabulary: Iterable[str] = ()
) -> tuple[VerbFrame, ...]:
    """Read a command into frames, one a clause, in the order said.

    ``vocabulary`` holds the nouns of the scene ("mug", "coffee table").
    Unknown verbs and nouns are read by where they stand. Nothing read: empty.
    """
    return _parsed(text, _Lexicon(lexicon), tuple(vocabulary))


class _Lexicon:
    """A lexicon that equals only itself: comparing it whole would take longer than reading."""

    def __init__(self, words: Lexicon) -> None:
        self.words = words

    def __hash__(self) -> int:
        return id(self.words)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Lexicon) and self.words is other.words


@lru_cache(maxsize=1 << 10)
def _parsed(text: str, lexicon: _Lexicon, vocabulary: tuple[str, ...]) -> tuple[VerbFrame, ...]:
    """Lessons and replays say the same again and again, and a text is always read alike."""
    classes = WordClasses(lexicon.words, vocabulary)
    tokens = tokenise(text)
    if _is_foreign(tokens, classes):
        return ()
    clauses = [
        clause
        for sentence in sentences(tokens)
        if not _is_question(sentence)
        for clause in _sharing(SentenceReader(classes.joined(sentence), classes).read())
    ]
    return tuple(clause.settled() for clause in clauses)


def explain_unread(
    text: str, lexicon: Lexicon = EMPTY_LEXICON, vocabulary: Iterable[str] = ()
) -> Unread | None:
    """Why ``parse`` reads nothing in ``text``; None if it does read something."""
    known = tuple(vocabulary)
    if not text.strip():
        return Unread.EMPTY
    if parse(text, lexicon, known):
        return None
    tokens = tokenise(text)
    if _is_foreign(tokens, WordClasses(lexicon, known)):
        return Unread.NOT_ENGLISH
    if not any(token[:1].isalpha() for token in tokens):
        return Unread.NO_WORDS
    if any(_is_question(sentence) for sentence in sentences(tokens)) or "?" in text:
        return Unread.QUESTION
    return Unread.NO_VERB


def _sharing(clauses: list[Clause]) -> list[Clause]:
    """``wash and dry the plates``: a bare verb takes the objects of the next clause."""
    for clause, following in reversed(list(pairwise(clauses))):
        if clause.bare and clause.verb not in household.INTRANSITIVE and not following.purpose:
            clause.pieces = [Piece(OBJECT, phrase, joined=True) for phrase in following.objects]
    return clauses


def _is_question(sentence: Sequence[str]) -> bool:
    first, second = sentence[0], sentence[1] if len(sentence) > 1 else ""
    if first in words.COPULAS - {"be", "'s"}:
        return True
    if first in {"do", "does", "did", "has", "had"} and second in words.SUBJECT_PRONOUNS:
        return not {"mind", "think", "want"} & set(sentence[2:3])
    if first in {"does", "did", "has", "had"}:
        return True
    asks = first in words.QUESTION_WORDS
    if first in {"what", "which"} and "do" in sentence[2:4] and "you" in sentence[3:5]:
        return True  # "what verbs do you know"
    return (
        asks
        and second in words.AUXILIARIES | {"about", "many", "much"} - {"about"}
        and ("not" not in sentence[:3])
    )


def _is_foreign(tokens: Sequence[str], classes: WordClasses) -> bool:
    """Whether nothing English is in the text, or other languages' words outnumber English."""
    letters = [token for token in tokens if token[:1].isalpha()]
    if not letters:
        return False
    if not any(token.isascii() for token in letters):
        return True
    english = sum(_is_english(token, classes) for token in letters)
    foreign = sum(token in words.FOREIGN or not token.isascii() for token in letters)
    return foreign > english


def _is_english(token: str, classes: WordClasses) -> bool:
    if token in words.FOREIGN:
        return False
    return not classes.is_open(token) or classes.is_known(token) or classes.is_adverb(token)

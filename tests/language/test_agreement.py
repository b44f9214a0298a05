"""The grammar beside a statistical parser's frames, on sentences that nobody here wrote."""

from __future__ import annotations

import pytest

from tests.language.corpus import needs_corpus, readings
from verbteach.experiments.frame_agreement import Agreement, Difference, Parsed, agreement
from verbteach.language.grammar import parse


def _compare(text: str, verb: str, *phrases: str) -> Agreement:
    return agreement([(Parsed(text, verb, phrases), parse(text))])


def test_the_same_reading_agrees_whole() -> None:
    found = _compare("put the cups on the big table", "put", "cups", "big table")
    assert (found.verbs, found.heads_precision, found.heads_recall) == (1.0, 1.0, 1.0)
    assert found.differences == {}


@pytest.mark.parametrize(
    ("text", "verb", "phrases", "kind"),
    [
        ("", "turn", ["tap"], Difference.NO_WORDS),
        ("the tap", "turn", ["tap"], Difference.UNREAD),
        ("bring the pot to the sink", "sink", ["pot", "sink"], Difference.NOT_A_VERB),
        ("bring the pot", "carry", ["pot"], Difference.OTHER_VERB),
        ("bring the pot", "bring", ["bring", "pot"], Difference.VERB_AS_NOUN),
        ("take the ice cream", "take", ["ice", "cream"], Difference.PART_OF_NAME),
        ("take the pot", "take", ["pot", "cat"], Difference.LEFT_OUT),
        ("take it to the sink", "take", ["sink"], Difference.ADDED),
    ],
)
def test_each_kind_of_difference_is_told(
    text: str, verb: str, phrases: list[str], kind: Difference
) -> None:
    assert kind in _compare(text, verb, *phrases).differences


@needs_corpus
@pytest.mark.slow
def test_the_corpus_parser_mostly_agrees() -> None:
    found = agreement(readings())
    assert found.verbs > 0.91
    assert found.heads_precision > 0.85
    assert found.heads_recall > 0.85
    assert found.differences[Difference.OTHER_VERB] < 0.01 * found.clauses

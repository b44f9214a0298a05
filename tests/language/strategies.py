"""What the tests of this room draw from: arbitrary text, and text made of command words."""

from __future__ import annotations

from hypothesis import strategies as st

from verbteach.language import household, openers, words
from verbteach.language.wordlist import word_set

_FUNCTION_WORDS = sorted(
    words.DETERMINERS
    | words.PREPOSITIONS
    | words.PARTICLES
    | words.CONJUNCTIONS
    | words.SUBORDINATORS
    | words.OBJECT_PRONOUNS
    | words.AUXILIARIES
    | words.RELATIVES
    | words.ADVERBS
    | words.PLACE_ADVERBS
    | {",", ".", "'s", "&", "not", "x"}
)
_OPENINGS = sorted(" ".join(phrase) for rows in openers.OPENERS.values() for phrase, _ in rows)
_CONTENT = sorted(household.VERBS | household.NOUNS | household.ADJECTIVES)

TEXTS = st.text(max_size=200)
WORD_SALADS = st.lists(
    st.one_of(
        st.sampled_from(_FUNCTION_WORDS), st.sampled_from(_CONTENT), st.sampled_from(_OPENINGS)
    ),
    max_size=20,
).map(" ".join)
NOUNS = st.sampled_from(
    sorted(word_set("cup mug plate kettle table shelf box knife glass dish pillow book towel"))
)
ADJECTIVES = st.sampled_from(["red", "big", "silver", "wooden", "small"])

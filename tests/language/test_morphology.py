"""Word forms: there and back again, exceptions included."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from verbteach.language.household import NOUNS, VERBS
from verbteach.language.inflection import (
    base_of_gerund,
    base_of_participle,
    gerund,
    past_participle,
    third_person,
)
from verbteach.language.morphology import article, is_plural, listing, plural, singular

PLURALS = {
    "dish": "dishes", "knife": "knives", "shelf": "shelves", "box": "boxes", "potato": "potatoes",
    "vase": "vases", "case": "cases", "glass": "glasses", "key": "keys", "battery": "batteries",
    "cookie": "cookies", "movie": "movies", "shoe": "shoes", "leaf": "leaves", "person": "people",
    "mug": "mugs", "bus": "buses", "orange": "oranges", "sandwich": "sandwiches", "toy": "toys",
    "coffee mug": "coffee mugs", "axe": "axes", "purse": "purses", "hoe": "hoes", "sauce": "sauces",
}  # fmt: skip
UNCHANGED = ("scissors", "furniture", "glass", "gas", "news", "asparagus", "tennis", "is", "")
VERB_FORMS = {
    "fill": ("filling", "fills", "filled"),
    "put": ("putting", "puts", "put"),
    "turn on": ("turning on", "turns on", "turned on"),
    "wash": ("washing", "washes", "washed"),
    "empty": ("emptying", "empties", "emptied"),
    "take out": ("taking out", "takes out", "taken out"),
    "tie": ("tying", "ties", "tied"),
    "stir": ("stirring", "stirs", "stirred"),
    "free": ("freeing", "frees", "freed"),
    "go": ("going", "goes", "gone"),
    "do": ("doing", "does", "done"),
    "play": ("playing", "plays", "played"),
    "open": ("opening", "opens", "opened"),
}


@pytest.mark.parametrize(("one", "many"), PLURALS.items())
def test_plurals(one: str, many: str) -> None:
    assert plural(one) == many
    assert is_plural(many.rsplit(maxsplit=1)[-1])
    assert singular(many.rsplit(maxsplit=1)[-1]) == one.rsplit(maxsplit=1)[-1]


@pytest.mark.parametrize("noun", UNCHANGED)
def test_what_is_no_regular_plural_stays(noun: str) -> None:
    assert singular(noun) == noun


@pytest.mark.parametrize("noun", sorted(NOUNS))
def test_every_known_noun_survives_its_plural(noun: str) -> None:
    assert singular(plural(noun)) == noun


@pytest.mark.parametrize(("verb", "forms"), VERB_FORMS.items())
def test_verb_forms(verb: str, forms: tuple[str, str, str]) -> None:
    assert (gerund(verb), third_person(verb), past_participle(verb)) == forms


@pytest.mark.parametrize("verb", sorted(VERBS))
def test_every_known_verb_is_found_behind_its_gerund(verb: str) -> None:
    found = base_of_gerund(gerund(verb), VERBS)
    assert found is not None
    assert gerund(found) == gerund(verb)
    base = base_of_participle(past_participle(verb), VERBS)
    assert base is None or past_participle(base) == past_participle(verb)


def test_unknown_gerunds_are_spelled_likely() -> None:
    assert base_of_gerund("blorping", ()) == "blorp"
    assert base_of_gerund("zapping", ()) == "zap"
    assert base_of_gerund("freaving", ()) == "freave"
    assert base_of_gerund("string", ()) is None
    assert base_of_gerund("mug", ()) is None


@pytest.mark.parametrize(
    ("phrase", "expected"),
    [("mug", "a"), ("apple", "an"), ("hour", "an"), ("xbox", "an"), ("used cup", "a"),
     ("utensil", "a"), ("unopened can", "an"), ("umbrella", "an"), ("8 ounce cup", "an"),
     ("one", "a"), ("", "a")],
)  # fmt: skip
def test_articles(phrase: str, expected: str) -> None:
    assert article(phrase) == expected


@given(st.lists(st.sampled_from(["a", "b", "c"]), max_size=5))
def test_lists_keep_every_item(items: list[str]) -> None:
    assert listing(items).replace(" and ", ", ").split(", ") == (items or [""])


@given(st.text(max_size=20))
def test_any_word_has_forms(word: str) -> None:
    for form in (singular, plural, gerund, third_person, past_participle, article):
        assert isinstance(form(word), str)

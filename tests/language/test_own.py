"""The robot's own grounding: words first, experience with them, and the corpus as the judge."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.language.corpus import cases, needs_corpus
from tests.language.rooms import looks, phrase
from tests.language.strategies import WORD_SALADS
from verbteach.experiments.grounding_scores import leave_one_environment_out
from verbteach.language.grammar import parse
from verbteach.language.own import (
    Experience,
    OwnParameters,
    fitting,
    ground,
    ground_phrase,
    kind_of,
)


def _chances(text: str, experience: Experience | None = None, role: str = "") -> dict[str, float]:
    past = experience or Experience({})
    return dict(ground_phrase(phrase(text), looks(), past, (), role))


def test_words_alone_are_uniform_over_what_they_fit() -> None:
    assert _chances("the red mug") == {"Mug_1": 0.5, "Mug_3": 0.5}


def test_experience_tips_the_scales() -> None:
    past = Experience.of([("red mug", "Mug_3", 1.0)])
    found = _chances("the red mug", past)
    assert max(found, key=found.__getitem__) == "Mug_3"
    assert found["Mug_1"] > 0


def test_experience_gives_new_words_a_meaning_and_passes_to_the_like() -> None:
    past = Experience.of([("fleeb", "Pot_1", 1.0), ("zork", "Mug_77", 2.0)])
    assert set(_chances("the fleeb", past)) == {"Pot_1"}
    assert set(_chances("the zork", past)) == {"Mug_1", "Mug_2", "Mug_3"}
    assert _chances("the green fleeb", past)["Pot_1"] == 1.0
    assert kind_of("Mug_77") == "Mug" == kind_of("Mug")


def test_where_nothing_is_known_all_that_fit_the_role_are_alike() -> None:
    found = _chances("the fleeb")
    assert len(set(found.values())) == 1
    assert set(found) == {t for t in looks().objects if looks().is_thing(t)}
    places = _chances("the fleeb", role="in")
    assert set(places) == set(fitting(looks(), "in")) < set(found)
    assert "Fridge_1" in places
    assert "Fork_1" not in places


def test_a_substance_passes_its_weight_to_what_it_is_in() -> None:
    found = _chances("the water")
    assert found["Water"] > found["Kettle_1"] > 0
    only_things = OwnParameters(values=False)
    assert dict(ground_phrase(phrase("the water"), looks(), parameters=only_things)) == {
        "Kettle_1": 1.0
    }


@given(
    WORD_SALADS,
    st.lists(
        st.tuples(
            st.sampled_from(["mug", "it", "red mug", "x", ""]),
            st.sampled_from(["Mug_1", "Mug_9", "gone"]),
            st.floats(0, 100),
        ),
        max_size=5,
    ),
)
def test_every_distribution_sums_to_one_and_is_ranked(
    text: str, past: list[tuple[str, str, float]]
) -> None:
    room, experience = looks(), Experience.of(past)
    for frame in parse(text):
        for _, told in ground(frame, room, experience, ["Mug_1"]):
            assert math.isclose(math.fsum(p for _, p in told), 1.0)
            assert list(told) == sorted(told, key=lambda row: (-row[1], row[0]))
            assert all(thing in room.objects for thing, _ in told)


@needs_corpus
@pytest.mark.slow
def test_the_corpus_agrees() -> None:
    things = OwnParameters(values=False)
    words = leave_one_environment_out(cases(), things, experienced=False)
    both = leave_one_environment_out(cases(), things)
    assert words.best > 0.78
    assert both.best > 0.92
    assert both.jaccard > 0.88

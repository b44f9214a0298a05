"""Every fluent and action of the household has words, and they read as English."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import astuple
from pathlib import Path

import pytest

from verbteach.world.scene import Scene
from verbteach_scenarios.errors import SceneFileError
from verbteach_scenarios.lexicon_file import load_lexicon, parse_lexicon
from verbteach_scenarios.scenes import load_domain, load_scene, scene_ids

LEXICON = load_lexicon()
DOMAIN = load_domain()
SCENES = [load_scene(scene_id) for scene_id in scene_ids()]


def slots(text: str) -> set[int]:
    return {int(number) for number in re.findall(r"\{(\d)\}", text)}


def test_every_predicate_and_action_is_worded_and_nothing_else() -> None:
    assert set(LEXICON.fluents) == set(DOMAIN.predicates)
    assert set(LEXICON.actions) == set(DOMAIN.actions)


@pytest.mark.parametrize("name", sorted(DOMAIN.predicates))
def test_sentences_speak_of_every_argument(name: str) -> None:
    wanted = set(range(len(DOMAIN.predicates[name].parameters)))
    sentences = astuple(LEXICON.fluents[name])
    assert all(slots(sentence) == wanted for sentence in sentences)
    assert len(set(sentences)) == len(sentences)
    assert LEXICON.fluents[name].question.endswith("?")


@pytest.mark.parametrize("name", sorted(DOMAIN.actions))
def test_actions_speak_of_every_argument(name: str) -> None:
    assert slots(LEXICON.actions[name]) == set(range(len(DOMAIN.actions[name].parameters)))


def spoken(scene: Scene) -> Iterator[str]:
    names: Mapping[str, str] = {o.id: f"the {o.names[0]}" for o in scene.objects.values()}
    for fluent in sorted(scene.initial):
        for sentence in astuple(LEXICON.fluents[fluent.predicate]):
            yield sentence.format(*(names[arg] for arg in fluent.args))


def test_what_holds_in_the_bundled_rooms_reads_as_plain_sentences() -> None:
    for scene in SCENES:
        for sentence in spoken(scene):
            assert re.fullmatch(r"[a-zA-Z' -]+\??", sentence), sentence
            assert "  " not in sentence
            assert "the the" not in sentence


def test_a_few_sentences_as_they_sound() -> None:
    words = LEXICON.fluents
    assert words["has"].question.format("the kettle", "the water") == (
        "is the water in the kettle?"
    )
    assert words["open"].ceased.format("the fridge") == "the fridge is now closed"
    assert words["hot"].should.format("the water") == "the water should be hot"
    assert words["stands-on"].is_false.format("the lamp", "the desk") == (
        "the lamp does not stand on the desk"
    )
    assert LEXICON.actions["put-in"].format("the milk", "the fridge") == (
        "put the milk in the fridge"
    )


def test_every_attribute_of_the_bundled_things_is_known() -> None:
    for scene in SCENES:
        for thing in scene.objects.values():
            for kind, value in thing.attributes.items():
                assert LEXICON.attributes.get(value) == kind, (scene.id, thing.id, value)


def test_synonyms_go_both_ways_and_kinds_one_way() -> None:
    assert "sofa" in LEXICON.synonyms["couch"]
    assert "couch" in LEXICON.synonyms["sofa"]
    assert "beer" in LEXICON.synonyms["drink"]
    assert "drink" not in LEXICON.synonyms.get("beer", frozenset())


def test_a_folder_lays_its_own_words_over_the_bundled_ones(tmp_path: Path) -> None:
    (tmp_path / "lexicon.toml").write_text(
        '[fluents]\nopen = { is = "ajar" }\n[synonyms]\nsame = [["couch", "divan"]]\n'
        '[actions]\nsing = "sing to {0}"\n[verbs]\nplain = ["sing"]\n'
    )
    words = load_lexicon(tmp_path)
    assert words.fluents["open"].is_true == "{0} is ajar"
    assert words.fluents["hot"] == LEXICON.fluents["hot"]
    assert {"divan", "sofa"} <= words.synonyms["couch"]
    assert words.actions["sing"] == "sing to {0}"
    assert words.verbs == LEXICON.verbs | {"sing"}


@pytest.mark.parametrize(
    "text",
    [
        "[fluents]\nopen = { is_true = '{0} is open' }\n",
        "[fluents]\nopen = { iss = 'open' }\n",
        "[fluents]\nopen = 3\n",
        "[fluents]\nopen = { is = '{0' }\n",
        "[fluents]\nopen = { does = ['opens'], rest = '' }\n",
        "[actions]\nopen = 3\n",
        "[attributes]\ncolour = 'red'\n",
        "[synonyms]\nsame = [3]\n",
        "[verbs]\nplain = 'open'\n",
        "[fluents",
    ],
)
def test_a_lexicon_that_does_not_fit_is_refused(text: str) -> None:
    with pytest.raises(SceneFileError, match=r"mine\.toml"):
        parse_lexicon(text, Path("mine.toml"))

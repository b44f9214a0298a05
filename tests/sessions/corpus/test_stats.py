"""Figures, counted by hand on sessions small enough to."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.sessions.corpora import ANNA, BEN
from verbteach_sessions.corpus.agreement import Agreement, jaccard, literals
from verbteach_sessions.corpus.stats import Stats, words
from verbteach_sessions.exports.dialogue import Dialogue, Turn
from verbteach_sessions.exports.reading import read_dialogue


def stats(*dialogues: Dialogue) -> Stats:
    made = Stats()
    for dialogue in dialogues:
        made.add(dialogue)
    return made


def turn(number: int, speaker: str, act: str, **more: object) -> Turn:
    fields = {"acts": ({"act": act, **more.pop("arguments", {})},), "texts": ("some words",)}  # type: ignore[dict-item]
    return Turn(
        number=number,
        seq=number,
        reply_to=number - 1 if number else None,
        speaker=speaker,
        kind=speaker,
        at=float(number),
        phase="execution",
        scene="kitchen-1",
        command=0,
        **{**fields, **more},  # type: ignore[arg-type]
    )


ASKED = (
    turn(0, "robot", "await_command", reward=0.0),
    turn(1, "teacher", "command", answer_seconds=4.0),
    turn(2, "robot", "np_grd_ynq", reward=0.0),
    turn(3, "teacher", "no", answer_seconds=1.0),
    turn(4, "robot", "np_grd_whq", reward=-2.0),
    turn(5, "teacher", "say", answer_seconds=2.0),
    turn(6, "robot", "np_grd_ynq", reward=-6.5),
    turn(7, "teacher", "yes"),
    turn(8, "robot", "learned", reward=-1.0, arguments={"verb": "boil", "arity": 1}),
)


@pytest.fixture
def asked(corpus: tuple[Path, ...]) -> Dialogue:
    """A dialogue of three questions in the clothes of a recorded one."""
    return replace(read_dialogue(corpus[1]), turns=ASKED, seconds=8.0)


def test_questions_by_type_and_price(asked: Dialogue) -> None:
    questions = stats(asked).to_json()["questions"]
    assert (questions["count"], questions["price"]) == (3, -9.5)
    ynq, whq = questions["by_type"]["np_grd_ynq"], questions["by_type"]["np_grd_whq"]
    assert (ynq["count"], ynq["price"], ynq["answers"]) == (2, -3.0, {"no": 1, "yes": 1})
    assert ynq["seconds"] == {"count": 1, "mean": 1.0, "median": 1.0}
    assert (whq["count"], whq["price"], whq["answers"]) == (1, -6.5, {"say": 1})


def test_times_words_and_people(asked: Dialogue) -> None:
    figures = stats(asked).to_json()
    assert figures["seconds_per_answer"] == {"count": 3, "mean": 2.3333, "median": 2.0}
    # Two words in the command and two in the free answer; "yes" and "no" are no prose.
    assert figures["words_per_learned_verb"]["verbs"] == {
        "boil": {"count": 1, "mean": 4.0, "median": 4.0}
    }
    person = figures["per_participant"][BEN]
    assert (person["turns"], person["questions"], person["words"]) == (9, 3, 4)
    assert person["verbs_taught"] == ["boil"]
    assert person["reward"] == -9.5


def test_what_was_taken_back_does_not_count(asked: Dialogue) -> None:
    undone = replace(asked, turns=tuple(replace(one, holds=one.number < 4) for one in ASKED))
    assert stats(undone).to_json()["questions"]["count"] == 1


def test_a_recorded_corpus(corpus: tuple[Path, ...]) -> None:
    dialogues = [read_dialogue(path) for path in corpus]
    figures = stats(*dialogues).to_json()
    assert figures["sessions"] == 3
    assert figures["teachers"] == {"human": 2, "simulated": 1}
    assert list(figures["per_participant"]) == [ANNA, BEN]
    held = sum(len(dialogue.held) for dialogue in dialogues)
    assert sum(figures["turns"].values()) == held
    anna = figures["per_participant"][ANNA]
    assert anna["reward"] == dialogues[0].totals["reward"]
    boil = figures["agreement"]["verbs"]["boil/1"]
    assert (boil["people"], boil["pairs"]) == (2, 1)
    assert 0 < boil["mean"] < 1


def test_without_sessions_everything_is_nothing() -> None:
    figures = Stats().to_json()
    assert figures["seconds_per_answer"] == {"count": 0, "mean": None, "median": None}
    assert figures["agreement"] == {"mean": None, "pairs": 0, "verbs": {}}


def taught(dialogue: Dialogue, person: str, *hypotheses: str) -> Dialogue:
    arguments = [{"verb": "boil", "arity": 1, "hypothesis": text} for text in hypotheses]
    turns = [turn(n, "robot", "learned", arguments=one) for n, one in enumerate(arguments)]
    return replace(dialogue, participant=person, turns=tuple(turns))


def test_agreement_is_the_overlap_of_goals(asked: Dialogue) -> None:
    agreement = Agreement()
    agreement.add(taught(asked, "a", "(hot ?0) (not (open ?1))"))
    agreement.add(taught(asked, "b", "(hot ?0)"))
    agreement.add(taught(asked, "c", "(cold ?0)", "(hot ?0)"))
    document = agreement.to_json()
    # a-b: 1/2; a-c: mean of 0 and 1/2; b-c: mean of 0 and 1.
    assert document["verbs"]["boil/1"] == {"people": 3, "pairs": 3, "mean": 0.4167}
    assert document["pairs"] == 3


def test_one_person_alone_agrees_with_nobody(asked: Dialogue) -> None:
    agreement = Agreement()
    for _ in range(2):
        agreement.add(taught(asked, "a", "(hot ?0)"))
    assert agreement.to_json()["mean"] is None


@given(st.frozensets(st.text(max_size=3)), st.frozensets(st.text(max_size=3)))
def test_jaccard_is_symmetric_and_one_only_for_equals(
    one: frozenset[str], two: frozenset[str]
) -> None:
    assert jaccard(one, two) == jaccard(two, one)
    assert 0 <= jaccard(one, two) <= 1
    assert (jaccard(one, two) == 1) is (bool(one) and one == two)


def test_literals_of_a_hypothesis() -> None:
    text = "(in ?0 <bin>0) (not (open ?1)) (handsfull)"
    assert literals(text) == {"(in ?0 <bin>0)", "(not (open ?1))", "(handsfull)"}


def test_words() -> None:
    assert words("don't put the well-known mug_1 there!") == 7
    assert words("") == 0

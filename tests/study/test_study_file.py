"""The study's file: what is read from it, and that every misfit is found with its line."""

from __future__ import annotations

from contextlib import suppress
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.study.files import SCENES, SMALL, study
from verbteach_sessions.study.bundled import EXAMPLE
from verbteach_sessions.study.errors import StudyFileError
from verbteach_sessions.study.study_file import parse_study, read_study

HERE = Path("study.toml")


def problems(text: str) -> list[tuple[int, str]]:
    """What is wrong with a text, each with its line."""
    with pytest.raises(StudyFileError) as caught:
        parse_study(text.encode(), HERE, SCENES)
    return [(line, message) for line, message in caught.value.problems]


def line_of(text: str, part: str) -> int:
    """The line on which ``part`` stands first, from 1."""
    return text[: text.index(part)].count("\n") + 1


def test_the_example_that_comes_along_fits_and_compares_showing_with_asking() -> None:
    example = read_study(EXAMPLE, SCENES)
    showing, asking = example.conditions
    assert showing.policy == "she16"
    assert asking.policy != showing.policy
    assert (showing.noise, showing.panels) == (asking.noise, asking.panels)
    assert example.questionnaire.nasa_tlx
    assert "delete" in example.consent


def test_what_is_left_out_gets_its_default() -> None:
    small = study()
    assert small.design == "between"
    assert small.conditions[1].panels == ("scene", "mind", "verbs")
    assert small.conditions[0].noise == "perfect"
    assert small.lessons.scenes == ("kitchen-1", "kitchen-2")
    assert small.lessons.stop.questions == 2
    assert small.practice is not None


def test_the_hashes_are_of_what_is_shown_and_of_the_file() -> None:
    other = study(SMALL.replace("Do you agree?", "Do you agree!"))
    assert study().consent_hash != other.consent_hash
    assert study().file_hash != other.file_hash
    assert study(SMALL + "# a remark\n").consent_hash == study().consent_hash


@pytest.mark.parametrize(
    ("old", "new", "word"),
    [
        ('policy = "she16"', 'policy = "shy16"', "shy16"),
        ('panels = ["scene"]', 'panels = ["scene", "brain"]', "brain"),
        ('panels = ["scene"]', "panels = 3", "list"),
        ('scene = "kitchen-2"', 'scene = "kitchen-99"', "kitchen-99"),
        ("questions = 2", "questions = -1", "whole number"),
        ("questions = 2", "questions = true", "whole number"),
        ("questions = 2", "minutes = 0", "greater than 0"),
        ("questions = 2", "minutse = 5", "not known here"),
        ('consent = "Do you agree?"', 'consent = " "', "not empty"),
        ('consent = "Do you agree?"', "consent = 5", "must be a text"),
        ('id = "small"', 'id = "../small"', "small letters"),
        ("[questionnaire]", '[questionnaire]\nwhen = "never"', "never"),
        ("[questionnaire]", "[questionnaire]\nnasa_tlx = 1", "true or false"),
        ('id = "asking"', 'id = "showing"', "used twice"),
        ('id = "asking"', 'id = "asking"\nnoise = "loud"', "no noise level 'loud'"),
        ("seed = 7", "seed = seven", "is not TOML"),
    ],
)
def test_what_does_not_fit_is_named_with_its_line(old: str, new: str, word: str) -> None:
    text = SMALL.replace(old, new, 1)
    found = problems(text)
    assert any(word in message for _, message in found), found
    line = next(line for line, message in found if word in message)
    twice = text.count("\n", 0, text.rindex(new)) + 1
    assert line == (twice if word == "used twice" else line_of(text, new.splitlines()[-1]))


def test_all_misfits_are_told_at_once_in_the_order_of_the_file() -> None:
    text = (
        SMALL.replace('"she16"', '"x"').replace('"kitchen-2"', '"y"').replace("seed = 7", "se = 7")
    )
    found = problems(text)
    assert [line for line, _ in found] == sorted(line for line, _ in found)
    assert len(found) == 3


def test_what_is_missing_is_told() -> None:
    found = " ".join(message for _, message in problems(""))
    for word in ("study.id", "study.consent", "condition", "lessons.scenes"):
        assert word in found


def test_lessons_that_nothing_ends_are_refused() -> None:
    text = SMALL.replace("[[lessons.task]]", "[[other.task]]").replace(
        "questions = 2", 'scenes = ["kitchen-1"]'
    )
    assert any("nothing ends it" in message for _, message in problems(text))


def test_a_line_in_a_text_of_several_lines_is_no_key() -> None:
    text = SMALL.replace('"Do you agree?"', '"""\npolicy = "x"\n[lessons]\n"""', 1)
    assert study(text).consent.startswith("policy")
    broken = text.replace("questions = 2", "questions = -2")
    assert problems(broken)[0][0] == line_of(broken, "questions = -2")


def test_bytes_that_are_no_text_are_refused_with_their_line() -> None:
    with pytest.raises(StudyFileError) as caught:
        parse_study(b"[study]\nid = '\xff'\n", HERE, SCENES)
    assert caught.value.problems[0].line == 2


@settings(max_examples=60, deadline=None)
@given(st.integers(0, len(SMALL) - 1), st.text(max_size=3))
def test_no_slip_of_the_pen_is_a_crash(place: int, slip: str) -> None:
    text = SMALL[:place] + slip + SMALL[place + 1 :]
    with suppress(StudyFileError, UnicodeEncodeError):
        assert study(text).conditions

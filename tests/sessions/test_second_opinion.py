"""A second reader takes part in a session, live and recomputed, only if the header says so."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from tests.sessions.rooms import BOIL, Clock, begin, recorded, say, settings
from verbteach.dialogue import acts
from verbteach.dialogue.setting import Setting
from verbteach.language.agreement import NoSecondReaderError
from verbteach.language.frames import VerbFrame
from verbteach.language.grammar import parse
from verbteach_sessions.header import READER, Header, versions
from verbteach_sessions.method import Method
from verbteach_sessions.plain_values import ParameterError
from verbteach_sessions.replay import verify
from verbteach_sessions.session import Session
from verbteach_sessions.validate import validate

WITH = Method(second_opinion=True)
DISPUTED = BOIL.replace("boil the water\n", "boil the water\ncommand: yes\n", 1)


class Contrary:
    """Reads "boil" as another verb."""

    def read(self, text: str) -> tuple[VerbFrame, ...]:
        return parse(text.replace("boil", "wash"))


class Broken:
    """A parser that cannot be loaded."""

    def read(self, text: str) -> tuple[VerbFrame, ...]:
        raise NoSecondReaderError(f"cannot read {text!r}")


def contrary(scene: str) -> Setting:
    return replace(settings(scene), second=Contrary())


def broken(scene: str) -> Setting:
    return replace(settings(scene), second=Broken())


def held(folder: Path) -> Path:
    header = Header.new("kitchen-1", WITH)
    with Session.create(folder, header, contrary, clock=Clock()) as session:
        return say(session, DISPUTED).path


def test_the_header_says_so_only_where_there_was_one() -> None:
    assert "second_opinion" not in Method().to_json()
    assert WITH.to_json() == {**Method().to_json(), "second_opinion": True}
    assert Method.from_json(WITH.to_json()) == WITH
    assert Method.from_json({**Method().to_json(), "second_opinion": False}) == Method()
    with pytest.raises(ParameterError, match="second_opinion"):
        Method.from_json({**Method().to_json(), "second_opinion": "spacy"})


def test_a_session_held_with_one_is_recomputed_with_one(tmp_path: Path) -> None:
    path = held(tmp_path)
    found = verify(path, contrary)
    assert found.verified
    assert validate(path, contrary).valid
    with Session.resume(path, contrary, clock=Clock()) as session:
        assert session.recovered == ()
        assert session.header.method == WITH
        turn = session.perform(acts.Command("boil the water"))
        assert isinstance(turn.waiting_act, acts.AskRephrase)


def test_a_session_held_without_one_is_recomputed_without(tmp_path: Path) -> None:
    path = recorded(tmp_path, BOIL)
    plain = verify(path, settings)
    assert plain.verified
    assert verify(path, broken) == plain
    with Session.resume(path, broken, clock=Clock()) as session:
        assert session.perform(acts.Command("boil the water")).acts


def test_a_new_session_without_one_never_asks_it(tmp_path: Path) -> None:
    header = Header.new("kitchen-1")
    with Session.create(tmp_path, header, broken, clock=Clock()) as session:
        said = say(session, BOIL).content_hash
    with begin(tmp_path) as session:
        assert say(session, BOIL).content_hash == said


def test_a_second_opinion_is_part_of_the_content(tmp_path: Path) -> None:
    def hashed(method: Method, name: str) -> str:
        header = Header.new("kitchen-1", method)
        with Session.create(tmp_path / name, header, contrary, clock=Clock()) as session:
            return session.content_hash

    assert hashed(WITH, "with") != hashed(Method(), "without")


def test_where_it_is_missing_nothing_is_begun_recomputed_or_written(tmp_path: Path) -> None:
    path = held(tmp_path / "held")
    before = (path / "events.jsonl").read_bytes()
    with pytest.raises(NoSecondReaderError, match="verbteach\\[nlp\\]"):
        Session.create(tmp_path / "new", Header.new("kitchen-1", WITH), settings)
    assert not (tmp_path / "new").exists() or not list((tmp_path / "new").iterdir())
    with pytest.raises(NoSecondReaderError, match="verbteach\\[nlp\\]"):
        verify(path, settings)
    with pytest.raises(NoSecondReaderError, match="verbteach\\[nlp\\]"):
        Session.resume(path, settings, clock=Clock())
    (problem,) = validate(path, settings).problems
    assert problem.rule == "replay"
    assert "verbteach[nlp]" in problem.message
    assert (path / "events.jsonl").read_bytes() == before


def test_a_reader_that_fails_leaves_the_session_as_it_was(tmp_path: Path) -> None:
    with Session.create(tmp_path, Header.new("kitchen-1", WITH), broken) as session:
        before = session.content_hash
        with pytest.raises(NoSecondReaderError, match="cannot read"):
            session.perform(acts.Command("boil the water"))
        assert session.content_hash == before
        path = session.path
    assert verify(path, contrary).verified
    held_path = held(tmp_path / "held")
    with pytest.raises(NoSecondReaderError, match="cannot read"):
        verify(held_path, broken)


def test_the_readers_version_matters_only_where_it_took_part() -> None:
    other = {**versions(), READER[0]: "0.1"}
    assert Header.new("kitchen-1").changed_software(other) == ()
    assert Header.new("kitchen-1", WITH).changed_software(other) == (READER[0],)
    older = {**versions(), "numpy": "0.1"}
    assert Header.new("kitchen-1").changed_software(older) == ("numpy",)

"""What the scan finds and what it leaves alone; redaction by what was decided."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.sessions.corpora import MAIL
from verbteach_sessions.corpus.findings import left_over, scan
from verbteach_sessions.corpus.personal import Scanner
from verbteach_sessions.corpus.redactions import REDACTIONS_NAME, Decision, Redactions, Redactor
from verbteach_sessions.errors import LogError


@pytest.mark.parametrize(
    ("kind", "personal", "around"),
    [
        ("e-mail", "anna.b+x@mail.example.org", "write to {}, please"),
        ("web address", "https://example.org/~anna?x=1", "see {} there"),
        ("web address", "www.example.org", "see {}"),
        ("handle", "@anna_b", "I am {} elsewhere"),
        ("telephone", "+49 151 23456789", "call {}!"),
        ("telephone", "(030) 123-4567", "call {} now"),
        ("IBAN", "DE89 3704 0044 0532 0130 00", "pay to {}"),
        ("card number", "4111 1111 1111 1111", "it is {}"),
        ("network address", "192.168.7.12", "from {}"),
        ("date", "12.05.1990", "born {}"),
        ("date", "3 May 1990", "born on {}"),
        ("date", "May 3rd, 1990", "born {}"),
        ("street", "12 Old Mill Road", "I live at {}"),
        ("street", "Hauptstraße 12", "I live at {}"),
        ("user's folder", "/home/anna", "in {}/x"),
        ("user's folder", "C:\\Users\\anna", "in {}\\x"),
        ("name", "Anna Blume", "my name is {}, hello"),
        ("name", "Anna", "Call me {}."),
        ("listed name", "Grete", "ask grete"),
    ],
)
def test_personal_data_is_found(kind: str, personal: str, around: str) -> None:
    hits = list(Scanner(["Grete"]).hits(around.format(personal)))
    assert [(hit.kind, hit.text.casefold()) for hit in hits] == [(kind, personal.casefold())]


@pytest.mark.parametrize(
    "text",
    [
        "boil the water for 10 minutes",
        "put Kettle_1 on Burner_1, then turn StoveKnob_1",
        "take 2 of the 12 cups; it is 3/4 full",
        "I am sure. This is The one, I'm Done",
        "no, the red one (the 2nd)",
        "version 1.2.3",
        "4111 1111 1111 1112 is no card",
        "(not (on Mug_1 Counter_1))",
        "gretel is somebody else",
    ],
)
def test_what_teachers_say_is_left_alone(text: str) -> None:
    hits = [hit for hit in Scanner(["Grete"]).hits(text) if hit.kind != "telephone"]
    assert hits == []


@given(st.text(max_size=200))
def test_hits_are_parts_of_the_text(text: str) -> None:
    for hit in Scanner(["anna"]).hits(text):
        assert hit.text in text


def test_a_scan_takes_long_texts_in_its_stride() -> None:
    for text in ("a" * 50_000, "1 " * 25_000, "a@" * 25_000, "A1 " * 20_000, "my name is " * 5_000):
        list(Scanner(["anna"]).hits(text))


def test_each_text_is_found_once_with_its_event(mine: tuple[Path, ...]) -> None:
    log = Redactions.of(mine[0].parent)
    found = {finding.text: finding for finding in scan(mine[0], Scanner(), log)}
    assert set(found) == {MAIL, "+49 151 23456789", "http://evil.example/"}
    assert found[MAIL].choice is None
    assert found[MAIL].session == mine[0].name
    assert not list(scan(mine[1], Scanner(), log))


def test_decisions_are_kept_apart_and_hold(mine: tuple[Path, ...]) -> None:
    folder = mine[0].parent
    log = Redactions.of(folder)
    mail, phone, web = scan(mine[0], Scanner(), log)
    log.decide([mail.decision("redact"), phone.decision("keep")])
    again = Redactions.of(folder)
    assert [one.choice for one in scan(mine[0], Scanner(), again)] == ["redact", "keep", None]
    assert [one.text for one in left_over(mine[0], Scanner(), again)] == [web.text]
    path = folder / REDACTIONS_NAME
    assert path.stat().st_mode & 0o777 == 0o600
    # The last word about a text counts.
    again.decide([mail.decision("keep")])
    assert again.choices(mine[0].name) == {"keep": 2}
    assert MAIL not in path.read_text("utf-8").replace(MAIL, "", 2)


def test_records_do_not_change(mine: tuple[Path, ...]) -> None:
    before = (mine[0] / "events.jsonl").read_bytes()
    log = Redactions.of(mine[0].parent)
    log.decide(finding.decision("redact") for finding in scan(mine[0], Scanner(), log))
    assert (mine[0] / "events.jsonl").read_bytes() == before


def test_the_robots_repeating_is_redacted_too() -> None:
    redactor = Redactor([Decision("s", "name", "Anna Blume", "redact")])
    told = {"np": "anna  blume", "texts": ["I don't know Anna Blume, nor Annabel."], "x": [1, None]}
    assert redactor(told) == {
        "np": "[name]",
        "texts": ["I don't know [name], nor Annabel."],
        "x": [1, None],
    }
    assert redactor.count == 2


def test_the_longer_text_is_redacted_first() -> None:
    decisions = [Decision("s", "name", t, "redact") for t in ("Anna", "Anna Blume")]
    assert Redactor(decisions)("Anna Blume met Anna") == "[name] met [name]"


@pytest.mark.parametrize(
    "line",
    [
        "not json",
        "[]",
        json.dumps({"session": "s", "kind": "k", "text": "t", "choice": "maybe"}),
        json.dumps({"session": "s", "kind": "k", "text": " ", "choice": "keep"}),
    ],
)
def test_a_line_that_is_no_decision_is_named(tmp_path: Path, line: str) -> None:
    good = json.dumps({"session": "s", "kind": "k", "text": "t", "choice": "keep"})
    (tmp_path / REDACTIONS_NAME).write_text(f"{good}\n{line}\n", "utf-8")
    with pytest.raises(LogError, match="line 2"):
        Redactions.of(tmp_path)

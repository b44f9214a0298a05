from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.scenarios.tell_me_dave_folder import (
    CLAUSES,
    FILLING,
    OBJECTS,
    REAL,
    clauses_text,
    needs_corpus,
    trace_text,
    write_document,
)
from verbteach.world.fluents import Fluent
from verbteach.world.plan import Action
from verbteach_scenarios.tell_me_dave.clauses import noun_phrases
from verbteach_scenarios.tell_me_dave.corpus import read_corpus
from verbteach_scenarios.tell_me_dave.errors import CorpusError
from verbteach_scenarios.tell_me_dave.traces import LineSyntaxError, parse_state, print_state

WORDS = st.text("AbcXyz_019", min_size=1, max_size=6)
FLUENTS = st.builds(Fluent, WORDS, st.lists(WORDS, min_size=1, max_size=3).map(tuple))


def test_a_document_is_read_whole(tmp_path: Path) -> None:
    (document,) = read_corpus(write_document(tmp_path)).documents
    assert document.name == "7"
    assert document.objects["Mug_1"] == ("IsGraspable", "IsPourable")
    assert document.objects["Robot"] == ()
    assert len(document.steps) == len(FILLING)
    assert document.steps[0].action == Action("moveto", ("Mug_1",))
    assert Fluent("Near", ("Robot", "Mug_1")) in document.steps[1].state
    assert document.steps[-1].action is None
    assert document.sentence == "Put the cup\nin the sink and fill it"


def test_a_clause_is_read_whole(tmp_path: Path) -> None:
    (document,) = read_corpus(write_document(tmp_path)).documents
    put, fill, thanks = document.clauses
    assert put.sentence == "Put the cup\nin the sink"
    assert (put.start, put.end, put.length) == (0, 3, 4)
    assert put.words == ("Put", "cup", "sink", "in")
    assert put.mapping == (("cup", ("Mug_1", "Bowl_1")), ("sink", ("Sink",)))
    assert noun_phrases(put.frame) == ("cup", "sink")
    assert [str(a) for a in document.actions(fill)] == ["turn SinkKnob Sink", "wait"]
    assert thanks.length == 0
    assert document.actions(thanks) == ()
    assert thanks.mapping == ()


def test_documents_come_by_number_and_numbers_may_have_gaps(tmp_path: Path) -> None:
    for name in ("12", "3", "100"):
        write_document(tmp_path, name)
    (tmp_path / "LICENSE").write_text("other files are ignored")
    (tmp_path / "._3.clauses").write_bytes(b"\x00\x05\x16\x07")
    seen: list[tuple[int, int]] = []
    corpus = read_corpus(tmp_path, lambda done, of: seen.append((done, of)))
    assert [d.name for d in corpus.documents] == ["3", "12", "100"]
    assert seen == [(1, 3), (2, 3), (3, 3)]


def test_line_ends_and_a_byte_order_mark_do_not_matter(tmp_path: Path) -> None:
    write_document(tmp_path)
    plain = read_corpus(tmp_path).documents
    for path in tmp_path.iterdir():
        text = path.read_text(encoding="utf-8").replace("\n", "\r\n")
        path.write_bytes(b"\xef\xbb\xbf" + text.encode())
    assert read_corpus(tmp_path).documents == plain


def test_a_noun_phrase_may_hold_a_parenthesis(tmp_path: Path) -> None:
    clauses = [(0, 3, "put", "put", "(the cup (left),Mug_1) (sink,Sink)")]
    command = read_corpus(write_document(tmp_path, clauses=clauses)).documents[0].clauses[0]
    assert command.mapping == (("the cup (left)", ("Mug_1",)), ("sink", ("Sink",)))


def test_what_is_odd_is_noted_with_its_line(tmp_path: Path) -> None:
    clauses = [(0, 3, "put", "put", "(lid,Lid_9) (cup,Mug_1)"), (9, 4, "odd", "odd", "")]
    steps = [("(On Mug_1 Shelf_3)", "moveto Mug_1"), ("(Near Robot Mug_1)", "")]
    clauses[0] = (0, 0, *clauses[0][2:])
    corpus = read_corpus(write_document(tmp_path, steps=steps, clauses=clauses))
    assert corpus.documents[0].clauses[0].mapping == (("cup", ("Mug_1",)),)
    assert [(o.path.name, o.line) for o in corpus.oddities] == [
        ("7.instenv", 12),
        ("7.clauses", 11),
        ("7.clauses", 16),
    ]
    assert "Shelf_3" in corpus.oddities[0].reason
    assert "Lid_9" in str(corpus.oddities[1])
    assert "no action" in corpus.oddities[2].reason


def failure(folder: Path) -> CorpusError:
    with pytest.raises(CorpusError) as caught:
        read_corpus(folder)
    return caught.value


def test_a_folder_without_documents_is_an_error(tmp_path: Path) -> None:
    assert "holds no document" in str(failure(tmp_path))
    assert "cannot be read" in str(failure(tmp_path / "absent"))


@pytest.mark.parametrize("missing", [".instenv", ".clauses"])
def test_half_a_document_is_an_error(tmp_path: Path, missing: str) -> None:
    write_document(tmp_path)
    (tmp_path / f"7{missing}").unlink()
    error = failure(tmp_path)
    assert f"has no 7{missing} beside it" in str(error)
    assert error.path.exists()


@pytest.mark.parametrize("suffix", [".instenv", ".clauses"])
def test_another_encoding_is_an_error_with_its_line(tmp_path: Path, suffix: str) -> None:
    write_document(tmp_path)
    path = tmp_path / f"7{suffix}"
    path.write_bytes(path.read_bytes().replace(b"cup", b"caf\xe9").replace(b"Sink:", b"\xe9:"))
    error = failure(tmp_path)
    assert "UTF-8" in str(error)
    assert error.line == 1


TRACE = trace_text(FILLING)
TORN_TRACES = [
    pytest.param(("Obj list:", "Objects:"), 1, "'Obj list:' should stand here", id="no list"),
    pytest.param((OBJECTS, ""), 1, "no object is listed", id="empty list"),
    pytest.param(("(Bowl_1:", "(Mug_1:"), 1, "listed twice", id="object twice"),
    pytest.param(("(Bowl_1:IsGraspable)", "(Bowl 1)"), 1, "is not an object", id="no object"),
    pytest.param(
        ("<start step >2", "<start step >3"), 13, "step 2 should follow", id="step left out"
    ),
    pytest.param(("<start step >2", "<start step >two"), 13, "whole number", id="step no number"),
    pytest.param(("<end step >2", "<end step >1"), 16, "step 2 ends as step 1", id="wrong end"),
    pytest.param(("moveto Sink", ""), 15, "step 2 has no instruction", id="instruction gone"),
    pytest.param(("(Near Robot Mug_1)", "(Near Robot Mug_1"), 9, "outside", id="open fluent"),
    pytest.param(("(Near Robot Mug_1)", "(Near)"), 9, "not a fluent", id="no fluent"),
    pytest.param(("(Near Robot Mug_1)", "Near Mug_1"), 9, "outside", id="bare words"),
    pytest.param(("Instruction: turn", "Instr: turn"), 25, "'Instruction:' should", id="no key"),
]


@pytest.mark.parametrize(("damage", "line", "reason"), TORN_TRACES)
def test_a_damaged_trace_is_an_error_with_its_line(
    tmp_path: Path, damage: tuple[str, str], line: int, reason: str
) -> None:
    write_document(tmp_path)
    assert damage[0] in TRACE
    (tmp_path / "7.instenv").write_text(TRACE.replace(*damage, 1), encoding="utf-8")
    error = failure(tmp_path)
    assert reason in error.reason
    assert (error.path.name, error.line) == ("7.instenv", line)


def test_a_trace_cut_anywhere_is_an_error(tmp_path: Path) -> None:
    write_document(tmp_path)
    for size in range(0, len(TRACE) - 1, 5):
        (tmp_path / "7.instenv").write_text(TRACE[:size], encoding="utf-8")
        assert failure(tmp_path).line > 0


COMMAND = clauses_text(CLAUSES)
TORN_CLAUSES = [
    pytest.param(("entire", "whole"), 1, "'entire sentence:' should", id="no sentence"),
    pytest.param(("start env: 0", "start env: -1"), 6, "starts at action -1", id="below zero"),
    pytest.param(("end env: 3", "end env: 6"), 6, "the trace's last is 5", id="beyond"),
    pytest.param(("end env: 3", "end env: x"), 6, "whole number", id="no number"),
    pytest.param(("verb: Put", "verb: "), 11, "no verb", id="no verb"),
    pytest.param(("(cup,Mug_1)", "(cup,Mug_1"), 12, "no pair", id="open pair"),
    pytest.param(("(cup,Mug_1)", "(cup Mug_1)"), 12, "no pair", id="no comma"),
    pytest.param(("words: Put", "word: Put"), 10, "'words:'", id="no words"),
    pytest.param(("clause dscr: Put", "dscr: Put"), 13, "'clause dscr:'", id="no frame"),
    pytest.param(("<end clause>", "<start clause>"), 13, "'<end clause>' should", id="no end"),
]


@pytest.mark.parametrize(("damage", "line", "reason"), TORN_CLAUSES)
def test_a_damaged_command_is_an_error_with_its_line(
    tmp_path: Path, damage: tuple[str, str], line: int, reason: str
) -> None:
    write_document(tmp_path)
    assert damage[0] in COMMAND
    (tmp_path / "7.clauses").write_text(COMMAND.replace(*damage, 1), encoding="utf-8")
    error = failure(tmp_path)
    assert reason in error.reason
    assert (error.path.name, error.line) == ("7.clauses", line)


@given(st.frozensets(FLUENTS, max_size=12))
def test_a_state_survives_printing_and_reading(state: frozenset[Fluent]) -> None:
    assert parse_state(print_state(state)) == state


@given(st.lists(FLUENTS, min_size=1, max_size=6), st.sampled_from([",", ", ", " ", "", " ,  "]))
def test_separators_between_fluents_vary(fluents: list[Fluent], between: str) -> None:
    assert parse_state(between.join(map(str, fluents))) == frozenset(fluents)


@pytest.mark.parametrize("text", ["(a b", "a b)", "(a (b))", "(a b) c", "()", "(a)"])
def test_a_torn_state_is_refused(text: str) -> None:
    with pytest.raises(LineSyntaxError):
        parse_state(text)


@needs_corpus
def test_the_real_corpus_is_read_whole() -> None:
    corpus = read_corpus(REAL)
    assert len(corpus.documents) == 378
    assert sum(len(d.steps) - 1 for d in corpus.documents) == 8082
    assert sum(len(d.clauses) for d in corpus.documents) == 1578
    assert [(o.path.name, o.line) for o in corpus.oddities] == [
        ("195.clauses", 15),
        ("317.clauses", 35),
        ("461.clauses", 25),
    ]

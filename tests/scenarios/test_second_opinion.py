"""A second opinion: frames from a dependency parse, and a parser loaded behind one's back."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterable
from types import SimpleNamespace
from typing import Any

import pytest

from verbteach.experiments.frame_scores import read_commands, score, split
from verbteach.language.agreement import agree
from verbteach.language.grammar import parse
from verbteach.language.notation import write_frames
from verbteach_scenarios.nlp.dependencies import Word, frames_of
from verbteach_scenarios.nlp.second_opinion import (
    NoSecondOpinionError,
    SecondOpinion,
    is_installed,
)

# word/lemma/part of speech/label/head, as a parser for English gives them.
PARSED = {
    "turn/turn/VERB/ROOT/0 the/the/DET/det/2 tv/tv/NOUN/dobj/0 on/on/ADP/prt/0": (
        "turn_on(obj=tv)"
    ),
    "wash/wash/VERB/ROOT/0 and/and/CCONJ/cc/0 dry/dry/VERB/conj/0 the/the/DET/det/4 "
    "plates/plate/NOUN/dobj/2": "wash(obj=plate) && dry(obj=plate)",
    "use/use/VERB/ROOT/0 the/the/DET/det/2 sponge/sponge/NOUN/dobj/0 to/to/PART/aux/4 "
    "wipe/wipe/VERB/xcomp/0 the/the/DET/det/6 table/table/NOUN/dobj/4": (
        "wipe(obj=table; with=sponge)"
    ),
    "could/could/AUX/aux/3 you/you/PRON/nsubj/3 please/please/INTJ/intj/3 take/take/VERB/ROOT/3 "
    "the/the/DET/det/5 trash/trash/NOUN/dobj/3 out/out/ADP/prt/3": "take_out(obj=trash)",
    "do/do/AUX/aux/2 n't/not/PART/neg/2 open/open/VERB/ROOT/2 the/the/DET/det/4 "
    "window/window/NOUN/dobj/2": "not_open(obj=window)",
    "take/take/VERB/ROOT/0 it/it/PRON/dobj/0 out/out/ADP/prep/0 of/of/ADP/prep/2 "
    "the/the/DET/det/5 sink/sink/NOUN/pobj/3": "take(obj=it; out_of=sink)",
    "go/go/VERB/ROOT/0 and/and/CCONJ/cc/0 get/get/VERB/conj/0 the/the/DET/det/4 "
    "mop/mop/NOUN/dobj/2": "get(obj=mop)",
    "put/put/VERB/ROOT/0 it/it/PRON/dobj/0 there/there/ADV/advmod/0": "put(obj=it; loc=there)",
    "put/put/VERB/ROOT/0 it/it/PRON/dobj/0 on/on/ADP/prep/0 top/top/NOUN/pobj/2 of/of/ADP/prep/3 "
    "the/the/DET/det/6 box/box/NOUN/pobj/4": "put(obj=it; on_top_of=box)",
}


def _words(text: str) -> list[Word]:
    rows = (entry.split("/") for entry in text.split())
    return [Word(word, lemma, pos, dep, int(head)) for word, lemma, pos, dep, head in rows]


@pytest.mark.parametrize(("parsed", "expected"), PARSED.items())
def test_frames_from_a_dependency_parse(parsed: str, expected: str) -> None:
    assert write_frames(frames_of(_words(parsed))) == expected


def test_a_recipient_comes_last() -> None:
    parsed = (
        "bring/bring/VERB/ROOT/0 me/I/PRON/dative/0 the/the/DET/det/4 red/red/ADJ/amod/4 "
        "mug/mug/NOUN/dobj/0"
    )
    assert write_frames(frames_of(_words(parsed))) == "bring(obj=mug[red]; to=me)"


def test_nothing_parsed_gives_no_frame() -> None:
    assert frames_of([]) == ()


def _token(text: str, index: int) -> SimpleNamespace:
    head = SimpleNamespace(i=0)
    return SimpleNamespace(text=text, lemma_=text, pos_="VERB", dep_="ROOT", head=head, i=index)


def test_reading_waits_until_the_parser_is_loaded() -> None:
    release = threading.Event()

    def load() -> Callable[[str], Iterable[Any]]:
        release.wait(10)
        return lambda text: [_token(text, 0)]

    opinion = SecondOpinion(load)
    opinion.begin()
    opinion.begin()
    assert not opinion.is_ready
    threading.Timer(0.05, release.set).start()
    assert write_frames(opinion.read("  STOP\x00 ")) == "stop()"
    assert opinion.is_ready
    assert opinion.read("") == ()


def test_a_parser_that_cannot_be_loaded_is_said_once_it_is_needed() -> None:
    def load() -> Callable[[str], Iterable[Any]]:
        raise OSError("no such model")

    opinion = SecondOpinion(load)
    opinion.begin()
    with pytest.raises(NoSecondOpinionError, match="no such model"):
        opinion.read("open the door")


@pytest.mark.skipif(is_installed(), reason="the extra verbteach[nlp] is installed")
def test_without_the_extra_there_is_no_second_opinion() -> None:
    with pytest.raises(NoSecondOpinionError, match="not installed"):
        SecondOpinion().read("open the door")


@pytest.mark.slow
@pytest.mark.skipif(not is_installed(), reason="verbteach[nlp] IS NOT INSTALLED: not compared")
def test_where_both_agree_both_are_right() -> None:
    from tests.language.test_commands import OWN

    with OWN.open(encoding="utf-8") as lines:
        kept, _ = split(read_commands(lines))
    opinion = SecondOpinion()
    shared = [c for c in kept if agree(parse(c.text), opinion.read(c.text))]
    assert len(shared) > 0.5 * len(kept)
    assert score(shared, parse).exact > 0.95

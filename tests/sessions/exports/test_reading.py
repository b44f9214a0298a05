"""From records to dialogues: nothing said is lost, and no time of day gets in."""

from __future__ import annotations

import json
import shutil
from dataclasses import asdict
from pathlib import Path

import pytest

from tests.sessions.corpora import ANNA, MAIL
from tests.sessions.records import first, forge, read_events
from tests.sessions.rooms import babble, begin
from verbteach.dialogue.rewards import Rewards
from verbteach_sessions.branching import branch
from verbteach_sessions.corpus.redactions import Decision, Redactor
from verbteach_sessions.corpus.splits import grouped, member
from verbteach_sessions.errors import LogError
from verbteach_sessions.eventlog import LogReader
from verbteach_sessions.exports.alias import alias, timeless
from verbteach_sessions.exports.dialogue import ROBOT, TEACHER, Dialogue
from verbteach_sessions.exports.reading import read_dialogue
from verbteach_sessions.history import History
from verbteach_sessions.learned import source_from
from verbteach_sessions.transcript import NOTE, transcript


def test_turns_reply_to_each_other_in_order(dialogues: tuple[Dialogue, ...]) -> None:
    for dialogue in dialogues:
        assert [turn.number for turn in dialogue.turns] == list(range(len(dialogue.turns)))
        assert dialogue.turns[0].reply_to is None
        for turn in dialogue.turns[1:]:
            assert turn.reply_to is not None
            screen = dialogue.turns[turn.reply_to]
            assert screen.number < turn.number
            assert screen.speaker != turn.speaker
            assert screen.at <= turn.at


def test_what_was_taken_back_is_marked(dialogues: tuple[Dialogue, ...]) -> None:
    anna = dialogues[0]
    undone = [turn.text for turn in anna.turns if not turn.holds]
    assert undone[0] == "moveto Kettle_1"
    assert len(undone) == 2
    assert "undo" in [turn.kind for turn in anna.turns]
    assert all(turn.holds and turn.spoken for turn in anna.held)


@pytest.mark.parametrize("seed", range(4))
def test_what_holds_is_what_the_transcript_says(tmp_path: Path, seed: int) -> None:
    with begin(tmp_path) as session:
        path = babble(session, seed, 60).path
    history = History()
    for event in LogReader(path):
        history.take(event)
    lines = [line for line in transcript(history, Rewards()) if line.speaker != NOTE]
    expected = [(one.speaker, one.text) for one in lines if one.kind not in ("why", "repeat")]
    held = read_dialogue(path).held
    assert [(turn.speaker, text) for turn in held for text in turn.texts] == expected
    replies = [e for e in read_events(path) if e["type"] == "robot"]
    turns = read_dialogue(path).turns
    assert sum(t.speaker == ROBOT and t.kind == "robot" for t in turns) == len(replies)


def test_commands_are_counted_as_given(dialogues: tuple[Dialogue, ...]) -> None:
    commands = [t.command for t in dialogues[0].turns if t.act_names == ("command",)]
    assert commands == [0, 1]
    learned = next(t for t in dialogues[0].turns if "learned" in t.act_names)
    assert learned.command == 0
    assert dialogues[0].turns[0].command is None


def test_a_dialogue_holds_no_time_of_day(
    corpus: tuple[Path, ...], dialogues: tuple[Dialogue, ...]
) -> None:
    for path, dialogue in zip(corpus, dialogues, strict=True):
        text = json.dumps(asdict(dialogue), default=list)
        created = read_events(path)[0]["data"]["created"]
        for moment in (created, created[:10], path.name, path.name[:8]):
            assert moment not in text
    assert dialogues[0].participant == ANNA


def test_an_alias_is_the_random_part_or_a_digest() -> None:
    assert alias("20260101-120000-abcdefgh") == "abcdefgh"
    other = alias("anna-on-2026-01-01")
    assert "anna" not in other
    assert "2026" not in other
    assert other == alias("anna-on-2026-01-01") != alias("anna-on-2026-01-02")


def test_moments_are_left_out_of_what_is_free_in_form() -> None:
    study = {"id": "s", "created": "2026-01-01T10:00:00+00:00", "days": ["2026-01-01", "1/2"]}
    assert timeless({"study": study}) == {"study": {"id": "s", "days": ["1/2"]}}


def test_half_a_surrogate_pair_becomes_a_sign(tmp_path: Path) -> None:
    with begin(tmp_path) as session:
        path = session.path
    forge(path, lambda events: first(events, "robot")["data"].update(texts=["a\ud800b"]))
    assert read_dialogue(path).turns[0].text == "a?b"


def test_redaction_reaches_every_string(corpus: tuple[Path, ...]) -> None:
    redactor = Redactor([Decision("", "e-mail", MAIL.upper(), "redact")])
    text = json.dumps(asdict(read_dialogue(corpus[0], redactor)), default=list)
    assert MAIL not in text
    assert "[e-mail]" in text
    assert redactor.count >= 2  # as typed and as read


def test_an_act_that_is_none_is_named_by_its_line(tmp_path: Path) -> None:
    with begin(tmp_path) as session:
        path = babble(session, 1, 3).path
    forge(path, lambda events: first(events, "teacher")["data"].update(act={"act": ["x"]}))
    with pytest.raises(LogError, match="line"):
        read_dialogue(path)


def test_the_persons_turns_bear_what_was_on_the_screen(dialogues: tuple[Dialogue, ...]) -> None:
    for turn in dialogues[2].turns:
        if turn.speaker == TEACHER:
            assert turn.reply_to is not None
            screen = dialogues[2].turns[turn.reply_to]
            assert (turn.phase, turn.scene) == (screen.phase, screen.scene)


def test_a_branch_names_its_parent_by_its_alias(corpus: tuple[Path, ...], tmp_path: Path) -> None:
    copy = Path(shutil.copytree(corpus[1], tmp_path / corpus[1].name))
    made = branch(copy, tmp_path, at=3)
    dialogue, whole = read_dialogue(made.path), read_dialogue(copy)
    assert dialogue.parent == (alias(corpus[1].name), 3)
    assert dialogue.id != whole.id
    assert [t.text for t in dialogue.turns] == [t.text for t in whole.turns[:3]]
    assert grouped([member(whole), member(dialogue)]) == [sorted([whole.id, dialogue.id])]


def test_the_content_hash_is_that_of_the_record(
    corpus: tuple[Path, ...], dialogues: tuple[Dialogue, ...]
) -> None:
    for path, dialogue in zip(corpus, dialogues, strict=True):
        assert dialogue.content_hash == source_from(path).content_hash

"""Markdown, asciicast and SVG: well formed whatever was typed, and with every line in them."""

from __future__ import annotations

import io
import json
import re
from dataclasses import replace
from pathlib import Path
from xml.etree import ElementTree

from hypothesis import given
from hypothesis import strategies as st

from tests.sessions.corpora import NASTY
from verbteach_sessions.exports import asciicast, markdown_table, svg_image
from verbteach_sessions.exports.dialogue import Dialogue
from verbteach_sessions.exports.lines import spoken_lines
from verbteach_sessions.exports.markdown_table import escaped
from verbteach_sessions.exports.wrapping import cells, wrapped
from verbteach_sessions.visible import visible

texts = st.text(max_size=300)


@given(texts, st.integers(1, 40))
def test_wrapped_rows_fit_and_lose_nothing(text: str, width: int) -> None:
    shown = visible(text)
    rows = wrapped(shown, width)
    assert all(cells(row) <= max(width, 2) for row in rows)
    assert "".join(rows).replace(" ", "") == shown.replace(" ", "")


@given(texts)
def test_escaped_markdown_has_no_sign_of_its_own(text: str) -> None:
    made = escaped(text)
    bare = re.sub(r"\\[*_\[\]]|&#\d+;", "", made)
    assert not re.search(r"[\\`*_\[\]|<>~@]|&|://|\n|(?i:www\.)", bare)


def test_markdown_is_a_table_with_a_row_a_command(
    tmp_path: Path, dialogues: tuple[Dialogue, ...]
) -> None:
    markdown_table.write(dialogues, tmp_path)
    for dialogue in dialogues:
        lines = (tmp_path / f"{dialogue.id}.md").read_text("utf-8").splitlines()
        rows = [line for line in lines if line.startswith("|")]
        assert rows[:2] == ["| Execution | Learning |", "|---|---|"]
        commands = {turn.command for turn in dialogue.held if turn.command is not None}
        assert len(rows) == 2 + len(commands)
        assert all(row.count("|") == 3 for row in rows)


def test_markdown_numbers_who_speaks_as_the_paper_does(dialogues: tuple[Dialogue, ...]) -> None:
    lines = list(markdown_table.page(dialogues[0]))
    first = next(line for line in lines if line.startswith("| H1"))
    assert first.startswith("| H1: boil the water | R1: I don't know how to boil the water")
    assert "<br>H2: *(moveto Kettle\\_1)*<br>R2: " in first
    labels = re.findall(r"([HR]\d+): ", "".join(lines))
    assert labels[:4] == ["H1", "R1", "H2", "R2"]
    assert len(set(labels)) == len(labels)
    # What the robot learned is used: the second command has an execution beside no learning.
    assert lines[-1].endswith("|  |")


def test_asciicast_is_version_two_with_a_marker_a_turn(
    tmp_path: Path, dialogues: tuple[Dialogue, ...]
) -> None:
    # https://docs.asciinema.org/manual/asciicast/v2/
    asciicast.write(dialogues, tmp_path)
    for dialogue in dialogues:
        text = (tmp_path / f"{dialogue.id}.cast").read_text("utf-8")
        header, *events = map(json.loads, io.StringIO(text))
        assert (header["version"], header["width"], header["height"]) == (2, 100, 30)
        assert set(header) <= {"version", "width", "height", "idle_time_limit", "title"}
        assert all(len(event) == 3 and event[1] in ("o", "m") for event in events)
        times = [event[0] for event in events]
        assert times == sorted(times)
        markers = [event for event in events if event[1] == "m"]
        assert len(markers) == len({line.turn.number for line in spoken_lines(dialogue)})


def test_asciicast_has_no_control_sequences_but_its_own(dialogues: tuple[Dialogue, ...]) -> None:
    nasty = replace(dialogues[0].turns[0], texts=("\x1b]0;title\x07\x1b[2J" + "x" * 300,))
    dialogue = replace(dialogues[0], turns=(nasty,))
    out = "".join(event[2] for event in asciicast._events(dialogue) if event[1] == "o")
    assert set(re.findall(r"\x1b\[[0-9;]*m", out)) == {"\x1b[36m", "\x1b[0m"}
    bare = re.sub(r"\x1b\[[0-9;]*m", "", out)
    assert "\x1b" not in bare
    assert "\x07" not in bare
    assert all(cells(row) <= asciicast.WIDTH for row in bare.split("\r\n"))


def test_svg_is_well_formed_and_says_everything(
    tmp_path: Path, dialogues: tuple[Dialogue, ...]
) -> None:
    svg_image.write(dialogues, tmp_path)
    for dialogue in dialogues:
        root = ElementTree.fromstring((tmp_path / f"{dialogue.id}.svg").read_text("utf-8"))
        tags = {element.tag.rpartition("}")[2] for element in root.iter()}
        assert tags == {"svg", "title", "style", "rect", "text"}
        names = {name for element in root.iter() for name in element.attrib}
        assert not [name for name in names if name.startswith("on") or name.endswith("href")]
        said = "".join(
            element.text or "" for element in root.iter() if element.tag.endswith("text")
        )
        for line in spoken_lines(dialogue):
            assert line.text.replace(" ", "") in said.replace(" ", "")


def test_svg_bubbles_stay_within_the_picture(dialogues: tuple[Dialogue, ...]) -> None:
    root = ElementTree.fromstring(svg_image.picture(dialogues[0]))
    height = float(root.attrib["height"])
    for box in [one for one in root.iter() if one.attrib.get("rx")]:
        left, width = float(box.attrib["x"]), float(box.attrib["width"])
        assert left >= 0
        assert left + width <= svg_image.WIDTH
        assert float(box.attrib["y"]) + float(box.attrib["height"]) <= height


@given(st.lists(texts, min_size=1, max_size=4))
def test_svg_takes_any_text(dialogues: tuple[Dialogue, ...], said: list[str]) -> None:
    turn = replace(dialogues[0].turns[0], texts=tuple(said))
    ElementTree.fromstring(svg_image.picture(replace(dialogues[0], turns=(turn,))))


def test_notes_are_shown_as_they_were_typed(dialogues: tuple[Dialogue, ...]) -> None:
    notes = [line.text for line in spoken_lines(dialogues[0]) if line.speaker == "note"]
    assert notes[-2:] == list(NASTY[:2])

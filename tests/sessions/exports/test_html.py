"""Pages: one file that fetches nothing, and in which typed text can be nothing but text."""

from __future__ import annotations

import base64
import json
import re
import shutil
import subprocess
from dataclasses import replace
from hashlib import sha256
from html.parser import HTMLParser
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.sessions.corpora import NASTY
from tests.sessions.rooms import settings
from verbteach_sessions.exports import html_page
from verbteach_sessions.exports.dialogue import Dialogue
from verbteach_sessions.visible import visible
from verbteach_tui.views.sight import make_depict

TAGS = (
    "html head meta title style body h1 dl div dt dd nav button input output main ol li b em p"
    " aside script"
)
CHROMIUM = shutil.which("chromium") or shutil.which("google-chrome")


class Page(HTMLParser):
    """The elements of a page with their attributes, and the text in each script, style and item."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.tags: set[str] = set()
        self.attributes: list[tuple[str, str | None]] = []
        self.inside: dict[str, list[str]] = {"script": [], "style": [], "p": []}
        self._open: list[str] = []
        self.feed(text)
        self.close()

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.add(tag)
        self.attributes += attrs
        if tag in self.inside:
            self.inside[tag].append("")
            self._open.append(tag)

    def handle_endtag(self, tag: str) -> None:
        if self._open and self._open[-1] == tag:
            self._open.pop()

    def handle_data(self, data: str) -> None:
        if self._open:
            self.inside[self._open[-1]][-1] += data


def check(text: str) -> Page:
    """A page is built of nothing but its own elements, and names no other resource."""
    page = Page(text)
    assert page.tags <= set(TAGS.split())
    names = {name for name, _ in page.attributes}
    assert not [n for n in names if n.startswith("on") or n in ("src", "href", "style")]
    assert len(page.inside["script"]) == 2
    policies = [value for name, value in page.attributes if name == "content" and value]
    policy = next(value for value in policies if "default-src" in value)
    for kind, body in (("style", page.inside["style"][0]), ("script", page.inside["script"][1])):
        digest = base64.b64encode(sha256(body.encode()).digest()).decode()
        assert f"{kind}-src 'sha256-{digest}'" in policy
    assert policy.startswith("default-src 'none'")
    assert "unsafe" not in policy
    return page


def data_of(page: Page) -> Any:
    return json.loads(page.inside["script"][0])


def test_a_page_holds_every_turn(tmp_path: Path, dialogues: tuple[Dialogue, ...]) -> None:
    html_page.write(dialogues, tmp_path, settings, make_depict())
    for dialogue in dialogues:
        page = check((tmp_path / f"{dialogue.id}.html").read_text("utf-8"))
        data = data_of(page)
        assert len(data["turns"]) == len(dialogue.turns)
        assert all(turn["sight"] is not None for turn in data["turns"])
        said = [visible(t) for turn in dialogue.turns for t in turn.texts if t]
        assert [text for text in page.inside["p"] if text.strip()] == said
    index = (tmp_path / "index.html").read_text("utf-8")
    assert re.findall(r'href="([^"]+)"', index) == [f"{d.id}.html" for d in dialogues]


def test_nasty_text_is_text(dialogues: tuple[Dialogue, ...]) -> None:
    page = check(html_page.page(dialogues[0], {}))
    assert NASTY[0] in page.inside["p"]
    assert NASTY[1] in page.inside["p"]


@given(st.lists(st.text(max_size=200), min_size=1, max_size=3))
def test_no_text_breaks_a_page(dialogues: tuple[Dialogue, ...], said: list[str]) -> None:
    turn = replace(
        dialogues[0].turns[0],
        texts=tuple(said),
        verbs_learned=tuple(said),
        beliefs={"grounding": [{"phrase": said[0], "objects": [[said[0], 0.5]]}], "goals": []}
        | {"uncertain": [[said[0], 0.5]]},
        decisions=(
            {
                "candidates": [{"act": {"act": "np_grd_whq", "np": said[0]}, "q": None}],
                "chosen": 0,
                "reason": said[0],
            },
        ),
    )
    page = check(html_page.page(replace(dialogues[0], turns=(turn,)), {}))
    assert data_of(page)["turns"][0]["verbs"] == [visible(text) for text in said]


def test_scenes_show_what_changed(tmp_path: Path, dialogues: tuple[Dialogue, ...]) -> None:
    html_page.write(dialogues[:1], tmp_path, settings, make_depict())
    data = data_of(check((tmp_path / f"{dialogues[0].id}.html").read_text("utf-8")))
    grasped = 1 + next(t.number for t in dialogues[0].turns if t.text == "grasp Kettle_1")
    sight = data["sights"][data["turns"][grasped]["sight"]]
    robot = next(actor for actor in sight["actors"] if actor["label"] == "robot")
    assert [thing["label"] for thing in robot["holds"]] == ["kettle"]
    before = data["sights"][data["turns"][0]["sight"]]
    assert not next(a for a in before["actors"] if a["label"] == "robot")["holds"]


@pytest.mark.slow
def test_a_browser_shows_the_page_and_runs_nothing_typed(
    tmp_path: Path, dialogues: tuple[Dialogue, ...]
) -> None:
    if CHROMIUM is None:
        pytest.skip("no Chromium here to open the page with")
    html_page.write(dialogues[:1], tmp_path, settings, make_depict())
    number = next(t.number for t in dialogues[0].turns if t.text == NASTY[0])
    done = subprocess.run(
        [
            *(
                CHROMIUM,
                "--headless",
                "--no-sandbox",
                "--disable-gpu",
                "--virtual-time-budget=2000",
            ),
            *(f"--user-data-dir={tmp_path / 'profile'}", "--enable-logging=stderr", "--v=0"),
            *("--dump-dom", f"file://{tmp_path}/{dialogues[0].id}.html#{number}"),
        ],
        capture_output=True,
        text=True,
        timeout=120,
        check=True,
    )
    assert "Content Security Policy" not in done.stderr
    assert "CONSOLE" not in done.stderr
    assert f"turn {number} of {len(dialogues[0].turns) - 1}" in done.stdout
    dom = Page(done.stdout)
    assert "img" not in dom.tags
    assert NASTY[0] in dom.inside["p"]
    mind = done.stdout.split('id="sight"')[1]
    assert "kettle" in mind
    assert "boil" in mind.split('id="mind"')[1]

"""The commands that stand in blocks on the pages on records, typed as they are printed.

They are typed in one folder, page after page, where ``my-sessions`` is a small
example corpus. Slow: some of them fit and simulate.
"""

from __future__ import annotations

import re
import shlex
import shutil
from importlib.resources import files
from importlib.util import find_spec
from pathlib import Path

import pytest

from docs.diagrams import ROOT
from tests.tui.commandline import here
from verbteach_sessions.exports.formats import FORMATS
from verbteach_tui.conclusion import CHECK_FAILED, DONE

PAGES = ("collecting-a-corpus", "datasheet", "exports", "teachers-from-records")
SMALL = ("--sessions", "8", "--lessons", "2")
TOLD = "note: on 12.05.1990 I was born\nquit\n"

# A release has parts left to do, and a few sessions say too little about another policy.
MAY_FAIL = {"evaluate-policy", "release"}


def printed(page: str) -> list[list[str]]:
    text = (ROOT / "docs" / f"{page}.md").read_text("utf-8")
    blocks = re.findall(r"^```\n(.*?)^```", text, re.MULTILINE | re.DOTALL)
    exports = re.findall(r"^`(verbteach sessions export [^`]+)`", text, re.MULTILINE)
    lines = [*"".join(blocks).splitlines(), *exports]
    commands = [line for line in dict.fromkeys(lines) if line.startswith("verbteach ")]
    return [shlex.split(line)[1:] for line in commands if "..." not in line]


def installed(form: str) -> bool:
    return all(find_spec(package) is not None for package in FORMATS[form].packages)


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Where the pages have one type: with sessions of one's own, parts of them, and weights."""
    monkeypatch.chdir(tmp_path)
    assert here("sessions", "example", "--out", "my-sessions", *SMALL).status == DONE
    assert here("sessions", "split", "my-sessions", "--out", "splits.json").status == DONE
    shutil.copytree("my-sessions", "example-corpus")
    assert here("teach", "--plain", "--sessions", "my-sessions", typed=TOLD).status == DONE
    weights = files("verbteach_scenarios") / "data" / "weights" / "starting.json"
    Path("weights.json").write_bytes(weights.read_bytes())
    return tmp_path


@pytest.mark.slow
def test_what_stands_on_the_pages_can_be_typed(folder: Path) -> None:
    typed = 0
    for words in (words for page in PAGES for words in printed(page)):
        if not all(installed(word) for word in words if word in FORMATS):
            continue
        small = SMALL if words[:2] == ["sessions", "example"] else ()
        if "--out" in words and not small:  # another page may have made it
            shutil.rmtree(folder / words[words.index("--out") + 1], ignore_errors=True)
        done = here(*words, *small, sessions=folder / "mine")
        may = {DONE, CHECK_FAILED} if MAY_FAIL & set(words) else {DONE}
        assert done.status in may, f"{shlex.join(words)}\n{done.err}"
        typed += 1
    assert typed >= 15

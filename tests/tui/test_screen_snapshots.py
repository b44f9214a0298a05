"""How the screens beside the teaching room look; the sizes, the theme and what they show are fixed.

After a change that is meant to be seen: ``pytest tests/tui --snapshot-update -k snapshots``, and
a look at each picture that changed. What must fit at every size is in ``test_every_screen.py``.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from textual.app import App
from textual.pilot import Pilot
from textual.screen import Screen

from tests.study.files import study
from tests.tui.frames import at_rest
from tests.tui.lab.test_lab import FIGURE, ROW
from tests.tui.room import BOIL_THE_WATER, NARROW, NORMAL, WIDE, options, said
from verbteach_tui import app as app_module
from verbteach_tui.app import VerbteachApp
from verbteach_tui.lab.jobs import COMPARE, Job
from verbteach_tui.lab.lab import Lab
from verbteach_tui.lab.results import save_job, save_rows
from verbteach_tui.options import OpenRecord
from verbteach_tui.screens.help import HelpScreen
from verbteach_tui.screens.lab import LabScreen
from verbteach_tui.screens.verbs import VerbsScreen
from verbteach_tui.study import words
from verbteach_tui.study.app import CONSENT, DONE, StudyApp
from verbteach_tui.study.questionnaire_screen import QuestionnaireScreen
from verbteach_tui.study.reading_screen import ReadingScreen

Compare = Callable[..., bool]
Show = Callable[[Screen[Any], tuple[int, int]], bool]
SHAPE = "{0[0]}x{0[1]}".format


class _Frame(VerbteachApp):
    """The app with nothing on it but one screen, in the study's looks as well."""

    CSS_PATH = str(Path(app_module.__file__).parent / "app.tcss")
    CSS = StudyApp.CSS

    def begin(self) -> None:
        """Nothing of its own."""


@pytest.fixture
def shows(snap_compare: Compare, tmp_path: Path) -> Show:
    """Whether a screen looks in a size as it did."""

    def compare(screen: Screen[Any], size: tuple[int, int]) -> bool:
        app: App[None] = _Frame(options(tmp_path))

        async def before(pilot: Pilot[Any]) -> None:
            await app.push_screen(screen)
            await at_rest(pilot)

        return bool(snap_compare(app, terminal_size=size, run_before=before))

    return compare


@pytest.mark.parametrize("size", [NARROW, WIDE], ids=SHAPE)
def test_the_lab_with_an_earlier_run(shows: Show, tmp_path: Path, size: tuple[int, int]) -> None:
    earlier = tmp_path / "lab" / "20300101-000000-abcdefgh"
    save_job(earlier, Job(kind=COMPARE))
    save_rows(earlier, [ROW, {**ROW, "policy": "rl", "sji": {**FIGURE, "mean": 0.7}}])
    assert shows(LabScreen(Lab(tmp_path / "lab")), size)


@pytest.mark.parametrize("size", [NARROW, NORMAL], ids=SHAPE)
def test_a_consent(shows: Show, size: tuple[int, int]) -> None:
    text = "You teach a robot what verbs mean, for half an hour. " * 12 + "\n\n" + words.ASK_CONSENT
    assert shows(ReadingScreen("A study", "Consent", text, CONSENT), size)


@pytest.mark.parametrize("size", [NARROW, WIDE], ids=SHAPE)
def test_a_questionnaire(shows: Show, size: tuple[int, int]) -> None:
    assert shows(QuestionnaireScreen("A study", study().questionnaire), size)


def test_the_thanks(shows: Show) -> None:
    codes = (words.COMPLETION.format(code="AB-12"), words.WITHDRAWAL.format(code="abcd"))
    assert shows(ReadingScreen("A study", "Thank you", "\n\n".join(codes), DONE), NORMAL)


def test_help(shows: Show) -> None:
    keys = [("y", "yes (in words: yes)"), ("f5, esc", "Back")]
    assert shows(HelpScreen("What this is about, in a sentence or two. " * 4, keys), NARROW)


@pytest.mark.parametrize("size", [NORMAL, WIDE], ids=SHAPE)
def test_the_verbs_of_a_record(
    snap_compare: Compare, tmp_path: Path, size: tuple[int, int]
) -> None:
    record = said(tmp_path, *BOIL_THE_WATER)
    app = VerbteachApp(options(tmp_path, OpenRecord(record)))

    async def before(pilot: Pilot[Any]) -> None:
        await at_rest(pilot)
        await pilot.press("end", "f5")
        assert isinstance(app.screen, VerbsScreen)
        await at_rest(pilot)

    assert snap_compare(app, terminal_size=size, run_before=before)

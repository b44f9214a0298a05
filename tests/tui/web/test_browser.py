"""The app in a real browser: the same log as elsewhere, visitors apart, and the way back."""

from __future__ import annotations

import asyncio
from pathlib import Path
from urllib.parse import parse_qs, urlsplit

import pytest

from tests.study.files import SMALL
from tests.tui.commandline import here
from tests.tui.room import SETTINGS
from tests.tui.study.led import SHOW, study_file
from tests.tui.web.chromium import PROGRAM, Browser, Page, chromium, happens
from tests.tui.web.served import served
from verbteach_sessions.eventlog import LogReader
from verbteach_sessions.lock import in_use
from verbteach_sessions.session import Session
from verbteach_sessions.validate import validate
from verbteach_tui.study.reading_screen import TOO_SOON

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(
        PROGRAM is None, reason="no Chromium here: install Debian's package chromium to test this"
    ),
]
ROOM = "kitchen-1"


def logs(records: Path) -> list[Path]:
    """The sessions of all visitors."""
    return sorted(records.glob("*/*/events.jsonl"))


def robot_turns(log: Path) -> int:
    """How often the robot has spoken."""
    return log.read_bytes().count(b'"type":"robot"')


async def answered(log: Path, turns: int) -> None:
    """Wait for the robot, and for the answer to be on the screen."""
    await happens(lambda: robot_turns(log) >= turns)
    await asyncio.sleep(0.8)  # longer than the guard against words typed as keys


async def teach_to_open(page: Page, log: Path) -> None:
    """The lesson of ``SHOW``, by keys and typed lines."""
    before = robot_turns(log)
    command, *steps, done, right = SHOW
    await page.type(command)
    await answered(log, before + 1)
    await page.shows("don't show it")
    await page.press("/")
    await page.shows("type and press Enter")
    for number, step in enumerate(steps, start=2):
        await page.type(step)
        await answered(log, before + number)
        await page.shows("So far")
    await page.press("escape")
    await page.shows("don't show it")
    await page.press(done[0])
    await answered(log, before + 4)
    await page.shows("Is that the goal?")
    await page.press(right[0])
    await answered(log, before + 5)


async def started(page: Page, records: Path, sessions: int = 1, *, tour: bool = True) -> Path:
    """The newest log, once there are so many."""
    await happens(lambda: len(logs(records)) >= sessions)
    newest = max(logs(records), key=lambda log: log.stat().st_mtime)
    await answered(newest, 1)
    if tour:
        await page.shows("skip the tour")
        await page.press("escape")
    await page.shows("type and press Enter")
    return newest


def plain_hash(folder: Path) -> str:
    """The content of the same lesson in plain lines."""
    words = ("teach", "--plain", "--scene", ROOM, "--policy", "rl", "--sessions", folder, "--json")
    document = here(*words, typed="\n".join([*SHOW, "quit"])).document
    return str(document["content_hash"])


async def test_a_key_script_leaves_the_same_content_as_in_plain_lines(tmp_path: Path) -> None:
    records = tmp_path / "records"
    with served(records) as address:
        async with chromium(tmp_path / "profile") as browser:
            page = await browser.visit(address)
            await page.ready()
            await page.shows("Choose a room")
            await page.press("enter")
            log = await started(page, records)
            await teach_to_open(page, log)
            await page.press("f10")
            await happens(lambda: b'"type":"end"' in log.read_bytes())
    header = next(iter(LogReader(log)))
    assert header.data["interface"] == "browser"
    assert header.data["participant"] == log.parent.parent.name
    assert header.data["terminal"][0] > 80
    assert validate(log.parent, SETTINGS).valid
    with Session.resume(log.parent, SETTINGS) as session:
        assert session.content_hash == plain_hash(tmp_path / "plain")


async def test_visitors_are_kept_apart_and_tokens_let_one_browser_in(tmp_path: Path) -> None:
    records, tokens = tmp_path / "records", tmp_path / "tokens.txt"
    tokens.write_text("first-token-1\nsecond-token\n")
    with served(records, "--tokens", tokens) as address:
        async with chromium(tmp_path / "profile") as browser:
            await refused(browser, address, "not complete")
            await refused(browser, f"{address}?token=another-token", "not complete")
            one = await browser.visit(f"{address}?token=first-token-1")
            other = await browser.visit(f"{address}?token=second-token")
            await one.ready()
            assert "token" not in await one.value("location.href")
            await refused(browser, f"{address}?token=first-token-1", "another browser")
            await one.shows("Choose a room")
            await one.press("enter")
            first = await started(one, records)
            await one.type("open the fridge")
            await answered(first, 2)
            await other.ready()
            await other.shows("Choose a room")
            await other.press("enter")
            second = await started(other, records, 2)
            assert first.parent.parent != second.parent.parent
            assert robot_turns(second) == 1
            await one.reload()
            await one.ready()
            await happens(lambda: b'"type":"resume"' in first.read_bytes())
            await one.shows("don't show it")
            await one.press("/")
            await one.shows("type and press Enter")
            await one.type("go to the fridge")
            await answered(first, 3)
            assert len(logs(records)) == 2
    for log in (first, second):
        assert validate(log.parent, SETTINGS).valid
        kept = {path.name for path in log.parent.parent.iterdir()}
        assert kept == {"ticket.json", "toured", log.parent.name}
        assert "token" not in (log.parent.parent / "ticket.json").read_text().replace('"token"', "")


async def refused(browser: Browser, address: str, word: str) -> None:
    """Somebody is not let in, and told why."""
    page = await browser.visit(address)
    await page.until(f"document.body && document.body.innerText.includes({word!r})")
    assert await page.value("document.querySelector('.textual-terminal')") is None


async def read(page: Page, text: str) -> None:
    """Wait for a text, and for as long as nobody can have read it."""
    await page.shows(text)
    await asyncio.sleep(TOO_SOON)


async def test_a_study_in_a_browser_keeps_nothing_before_consent_and_comes_back(
    tmp_path: Path,
) -> None:
    records = tmp_path / "records"
    study = study_file(tmp_path, SMALL)
    with served(records, "--study", study) as address:
        async with chromium(tmp_path / "profile") as browser:
            page = await browser.visit(address)
            await page.ready()
            assert not records.exists()
            await read(page, "Do you agree")
            await page.press("y")
            await read(page, "Instructions")
            assert list(records.glob("*/ticket.json"))
            await page.press("enter")
            await read(page, "Practice")
            await page.press("enter")
            log = await started(page, records, tour=False)
            await page.type("open the fridge")
            await answered(log, 2)
            await page.reload()
            await page.ready()
            await read(page, "Practice")
            await page.press("enter")
            await happens(lambda: b'"type":"resume"' in log.read_bytes())
            no = await browser.visit(address)
            await no.ready()
            await read(no, "Do you agree")
            await no.press("n")
            await no.until("document.body.classList.contains('-closed')")
    (home,) = [path for path in records.iterdir() if path.is_dir()]
    assert (home / "visit.jsonl").is_file()
    assert next(iter(LogReader(log))).data["study"]["consent"]["answer"] == "yes"


async def test_who_was_with_a_killed_server_goes_on_with_the_next(tmp_path: Path) -> None:
    records = tmp_path / "records"
    async with chromium(tmp_path / "profile") as browser:
        with served(records, killed=True) as address:
            page = await browser.visit(address)
            await page.ready()
            await page.shows("Choose a room")
            await page.press("enter")
            log = await started(page, records)
            await page.type("open the fridge")
            await answered(log, 2)
        await page.until("document.body.classList.contains('-closed')")
        await happens(lambda: not in_use(log.parent))
        with served(records) as address:
            again = await browser.open(address, page.context)
            await again.ready()
            await happens(lambda: b'"type":"resume"' in log.read_bytes())
    assert validate(log.parent, SETTINGS).valid


REMEMBERING = """
    window.sockets = [];
    window.WebSocket = class extends WebSocket {
        constructor(url, ...rest) { super(url, ...rest); window.sockets.push(String(url)); }
    };
"""


async def test_a_narrow_window_has_the_columns_of_the_smallest_layout(tmp_path: Path) -> None:
    with served(tmp_path / "records") as address:
        async with chromium(tmp_path / "profile") as browser:
            page = await browser.visit(address)
            narrow = {"width": 390, "height": 800, "deviceScaleFactor": 1, "mobile": False}
            await page.ask("Emulation.setDeviceMetricsOverride", **narrow)
            await page.ask("Page.addScriptToEvaluateOnNewDocument", source=REMEMBERING)
            await page.value("location.reload()")
            await page.until("!!window.sockets && window.sockets.length > 0")
            query = parse_qs(urlsplit(await page.value("window.sockets[0]")).query)
            assert 60 <= int(query["width"][0]) < 70

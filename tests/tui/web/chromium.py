"""A real Chromium without a window, driven over its DevTools protocol."""

from __future__ import annotations

import asyncio
import base64
import re
import shutil
import subprocess
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager
from itertools import count
from pathlib import Path
from typing import Any

import aiohttp

PROGRAM = shutil.which("chromium") or shutil.which("chromium-browser")
LONGEST = 120.0  # seconds for anything to happen on a busy machine

_ANSI = re.compile(r"\x1b\[[0-9;?]*[A-Za-z]")
_NAMED = {
    "enter": ("Enter", "Enter", 13, "\r"),
    "tab": ("Tab", "Tab", 9, ""),
    "escape": ("Escape", "Escape", 27, ""),
    "f9": ("F9", "F9", 120, ""),
    "f10": ("F10", "F10", 121, ""),
}


class Browser:
    """The whole browser; every :meth:`visit` is somebody else's, with no cookies in common."""

    def __init__(self, socket: aiohttp.ClientWebSocketResponse) -> None:
        self._socket = socket
        self._numbers = count(1)
        self._waiting: dict[int, asyncio.Future[dict[str, Any]]] = {}
        self._pages: dict[str, Page] = {}
        self._reader = asyncio.create_task(self._read())

    async def visit(self, url: str) -> Page:
        """A page in a fresh profile."""
        context = await self.ask("Target.createBrowserContext")
        return await self.open(url, context["browserContextId"])

    async def open(self, url: str, context: str) -> Page:
        """A page in a profile that there is."""
        target = await self.ask("Target.createTarget", url="about:blank", browserContextId=context)
        target_id = target["targetId"]
        joined = await self.ask("Target.attachToTarget", targetId=target_id, flatten=True)
        page = self._pages[joined["sessionId"]] = Page(self, joined["sessionId"], context)
        await page.ask("Network.enable")
        await page.ask("Emulation.setFocusEmulationEnabled", enabled=True)
        await page.ask("Page.enable")
        await page.ask("Page.navigate", url=url)
        return page

    async def ask(self, method: str, session: str = "", **parameters: Any) -> dict[str, Any]:
        """Send a command and wait for its result."""
        number = next(self._numbers)
        self._waiting[number] = asyncio.get_running_loop().create_future()
        message: dict[str, Any] = {"id": number, "method": method, "params": parameters}
        if session:
            message["sessionId"] = session
        await self._socket.send_json(message)
        return await asyncio.wait_for(self._waiting[number], LONGEST)

    async def close(self) -> None:
        """Stop listening."""
        self._reader.cancel()
        await self._socket.close()

    async def _read(self) -> None:
        async for message in self._socket:
            if message.type is not aiohttp.WSMsgType.TEXT:
                continue
            data = message.json()
            if data.get("method") == "Network.webSocketFrameReceived":
                self._pages[data["sessionId"]].receive(data["params"]["response"])
            waiting = self._waiting.pop(data.get("id", 0), None)
            if waiting is None or waiting.done():
                continue
            if "error" in data:
                waiting.set_exception(RuntimeError(str(data["error"])))
            else:
                waiting.set_result(data["result"])


class Page:
    """One page, in the profile ``context``."""

    def __init__(self, browser: Browser, session: str, context: str) -> None:
        self.browser, self._session, self.context = browser, session, context
        self._painted = ""

    def receive(self, frame: dict[str, Any]) -> None:
        """Something came for the terminal in the page."""
        if frame["opcode"] == 2:
            self._painted += base64.b64decode(frame["payloadData"]).decode("utf-8", "replace")

    async def shows(self, text: str) -> None:
        """Wait until the terminal has been told to paint ``text`` since this was last asked."""
        await happens(lambda: text in _ANSI.sub("", self._painted))
        self._painted = ""
        await asyncio.sleep(0.3)

    async def ask(self, method: str, **parameters: Any) -> dict[str, Any]:
        """Send a command about this page."""
        return await self.browser.ask(method, self._session, **parameters)

    async def value(self, script: str) -> Any:
        """What a script comes to."""
        result = await self.ask("Runtime.evaluate", expression=script, returnByValue=True)
        return result["result"].get("value")

    async def text(self) -> str:
        """The text of the page, the terminal's apart."""
        return str(await self.value("document.body ? document.body.innerText : ''"))

    async def until(self, script: str) -> None:
        """Wait until a script comes to something true."""
        for _ in range(int(LONGEST / 0.1)):
            try:
                if await self.value(script):
                    return
            except RuntimeError:  # the page is being exchanged
                pass
            await asyncio.sleep(0.1)
        raise AssertionError(f"never: {script}; the page says {await self.text()!r}")

    async def ready(self) -> None:
        """Wait until the app has painted, and keys go to it without a click."""
        await self.until("document.body && document.body.classList.contains('-first-byte')")
        await self.until(
            "document.activeElement === document.querySelector('.xterm-helper-textarea')"
        )

    async def press(self, *keys: str) -> None:
        """Press keys, by name or by the character they type."""
        for key in keys:
            name, code, number, text = _NAMED.get(key, (key, "", ord(key[0].upper()), key))
            fields = {"key": name, "code": code, "windowsVirtualKeyCode": number}
            await self.ask("Input.dispatchKeyEvent", type="keyDown", text=text, **fields)
            await self.ask("Input.dispatchKeyEvent", type="keyUp", **fields)
            await asyncio.sleep(0.02)

    async def type(self, text: str) -> None:
        """Type a line."""
        await self.press(*text, "enter")

    async def reload(self) -> None:
        """As the button of the browser does; answers once the old page is gone."""
        await self.value("window.before = true")
        self._painted = ""
        await self.ask("Page.reload")
        await self.until("!window.before")


@asynccontextmanager
async def chromium(profile: Path) -> AsyncIterator[Browser]:
    """A browser, for as long as it is needed."""
    assert PROGRAM is not None
    words = [
        *(PROGRAM, "--headless=new", "--no-sandbox", "--disable-gpu", "--no-first-run"),
        *("--disable-dev-shm-usage", "--window-size=1400,900", "--remote-debugging-port=0"),
        *(f"--user-data-dir={profile}", "about:blank"),
    ]
    process = subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    try:
        port = profile / "DevToolsActivePort"
        await happens(lambda: port.exists() and len(port.read_text().split()) == 2)
        number, path = port.read_text().split()
        async with aiohttp.ClientSession() as web:
            url = f"ws://127.0.0.1:{number}{path}"
            socket = await web.ws_connect(url, max_msg_size=0)
            browser = Browser(socket)
            yield browser
            await browser.close()
    finally:
        process.terminate()
        process.wait(20)


async def happens(there: Callable[[], object]) -> None:
    """Wait until something is so."""
    for _ in range(int(LONGEST / 0.1)):
        if there():
            return
        await asyncio.sleep(0.1)
    raise AssertionError("it never happened")

"""The server: lets visitors in at the door, and joins each browser to a process of its own.

textual-serve brings the terminal in the page and speaks to the process; who may
come in, and that nobody gets into somebody else's, is seen to here.
"""

from __future__ import annotations

import asyncio
import logging
import signal
import sys
from contextlib import suppress
from pathlib import Path
from urllib.parse import urlsplit

import aiohttp_jinja2
import jinja2
from aiohttp import web
from aiohttp.web_runner import GracefulExit
from textual_serve.app_service import AppService
from textual_serve.server import Server, to_int

from verbteach_tui.web.tokens import Door, RefusedError, Visitor
from verbteach_tui.web.visits import Visits

PAGE = Path(__file__).parent / "page"
COOKIE = "verbteach"
FULL = "There are as many people here as there is room for. Please try again in a while."
LOST = "Please open the link that you were given once more."
HEADERS = {
    "Content-Security-Policy": (
        "default-src 'none'; script-src 'self'; style-src 'self' 'unsafe-inline'; "
        "img-src 'self' data:; font-src 'self' data:; connect-src 'self'; "
        "frame-ancestors 'none'; base-uri 'none'; form-action 'none'"
    ),
    "Referrer-Policy": "no-referrer",
    "X-Content-Type-Options": "nosniff",
    "Cache-Control": "no-store",
}
_SMALLEST, _LARGEST = 20, 500
_QUITTING = 10.0  # seconds that a process may take to leave before it is ended


class VisitorServer(Server):
    """Serves the app to visitors; ``most`` of them at once."""

    def __init__(
        self, door: Door, visits: Visits, host: str, port: int, title: str, most: int
    ) -> None:
        super().__init__("", host=host, port=port, title=title)
        self._door, self._visits, self._most = door, visits, most
        self._here: dict[str, AppService] = {}
        self._turns: dict[str, asyncio.Lock] = {}

    def make_app(self) -> web.Application:
        """The web application, for a runner of one's own."""
        app = web.Application()
        loader = jinja2.FileSystemLoader(PAGE)
        aiohttp_jinja2.setup(app, loader=loader, autoescape=True)
        app.add_routes(
            [
                web.get("/", self.handle_visit),
                web.get("/ws", self.handle_websocket),
                web.static("/static", self.statics_path),
                web.static("/page", PAGE),
            ]
        )
        app.on_shutdown.append(self.on_shutdown)
        return app

    async def _make_app(self) -> web.Application:
        return self.make_app()

    def serve(self, debug: bool = False) -> None:
        """Serve until interrupted. Raises ``OSError`` where the port cannot be had."""
        logging.basicConfig(level=logging.WARNING, stream=sys.stderr)
        loop = asyncio.new_event_loop()
        for name in (signal.SIGINT, signal.SIGTERM):
            loop.add_signal_handler(name, self.request_exit)
        with suppress(GracefulExit):
            web.run_app(
                self.make_app(),
                host=self.host,
                port=self.port,
                loop=loop,
                handle_signals=False,
                access_log=None,  # its lines would hold the tokens
                print=lambda *_: None,
            )

    async def on_shutdown(self, app: web.Application) -> None:
        """Let every visitor's process leave in good order."""
        await asyncio.gather(*(_left(service) for service in list(self._here.values())))

    # ---- the page

    async def handle_visit(self, request: web.Request) -> web.StreamResponse:
        """The page, for whoever may come in."""
        token = request.query.get("token", "")
        try:
            visitor = self._door.enter(token, request.cookies.get(COOKIE, ""))
        except RefusedError as error:
            return self._message(request, str(error), web.HTTPForbidden.status_code)
        # The token leaves the address bar, so that nobody copies it from there.
        response = web.HTTPSeeOther("./") if token else self._page(request)
        response.headers.update(HEADERS)
        response.set_cookie(
            COOKIE,
            visitor.secret,
            max_age=60 * 24 * 3600,
            httponly=True,
            samesite="Lax",
            secure=_is_https(request),
        )
        return response

    def _page(self, request: web.Request) -> web.StreamResponse:
        font_size = min(max(to_int(request.query.get("fontsize", "16"), 16), 6), 60)
        context = {"title": self.title, "font_size": font_size}
        return aiohttp_jinja2.render_template("index.html", request, context)

    def _message(self, request: web.Request, message: str, status: int) -> web.StreamResponse:
        context = {"title": self.title, "message": message}
        response = aiohttp_jinja2.render_template("message.html", request, context, status=status)
        response.headers.update(HEADERS)
        return response

    # ---- the connection

    async def handle_websocket(self, request: web.Request) -> web.WebSocketResponse:
        """Join the browser to the visitor's process; an older one of theirs leaves first."""
        visitor = self._door.known(request.cookies.get(COOKIE, ""))
        if visitor is None or not _from_here(request):
            raise web.HTTPForbidden(text=LOST, headers=HEADERS)
        if visitor.code not in self._here and len(self._here) >= self._most:
            raise web.HTTPServiceUnavailable(text=FULL, headers=HEADERS)
        socket = web.WebSocketResponse(heartbeat=15)
        await socket.prepare(request)
        size = _size(request, "width"), _size(request, "height")
        service = await self._joined(visitor, socket, size)
        try:
            await self._process_messages(socket, service)
        finally:
            await self._part(visitor, service)
        return socket

    async def _joined(
        self, visitor: Visitor, socket: web.WebSocketResponse, size: tuple[int, int]
    ) -> AppService:
        """The visitor's process, started once an older one of theirs has let go of the record."""

        async def close() -> None:
            await socket.close()

        async with self._turns.setdefault(visitor.code, asyncio.Lock()):
            older = self._here.get(visitor.code)
            if older is not None:
                await _left(older)
                await older.remote_close()
            service = AppService(
                self._visits.command(visitor),
                write_bytes=socket.send_bytes,
                write_str=socket.send_str,
                close=close,
                download_manager=self.download_manager,
            )
            self._here[visitor.code] = service
            await service.start(*size)
            return service

    async def _part(self, visitor: Visitor, service: AppService) -> None:
        await _left(service)
        if self._here.get(visitor.code) is service:
            del self._here[visitor.code]


async def _left(service: AppService) -> None:
    """Wait until the process has gone; it is ended where it does not go by itself."""
    process = service._process
    with suppress(Exception):
        await asyncio.wait_for(asyncio.shield(service.stop()), _QUITTING)
    if process is None:
        return
    with suppress(TimeoutError):
        await asyncio.wait_for(process.wait(), _QUITTING)
    if process.returncode is None:
        with suppress(ProcessLookupError):
            process.kill()
        await process.wait()


def _from_here(request: web.Request) -> bool:
    """Whether the page that wants to connect is this server's own."""
    origin = request.headers.get("Origin", "")
    wanted = request.headers.get("X-Forwarded-Host", request.host)
    return urlsplit(origin).netloc == wanted


def _is_https(request: web.Request) -> bool:
    return request.headers.get("X-Forwarded-Proto", request.scheme) == "https"


def _size(request: web.Request, name: str) -> int:
    default = 80 if name == "width" else 24
    return min(max(to_int(request.query.get(name, ""), default), _SMALLEST), _LARGEST)

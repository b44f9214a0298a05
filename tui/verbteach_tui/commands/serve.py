"""`verbteach serve`: the same app in a browser, one process a visitor."""

from __future__ import annotations

import ipaddress
from importlib.util import find_spec
from pathlib import Path
from typing import Annotated

import typer

from verbteach_tui.commands.parameters import ScenesFolder, SessionsFolder, ThemeOption
from verbteach_tui.commands.streams import note
from verbteach_tui.conclusion import WrongUseError
from verbteach_tui.near import known

HOST, PORT, MOST = "127.0.0.1", 8000, 20
TITLE = "verbteach"


def serve(
    host: Annotated[str, typer.Option(metavar="HOST", help="Where to listen.")] = HOST,
    port: Annotated[
        int, typer.Option(min=0, max=65535, metavar="N", help="The port; 0 takes a free one.")
    ] = (PORT),
    tokens: Annotated[
        Path | None,
        typer.Option(metavar="FILE", help="Let in who has one of these single-use tokens."),
    ] = None,
    study: Annotated[
        Path | None, typer.Option(metavar="FILE", help="Lead every visitor through this study.")
    ] = None,
    sessions: SessionsFolder = None,
    scenes: ScenesFolder = None,
    theme: ThemeOption = None,
    most: Annotated[
        int, typer.Option(min=1, max=1000, metavar="N", help="People at a time.")
    ] = MOST,
) -> None:
    """Serve the app to browsers: one process and one folder a visitor, until Ctrl-C.

    A visitor whose connection breaks comes back to where they were. Without
    tokens everybody on this machine may come in, and nobody from elsewhere.
    """
    if find_spec("textual_serve") is None:
        raise WrongUseError("serving needs the extra verbteach[web], which is not installed")
    if tokens is None and not is_local(host):
        raise WrongUseError(f"--host {host}: others can reach that, so --tokens is needed")
    from verbteach_scenarios.scenes import scene_ids
    from verbteach_sessions.catalogue import default_folder
    from verbteach_tui.installation import is_writable
    from verbteach_tui.web.server import VisitorServer
    from verbteach_tui.web.tokens import Door, read_tokens
    from verbteach_tui.web.visits import Visits

    if theme is not None:
        from verbteach_tui.themes import THEMES

        known(theme, [one.name for one in THEMES], "theme")
    folder = (sessions or default_folder()).absolute()
    if not is_writable(folder):
        raise WrongUseError(f"{folder}: sessions cannot be kept there")
    scene_ids(scenes)  # Whoever comes would find no scene where there is no such folder.
    title = _title(study, scenes)
    door = Door(folder, None if tokens is None else read_tokens(tokens))
    visits = Visits(folder, _absolute(study), _absolute(scenes), theme)
    port = port or _free_port(host)
    server = VisitorServer(door, visits, host, port, title, most)
    shown = f"[{host}]" if ":" in host else host
    note(f"serving on http://{shown}:{port}/{'?token=TOKEN' if tokens else ''}  (Ctrl-C ends it)")
    note(f"records go to {folder}, a folder a visitor")
    server.serve()


def is_local(host: str) -> bool:
    """Whether only this machine can reach ``host``."""
    try:
        return ipaddress.ip_address(host).is_loopback
    except ValueError:
        return host == "localhost"


def _absolute(path: Path | None) -> Path | None:
    return None if path is None else path.absolute()


def _title(study: Path | None, scenes: Path | None) -> str:
    """The study's title; its file is checked before anybody comes. Raises ``StudyFileError``."""
    if study is None:
        return TITLE
    from verbteach_tui.commands.study import read

    return read(study, scenes).title


def _free_port(host: str) -> int:
    import socket

    family = socket.AF_INET6 if ":" in host else socket.AF_INET
    with socket.socket(family, socket.SOCK_STREAM) as probe:
        probe.bind((host, 0))
        return int(probe.getsockname()[1])

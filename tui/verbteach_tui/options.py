"""What the app is started with. Knows no Textual, so that the command line can build it cheaply."""

from __future__ import annotations

from collections.abc import Callable, Collection
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, TypeAlias

if TYPE_CHECKING:
    from verbteach.dialogue.setting import Settings
    from verbteach.world.scene import Scene
    from verbteach_sessions.session import Session
    from verbteach_tui.keymap import Keymap


@dataclass(frozen=True)
class OpenHome:
    """Start on the home screen."""


@dataclass(frozen=True)
class OpenNew:
    """Start teaching at once, in a new session in this scene; ``command`` is said first, if any."""

    scene: str
    command: str = ""


@dataclass(frozen=True)
class OpenSession:
    """Start teaching at once, in the session in this folder."""

    path: Path


@dataclass(frozen=True)
class OpenRecord:
    """Play back the session in this folder, from event ``at`` on.

    ``speed`` is in turns a second; 0 stands still.
    """

    path: Path
    at: int = 0
    speed: float = 0.0


Opening: TypeAlias = OpenHome | OpenNew | OpenSession | OpenRecord


@dataclass(frozen=True)
class AppOptions:
    """What the app needs from the command line.

    ``settings`` makes a scene ready and ``scenes`` lists the ids there are, in
    the order to show. ``create`` begins a session in the scene of that id, with
    whatever noise, policy, seed, participant and earlier session the command
    line named; ``resume`` opens a session's folder. Both run in a worker thread
    and may raise; the app then says why and goes on. ``load`` opens a scene
    only to look at it, where that is cheaper than ``settings``. ``sessions`` is the folder
    whose sessions the home screen offers. ``speed`` is in executed steps per
    second (0: all at once). ``theme`` is a theme's name, ``None`` the default.
    ``keymap`` are the person's own keys. The tour is shown by itself where there
    is no file ``toured`` yet (``None``: never), and the file is made. ``take_part``
    leads through the study in a file, by a code, once this app is gone (``None``: not here);
    ``kinds`` names the kinds of fluents there are, which a study's noise may speak of.
    """

    settings: Settings
    scenes: Callable[[], tuple[str, ...]]
    create: Callable[[str], Session]
    resume: Callable[[Path], Session]
    sessions: Path
    load: Callable[[str], Scene] | None = None
    opening: Opening = field(default_factory=OpenHome)
    speed: float = 2.0
    theme: str | None = None
    keymap: Keymap | None = None
    toured: Path | None = None
    take_part: Callable[[Path, str | None], int] | None = None
    kinds: Callable[[], Collection[str]] | None = None

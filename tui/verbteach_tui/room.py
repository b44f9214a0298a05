"""The full screen, opened with what the command line named."""

from __future__ import annotations

import sys
from dataclasses import replace
from functools import partial
from pathlib import Path

from verbteach_sessions.places import at_home
from verbteach_tui.beginning import Beginning
from verbteach_tui.options import AppOptions, OpenHome, Opening
from verbteach_tui.terminal import in_browser


def full_screen(
    beginning: Beginning, opening: Opening | None = None, theme: str | None = None
) -> int:
    """Run the app, with the person's own keys; the exit status. Raises ``KeymapError``."""
    from verbteach_tui.app import run_app
    from verbteach_tui.keymap import keys_file, read_keymap

    keymap = read_keymap(keys_file())
    options = app_options(beginning, opening or OpenHome(), theme)
    take_part = None if in_browser() else partial(_take_part, beginning, theme)
    return run_app(replace(options, keymap=keymap, toured=_toured(beginning), take_part=take_part))


def _take_part(beginning: Beginning, theme: str | None, file: Path, code: str | None) -> int:
    from verbteach_tui.study.taking_part import ways

    return ways(replace(beginning, participant=code), file, theme, sys.stdout)["app"]()


def _toured(beginning: Beginning) -> Path:
    """The file that says that the tour was offered once; each visitor has one of their own."""
    if in_browser():
        return beginning.folder / "toured"
    from platformdirs import user_state_path

    with at_home():
        return user_state_path("verbteach") / "toured"


def app_options(
    beginning: Beginning, opening: Opening, theme: str | None = None, speed: float = 2.0
) -> AppOptions:
    """What the app is started with."""
    return AppOptions(
        settings=beginning.setting,
        scenes=beginning.scene_ids,
        create=beginning.create,
        resume=beginning.resume,
        sessions=beginning.folder,
        load=beginning.scene,
        kinds=beginning.fluent_kinds,
        opening=opening,
        speed=speed,
        theme=theme,
    )

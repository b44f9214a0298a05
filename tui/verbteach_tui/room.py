"""The full screen, opened with what the command line named."""

from __future__ import annotations

from verbteach_tui.beginning import Beginning
from verbteach_tui.options import AppOptions, OpenHome, Opening


def full_screen(
    beginning: Beginning, opening: Opening | None = None, theme: str | None = None
) -> int:
    """Run the app; the exit status."""
    from verbteach_tui.app import run_app

    return run_app(app_options(beginning, opening or OpenHome(), theme))


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
        opening=opening,
        speed=speed,
        theme=theme,
    )

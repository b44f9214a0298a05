"""The user guide's pictures: a lesson played in the running app, a picture at each point.

Run ``python docs/screenshots.py`` after changing a screen; it writes
``docs/images/*.svg``. No terminal is needed.
"""

from __future__ import annotations

import asyncio
import re
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

from textual.pilot import Pilot

from verbteach_scenarios.scenes import load_scene, scene_ids
from verbteach_scenarios.settings import make_settings
from verbteach_sessions.driving import ScriptTeacher, drive
from verbteach_sessions.header import Header
from verbteach_sessions.session import Session
from verbteach_tui.app import VerbteachApp
from verbteach_tui.keyguard import KeyGuard
from verbteach_tui.options import AppOptions, OpenHome, Opening, OpenNew, OpenRecord
from verbteach_tui.screens.teach import TeachScreen
from verbteach_tui.widgets.command_input import CommandInput

IMAGES = Path(__file__).parent / "images"
WIDE, NORMAL, NARROW = (120, 40), (80, 24), (60, 20)

BOIL = (
    "boil the water",
    "go to the kettle",
    "take the kettle",
    "go to the left burner",
    "set the kettle on the left burner",
    "go to the left knob",
    "turn the left knob",
)


RECORDED = (
    "command: wash the mug",
    "object: Mug_2",
    "skip",
    "command: boil the water",
    "do: moveto Kettle_1",
    "do: grasp Kettle_1",
    "do: moveto Burner_1",
    "do: set-on Kettle_1 Burner_1",
)


class Step(NamedTuple):
    """Type ``line``, else press ``key``; then take the picture ``shot``, if it has a name.

    ``phase`` is what the robot must wait for afterwards, where that matters.
    """

    line: str = ""
    key: str = ""
    shot: str = ""
    phase: str = ""


class Scenario(NamedTuple):
    """A lesson in one size; ``scene`` is empty for the home screen.

    Where ``recorded`` are the lines of a script, what they make is played back.
    """

    size: tuple[int, int]
    scene: str
    steps: tuple[Step, ...]
    recorded: tuple[str, ...] = ()


SCENARIOS = (
    Scenario(WIDE, "", (Step(shot="home"),)),
    Scenario(
        WIDE,
        "kitchen-1",
        (
            Step("wash the mug", shot="question"),
            Step(key="s"),
            Step(key="s"),
            *(Step(line) for line in BOIL[:-1]),
            Step(BOIL[-1], shot="demonstrate"),
            Step("done", shot="read-back"),
            Step(key="y"),
            Step("scene: kitchen-3"),
            Step("boil the water", phase="judgement"),
            Step(key="space"),
            *(Step(key="right") for _ in range(3)),
            Step(key="right", shot="watch"),
            Step(key="e", shot="teach"),
            Step(key="g"),
            Step(key="f5", shot="verbs"),
        ),
    ),
    Scenario(
        WIDE,
        "kitchen-1",
        (*(Step(key="right") for _ in range(6)), Step(key="right", shot="replay")),
        RECORDED,
    ),
    Scenario(NORMAL, "kitchen-1", (*(Step(line) for line in BOIL), Step(shot="teach-80x24"))),
    Scenario(NARROW, "kitchen-1", (Step("wash the mug", shot="teach-60x20"),)),
)


async def play(scenario: Scenario, folder: Path) -> dict[str, str]:
    """Play a scenario; its pictures as SVG, by name."""
    settings = make_settings()
    opening: Opening = OpenNew(scenario.scene) if scenario.scene else OpenHome()
    if scenario.recorded:
        with Session.create(folder, Header.new(scenario.scene), settings) as session:
            drive(session, ScriptTeacher(scenario.recorded))
        opening = OpenRecord(session.path)
    app = VerbteachApp(
        AppOptions(
            settings,
            scene_ids,
            lambda scene: Session.create(folder, Header.new(scene, interface="app"), settings),
            lambda path: Session.resume(path, settings),
            folder,
            load_scene,
            opening,
            speed=0.5,
        )
    )
    shots: dict[str, str] = {}
    async with app.run_test(size=scenario.size) as pilot:
        await _settled(pilot)
        for step in scenario.steps:
            await _do(pilot, step)
            _check(pilot, step)
            if step.shot:
                shots[step.shot] = _portable(app.export_screenshot(title="verbteach"))
    app.close_sessions()
    return shots


async def _do(pilot: Pilot[None], step: Step) -> None:
    screen = pilot.app.screen
    if isinstance(screen, TeachScreen):
        screen.guard = KeyGuard(0.0, 0.0)
    if step.line:
        line = screen.query_one(CommandInput)
        line.focus()
        line.value = step.line
    if step.line or step.key:
        await pilot.press(step.key or "enter")
    await _settled(pilot)


def _check(pilot: Pilot[None], step: Step) -> None:
    screen = pilot.app.screen
    if step.phase and isinstance(screen, TeachScreen):
        phase = screen.snapshot.phase.value
        if phase != step.phase:
            raise SystemExit(f"after {step.line or step.key!r} the robot waits for {phase}")


async def _settled(pilot: Pilot[None]) -> None:
    """Wait until no worker runs and all that they did is drawn."""
    for _ in range(600):
        await pilot.pause(0.02)
        screen = pilot.app.screen
        thinking = isinstance(screen, TeachScreen) and screen.thinking
        if not thinking and not any(worker.is_running for worker in pilot.app.workers):
            break
    await pilot.pause(0.2)


def _portable(svg: str) -> str:
    """Without the fonts that the picture would fetch from elsewhere."""
    return re.sub(r"@font-face \{.*?\}\s*", "", svg, flags=re.DOTALL).replace(
        "Fira Code", "DejaVu Sans Mono, Menlo, Consolas"
    )


def main(names: Sequence[str]) -> None:
    """Write the pictures, or those of them that ``names`` says."""
    IMAGES.mkdir(exist_ok=True)
    for scenario in SCENARIOS:
        with tempfile.TemporaryDirectory() as folder:
            for name, svg in asyncio.run(play(scenario, Path(folder))).items():
                if not names or name in names:
                    (IMAGES / f"{name}.svg").write_text(svg, encoding="utf-8")


if __name__ == "__main__":
    main(sys.argv[1:])

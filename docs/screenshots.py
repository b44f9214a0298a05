"""The guides' pictures: a lesson played in the running app, a picture at each point.

Run ``python docs/screenshots.py`` after changing a screen, with the names of
pictures for those alone; it writes ``docs/images/*.svg``. No terminal is needed.
"""

from __future__ import annotations

import asyncio
import sys
import tempfile
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import NamedTuple

sys.path.insert(0, str(Path(__file__).parent.parent))

from docs.played import Step, do, picture, settled
from docs.study_screenshots import TAKING_PART, in_the_lab, take_part
from verbteach_scenarios.settings import make_settings
from verbteach_sessions.driving import ScriptTeacher, drive
from verbteach_sessions.header import Header
from verbteach_sessions.session import Session
from verbteach_tui.app import VerbteachApp
from verbteach_tui.beginning import Beginning, Choices
from verbteach_tui.options import OpenHome, Opening, OpenNew, OpenRecord
from verbteach_tui.room import app_options

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


class Scenario(NamedTuple):
    """A lesson in one size; ``scene`` is empty for the home screen.

    Where ``recorded`` are the lines of a script, what they make is played back.
    ``policy`` is the question policy, where it is not the one that teaching begins with.
    """

    size: tuple[int, int]
    scene: str
    steps: tuple[Step, ...]
    recorded: tuple[str, ...] = ()
    policy: str | None = None


SCENARIOS = (
    Scenario(WIDE, "", (Step(shot="home"),)),
    Scenario(WIDE, "kitchen-1", (Step("wash the mug", shot="question"),), policy="she16"),
    Scenario(
        WIDE,
        "kitchen-1",
        (
            *(Step(line) for line in BOIL[:-1]),
            Step(BOIL[-1], shot="demonstrate"),
            Step("done", phase="learning"),
            Step(key="y", shot="read-back", phase="read_back"),
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
    Scenario(NARROW, "kitchen-1", (Step("wash the mug", shot="teach-60x20"),), policy="she16"),
)


async def play(scenario: Scenario, folder: Path) -> dict[str, str]:
    """Play a scenario; its pictures as SVG, by name."""
    opening: Opening = OpenNew(scenario.scene) if scenario.scene else OpenHome()
    if scenario.recorded:
        with Session.create(folder, Header.new(scenario.scene), make_settings()) as session:
            drive(session, ScriptTeacher(scenario.recorded))
        opening = OpenRecord(session.path)
    beginning = Beginning(folder, "app", choices=Choices(policy=scenario.policy))
    app = VerbteachApp(app_options(beginning, opening, speed=0.5))
    shots: dict[str, str] = {}
    async with app.run_test(size=scenario.size) as pilot:
        await settled(pilot)
        for step in scenario.steps:
            await do(pilot, step)
            if step.shot:
                shots[step.shot] = picture(app)
    app.close_sessions()
    return shots


async def everything(folder: Path, names: Sequence[str]) -> dict[str, str]:
    """All pictures, or those of ``names``, by name; whatever is played lies in ``folder``."""
    shots: dict[str, str] = {}
    for number, scenario in enumerate(SCENARIOS):
        if _is_wanted((step.shot for step in scenario.steps), names):
            shots |= await play(scenario, folder / f"sessions-{number}")
    if _is_wanted((step.shot for step in TAKING_PART), names):
        shots |= await take_part(folder)
    if _is_wanted(("lab",), names):
        shots |= await in_the_lab(folder)
    return {name: svg for name, svg in shots.items() if not names or name in names}


def _is_wanted(shots: Iterable[str], names: Sequence[str]) -> bool:
    return not names or not set(names).isdisjoint(shots)


def main(names: Sequence[str]) -> None:
    """Write the pictures, or those of them that ``names`` says."""
    IMAGES.mkdir(exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:
        for name, svg in asyncio.run(everything(Path(folder), names)).items():
            (IMAGES / f"{name}.svg").write_text(svg, encoding="utf-8")


if __name__ == "__main__":
    main(sys.argv[1:])

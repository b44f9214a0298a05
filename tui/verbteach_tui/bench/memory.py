"""How much memory the app holds after many turns, measured in a process of its own.

`python -m verbteach_tui.bench.memory FOLDER TURNS SECONDS` runs the app without a
screen, lets the simulated teacher teach in it, and prints megabytes.
"""

from __future__ import annotations

import asyncio
import resource
import sys
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

from verbteach_tui.bench.allowance import Allowance
from verbteach_tui.bench.apart import measured_apart, tell

SIZE = (120, 40)
PATIENCE = 0.005  # seconds between looks whether the robot has answered


def app_memory(
    folder: Path,
    turns: int,
    seconds: float,
    done: Callable[[int], None],
    without: Sequence[str] = (),
) -> dict[str, Any] | None:
    """``mb`` that the app holds after ``turns``, fewer where the seconds run out before.

    ``half_mb`` is what it held after half of the turns it was to take, ``None`` where it took
    fewer. No answer where the app does not run.
    """
    words = (str(folder), str(turns), str(seconds))
    return measured_apart("verbteach_tui.bench.memory", words, seconds, done, without)


def resident_mb() -> float:
    """What this process holds now, or where that is not told the most it ever held."""
    status = Path("/proc/self/statm")
    if status.is_file():
        pages = int(status.read_text("utf-8").split()[1])
        return pages * resource.getpagesize() / 2**20
    unit = 1 if sys.platform == "darwin" else 1024
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * unit / 2**20


async def run(folder: Path, turns: int, allowance: Allowance) -> dict[str, Any]:
    """Teach in the app for as long as there are turns and time; what it then holds."""
    from verbteach.dialogue.simulated import SimulatedTeacher, seeded_order
    from verbteach_scenarios.lessons import load_lessons
    from verbteach_tui.app import VerbteachApp
    from verbteach_tui.beginning import Beginning
    from verbteach_tui.options import OpenNew
    from verbteach_tui.room import app_options
    from verbteach_tui.screens.speaking import SpeakingScreen

    beginning = Beginning(folder, "app", "simulated")
    order = seeded_order(load_lessons(), turns, 1)
    teacher = SimulatedTeacher(order, beginning.setting)
    app = VerbteachApp(app_options(beginning, OpenNew(order[0].scene), speed=0.0))
    number, half = 0, None
    async with app.run_test(size=SIZE):
        while number < turns and not allowance.over():
            while not isinstance(app.screen, SpeakingScreen) or app.screen.thinking:
                await asyncio.sleep(PATIENCE)
            session = app.screen.teaching.session
            act = teacher.reply(session.turn, session.robot.state)
            if act is None:
                break
            app.screen.say(act, "", "simulated")
            number += 1
            if number % 20 == 0:
                tell(number)
            if number == turns // 2:
                half = resident_mb()
            await asyncio.sleep(PATIENCE)
        held = resident_mb()
    app.close_sessions()
    return {"mb": held, "turns": number, "half_mb": half}


if __name__ == "__main__":
    folder, turns, seconds = sys.argv[1:]
    tell(asyncio.run(run(Path(folder), int(turns), Allowance(float(seconds)))))

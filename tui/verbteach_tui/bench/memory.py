"""How much memory the app holds after many turns, measured in a process of its own.

`python -m verbteach_tui.bench.memory FOLDER TURNS` runs the app without a
screen, lets the simulated teacher teach in it, and prints megabytes.
"""

from __future__ import annotations

import asyncio
import resource
import subprocess
import sys
from pathlib import Path

SIZE = (120, 40)
PATIENCE = 0.005  # seconds between looks whether the robot has answered


def app_rss_mb(folder: Path, turns: int) -> float | None:
    """Resident megabytes of the app after ``turns`` turns; ``None`` where it did not get there."""
    words = [sys.executable, "-m", "verbteach_tui.bench.memory", str(folder), str(turns)]
    done = subprocess.run(words, capture_output=True, text=True, check=False)
    return float(done.stdout) if done.returncode == 0 else None


def resident_mb() -> float:
    """What this process holds now, or where that is not told the most it ever held."""
    status = Path("/proc/self/statm")
    if status.is_file():
        pages = int(status.read_text("utf-8").split()[1])
        return pages * resource.getpagesize() / 2**20
    unit = 1 if sys.platform == "darwin" else 1024
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * unit / 2**20


async def run(folder: Path, turns: int) -> float:
    """Teach ``turns`` turns in the app; resident megabytes afterwards."""
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
    async with app.run_test(size=SIZE):
        for _ in range(turns):
            while not isinstance(app.screen, SpeakingScreen) or app.screen.thinking:
                await asyncio.sleep(PATIENCE)
            session = app.screen.teaching.session
            act = teacher.reply(session.turn, session.robot.state)
            if act is None:
                break
            app.screen.say(act, "", "simulated")
            await asyncio.sleep(PATIENCE)
        held = resident_mb()
    app.close_sessions()
    return held


if __name__ == "__main__":
    print(asyncio.run(run(Path(sys.argv[1]), int(sys.argv[2]))))

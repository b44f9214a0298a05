"""Scenes made ready for the robot: loaded, grounded and given a planner, each once."""

from __future__ import annotations

from functools import cache
from pathlib import Path

from verbteach.dialogue.setting import Setting, Settings
from verbteach.language.agreement import SecondReader
from verbteach.world.planner import PlannerConfig, make_planner
from verbteach.world.task import Task
from verbteach_scenarios.lexicon_file import load_lexicon
from verbteach_scenarios.scenes import load_scene

# A goal without a plan is given up within a second or two on the plain path; no goal of a
# bundled lesson needs more.
_INTERACTIVE = PlannerConfig(expansions=500)


def make_settings(folder: Path | None = None, second: SecondReader | None = None) -> Settings:
    """Settings for the scenes in ``folder``, or for the bundled ones; each is prepared once.

    ``second`` is there in every scene for whoever wants a second reading.
    The function it answers raises ``UnknownSceneError`` and ``WorldFileError``.
    """

    @cache
    def setting(scene_id: str) -> Setting:
        scene = load_scene(scene_id, folder)
        task = Task.from_scene(scene)
        return Setting(scene, task, make_planner(task, _INTERACTIVE), load_lexicon(folder), second)

    return setting

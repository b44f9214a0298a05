"""Studies for tests: a small one, and changes of it."""

from __future__ import annotations

from pathlib import Path

from verbteach_scenarios.scenes import scene_ids
from verbteach_sessions.study.design import Study
from verbteach_sessions.study.study_file import parse_study

SMALL = """
[study]
id = "small"
title = "A small study"
seed = 7
consent = "Do you agree?"
instructions = "Teach."
thanks = "Thank you."

[practice]
[[practice.task]]
scene = "kitchen-1"
text = "Open the fridge."

[lessons]
questions = 2
[[lessons.task]]
scene = "kitchen-1"
text = "Open the fridge."
[[lessons.task]]
scene = "kitchen-2"
text = "Open the fridge there."

[[condition]]
id = "showing"
policy = "she16"
panels = ["scene"]

[[condition]]
id = "asking"
policy = "manual"

[questionnaire]
"""

SCENES = scene_ids()


def study(text: str = SMALL) -> Study:
    """The study that ``text`` says."""
    return parse_study(text.encode(), Path("study.toml"), SCENES)

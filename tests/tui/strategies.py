"""Texts, rows and walks through scenes, for property tests of what is shown."""

from __future__ import annotations

import numpy as np
from hypothesis import strategies as st

from verbteach.dialogue.setting import Setting
from verbteach.world.fluents import State
from verbteach.world.simulator import applicable, apply
from verbteach_tui.views.rows import STYLES, Span

NASTY = (
    "[bold red]boil[/] [@click=app.quit]x[/]",
    "\x1b[31mred\x1b[0m \x1b]0;title\x07",
    "null\x00 bell\x07 back\x08 return\r line\n tab\t delete\x7f c1\x9b",
    "right\u202eto left, joined\u200dhere, soft\u00adhyphen, \ufeffmark",
    "日本語のコマンド、やかん 🫖👩‍👩‍👧",
    "e" + "\u0301" * 50,
    "{0} %s \\ ' \" ` $HOME",
    "x" * 10_000,
    "   ",
)
"""What people, and those who test programs, type."""


def texts() -> st.SearchStrategy[str]:
    """Any text, the nasty ones often."""
    return st.one_of(st.text(max_size=80), st.sampled_from(NASTY))


def spans() -> st.SearchStrategy[list[Span]]:
    """Spans of visible text in any style."""
    words = st.text(
        alphabet=st.one_of(st.sampled_from("ab cde  fg"), st.sampled_from("日本語·✱")), max_size=30
    )
    return st.lists(st.builds(Span, words, st.sampled_from(STYLES)), max_size=6)


def walk(setting: Setting, steps: int, seed: int) -> list[State]:
    """States along a random walk of applicable actions, the initial one first."""
    rng = np.random.default_rng(seed)
    states = [setting.scene.initial]
    for _ in range(steps):
        actions = applicable(setting.task, states[-1])
        states.append(apply(setting.task, states[-1], actions[rng.integers(len(actions))]))
    return states

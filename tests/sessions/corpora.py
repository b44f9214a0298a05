"""A small corpus for tests: two people, one of whom types nasty things, and a simulated teacher."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.sessions.rooms import babble, begin, recorded

ANNA, BEN = "k7m2xq9fhd", "p3w8rt5vnz"
MAIL = "anna.b@example.org"
NASTY = (
    "</script><script>alert(1)</script><img src=x onerror=alert(2)>",
    '=HYPERLINK("http://evil.example/","x") | pipe & `code` **bold** <!-- c --> ]]>',
    "\x1b[31mred\x07 \u202eoverride \u2028 line \ud800 half",
)
BY_ANNA = f"""\
command: boil the water
note: write to {MAIL} or call +49 151 23456789
do: moveto Kettle_1
undo
do: moveto Kettle_1
do: grasp Kettle_1
why
do: moveto Burner_1
do: put-on Kettle_1 Burner_1
do: moveto StoveKnob_1
do: turn StoveKnob_1
done
good
flag
note: {NASTY[0]}
note: {NASTY[1]}
scene: kitchen-3
command: boil the water
"""
BY_BEN = """\
command: boil the water
do: moveto StoveKnob_1
do: turn StoveKnob_1
done
good
"""


_made: list[tuple[Path, ...]] = []


def small_corpus(folders: pytest.TempPathFactory) -> tuple[Path, ...]:
    """Three sessions: Anna's, Ben's, and one by a program. Made once for all tests; read only."""
    if not _made:
        _made.append(_make(folders.mktemp("corpus")))
    return _made[0]


def _make(folder: Path) -> tuple[Path, ...]:
    anna = recorded(folder, BY_ANNA, teacher="human", participant=ANNA)
    ben = recorded(folder, BY_BEN, teacher="human", participant=BEN)
    with begin(folder, teacher="simulated") as session:
        program = babble(session, 5, 40).path
    return anna, ben, program

"""A small corpus folder that tests write and damage, and where the real one lies."""

from __future__ import annotations

import os
from collections.abc import Iterable, Sequence
from pathlib import Path

import pytest

SHARED = Path(os.environ.get("VERBTEACH_SHARED", Path(__file__).parents[3] / "shared"))
REAL = SHARED / "data" / "tell-me-dave"

needs_corpus = pytest.mark.skipif(
    not REAL.is_dir(),
    reason=f"THE REAL CORPUS IS ABSENT: no folder {REAL}; set VERBTEACH_SHARED",
)

OBJECTS = (
    "(Robot:) (Sink:IsPlaceableOn) (Counter_1:IsPlaceableOn) (SinkKnob:IsTurnable) "
    "(Mug_1:IsGraspable,IsPourable) (Bowl_1:IsGraspable)"
)
MARKS = "(IsGraspable Mug_1),(IsGraspable Bowl_1)"
FILLING = (
    ("(On Mug_1 Counter_1)", "moveto Mug_1"),
    ("(On Mug_1 Counter_1), (Near Robot Mug_1)", "grasp Mug_1"),
    ("(Grasping Robot Mug_1)", "moveto Sink"),
    ("(Grasping Robot Mug_1),(Near Robot Sink)", "keep Mug_1 On Sink"),
    ("(On Mug_1 Sink),(Near Robot Sink)", "turn SinkKnob"),
    (
        "(On Mug_1 Sink),(Near Robot Sink),(state SinkKnob TapIsOn),(state Mug_1 Water)",
        "wait",
    ),
    ("(On Mug_1 Sink),(Near Robot Sink),(state SinkKnob TapIsOn),(state Mug_1 Water)", ""),
)
"""A mug is put into the sink and the tap turned on."""

CLAUSES = (
    (0, 3, "Put the cup\nin the sink", "Put", "(cup,Mug_1) (cup,Bowl_1) (sink,Sink)"),
    (4, 5, "and fill it", "fill", "(it,Mug_1)"),
    (6, 5, "thanks", "thanks", ""),
)


def trace_text(steps: Sequence[tuple[str, str]], objects: str = OBJECTS, marks: str = MARKS) -> str:
    blocks = [
        f"<start step >{i}\nEnv: {marks},{fluents}\nInstruction: {words}\n<end step >{i}\n"
        for i, (fluents, words) in enumerate(steps)
    ]
    return "\n".join([f"Obj list:  {objects}\n", *blocks])


def clauses_text(clauses: Iterable[tuple[int, int, str, str, str]]) -> str:
    blocks = [
        f"<start clause>\nstart env: {start}\nend env: {end}\nsent: {sentence}\n"
        f"clause dscr: {verb} [   cup |   sink | relation: (2, 2){{ cup x  sink -> in}} ]\n"
        f"words: {verb} cup sink in\nverb: {verb}\narg mapping: {mapping}\n<end clause>\n"
        for start, end, sentence, verb, mapping in clauses
    ]
    return "\n".join(["entire sentence: Put the cup\nin the sink and fill it\n", *blocks])


def write_document(
    folder: Path,
    name: str = "7",
    *,
    steps: Sequence[tuple[str, str]] = FILLING,
    clauses: Iterable[tuple[int, int, str, str, str]] = CLAUSES,
    objects: str = OBJECTS,
    marks: str = MARKS,
) -> Path:
    """Write both files of a document; return the folder."""
    (folder / f"{name}.instenv").write_text(trace_text(steps, objects, marks), encoding="utf-8")
    (folder / f"{name}.clauses").write_text(clauses_text(clauses), encoding="utf-8")
    return folder

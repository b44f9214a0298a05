from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

from tests.scenarios.tell_me_dave_folder import FILLING, REAL, needs_corpus, write_document
from verbteach_scenarios.tell_me_dave.check import BenchmarkReport, check_corpus
from verbteach_scenarios.tell_me_dave.errors import CorpusError
from verbteach_scenarios.tell_me_dave.reach import ReachKind
from verbteach_scenarios.tell_me_dave.transitions import DifferenceKind


def test_a_sound_document_is_reproduced_and_reached(tmp_path: Path) -> None:
    told: list[tuple[str, int, int]] = []
    report = check_corpus(write_document(tmp_path), lambda *stage: told.append(stage))
    assert (report.documents, report.clauses, report.instances) == (1, 3, 2)
    assert (report.verbs, report.noun_phrases, report.environments) == (2, 2, 1)
    assert report.transitions == 6
    assert report.reproduced == 1.0
    assert (report.sji, report.exact) == (1.0, 1.0)
    assert (report.length.mean, report.length.min, report.length.max) == (3.0, 2, 4)
    assert report.cleaned.mean == 2.5
    assert told == [("reading", 1, 1), ("running", 1, 1), ("planning", 1, 2), ("planning", 2, 2)]


def test_a_folder_that_cannot_be_read_is_an_error(tmp_path: Path) -> None:
    with pytest.raises(CorpusError):
        check_corpus(tmp_path)


@pytest.mark.parametrize(
    ("before", "words", "after", "kind", "reason"),
    [
        ("(Near Robot Sink)", "keep Mug_1 On Sink", "", DifferenceKind.EMPTY_HANDED, "Grasping"),
        ("", "turn SinkKnob", "", DifferenceKind.ELSEWHERE, "Near Robot Sink"),
        ("(Near Robot Sink)", "grasp Sink", "", DifferenceKind.UNKNOWN, "IsGraspable"),
        ("", "dance Mug_1", "", DifferenceKind.UNKNOWN, "dance"),
        ("", "moveto Sink", "(On Mug_1 Sink)", DifferenceKind.EFFECT, "effects"),
        (
            "(Grasping Robot Mug_1),(Grasping Robot Spoon_9)",
            "scoop Spoon_9 Mug_1",
            "(state Spoon_9 ScoopsLeft)",
            DifferenceKind.UNMET,
            "ScoopsLeft",
        ),
    ],
)
def test_what_differs_is_listed_with_its_kind(
    *, tmp_path: Path, before: str, words: str, after: str, kind: DifferenceKind, reason: str
) -> None:
    marks = "(IsGraspable Mug_1),(IsGraspable Spoon_9),(IsScoopable Spoon_9)"
    steps = [(before, words), (after, "")]
    report = check_corpus(write_document(tmp_path, steps=steps, clauses=(), marks=marks))
    (one,) = report.differences
    assert (one.document, one.step, one.action, one.kind) == ("7", 0, words, kind)
    assert reason in one.reason
    assert report.reproduced == 0.0


def test_a_difference_names_both_changes(tmp_path: Path) -> None:
    steps = [("(Near Robot Mug_1)", "moveto Sink"), ("(On Mug_1 Sink)", "")]
    report = check_corpus(write_document(tmp_path, steps=steps, clauses=()))
    document = json.loads(json.dumps(report.to_json()))
    assert document["differences"] == [
        {
            "document": "7",
            "step": 0,
            "action": "moveto Sink",
            "expected": ["+(On Mug_1 Sink)", "-(Near Robot Mug_1)"],
            "got": ["+(Near Robot Sink)"],
            "kind": "effect",
            "reason": "its effects differ",
        }
    ]
    assert document["reachable"] == {"sji": 0.0, "exact": 0.0, "kinds": {}}


def reached(folder: Path, start: int, end: int) -> list[tuple[ReachKind, float]]:
    clauses = [(start, end, "go on", "go", "(cup,Mug_1)")]
    report = check_corpus(write_document(folder, clauses=clauses))
    return [(one.kind, round(one.sji, 3)) for one in report.reached]


def test_how_plans_come_out_is_told_apart(tmp_path: Path) -> None:
    assert reached(tmp_path, 0, 3) == [(ReachKind.EXACT, 1.0)]
    assert reached(tmp_path, 5, 5) == [(ReachKind.NOTHING_CHANGED, 0.0)]


def test_what_the_demonstrator_let_go_stays_in_the_planners_hand(tmp_path: Path) -> None:
    steps = [
        *FILLING[:2],
        ("(Grasping Robot Mug_1)", "release Mug_1"),
        ("", ""),
    ]
    clauses = [(0, 2, "take the cup off", "take", "(cup,Mug_1)")]
    report = check_corpus(write_document(tmp_path, steps=steps, clauses=clauses))
    (one,) = report.reached
    assert one.kind is ReachKind.LEFT_IN_HAND
    assert [str(literal) for literal in one.surplus] == ["(Grasping Robot Mug_1)"]
    assert one.sji == 0.5


def test_a_tap_that_was_turned_off_again_is_left_on(tmp_path: Path) -> None:
    steps = [*FILLING[:5], (FILLING[5][0], "turn SinkKnob")]
    steps.append(("(On Mug_1 Sink),(Near Robot Sink),(state Mug_1 Water)", ""))
    clauses = [(0, 5, "fill the cup", "fill", "(cup,Mug_1)")]
    report = check_corpus(write_document(tmp_path, steps=steps, clauses=clauses))
    assert [one.kind for one in report.reached] == [ReachKind.LEFT_ON]


def test_what_no_action_brings_about_has_no_plan(tmp_path: Path) -> None:
    steps = [("(On Mug_1 Sink)", "wait"), ("(On Sink Mug_1)", "")]
    clauses = [(0, 0, "turn the world over", "turn", "(cup,Mug_1)")]
    report = check_corpus(write_document(tmp_path, steps=steps, clauses=clauses))
    assert [one.kind for one in report.reached] == [ReachKind.NO_PLAN]
    assert report.sji == 0.0


@pytest.fixture(scope="module")
def real() -> BenchmarkReport:
    return check_corpus(REAL)


@needs_corpus
@pytest.mark.slow
def test_the_real_corpus_is_reproduced(real: BenchmarkReport) -> None:
    assert real.transitions == 8082
    assert real.reproduced >= 0.995
    assert {one.kind for one in real.differences} == {DifferenceKind.EMPTY_HANDED}


@needs_corpus
@pytest.mark.slow
def test_the_real_changes_are_reached(real: BenchmarkReport) -> None:
    assert len(real.reached) == real.instances == 786
    assert real.sji >= 0.94
    assert real.exact >= 0.85
    assert not [one for one in real.reached if one.kind is ReachKind.NO_PLAN]


@needs_corpus
@pytest.mark.slow
def test_the_report_does_not_depend_on_hash_order(tmp_path: Path, real: BenchmarkReport) -> None:
    for name in ("1", "5", "33", "39"):
        for suffix in (".instenv", ".clauses"):
            (tmp_path / f"{name}{suffix}").write_bytes((REAL / f"{name}{suffix}").read_bytes())
    code = (
        "import sys, json, pathlib;"
        "from verbteach_scenarios.tell_me_dave.check import check_corpus;"
        "r = check_corpus(pathlib.Path(sys.argv[1])); print(json.dumps(r.to_json()), r.reached)"
    )
    outputs = {
        subprocess.run(
            [sys.executable, "-c", code, str(tmp_path)],
            env={"PYTHONHASHSEED": seed},
            capture_output=True,
            check=True,
            text=True,
        ).stdout
        for seed in ("0", "1", "2")
    }
    assert len(outputs) == 1

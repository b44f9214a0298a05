"""What goes wrong is put down to one cause, and the causes add up."""

from __future__ import annotations

from dataclasses import replace

import pytest

from tests.experiments.shelves import grounds
from verbteach.experiments.evaluation import run_trials
from verbteach.experiments.folds import Fold
from verbteach.experiments.jobs import Setup
from verbteach.experiments.mishaps import Kind, analyse, cause, markdown
from verbteach.experiments.she16 import VARIANTS

SETUP = Setup(VARIANTS["she16"], development=2)


@pytest.mark.parametrize(
    ("own", "best", "grounded", "goal", "kind"),
    [
        (0.8, 0.8, 0.8, 0.8, Kind.PLANNING),
        (0.2, 0.3, 0.2, 1.0, Kind.NO_CANDIDATE),
        (0.2, 1.0, 1.0, 1.0, Kind.GROUNDING),
        (0.2, 1.0, 0.3, 1.0, Kind.CHOICE),
        (0.5, 1.0, 0.5, 0.9, Kind.CHOICE),
    ],
)
def test_the_step_that_lost_most_is_the_cause(
    own: float, best: float, grounded: float, goal: float, kind: Kind
) -> None:
    assert cause(own, best, grounded, goal) is kind


def test_mishaps_and_successes_are_all_commands() -> None:
    analysis = analyse(grounds(), SETUP)
    trials = run_trials(grounds(), SETUP)
    wrong = {trial.instance for trial in trials if trial.score.sji < 1}
    assert {one.instance.id for one in analysis.mishaps} == wrong
    mean = sum(trial.score.sji for trial in trials) / len(trials)
    assert sum(map(analysis.lost, Kind)) == pytest.approx(1 - mean)
    text = markdown(analysis)
    assert f"| exactly the demonstrated change | {len(trials) - len(wrong)} | |" in text


def test_what_the_corpus_got_wrong_is_told_from_what_the_robot_did() -> None:
    fold = grounds().folds[0]
    first, second, *rest = fold.test
    idle = replace(first, end=first.start, verb="linger")
    elsewhere = replace(second, candidates=(("Lamp_1",),), phrases=("lamp",), grounding=("Lamp_1",))
    new = replace(rest[0], verb="frob", actions=rest[0].actions)
    odd = Fold(fold.name, fold.train, (idle, elsewhere, new))
    analysis = analyse(replace(grounds(), folds=(odd,)), SETUP)
    kinds = {one.instance.id: one.kind for one in analysis.mishaps}
    assert kinds[first.id] is Kind.NOTHING_CHANGED
    assert kinds[second.id] is Kind.MISALIGNED
    assert kinds.get(new.id, Kind.UNSEEN_VERB) is Kind.UNSEEN_VERB

"""`train`: weights from the command line, small ones."""

from __future__ import annotations

from pathlib import Path
from typing import get_args

import pytest

from tests.docs.test_commands import documented_keys, keys
from tests.scenarios.tell_me_dave_folder import OBJECTS, write_document
from tests.tui.commandline import assert_refused, here
from verbteach.experiments.interactive_training import LEARNERS
from verbteach_scenarios.weights import load_weights
from verbteach_tui.commands.train import LearnerName


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    made = tmp_path / "corpus"
    made.mkdir()
    for number in range(3):
        write_document(made, str(number))
        write_document(made, str(10 + number), objects=f"{OBJECTS} (Plate_1:IsGraspable)")
    return made


def test_every_learner_can_be_named() -> None:
    assert set(get_args(LearnerName)) == {"lspi", *LEARNERS}


@pytest.mark.parametrize("learner", get_args(LearnerName))
def test_a_small_one_is_trained_anew(learner: str, folder: Path, tmp_path: Path) -> None:
    out = tmp_path / "weights.json"
    words = ("--data", folder, "--episodes", 12, "--noise", "std3", "--learner", learner)
    document = here("train", *words, "--out", out, "--json").document
    assert document["episodes"] == 24
    assert document["weights"] == str(out)
    assert document["questions"] >= 0
    assert -100 < document["mean_return"] <= 100
    weights = load_weights(out)
    assert weights.learner == learner
    assert any(weights.execution.values)
    assert set(weights.covariances) == (
        {"execution", "learning"} if learner in {"lspi", "bayesian"} else set()
    )
    assert set(keys(document)) <= documented_keys("train")


def test_equal_seeds_give_equal_weights(folder: Path, tmp_path: Path) -> None:
    paths = [tmp_path / name for name in ("a.json", "b.json", "c.json")]
    for seed, path in zip((1, 1, 2), paths, strict=True):
        ran = here("train", "--data", folder, "--episodes", 12, "--seed", seed, "--out", path)
        assert ran.status == 0
        assert "execution" in ran.out
    same, again, other = (path.read_bytes() for path in paths)
    assert same == again
    assert same != other


def test_wrong_use_is_said_in_a_line(folder: Path, tmp_path: Path) -> None:
    out = ("--out", tmp_path / "weights.json")
    assert_refused(here("train", "--data", tmp_path / "none", *out), "none")
    assert_refused(here("train", "--data", folder, "--out", tmp_path / "no" / "w.json"), "no such")
    assert_refused(here("train", "--data", folder, "--out", tmp_path), "is a folder")
    assert_refused(here("train", tmp_path, *out), "named after --from")
    assert_refused(here("train", "--noise", "fog", *out), "fog", "perfect")
    assert_refused(here("train", "--learner", "magic", *out), "magic")
    assert_refused(here("train", "--data", folder, "--from", tmp_path, *out), "--from")
    both = ("--from", tmp_path / "one", tmp_path / "two")
    assert_refused(here("train", "--data", folder, *both, *out), "--from")
    assert not (tmp_path / "weights.json").exists()

from __future__ import annotations

import json
from pathlib import Path

import pytest

from verbteach.policy.linear import LinearPolicy
from verbteach.policy.weights_file import EXECUTION, LEARNING
from verbteach_scenarios.weights import (
    STARTING,
    WeightsFileError,
    load_weights,
    save_weights,
    starting_weights,
)


def test_the_starting_weights_fit_this_programs_features() -> None:
    weights = starting_weights()
    assert weights.execution.space == EXECUTION
    assert weights.learning.space == LEARNING
    assert LinearPolicy(weights.execution).weights.values != (0.0,) * len(EXECUTION.names)
    assert set(weights.covariances) == {"execution", "learning"}
    assert weights.training["source"] == "bundled lessons"


def test_weights_are_written_whole(tmp_path: Path) -> None:
    path = tmp_path / "weights.json"
    save_weights(path, starting_weights())
    assert load_weights(path) == starting_weights()
    assert [one.name for one in tmp_path.iterdir()] == ["weights.json"]


def test_a_file_for_other_features_is_refused_with_its_name(tmp_path: Path) -> None:
    data = json.loads(STARTING.read_text(encoding="utf-8"))
    data["phases"]["execution"]["features"][0] = "charm"
    path = tmp_path / "old.json"
    path.write_text(json.dumps(data), encoding="utf-8")
    with pytest.raises(WeightsFileError, match=r"old\.json.*charm"):
        load_weights(path)


@pytest.mark.parametrize("content", [b"{", b"\xff\xfe", b"[]", b"{}"])
def test_what_is_no_file_of_weights_is_refused(tmp_path: Path, content: bytes) -> None:
    path = tmp_path / "broken.json"
    path.write_bytes(content)
    with pytest.raises(WeightsFileError, match=r"broken\.json"):
        load_weights(path)

from __future__ import annotations

import json
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from verbteach.policy.linear import Weights
from verbteach.policy.weights_file import EXECUTION, LEARNING, Matrix, PolicyWeights, WeightsError

REAL = st.floats(allow_nan=False, allow_infinity=False)


def values(size: int) -> st.SearchStrategy[tuple[float, ...]]:
    return st.lists(REAL, min_size=size, max_size=size).map(tuple)


def identity(size: int) -> Matrix:
    return tuple(tuple(float(i == j) for j in range(size)) for i in range(size))


@st.composite
def policy_weights(draw: st.DrawFn) -> PolicyWeights:
    spread = draw(st.booleans())
    return PolicyWeights(
        Weights(EXECUTION, draw(values(len(EXECUTION.names)))),
        Weights(LEARNING, draw(values(len(LEARNING.names)))),
        draw(st.sampled_from(["lspi", "sarsa"])),
        {"gamma": 0.99},
        {"seed": 0},
        {"execution": identity(len(EXECUTION.names))} if spread else {},
    )


def document() -> dict[str, Any]:
    zero = PolicyWeights(Weights.zero(EXECUTION), Weights.zero(LEARNING), "lspi")
    read: dict[str, Any] = json.loads(json.dumps(zero.to_json()))
    return read


@given(policy_weights())
def test_weights_survive_a_file(weights: PolicyWeights) -> None:
    assert PolicyWeights.from_json(json.loads(json.dumps(weights.to_json()))) == weights


def test_the_files_order_of_features_does_not_matter() -> None:
    data = document()
    names = data["phases"]["execution"]["features"]
    size = len(names)
    data["phases"]["execution"] = {
        "features": names[::-1],
        "weights": [float(size - 1 - i) for i in range(size)],
        "covariance": [[float(10 * i + j) for j in range(size)] for i in range(size)],
    }
    read = PolicyWeights.from_json(data)
    assert read.execution.values == tuple(map(float, range(size)))
    matrix = read.covariances["execution"]
    assert matrix[0][1] == 10 * (size - 1) + (size - 2)


def test_weights_for_other_features_are_refused_by_name() -> None:
    data = document()
    data["phases"]["learning"]["features"][0] = "charm"
    with pytest.raises(WeightsError, match=r"charm.*learning.*verbteach train"):
        PolicyWeights.from_json(data)


@pytest.mark.parametrize(
    ("change", "reason"),
    [
        ({"format": "letters"}, "no file of policy weights"),
        ({"version": 99}, "version 99"),
        ({"phases": 3}, "'phases'"),
        ({"training": []}, "'training'"),
        ({"promises": []}, "'promises'"),
        ({"promises": {"sureness": {"charm": 1.0}}}, "'promises'.*other features.*train"),
    ],
)
def test_what_is_no_weights_is_said(change: dict[str, Any], reason: str) -> None:
    with pytest.raises(WeightsError, match=reason):
        PolicyWeights.from_json({**document(), **change})
    with pytest.raises(WeightsError, match="JSON"):
        PolicyWeights.from_json([1])


@pytest.mark.parametrize("bad", [[1.0], "text", [True] * len(EXECUTION.names)])
def test_every_feature_needs_one_number(bad: object) -> None:
    data = document()
    data["phases"]["execution"]["weights"] = bad
    with pytest.raises(WeightsError, match="a number for each feature"):
        PolicyWeights.from_json(data)


def test_numbers_are_finite() -> None:
    data = document()
    data["phases"]["execution"]["weights"][3] = float("nan")
    with pytest.raises(WeightsError, match="finite"):
        PolicyWeights.from_json(data)


def test_a_spread_is_square() -> None:
    data = document()
    data["phases"]["learning"]["covariance"] = [[1.0]]
    with pytest.raises(WeightsError, match="a row for each feature"):
        PolicyWeights.from_json(data)

"""What training leaves behind: the weights of both question policies, as plain JSON values.

Feature names travel with the weights, because a weight means nothing without
the feature it is for. Reading refuses a file made for other features. Knows no
file system.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, TypeAlias

from verbteach.dialogue import execution_inquiry, learning_inquiry
from verbteach.policy.calibration import Calibrations
from verbteach.policy.linear import FeatureSpace, Weights
from verbteach.policy.sureness import FEATURES as SURE_BY

EXECUTION = FeatureSpace(tuple(execution_inquiry.FEATURES))
LEARNING = FeatureSpace(tuple(learning_inquiry.FEATURES))
SPACES: Mapping[str, FeatureSpace] = {"execution": EXECUTION, "learning": LEARNING}
"""The features of each phase."""

FORMAT, VERSION = "verbteach policy weights", 1

Matrix: TypeAlias = tuple[tuple[float, ...], ...]
"""Rows of a square matrix, one row and one column a feature."""


class WeightsError(ValueError):
    """A document of weights does not fit; the message says what is wrong with it."""


@dataclass(frozen=True)
class PolicyWeights:
    """The weights of both phases, and where they come from.

    ``covariances`` has a phase's posterior spread (features x features) where
    the learner keeps one; the weights are its mean. ``parameters`` are the
    learner's, ``training`` says on what and how well it learned. All of it is
    plain JSON. ``calibrations`` are what promises rest on, where there are any.
    """

    execution: Weights
    learning: Weights
    learner: str
    parameters: Mapping[str, Any] = field(default_factory=dict)
    training: Mapping[str, Any] = field(default_factory=dict)
    covariances: Mapping[str, Matrix] = field(default_factory=dict)
    calibrations: Calibrations | None = None

    def to_json(self) -> dict[str, Any]:
        """The document; ``from_json`` reads it."""
        promises = {} if self.calibrations is None else {"promises": self.calibrations.to_json()}
        return {
            "format": FORMAT,
            "version": VERSION,
            "learner": self.learner,
            "parameters": dict(self.parameters),
            "training": dict(self.training),
            "phases": {
                "execution": self._phase("execution", self.execution),
                "learning": self._phase("learning", self.learning),
            },
            **promises,
        }

    def _phase(self, name: str, weights: Weights) -> dict[str, Any]:
        covariance = self.covariances.get(name)
        return {
            "features": list(weights.space.names),
            "weights": list(weights.values),
            "covariance": None if covariance is None else [list(row) for row in covariance],
        }

    @classmethod
    def from_json(cls, data: object) -> PolicyWeights:
        """Read a document. Raises ``WeightsError`` where it is none or is for other features."""
        document = _mapping(data, "the document")
        if document.get("format") != FORMAT:
            raise WeightsError("this is no file of policy weights")
        if document.get("version") != VERSION:
            version = document.get("version")
            raise WeightsError(f"weights of version {version!r}; this program reads {VERSION}")
        phases = _mapping(document.get("phases"), "'phases'")
        read = {name: _mapping(phases.get(name), f"'phases.{name}'") for name in SPACES}
        covariances = {name: _covariance(read[name], name) for name in SPACES}
        return cls(
            execution=_weights(read["execution"], "execution"),
            learning=_weights(read["learning"], "learning"),
            learner=str(document.get("learner", "")),
            parameters=_mapping(document.get("parameters"), "'parameters'"),
            training=_mapping(document.get("training"), "'training'"),
            covariances={name: found for name, found in covariances.items() if found is not None},
            calibrations=_calibrations(document.get("promises")),
        )


def _calibrations(data: object) -> Calibrations | None:
    """What promises rest on; files from before there were promises have nothing."""
    if data is None:
        return None
    try:
        return Calibrations.from_json(_mapping(data, "'promises'"), SURE_BY)
    except ValueError as error:
        raise WeightsError(f"'promises': {error}; train anew: verbteach train") from error


def _mapping(value: object, name: str) -> Mapping[str, Any]:
    if not isinstance(value, Mapping):
        raise WeightsError(f"{name} should be an object of JSON")
    return value


def _weights(phase: Mapping[str, Any], name: str) -> Weights:
    """A phase's weights in the program's order of features, whatever order the file has."""
    features = phase.get("features")
    if not isinstance(features, list) or len(set(map(str, features))) != len(features):
        raise WeightsError(f"'phases.{name}.features' should list every feature once")
    values = _numbers(phase.get("weights"), len(features), f"'phases.{name}.weights'")
    try:
        return Weights.from_json(SPACES[name], dict(zip(features, values, strict=True)))
    except ValueError as error:
        raise WeightsError(f"{error} (phase {name}); train anew: verbteach train") from error


def _covariance(phase: Mapping[str, Any], name: str) -> Matrix | None:
    rows = phase.get("covariance")
    if rows is None:
        return None
    place = f"'phases.{name}.covariance'"
    features = phase.get("features")
    size = len(features) if isinstance(features, list) else 0
    if not isinstance(rows, list) or len(rows) != size:
        raise WeightsError(f"{place} should have a row for each feature")
    read = [_numbers(row, size, place) for row in rows]
    return _reordered(read, features or [], SPACES[name].names)


def _reordered(rows: Sequence[Sequence[float]], have: Sequence[str], want: Sequence[str]) -> Matrix:
    index = {name: place for place, name in enumerate(have)}
    order = [index[name] for name in want if name in index]
    return tuple(tuple(rows[i][j] for j in order) for i in order)


def _numbers(values: object, count: int, place: str) -> tuple[float, ...]:
    """So many finite numbers."""
    if not isinstance(values, list) or len(values) != count:
        raise WeightsError(f"{place} should have a number for each feature")
    for value in values:
        if isinstance(value, bool) or not isinstance(value, int | float):
            raise WeightsError(f"{place} should have a number for each feature, not {value!r}")
        if not math.isfinite(value):
            raise WeightsError(f"{place} should have finite numbers")
    return tuple(float(value) for value in values)

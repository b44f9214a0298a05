"""Files of policy weights: those that `verbteach train` writes, and those that come with the robot.

The starting weights were trained on the bundled lessons; `docs/live-learning.md`
says how.
"""

from __future__ import annotations

import json
from pathlib import Path

from verbteach.policy.weights_file import PolicyWeights, WeightsError
from verbteach_scenarios.errors import WorldFileError

STARTING = Path(__file__).parent / "data" / "weights" / "starting.json"


class WeightsFileError(WorldFileError):
    """A file of policy weights does not fit."""


def load_weights(path: Path) -> PolicyWeights:
    """Read a file of weights.

    Raises ``WeightsFileError`` where it is none or was made for other features,
    ``OSError`` where it cannot be read.
    """
    return read_weights(path.read_bytes(), path)


def read_weights(raw: bytes, path: Path) -> PolicyWeights:
    """The weights that a file's bytes say; ``path`` is for the message of ``WeightsFileError``."""
    try:
        return PolicyWeights.from_json(json.loads(raw.decode("utf-8")))
    except json.JSONDecodeError as error:
        raise WeightsFileError(path, error.lineno, f"this is no JSON: {error.msg}") from error
    except UnicodeDecodeError as error:
        raise WeightsFileError(path, 0, "this is no text in UTF-8") from error
    except WeightsError as error:
        raise WeightsFileError(path, 0, str(error)) from error


def save_weights(path: Path, weights: PolicyWeights) -> None:
    """Write a file of weights, whole or not at all."""
    text = json.dumps(weights.to_json(), ensure_ascii=False, allow_nan=False, indent=1)
    beside = path.with_name(f".{path.name}.part")
    beside.write_text(text + "\n", encoding="utf-8")
    beside.replace(path)


def starting_weights() -> PolicyWeights:
    """The weights that a robot begins with, trained on the bundled lessons."""
    return load_weights(STARTING)

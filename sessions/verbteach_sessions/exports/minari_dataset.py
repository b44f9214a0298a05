"""A Minari dataset of the robot's choices. Needs the extra ``verbteach[minari]``.

An observation is the table of candidate acts: their features, and which act
each is; rows beyond the candidates have the act -1. The action is the row
chosen. ``infos`` hold the propensity and whether the choice explored; an
episode's ``options`` say whose it is and under which policy.
"""

from __future__ import annotations

import json
import os
import warnings
from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from verbteach.dialogue.codec import ROBOT_ACTS
from verbteach_sessions.exports.choices import RlEpisode, Step, episodes
from verbteach_sessions.exports.dialogue import Dialogue
from verbteach_sessions.exports.errors import NothingToExportError

DATASET = "verbteach/teaching-v0"
_VARIABLE = "MINARI_DATASETS_PATH"


def write(dialogues: Iterable[Dialogue], folder: Path) -> None:
    """Write the dataset ``verbteach/teaching-v0``; ``folder`` is to be ``MINARI_DATASETS_PATH``.

    Raises :class:`NothingToExportError` where the robot decided nothing.
    """
    found = [episode for dialogue in dialogues for episode in episodes(dialogue)]
    if not found:
        raise NothingToExportError(
            "these sessions hold no decision of the robot, so there is nothing for Minari"
        )
    _create(folder, _Layout.of(found), found)


@dataclass(frozen=True)
class _Layout:
    """How wide the table of candidates is, and what its columns are."""

    rows: int
    features: tuple[str, ...]

    @classmethod
    def of(cls, found: Iterable[RlEpisode]) -> _Layout:
        steps = [step for episode in found for step in episode.steps]
        names = {name for s in steps for one in s.candidates for name in one["features"]}
        return cls(max(len(step.candidates) for step in steps), tuple(sorted(names)) or ("none",))

    def observations(self, steps: tuple[Step, ...]) -> dict[str, NDArray[Any]]:
        """Tables of shape (steps + 1, rows, features), and acts of shape (steps + 1, rows).

        The last one, after the end, is empty.
        """
        shape = len(steps) + 1, self.rows
        features = np.zeros((*shape, len(self.features)), dtype=np.float32)
        acts = np.full(shape, -1, dtype=np.int32)
        column = {name: index for index, name in enumerate(self.features)}
        for i, step in enumerate(steps):
            for j, candidate in enumerate(step.candidates):
                acts[i, j] = _ACTS.get(str(candidate["act"].get("act")), len(_ACTS))
                for name, value in candidate["features"].items():
                    features[i, j, column[name]] = value
        return {"acts": acts, "features": features}

    @property
    def description(self) -> str:
        """What the numbers mean, as JSON."""
        told: Mapping[str, Any] = {
            "about": "Choices of a robot that learns verbs; an episode is one command.",
            "features": self.features,
            "acts": [*_ACTS, "other"],
        }
        return json.dumps(told)


_ACTS = {name: index for index, name in enumerate(ROBOT_ACTS)}


def _create(folder: Path, layout: _Layout, found: list[RlEpisode]) -> None:
    import minari  # noqa: PLC0415 - an extra, and slow to import
    from gymnasium.spaces import Box, Dict, Discrete  # noqa: PLC0415

    shape = layout.rows, len(layout.features)
    spaces: dict[str, Any] = {
        "acts": Box(-1, len(_ACTS), (layout.rows,), np.int32),
        "features": Box(-np.inf, np.inf, shape, np.float32),
    }
    with _datasets_in(folder), warnings.catch_warnings():
        # Recorded choices belong to no Gymnasium environment, which Minari warns about.
        warnings.simplefilter("ignore", UserWarning)
        minari.create_dataset_from_buffers(
            DATASET,
            buffer=[_buffer(index, one, layout) for index, one in enumerate(found)],
            observation_space=Dict(spaces),
            action_space=Discrete(layout.rows),
            algorithm_name=", ".join(sorted({one.about["policy"] for one in found})),
            description=layout.description,
            data_format="arrow",
        )


def _buffer(index: int, episode: RlEpisode, layout: _Layout) -> Any:
    from minari.data_collector import EpisodeBuffer  # noqa: PLC0415

    steps = episode.steps
    ends = [False] * (len(steps) - 1)
    return EpisodeBuffer(
        id=index,
        observations=layout.observations(steps),
        actions=np.array([step.chosen for step in steps], dtype=np.int64),
        rewards=[step.reward for step in steps],
        terminations=[*ends, episode.closed],
        truncations=[*ends, not episode.closed],
        # One entry an observation. Lists, since Minari cannot read back arrays of one dimension.
        infos={
            "propensity": [*(step.propensity for step in steps), 1.0],
            "explored": [*(step.explored for step in steps), False],
        },
        options=dict(episode.about),
    )


@contextmanager
def _datasets_in(folder: Path) -> Iterator[None]:
    """Minari takes its folder from the environment only."""
    before = os.environ.get(_VARIABLE)
    os.environ[_VARIABLE] = str(folder)
    try:
        yield
    finally:
        if before is None:
            del os.environ[_VARIABLE]
        else:
            os.environ[_VARIABLE] = before

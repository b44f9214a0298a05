"""The figures of question policies: how good what was carried out is, and what it cost to ask."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from verbteach.experiments.figures import Observation, figure
from verbteach.experiments.interactive_results import Tested
from verbteach.experiments.sight import stream


def policy_scores(
    runs: Sequence[Sequence[Tested]], learning: Sequence[Sequence[Observation]], seed: int = 0
) -> dict[str, Any]:
    """What ``verbteach evaluate`` prints of a policy; equal runs and seeds give equal figures.

    ``learning`` holds, for each run, the questions of each lesson, or their
    mean. Raises ``ValueError`` where a run has no command or no lesson.
    """
    executed = {
        "ied": [[Observation(one.group, one.ied) for one in run] for run in runs],
        "sji": [[Observation(one.group, one.sji) for one in run] for run in runs],
        "questions_execution": [
            [Observation(one.group, _asked(one)) for one in run] for run in runs
        ],
        "questions_learning": [list(run) for run in learning],
    }
    figures = {
        name: figure(values, stream(seed, name)).to_json() for name, values in executed.items()
    }
    return {**figures, "by_type": _by_type(runs), "instances": len(runs[0])}


def _asked(one: Tested) -> float:
    return float(sum(one.questions.values()))


def _by_type(runs: Sequence[Sequence[Tested]]) -> Mapping[str, float]:
    """Questions of each type for a command, on average over all runs."""
    commands = sum(len(run) for run in runs)
    names = sorted({name for run in runs for one in run for name in one.questions})
    return {
        name: sum(one.questions.get(name, 0) for run in runs for one in run) / commands
        for name in names
    }

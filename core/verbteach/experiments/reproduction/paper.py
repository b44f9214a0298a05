"""The paper's own figures: She & Chai (2017), Tables 4 and 5."""

from __future__ import annotations

from collections.abc import Mapping

TABLE4: Mapping[str, Mapping[str, Mapping[str, float]]] = {
    "she16": {
        "perfect": {"ied": 0.430, "sji": 0.426},
        "std3": {"ied": 0.284, "sji": 0.273},
        "std5": {"ied": 0.172, "sji": 0.168},
        "uniform": {"ied": 0.168, "sji": 0.163},
    },
    "rl": {
        "perfect": {"ied": 0.453, "sji": 0.468},
        "std3": {"ied": 0.420, "sji": 0.431},
        "std5": {"ied": 0.392, "sji": 0.411},
        "uniform": {"ied": 0.332, "sji": 0.347},
    },
}
"""Policy -> noise -> scores."""

TABLE5: Mapping[str, Mapping[str, Mapping[str, float]]] = {
    "rl": {
        "learning": {"ground": 2.130, "env": 2.615, "total": 4.746},
        "execution": {"ground": 0.383, "env": 0.650, "goal": 2.626, "total": 3.665},
        "score": {"ied": 0.420, "sji": 0.430},
    },
    "manual": {
        "learning": {"ground": 2.495, "env": 5.338, "total": 7.833},
        "execution": {"ground": 1.236, "env": 3.202, "goal": 2.353, "total": 6.792},
        "score": {"ied": 0.406, "sji": 0.404},
    },
    "random": {
        "learning": {"ground": 0.545, "env": 0.368, "total": 0.913},
        "execution": {"ground": 0.678, "env": 0.081, "goal": 0.151, "total": 0.909},
        "score": {"ied": 0.114, "sji": 0.113},
    },
}
"""Policy -> phase -> mean questions by kind, and scores; at NormStd3."""

NOISE_NAMES: Mapping[str, str] = {
    "perfect": "PerfectEnv",
    "std3": "NormStd3",
    "std5": "NormStd5",
    "uniform": "UniEnv",
}
"""What the paper calls the noise levels."""

PAPER_VARIANT = "she16-all"
"""The variant of She16 that the paper compares with: all objects, selection by regression."""


def of_table4(policy: str, noise: str) -> Mapping[str, float]:
    """The paper's cell; none where the paper has no such row."""
    name = "she16" if policy == PAPER_VARIANT else policy
    return TABLE4.get(name, {}).get(noise, {})

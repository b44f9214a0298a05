"""The charts of a reproduction, from its document."""

from __future__ import annotations

from typing import Any

from verbteach.experiments.reproduction.markdown import NAMES
from verbteach_tui.plots.curves import Chart, Point, lines, point


def charts(document: dict[str, Any]) -> dict[str, Chart]:
    """Charts by the name of their file; those that the document has figures for."""
    found = {}
    if "figure5" in document:
        found["figure5"] = Chart(
            "Figure 5: SJI by training instances (NormStd3)",
            "training instances",
            "SJI",
            tuple(lines(document["figure5"], NAMES)),
            {},
        )
    if "per_question" in document:
        found["questions"] = Chart(
            "SJI by questions asked (NormStd3); stars: where a policy stops by itself",
            "questions per command",
            "SJI",
            tuple(lines(document["per_question"], NAMES)),
            _stops(document),
        )
    return found


def _stops(document: dict[str, Any]) -> dict[str, Point]:
    """Where the policies end by themselves, where Table 5 is at hand."""
    return {
        policy: point(own["execution"]["total"]["mean"], own["sji"])
        for policy, own in document.get("table5", {}).items()
        if policy in document["per_question"]
    }

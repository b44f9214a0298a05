"""Benches for interactive experiments: the lessons, or a corpus, in furnished rooms."""

from __future__ import annotations

from verbteach.experiments.interactive_bench import Bench, BenchParameters
from verbteach.experiments.workroom import furnish
from verbteach_scenarios.grounds import EvaluationData


def bench_of(data: EvaluationData, parameters: BenchParameters | None = None) -> Bench:
    """A bench with every instance of the data."""
    grounds = data.grounds
    rooms = furnish(grounds.tasks, grounds.planner)
    return Bench(grounds.instances, rooms, parameters or BenchParameters())

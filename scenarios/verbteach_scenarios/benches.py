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


def bench_grounded(data: EvaluationData, grounding: str) -> Bench:
    """A bench whose noun phrases get their objects as named: ``corpus``, ``oracle`` or ``own``."""
    bench = bench_of(data, BenchParameters(oracle=grounding == "oracle"))
    bench.grounder = data.own if grounding == "own" else None
    return bench

"""Timing: milliseconds a call, and what is said of many of them."""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from statistics import quantiles
from typing import TypeVar

T = TypeVar("T")


def timed(call: Callable[[], T]) -> tuple[float, T]:
    """The milliseconds that ``call`` took, and what it answered."""
    start = time.perf_counter()
    answer = call()
    return (time.perf_counter() - start) * 1000, answer


def percentiles(times: Sequence[float]) -> dict[str, float | None]:
    """The median and the 95th percentile; null where nothing was measured."""
    if not times:
        return {"p50": None, "p95": None}
    if len(times) == 1:
        return {"p50": times[0], "p95": times[0]}
    cuts = quantiles(times, n=20, method="inclusive")
    return {"p50": cuts[9], "p95": cuts[18]}


def per_second(call: Callable[[], int], seconds: float) -> float:
    """How many things a second ``call`` does, which answers how many it did each time."""
    done, start = 0, time.perf_counter()
    while (spent := time.perf_counter() - start) < seconds:
        done += call()
    return done / spent

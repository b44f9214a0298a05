"""What is written as PDDL reads back the same."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from tests.world import kitchenette
from verbteach.world.task import Task
from verbteach_scenarios.pddl import (
    Problem,
    domain_text,
    parse_domain,
    parse_problem,
    problem_text,
    read_domain,
)

SHIPPED = sorted((Path(__file__).parents[2] / "scenarios").glob("**/domain.pddl"))


@pytest.mark.parametrize("path", [kitchenette.PATH, *SHIPPED], ids=lambda path: path.parent.name)
def test_a_domain_reads_back_the_same(path: Path) -> None:
    domain = read_domain(path)
    assert parse_domain(domain_text(domain)) == domain


def test_the_smallest_domain_reads_back_the_same() -> None:
    domain = parse_domain("(define (domain d))")
    assert parse_domain(domain_text(domain)) == domain


@pytest.mark.parametrize("seed", range(5))
def test_a_problem_reads_back_the_same(seed: int) -> None:
    rng = np.random.default_rng(seed)
    domain = kitchenette.domain()
    things = {**domain.constants, **kitchenette.objects((2, seed, 1, 1, 1))}
    start = kitchenette.start(things, rng)
    goal = kitchenette.goal(Task(domain, things, start), rng, size=seed)
    problem = Problem("p", things, start, goal)
    assert parse_problem(problem_text("p", domain, things, start, goal), domain) == problem

"""Other planners on the same questions, where they are installed.

Each is asked in a process of its own, from PDDL text, and parses and grounds
at every call: none of them offers to swap state and goal. One that takes too
long is stopped, and so is one that cannot read the domain.
"""

from __future__ import annotations

import importlib
import multiprocessing
import os
import tempfile
from collections.abc import Callable, Iterator, Mapping, Sequence
from importlib.util import find_spec
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any, NamedTuple

from verbteach_tui.bench.clock import percentiles, timed
from verbteach_tui.installation import installed

LONGEST = 20.0  # seconds a question
Solve = Callable[[str, str], int | None]
"""From a domain's and a problem's text to the number of steps; ``None`` where unsolved."""


class Answered(NamedTuple):
    """One call: milliseconds, steps (``None`` where unsolved), and an error's words."""

    ms: float
    steps: int | None
    problem: str = ""


def kairos() -> Solve:
    """Kairos 1.0.6 as the design measured it."""
    module = importlib.import_module("kairos")

    def solve(domain: str, problem: str) -> int | None:
        read = module.parse_problem(problem, module.parse_domain(domain))
        planner = module.Planner()
        found = planner.solve(read, timeout=LONGEST, anytime=False, search="ff", threads=1)
        return len(found.plan.steps) if found.status == module.Status.SOLVED else None

    return solve


def pymimir() -> Solve:
    """Mimir: greedy best-first search with lazy evaluation and h_FF."""
    module = importlib.import_module("pymimir")

    def solve(domain: str, problem: str) -> int | None:
        read = module.Problem(module.Domain(domain), problem, mode="lifted")
        heuristic = module.FFHeuristic(read)
        start = read.get_initial_state()
        found = module.gbfs_lazy(read, start, heuristic, max_time_seconds=LONGEST)
        return None if found.solution is None else len(found.solution)

    return solve


def pyperplan() -> Solve:
    """pyperplan: greedy best-first search with h_FF. It reads STRIPS only."""
    planner = importlib.import_module("pyperplan.planner")

    def solve(domain: str, problem: str) -> int | None:
        with tempfile.TemporaryDirectory() as folder:
            files = [Path(folder, name) for name in ("domain.pddl", "problem.pddl")]
            for file, text in zip(files, (domain, problem), strict=True):
                file.write_text(text, "utf-8")
            search, heuristic = planner.SEARCHES["gbf"], planner.HEURISTICS["hff"]
            found = planner.search_plan(*map(str, files), search, heuristic)
        return None if found is None else len(found)

    return solve


class Peer(NamedTuple):
    """Another planner: how it is imported, how it is installed, how it is asked."""

    module: str
    package: str
    make: Callable[[], Solve]


PEERS: Mapping[str, Peer] = {
    "kairos": Peer("kairos", "kairos-planner", kairos),
    "pymimir": Peer("pymimir", "pymimir", pymimir),
    "pyperplan": Peer("pyperplan", "pyperplan", pyperplan),
}


def here() -> tuple[str, ...]:
    """The peers that are installed."""
    return tuple(name for name, peer in PEERS.items() if find_spec(peer.module) is not None)


def measure(
    name: str, texts: Sequence[tuple[str, str]], done: Callable[[int], None]
) -> dict[str, Any]:
    """What one peer makes of the questions."""
    answers = []
    for answer in _asked(name, texts):
        answers.append(answer)
        done(len(answers))
    problems = [answer.problem for answer in answers if answer.problem]
    solved = [answer for answer in answers if answer.steps is not None]
    return {
        **percentiles([answer.ms for answer in solved]),
        "version": installed(PEERS[name].package),
        "questions": len(texts),
        "solved": len(solved),
        "steps": percentiles([answer.steps for answer in solved if answer.steps is not None]),
        "problem": problems[0] if problems else None,
    }


def _asked(name: str, texts: Sequence[tuple[str, str]]) -> Iterator[Answered]:
    """The answers in order, up to the first question that breaks the peer."""
    context = multiprocessing.get_context("spawn")
    ours, theirs = context.Pipe()
    process = context.Process(target=_serve, args=(name, theirs), daemon=True)
    process.start()
    theirs.close()
    try:
        for question in texts:
            ours.send(question)
            if not ours.poll(2 * LONGEST):
                yield Answered(0.0, None, f"no answer within {2 * LONGEST:g} s")
                return
            answer = _received(ours)
            yield answer
            if answer.problem:
                return
    finally:
        process.kill()
        process.join()


def _received(connection: Connection) -> Answered:
    try:
        return Answered(*connection.recv())
    except EOFError:
        return Answered(0.0, None, "the process ended")


def _serve(name: str, connection: Connection) -> None:
    """Answer questions until the connection closes; runs in the peer's own process."""
    silence = os.open(os.devnull, os.O_WRONLY)
    os.dup2(silence, 1)  # some print all that they ground, past Python's own streams
    os.dup2(silence, 2)
    solve = PEERS[name].make()
    while True:
        try:
            domain, problem = connection.recv()
        except EOFError:
            return
        try:
            ms, steps = timed(lambda: solve(domain, problem))  # noqa: B023
            connection.send((ms, steps, ""))
        except BaseException as error:  # a peer's own errors, `sys.exit` among them
            connection.send((0.0, None, f"{type(error).__name__}: {error}"[:300]))

"""Other planners on the same questions, where they are installed.

Each is asked in a process of its own, from PDDL text, and parses and grounds
at every call: none of them offers to swap state and goal. This planner is asked
in that way too, beside its own, where the task is ready. A question that
takes too long is broken off and counted as such, a peer that has used up its
time gets no more questions, and one that cannot read the domain neither.
"""

from __future__ import annotations

import importlib
import multiprocessing
import os
import tempfile
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import ExitStack
from importlib.util import find_spec
from multiprocessing.connection import Connection
from pathlib import Path
from time import monotonic
from typing import Any, NamedTuple

from verbteach.world import compiled
from verbteach.world.plan import Plan
from verbteach.world.planner import make_planner
from verbteach.world.task import Task
from verbteach_scenarios.pddl import parse_domain
from verbteach_scenarios.pddl.problem_file import parse_problem
from verbteach_tui.bench import planning
from verbteach_tui.bench.clock import percentiles, timed
from verbteach_tui.installation import installed

LONGEST = 5.0
"""Seconds a question may take."""
BUDGET = 60.0
"""Seconds after which a peer gets no further question."""
STARTING = 60.0
"""Seconds a peer may take to be loaded."""
Solve = Callable[[str, str], int | None]
"""From a domain's and a problem's text to the number of steps; ``None`` where unsolved."""


class Answered(NamedTuple):
    """One call: milliseconds, steps (``None`` where unsolved), an error's words, broken off."""

    ms: float
    steps: int | None
    problem: str = ""
    late: bool = False


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


def from_text() -> Solve:
    """This planner as the others are asked: nothing is ready but the program."""
    compiled.warm_up()
    path = planning.paths()[-1]

    def solve(domain: str, problem: str) -> int | None:
        read = parse_domain(domain)
        asked = parse_problem(problem, read)
        task = Task(read, asked.objects, asked.initial)
        answer = make_planner(task, planning.UNREMEMBERED, path).plan(asked.initial, asked.goal)
        return len(answer.actions) if isinstance(answer, Plan) else None

    return solve


class Peer(NamedTuple):
    """A planner: how it is imported, how it is installed, how it is asked."""

    module: str
    package: str
    make: Callable[[], Solve]


PEERS: Mapping[str, Peer] = {
    "verbteach, from text": Peer("verbteach_scenarios", "verbteach", from_text),
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
    """What one peer makes of the questions; ``questions`` are those it was asked."""
    answers = []
    for answer in _asked(name, texts):
        answers.append(answer)
        done(len(answers))
    problems = [answer.problem for answer in answers if answer.problem]
    solved = [answer for answer in answers if answer.steps is not None]
    return {
        **percentiles([answer.ms for answer in solved]),
        "version": installed(PEERS[name].package),
        "questions": len(answers),
        "solved": len(solved),
        "timed_out": sum(answer.late for answer in answers),
        "steps": percentiles([answer.steps for answer in solved if answer.steps is not None]),
        "problem": problems[0] if problems else None,
    }


def _asked(name: str, texts: Sequence[tuple[str, str]]) -> Iterator[Answered]:
    """The answers in order, up to the first question that breaks the peer or out of its time."""
    began = monotonic()
    with ExitStack() as stack:
        asking: _Asking | None = None
        for question in texts:
            if monotonic() - began > BUDGET:
                return
            asking = asking or stack.enter_context(_Asking(name))
            answer = asking.ask(question)
            yield answer
            if answer.problem:
                return
            if answer.late:
                asking.stop()
                asking = None


class _Asking:
    """A peer in a process of its own, which can be stopped whatever it is at."""

    def __init__(self, name: str) -> None:
        context = multiprocessing.get_context("spawn")
        self._ours, theirs = context.Pipe()
        self._process = context.Process(target=_serve, args=(name, theirs), daemon=True)
        self._process.start()
        theirs.close()
        self._ready = self._received(STARTING)

    def __enter__(self) -> _Asking:
        return self

    def __exit__(self, *_: object) -> None:
        self.stop()

    def ask(self, question: tuple[str, str]) -> Answered:
        """Wait for the answer, not much longer than ``LONGEST``."""
        if self._ready.problem or self._ready.late:
            return self._ready._replace(problem=self._ready.problem or "it does not start")
        self._ours.send(question)
        return self._received(LONGEST + 1.0)

    def stop(self) -> None:
        """End the process."""
        self._process.kill()
        self._process.join()
        self._ours.close()

    def _received(self, seconds: float) -> Answered:
        if not self._ours.poll(seconds):
            return Answered(0.0, None, late=True)
        return _received(self._ours)


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
    try:
        solve = PEERS[name].make()
    except Exception as error:  # installed for another interpreter, or half
        connection.send((0.0, None, f"{type(error).__name__}: {error}"[:300]))
        return
    connection.send((0.0, None, ""))
    while True:
        try:
            domain, problem = connection.recv()
        except EOFError:
            return
        try:
            ms, steps = timed(lambda: solve(domain, problem))  # noqa: B023
            late = steps is None and ms >= 1000 * LONGEST
            connection.send((ms, steps, "", late))
        except BaseException as error:  # a peer's own errors, `sys.exit` among them
            connection.send((0.0, None, f"{type(error).__name__}: {error}"[:300]))

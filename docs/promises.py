"""How promises are kept: the tables in docs/learning.md, from commands nothing was trained on.

`python docs/promises.py --data DIR` works the courses of test commands out on a
Tell Me Dave folder, `--lessons` those of the set-apart lessons in the starting
weights; `--courses FILE` keeps them, or takes them from there. The courses are
then split into calibration and test over and over, seeds fixed, by whole
environments and at random.
"""

from __future__ import annotations

import argparse
import json
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np

from verbteach.experiments.asked_command import AskedCommand
from verbteach.experiments.command_courses import course_of
from verbteach.experiments.interactive_bench import Bench
from verbteach.experiments.interactive_protocol import Config, run
from verbteach.policy.courses import Course
from verbteach.policy.stopping import (
    Kept,
    UnkeepablePromiseError,
    cut_for,
    kept,
    of_all,
)
from verbteach.policy.sureness import fitted
from verbteach_scenarios import grounds
from verbteach_scenarios.benches import bench_of
from verbteach_scenarios.weights import starting_weights

RATES = (0.6, 0.7, 0.8, 0.9)
SPLITS = 20
POLICIES = ("rl", "manual")


class Told(NamedTuple):
    """A command's course and the environment it was given in."""

    environment: str
    course: Course


Courses = Mapping[str, Sequence[Told]]


def of_corpus(folder: Path, noise: str) -> Courses:
    """The commands of every second environment; weights, verbs and sureness from the others."""
    bench = bench_of(grounds.of_corpus(folder))
    held = tuple(sorted({one.environment for one in bench.instances})[::2])
    others = [one for one in bench.instances if one.environment not in held]
    executions: list[tuple[Mapping[str, float], bool]] = []

    def seen(command: AskedCommand) -> None:
        last = command.end.candidates()[-1].features
        if "select_hypo" in last:
            executions.append((last, command.carried.sji >= 1.0))

    for policy in ("manual", "random"):
        run(
            Bench(others, bench.rooms, bench.parameters),
            Config(policy=policy, noise=noise),
            witness=seen,
        )
    sureness = fitted(executions)
    found: dict[str, list[Told]] = {}
    for policy in POLICIES:
        rows = found.setdefault(policy, [])

        def told(command: AskedCommand, rows: list[Told] = rows) -> None:
            rows.append(Told(command.instance.environment, course_of(command, sureness)))

        run(bench, Config(policy=policy, noise=noise, held_out=held, together=True), witness=told)
    return found


def of_starting_weights() -> Courses:
    """The set-apart lessons that the starting weights were calibrated on; rooms are not told."""
    each = starting_weights().calibrations
    return {
        f"{one.policy}, {one.noise}": [Told("", course) for course in one.courses]
        for one in (each.each if each else ())
    }


def splits(rows: Sequence[Told], by: str) -> Iterator[tuple[list[Course], list[Course]]]:
    """Calibration and test, a half each: of the environments, or of the commands."""
    names = sorted({row.environment for row in rows})
    for number in range(SPLITS):
        rng = np.random.default_rng([number, len(rows)])
        if by == "environment":
            chosen = {names[i] for i in rng.permutation(len(names))[: len(names) // 2]}
            first = [row.environment in chosen for row in rows]
        else:
            order = rng.permutation(len(rows)) < len(rows) // 2
            first = order.tolist()
        pairs = list(zip(first, rows, strict=True))
        yield [row.course for mine, row in pairs if mine], [r.course for m, r in pairs if not m]


def table(found: Courses) -> Iterator[str]:
    """Rows in Markdown."""
    yield (
        "| policy | split by | promised | bound | could promise | right of carried out"
        " | not gone wrong, of all | carried out | questions |"
    )
    yield "|---|---|---|---|---|---|---|---|---|"
    for policy, rows in found.items():
        several = len({row.environment for row in rows}) > 1
        for by in ("environment", "command") if several else ("command",):
            parts = list(splits(rows, by))
            for rate in RATES:
                for bound in ("both", "of all"):
                    yield _row(policy, by, rate, bound, parts)


def _row(
    policy: str,
    by: str,
    rate: float,
    bound: str,
    parts: Sequence[tuple[list[Course], list[Course]]],
) -> str:
    came = [one for calibration, test in parts if (one := _kept(calibration, test, rate, bound))]
    head = f"| `{policy}` | {by} | {rate:.0%} | {bound} | {len(came)} of {len(parts)}"
    if not came:
        return f"{head} | - | - | - | - |"
    right = sum(one.right for one in came) / max(1, sum(one.carried_out for one in came))
    fine = np.mean([1.0 - one.wrong / one.commands for one in came])
    done = np.mean([one.carried_out / one.commands for one in came])
    asked = np.mean([one.questions / one.commands for one in came])
    return f"{head} | {right:.3f} | {fine:.3f} | {done:.2f} | {asked:.2f} |"


def _kept(
    calibration: Sequence[Course], test: Sequence[Course], rate: float, bound: str
) -> Kept | None:
    try:
        cut = cut_for(calibration, rate).sure if bound == "both" else of_all(calibration, rate)
    except UnkeepablePromiseError:
        return None
    return kept(test, cut)


def _read(path: Path) -> Courses:
    data = json.loads(path.read_text("utf-8"))
    return {
        policy: [Told(environment, Course.from_json(rows)) for environment, rows in told]
        for policy, told in data.items()
    }


def _written(found: Courses) -> str:
    rows = {
        policy: [[one.environment, one.course.to_json()] for one in told]
        for policy, told in found.items()
    }
    return json.dumps(rows)


def main() -> None:
    """Work the courses out, or read them, and print the table."""
    arguments = argparse.ArgumentParser(description=__doc__)
    arguments.add_argument("--data", type=Path)
    arguments.add_argument("--noise", default="perfect")
    arguments.add_argument("--lessons", action="store_true")
    arguments.add_argument("--courses", type=Path)
    asked = arguments.parse_args()
    if asked.lessons:
        found = of_starting_weights()
    elif asked.courses is not None and asked.courses.exists():
        found = _read(asked.courses)
    else:
        found = of_corpus(asked.data, asked.noise)
        if asked.courses is not None:
            asked.courses.write_text(_written(found), "utf-8")
    print("\n".join(table(found)))


if __name__ == "__main__":
    main()

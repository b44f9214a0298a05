"""The learners' learning curves: the pictures and the table in docs/learning.md.

`python docs/learners.py --data DIR` trains every learner with more and more
dialogues and tests what it learned in every second environment, from which
nothing was learned. What is worked out is kept in `--rows FILE` and not worked
out again; the pictures and the table are made of it.
"""

from __future__ import annotations

import argparse
import json
import statistics
import sys
from collections.abc import Iterator, Mapping, Sequence
from functools import lru_cache, partial
from itertools import product
from pathlib import Path
from typing import NamedTuple

from verbteach.experiments.asked_command import AskedCommand
from verbteach.experiments.interactive import hold, judged
from verbteach.experiments.interactive_bench import Bench
from verbteach.experiments.interactive_protocol import Config, run
from verbteach.experiments.interactive_training import TrainingParameters
from verbteach.experiments.sight import stream
from verbteach_scenarios import grounds
from verbteach_scenarios.benches import bench_of
from verbteach_tui.plots.curves import Chart, Line, Point
from verbteach_tui.plots.files import draw
from verbteach_tui.workers import Workers

sys.path.insert(0, str(Path(__file__).parent.parent))

from docs.results_asking import filled

PAGE = Path(__file__).with_name("learning.md")
IMAGES = PAGE.with_name("images")
LEARNERS = ("sarsa", "true-online", "bayesian", "lspi")
DIALOGUES = (300, 600, 1200, 2400)
PRICES = {1.0: "learners-paper-prices", TrainingParameters().price: "learners"}
RULES = ("silent", "split", "manual")


class Training(NamedTuple):
    """One training to be tested; a rule in the learner's place is only tested."""

    learner: str
    dialogues: int
    price: float
    run: int


class Tested(NamedTuple):
    """Means over the commands: the return in the paper's rewards, SJI, and questions."""

    earned: float
    sji: float
    asked: float


def tested(folder: Path, noise: str, training: Training) -> tuple[Training, Tested]:
    """Train, and test in every second environment; both are told, for they come in any order."""
    bench, rule = _bench(folder), training.learner in RULES
    learner = "lspi" if rule else training.learner
    how = TrainingParameters(learner=learner, dialogues=training.dialogues, price=training.price)
    found: list[Tested] = []

    def seen(command: AskedCommand) -> None:
        rng = stream("learners", command.instance.id)
        held = hold(command.start, command.policy, command.human, how.priced, rng)
        turns = judged(held, command.carried.sji, how.priced).turns
        earned = sum(turn.reward for turn in turns)
        found.append(Tested(earned, command.carried.sji, held.asked))

    config = Config(
        policy=training.learner if rule else "rl",
        noise=noise,
        run=training.run,
        held_out=tuple(sorted({one.environment for one in bench.instances})[::2]),
        together=True,
        training=how,
    )
    run(bench, config, witness=seen)
    means = (statistics.fmean(column) for column in zip(*found, strict=True))
    return training, Tested(*means)


@lru_cache(maxsize=1)
def _bench(folder: Path) -> Bench:
    return bench_of(grounds.of_corpus(folder))


def trainings(runs: int) -> Iterator[Training]:
    """Every training, run by run."""
    for number in range(runs):
        for price in PRICES:
            yield from (Training(rule, 0, price, number) for rule in RULES)
            for learner, dialogues in product(LEARNERS, DIALOGUES):
                yield Training(learner, dialogues, price, number)


Rows = Mapping[Training, Tested]


def chart(rows: Rows, price: float, noise: str) -> Chart:
    """Return against dialogues: means over the runs, and from the worst to the best of them."""
    lines = [_line(name, [(n, _of(rows, name, n, price)) for n in DIALOGUES]) for name in LEARNERS]
    for rule in RULES:
        found = _of(rows, rule, 0, price)
        lines.append(_line(rule, [(n, found) for n in (DIALOGUES[0], DIALOGUES[-1])]))
    times = "the paper's prices" if price == 1.0 else f"questions {price:g} times as dear"
    title = f"Earned in rooms not learned in ({noise}, {times})"
    lowest = min(point.low for line in lines for point in line.points)
    axes = ("dialogues in training", "mean return of a command")
    return Chart(title, *axes, tuple(lines), {}, bottom=5.0 * (lowest // 5.0))


def _of(rows: Rows, name: str, dialogues: int, price: float) -> list[Tested]:
    wanted = (name, dialogues, price)
    return [found for training, found in sorted(rows.items()) if training[:3] == wanted]


def _line(name: str, points: Sequence[tuple[int, Sequence[Tested]]]) -> Line:
    earned = [(n, [one.earned for one in found]) for n, found in points]
    drawn = (Point(n, statistics.fmean(y), min(y), max(y)) for n, y in earned)
    return Line(name, name, tuple(drawn))


def table(rows: Rows, runs: int) -> Iterator[str]:
    """Every run's return, with the means of SJI and questions, by learner and dialogues."""
    each = " | ".join(f"run {number}" for number in range(runs))
    yield f"| price | learner | dialogues | return | SJI | asked | {each} |"
    yield "|---" * (6 + runs) + "|"
    for price, name in product(PRICES, (*RULES, *LEARNERS)):
        for dialogues in DIALOGUES if name in LEARNERS else (0,):
            found = _of(rows, name, dialogues, price)
            earned, sji, asked = (statistics.fmean(column) for column in zip(*found, strict=True))
            single = " | ".join(f"{one.earned:.1f}" for one in found)
            yield (
                f"| {price:g} | `{name}` | {dialogues or '-'} | {earned:.1f} | {sji:.3f}"
                f" | {asked:.2f} | {single} |"
            )


def _read(path: Path) -> dict[Training, Tested]:
    if not path.exists():
        return {}
    lines = (json.loads(line) for line in path.read_text("utf-8").splitlines())
    return {Training(*training): Tested(*found) for training, found in lines}


def main() -> None:
    """Work out what is not there yet, draw, and fill the table."""
    arguments = argparse.ArgumentParser(description=__doc__)
    arguments.add_argument("--data", type=Path, required=True)
    arguments.add_argument("--noise", default="std3")
    arguments.add_argument("--runs", type=int, default=3)
    arguments.add_argument("--jobs", type=int, default=2)
    arguments.add_argument("--rows", type=Path, required=True)
    asked = arguments.parse_args()
    rows = _read(asked.rows)
    left = [one for one in trainings(asked.runs) if one not in rows]
    work = partial(tested, asked.data, asked.noise)
    for training, found in Workers(asked.jobs)(work, left):
        rows[training] = found
        with asked.rows.open("a", encoding="utf-8") as out:
            out.write(json.dumps([training, found]) + "\n")
    for price, name in PRICES.items():
        for path in draw(chart(rows, price, asked.noise), IMAGES / name):
            if path.suffix == ".png":
                path.unlink()
    page = PAGE.read_text("utf-8")
    PAGE.write_text(filled(page, "learners", "\n".join(table(rows, asked.runs))), "utf-8")


if __name__ == "__main__":
    # By its name other processes find it, and keep their bench.
    from docs import learners

    learners.main()

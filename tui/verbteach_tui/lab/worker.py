"""The lab's worker: a process that is given a job and tells, line by line, how it goes.

It reads one JSON line, the job and the folder for its results, and writes JSON
lines. Results are on the disk, whole, before they are told of; it may be ended at
any moment and leaves nothing half written.
"""

from __future__ import annotations

import json
import os
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

from verbteach_tui.lab.jobs import TRAIN, Job
from verbteach_tui.lab.results import save_job, save_rows, save_training

if TYPE_CHECKING:
    from verbteach.experiments.interactive_bench import Bench

Tell = Callable[[dict[str, Any]], None]
_NICENESS = 10
_RHYTHM = 0.1  # seconds between two lines about the same stage


def main() -> int:
    """Do the job on standard input; the exit status."""
    request = json.loads(sys.stdin.readline())
    os.nice(_NICENESS)
    try:
        work(Job.from_json(request["job"]), Path(request["folder"]), _tell)
    except BrokenPipeError:  # nobody listens any more
        return 1
    except Exception as error:
        _tell({"failed": f"{type(error).__name__}: {error}"})
        raise
    return 0


def work(job: Job, folder: Path, tell: Tell) -> None:
    """Do a job and tell of it; what comes of it goes to ``folder``."""
    tell({"stage": "rooms", "done": 0, "total": 1, "figures": []})
    bench = _bench()
    tell({"stage": "rooms", "done": 1, "total": 1, "figures": []})
    if job.kind == TRAIN:
        _train(job, bench, folder, tell)
    else:
        _compare(job, bench, folder, tell)
    tell({"saved": str(folder)})


def _tell(line: dict[str, Any]) -> None:
    print(json.dumps(line), flush=True)


def _bench() -> Bench:
    from verbteach_scenarios.benches import bench_of
    from verbteach_scenarios.grounds import of_lessons
    from verbteach_scenarios.lessons import load_lessons
    from verbteach_scenarios.settings import make_settings

    return bench_of(of_lessons(load_lessons(), make_settings()))


def _train(job: Job, bench: Bench, folder: Path, tell: Tell) -> None:
    from verbteach.experiments.interactive_training import TrainingParameters
    from verbteach.experiments.policy_training import Schooling, train_policies

    gatherer = _Gatherer(tell)
    training = TrainingParameters(dialogues=job.dialogues, warm=job.dialogues * 4 // 11)
    schooling = Schooling(noises=(job.noise,), seed=job.seed, training=training)
    weights = train_policies(bench, schooling, "the bundled lessons", gatherer.heard)
    gatherer.flush()
    save_job(folder, job)  # what comes to nothing leaves nothing
    save_training(folder, weights, gatherer.curves)


def _compare(job: Job, bench: Bench, folder: Path, tell: Tell) -> None:
    from verbteach.experiments.interactive_protocol import Config, run
    from verbteach.experiments.interactive_training import TrainingParameters

    rows: list[dict[str, Any]] = []
    for policy in job.policies:
        gatherer = _Gatherer(tell, f"{policy}: ")
        config = Config(
            policy=policy,
            noise=job.noise,
            seed=job.seed,
            held_out=job.held_out,
            together=True,
            verb_share=job.share,
            training=TrainingParameters(dialogues=job.dialogues, warm=job.dialogues * 4 // 11),
        )
        result = run(bench, config, heard=gatherer.heard)
        gatherer.flush()
        if not rows:
            save_job(folder, job)
        rows.append(_row(policy, result, job.seed))
        save_rows(folder, rows)
        tell({"row": rows[-1]})


def _row(policy: str, result: Any, seed: int) -> dict[str, Any]:
    from verbteach.experiments.figures import Observation
    from verbteach.experiments.policy_scores import policy_scores

    taught = result.taught
    asked = sum(taught.questions.values()) / max(1, taught.dialogues)
    scores = policy_scores([result.tested], [[Observation("lessons", asked)]], seed)
    right = sum(one.right for one in result.tested) / len(result.tested)
    return {"policy": policy, "right": right, **scores}


class _Gatherer:
    """Gathers what is heard of a stage into a line now and then."""

    def __init__(self, tell: Tell, lead: str = "") -> None:
        self._tell, self._lead = tell, lead
        self._line: dict[str, Any] = {}
        self._told_at = 0.0
        self.curves: dict[str, list[float]] = {}

    def heard(self, stage: str, done: int, total: int, figure: float) -> None:
        if self._line.get("stage") not in (None, self._lead + stage):
            self.flush()
        figures = [*self._line.get("figures", []), figure]
        self._line = {
            "stage": self._lead + stage,
            "done": done,
            "total": total,
            "figures": figures,
        }
        self.curves.setdefault(stage, []).append(figure)
        if time.monotonic() - self._told_at > _RHYTHM or done == total:
            self.flush()

    def flush(self) -> None:
        """Tell what has been gathered."""
        if self._line:
            self._tell(self._line)
        self._line, self._told_at = {}, time.monotonic()


if __name__ == "__main__":
    sys.exit(main())

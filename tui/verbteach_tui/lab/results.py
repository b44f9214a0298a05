"""Where the lab's results lie, a folder a run; each file is put there whole or not at all."""

from __future__ import annotations

import csv
import io
import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from verbteach_sessions.files import FOLDER_MODE, replace_file
from verbteach_tui.lab.jobs import Job

if TYPE_CHECKING:
    from verbteach.policy.weights_file import PolicyWeights

JOB, WEIGHTS, CURVES, ROWS, TABLE = (
    *("job.json", "weights.json", "curves.csv", "comparison.json", "comparison.csv"),
)
FIGURES = ("ied", "sji", "questions_learning", "questions_execution")


@dataclass(frozen=True)
class Earlier:
    """An earlier run. What it left undone is empty."""

    path: Path
    job: Job
    rows: tuple[Mapping[str, Any], ...] = ()
    trained: bool = False


def curves_of(run: Earlier) -> dict[str, tuple[float, ...]]:
    """The return of each dialogue that a training run held, by phase; empty where it left none."""
    curves: dict[str, tuple[float, ...]] = {}
    try:
        with (run.path / CURVES).open(encoding="utf-8", newline="") as file:
            for line in csv.DictReader(file):
                phase = line["phase"]
                curves[phase] = (*curves.get(phase, ()), float(line["return"]))
    except (OSError, ValueError, TypeError, KeyError):
        return {}
    return curves


def lab_folder(sessions: Path) -> Path:
    """The lab's folder: beside the folder of sessions."""
    return sessions.parent / "lab"


def save_job(folder: Path, job: Job) -> None:
    """Keep what was asked for. Raises ``StorageError``."""
    folder.mkdir(mode=FOLDER_MODE, parents=True, exist_ok=True)
    _save(folder / JOB, job.to_json())


def save_training(
    folder: Path, weights: PolicyWeights, curves: Mapping[str, Sequence[float]]
) -> None:
    """Keep the weights and the return of each dialogue. Raises ``StorageError``."""
    lines = [
        {"phase": phase, "dialogue": number, "return": earned}
        for phase in ("learning", "execution")
        for number, earned in enumerate(curves.get(phase, ()), start=1)
    ]
    replace_file(folder / CURVES, _csv(["phase", "dialogue", "return"], lines))
    _save(folder / WEIGHTS, weights.to_json())


def save_rows(folder: Path, rows: Sequence[Mapping[str, Any]]) -> None:
    """Keep the policies compared so far. Raises ``StorageError``."""
    _save(folder / ROWS, list(rows))
    names = ["policy", "right", *(f"{f}{part}" for f in FIGURES for part in ("", "_low", "_high"))]
    replace_file(folder / TABLE, _csv(names, [_flat(row) for row in rows]))


def earlier_runs(folder: Path) -> tuple[Earlier, ...]:
    """The runs in the lab's folder, the newest first; what cannot be read is left out."""
    try:
        paths = sorted((path for path in folder.iterdir() if path.is_dir()), reverse=True)
    except OSError:
        return ()
    found = (_earlier(path) for path in paths)
    return tuple(one for one in found if one is not None)


def _earlier(path: Path) -> Earlier | None:
    try:
        job = Job.from_json(json.loads((path / JOB).read_text("utf-8")))
        rows = path / ROWS
        kept = json.loads(rows.read_text("utf-8")) if rows.exists() else []
    except (OSError, ValueError, TypeError, KeyError):
        return None
    return Earlier(path, job, tuple(kept), (path / WEIGHTS).exists())


def _flat(row: Mapping[str, Any]) -> dict[str, Any]:
    cells = {"policy": row["policy"], "right": row["right"]}
    for name in FIGURES:
        low, high = row[name]["ci95"]
        cells |= {name: row[name]["mean"], f"{name}_low": low, f"{name}_high": high}
    return cells


def _save(path: Path, value: object) -> None:
    text = json.dumps(value, ensure_ascii=False, allow_nan=False, indent=1)
    replace_file(path, text.encode() + b"\n")


def _csv(names: Sequence[str], rows: Sequence[Mapping[str, Any]]) -> bytes:
    text = io.StringIO()
    writer = csv.DictWriter(text, list(names), lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows)
    return text.getvalue().encode()

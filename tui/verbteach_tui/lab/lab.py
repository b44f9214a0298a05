"""The lab: at most one job at a time, in a process of its own that can be ended at any moment."""

from __future__ import annotations

import json
import subprocess
import sys
import tempfile
import threading
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

from verbteach_sessions.names import new_id
from verbteach_tui.lab.jobs import Job

IDLE, RUNNING, DONE, CANCELLED, FAILED = "idle", "running", "done", "cancelled", "failed"
_COMMAND = (sys.executable, "-m", "verbteach_tui.lab.worker")
_STOPPING = 5.0  # seconds that a worker may take to end


@dataclass(frozen=True)
class LabState:
    """How the job stands. ``curves`` has the figures of each stage, in order; ``note`` the end."""

    phase: str = IDLE
    job: Job | None = None
    stage: str = ""
    done: int = 0
    total: int = 0
    curves: Mapping[str, tuple[float, ...]] = field(default_factory=dict)
    rows: tuple[Mapping[str, Any], ...] = ()
    folder: Path | None = None
    note: str = ""

    @property
    def running(self) -> bool:
        """Whether there is work going on."""
        return self.phase == RUNNING

    def after(self, line: Mapping[str, Any]) -> LabState:
        """The state after a line of the worker's."""
        if "failed" in line:
            return replace(self, phase=FAILED, note=str(line["failed"]))
        if "saved" in line:
            return replace(self, phase=DONE, note="")
        if "row" in line:
            return replace(self, rows=(*self.rows, line["row"]))
        stage = line["stage"]
        grown = (*self.curves.get(stage, ()), *line["figures"])
        curves = {**self.curves, stage: grown} if line["figures"] else self.curves
        return replace(self, stage=stage, done=line["done"], total=line["total"], curves=curves)


class Lab:
    """Starts jobs and follows them. ``state`` is replaced as a whole, so any thread may read it."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.state = LabState()
        self._lock = threading.Lock()
        self._process: subprocess.Popen[str] | None = None
        self._reader: threading.Thread | None = None

    def start(self, job: Job) -> bool:
        """Begin a job; False where one is going on."""
        with self._lock:
            if self.state.running:
                return False
            self.state = LabState(RUNNING, job, folder=self.folder / new_id())
        self._reader = threading.Thread(target=self._follow, args=(self.state,), daemon=True)
        self._reader.start()
        return True

    def cancel(self) -> None:
        """End the job, if one is going on; what it has saved stays."""
        with self._lock:
            if not self.state.running:
                return
            kept = "the policies compared so far are kept" if self.state.rows else "nothing is kept"
            self.state = replace(self.state, phase=CANCELLED, note=kept)
        self._end()

    def close(self) -> None:
        """End whatever is going on, and wait for it."""
        self.cancel()
        if self._reader is not None:
            self._reader.join(_STOPPING)

    def _follow(self, first: LabState) -> None:
        """In a thread of its own: start the worker, and take in its lines to the end."""
        with tempfile.TemporaryFile("w+", encoding="utf-8") as complaints:
            try:
                process = subprocess.Popen(
                    _COMMAND,
                    stdin=subprocess.PIPE,
                    stdout=subprocess.PIPE,
                    stderr=complaints,
                    text=True,
                    start_new_session=True,  # a Ctrl-C at the terminal is not meant for it
                )
            except OSError as error:
                self._take(first, {"failed": str(error)})
                return
            self._process = process
            if not self._same(first):  # cancelled before it began
                self._end()
            self._listen(first, process)
            if self.state.running and self._same(first):
                complaints.seek(0)
                said = complaints.read().strip().splitlines()
                self._take(first, {"failed": said[-1] if said else "the worker ended early"})

    def _listen(self, first: LabState, process: subprocess.Popen[str]) -> None:
        request = {"job": first.job.to_json() if first.job else {}, "folder": str(first.folder)}
        try:
            with process:
                assert process.stdin is not None
                assert process.stdout is not None
                process.stdin.write(json.dumps(request) + "\n")
                process.stdin.close()
                for line in process.stdout:
                    self._take(first, json.loads(line))
        except (OSError, ValueError):  # it was ended in the middle of a line
            return

    def _take(self, first: LabState, line: Mapping[str, Any]) -> None:
        with self._lock:
            if self.state.running and self.state.folder == first.folder:
                self.state = self.state.after(line)

    def _same(self, first: LabState) -> bool:
        return self.state.running and self.state.folder == first.folder

    def _end(self) -> None:
        process = self._process
        if process is not None and process.poll() is None:
            process.terminate()

"""The files of weights that a study's conditions begin with: read, checked, and known by hash."""

from __future__ import annotations

from collections.abc import Mapping
from hashlib import sha256
from pathlib import Path

from verbteach.policy.learned_policy import LearnedPolicy
from verbteach_scenarios.weights import WeightsFileError, read_weights
from verbteach_sessions.study.tables import Table

LEARNED = LearnedPolicy.name
"""The policy that has weights."""


def copy_of_weights(folder: Path, weights_hash: str) -> Path:
    """Where the copy of a file of weights with this hash lies among a study's records."""
    return folder / f"weights-{weights_hash[:16]}.json"


class WeightsBeside:
    """Reads what conditions name, from beside the study's file in ``folder``.

    With ``kept``, hashes by condition, the copies of these are read instead of
    the named files. ``attached`` has the bytes of all that were read, by hash.
    """

    def __init__(self, folder: Path, kept: Mapping[str, str] | None = None) -> None:
        self._folder, self._kept = folder, kept
        self.attached: dict[str, bytes] = {}

    def read(self, condition: Table, named: str) -> str:
        """The SHA-256 of the file; where it does not fit, that is noted, and the answer empty."""
        if not named:
            return ""
        known = None if self._kept is None else self._kept.get(condition.text("id", ""), "")
        path = self._folder / named if known is None else copy_of_weights(self._folder, known)
        try:
            raw = path.read_bytes()
            read_weights(raw, path)
        except (OSError, WeightsFileError) as error:
            reason = error.strerror if isinstance(error, OSError) else str(error)
            condition.fail("weights", f"{named!r} cannot be taken: {reason}")
            return ""
        found = sha256(raw).hexdigest()
        if known is not None and found != known:
            condition.fail("weights", f"{path.name} was changed after somebody began with it")
            return ""
        self.attached[found] = raw
        return found

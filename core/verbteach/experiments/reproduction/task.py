"""One piece of work of a reproduction: one policy at one noise level in one run, with its key."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass, field
from hashlib import sha256
from typing import Any

from verbteach.experiments.interactive_protocol import Config


@dataclass(frozen=True)
class Task:
    """A configuration, and in ``about`` what else its row hangs on: the data, the grounding."""

    config: Config
    about: Mapping[str, str] = field(default_factory=dict)

    def to_json(self) -> dict[str, Any]:
        """As JSON gives it back, so that keys agree before and after a file."""
        data: dict[str, Any] = json.loads(json.dumps({**self.config.to_json(), **self.about}))
        return data

    @property
    def key(self) -> str:
        """What the task's row is known by, the same in every process."""
        return key_of(self.to_json())


def key_of(settings: Mapping[str, Any]) -> str:
    """A short hash of a task as JSON."""
    text = json.dumps(settings, sort_keys=True, separators=(",", ":"))
    return sha256(text.encode()).hexdigest()[:16]

"""Many runs: rows keyed by their configuration, so that a killed sweep goes on where it was.

How the work is spread comes in as ``mapper`` and where rows are kept as
``keep``; a row is a function of its configuration alone, so neither the
number of workers nor the order of work changes one.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from hashlib import sha256
from typing import Any, NamedTuple, Protocol

from verbteach.experiments.figures import Observation
from verbteach.experiments.interactive_protocol import Config, Result

GROUND = ("np_grd_whq", "np_grd_ynq", "bulk_np_grd_ynq")
ENVIRONMENT = ("env_pred_ynq", "pred_change_ynq")
GOAL = ("goal_pred_ynq", "goal_relevant_ynq")
KINDS: Mapping[str, tuple[str, ...]] = {"ground": GROUND, "env": ENVIRONMENT, "goal": GOAL}
"""The paper's kinds of questions (Table 5), by act names."""


class Command(NamedTuple):
    """How one test command went: its document, its scores and its questions by kind."""

    instance: str
    document: str
    ied: float
    sji: float
    right: bool
    certainty: float
    ground: int
    env: int
    goal: int

    @property
    def total(self) -> int:
        """All questions."""
        return self.ground + self.env + self.goal


@dataclass(frozen=True)
class Row:
    """One run: what was asked for, and every test command; ``learning`` are means per lesson."""

    config: Mapping[str, Any]
    commands: tuple[Command, ...]
    learning: Mapping[str, float]
    lessons: int
    kept: float

    @property
    def key(self) -> str:
        """The configuration's key."""
        return key_of(self.config)

    @property
    def policy(self) -> str:
        """The policy's name."""
        return str(self.config["policy"])

    def observations(self, value: str) -> list[Observation]:
        """One figure of every command: ``ied``, ``sji``, ``total``, ``goal`` and so on."""
        return [Observation(c.document, float(getattr(c, value))) for c in self.commands]

    def to_json(self) -> dict[str, Any]:
        """Plain JSON, one line of a file of rows."""
        return {
            "key": self.key,
            "config": dict(self.config),
            "commands": [list(command) for command in self.commands],
            "learning": dict(self.learning),
            "lessons": self.lessons,
            "kept": self.kept,
        }

    @classmethod
    def from_json(cls, data: Mapping[str, Any]) -> Row:
        """Read a row. Raises ``ValueError`` where it is none or its key does not fit."""
        try:
            row = cls(
                data["config"],
                tuple(Command(*one) for one in data["commands"]),
                data["learning"],
                int(data["lessons"]),
                float(data["kept"]),
            )
            fits = row.key == data["key"]
        except (KeyError, TypeError) as error:
            raise ValueError(f"not a row of results: {error!r}") from error
        if not fits:
            raise ValueError(f"the row {data['key']} was made with another configuration")
        return row


def key_of(config: Mapping[str, Any]) -> str:
    """A short hash of a configuration, the same in every process."""
    text = json.dumps(config, sort_keys=True, separators=(",", ":"))
    return sha256(text.encode()).hexdigest()[:16]


def row_of(config: Config, result: Result) -> Row:
    """A run's result as a row."""
    commands = tuple(
        Command(
            t.instance, t.group, t.ied, t.sji, t.right, t.certainty,
            *(_count(t.questions, kind) for kind in KINDS),
        )
        for t in result.tested
    )  # fmt: skip
    lessons = result.taught.dialogues
    learning = {
        kind: _count(result.taught.questions, kind) / max(1, lessons) for kind in ("ground", "env")
    }
    kept = result.taught.right / max(1, lessons)
    return Row(plain(config), commands, learning, lessons, kept)


def plain(config: Config) -> dict[str, Any]:
    """A configuration as JSON gives it back, so that keys agree before and after a file."""
    data: dict[str, Any] = json.loads(json.dumps(config.to_json()))
    return data


def _count(questions: Mapping[str, int], kind: str) -> int:
    return sum(questions.get(name, 0) for name in KINDS[kind])


class Mapper(Protocol):
    """Applies a function to every configuration, in any number of processes, in any order."""

    def __call__(
        self, function: Callable[[Config], Row], configs: Sequence[Config], /
    ) -> Iterable[Row]:
        """Give the rows back as they are done."""
        ...


def in_turn(function: Callable[[Config], Row], configs: Sequence[Config], /) -> Iterator[Row]:
    """The mapper of one process."""
    return map(function, configs)


def sweep(
    configs: Sequence[Config],
    score: Callable[[Config], Row],
    done: Iterable[Row] = (),
    keep: Callable[[Row], None] | None = None,
    mapper: Mapper = in_turn,
) -> tuple[Row, ...]:
    """Score what is not done yet, keep each row as it comes, and give all in the configs' order."""
    wanted = {key_of(plain(config)): config for config in configs}
    rows = {row.key: row for row in done if row.key in wanted}
    left = [config for key, config in wanted.items() if key not in rows]
    for row in mapper(score, left):
        if row.key not in wanted or row.key in rows:
            raise ValueError(f"the row {row.key} was not asked for, or came twice")
        rows[row.key] = row
        if keep is not None:
            keep(row)
    return tuple(rows[key] for key in wanted)


def table4_configs(
    base: Config,
    policies: Sequence[str] = ("rl", "manual", "random", "split"),
    noises: Sequence[str] = ("perfect", "std3", "std5", "uniform"),
    runs: int = 20,
) -> list[Config]:
    """Every policy at every noise level, run by run; draws are shared across policies."""
    return [
        replace(base, policy=policy, noise=noise, run=run)
        for run in range(runs)
        for noise in noises
        for policy in policies
    ]


def figure5_configs(
    base: Config,
    policies: Sequence[str] = ("rl", "manual", "random", "split"),
    shares: Sequence[float] = (0.1, 0.25, 0.5, 0.75, 1.0),
    runs: int = 20,
) -> list[Config]:
    """Growing parts of the lessons, at one noise level; the same lessons for every policy."""
    return [
        replace(base, policy=policy, verb_share=share, run=run)
        for run in range(runs)
        for share in shares
        for policy in policies
    ]

"""What a task leaves behind: how every test command went, and what was asked in learning."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, NamedTuple

from verbteach.experiments.figures import Observation
from verbteach.experiments.interactive_results import Result, Tested
from verbteach.experiments.reproduction.task import Task, key_of

GROUND = ("np_grd_whq", "np_grd_ynq", "bulk_np_grd_ynq")
ENVIRONMENT = ("env_pred_ynq", "pred_change_ynq")
GOAL = ("goal_pred_ynq", "goal_relevant_ynq")
KINDS: Mapping[str, tuple[str, ...]] = {"ground": GROUND, "env": ENVIRONMENT, "goal": GOAL}
"""The paper's kinds of questions (Table 5), by act names."""


class Command(NamedTuple):
    """How one test command went: its document, its scores and its questions by kind.

    ``trace`` has (IED, SJI) after no question, after one and so on.
    """

    instance: str
    document: str
    ied: float
    sji: float
    right: bool
    certainty: float
    ground: int
    env: int
    goal: int
    trace: tuple[tuple[float, float], ...] = ()

    @property
    def total(self) -> int:
        """All questions."""
        return self.ground + self.env + self.goal


class Score(NamedTuple):
    """How a test command went at a checkpoint."""

    document: str
    ied: float
    sji: float


class Checkpoint(NamedTuple):
    """The test commands with the verbs of so many lessons."""

    lessons: int
    scores: tuple[Score, ...]


@dataclass(frozen=True)
class Row:
    """One run: what was asked for, and every test command.

    ``learning`` are mean questions per lesson by kind, ``kept`` the share of
    lessons whose goal was right. ``seconds`` of a processor's time are no
    result and make no difference.
    """

    settings: Mapping[str, Any]
    commands: tuple[Command, ...]
    learning: Mapping[str, float]
    lessons: int
    kept: float
    checkpoints: tuple[Checkpoint, ...] = ()
    seconds: float = field(default=0.0, compare=False)

    @property
    def key(self) -> str:
        """The task's key."""
        return key_of(self.settings)

    @property
    def policy(self) -> str:
        """The policy's name."""
        return str(self.settings["policy"])

    @property
    def noise(self) -> str:
        """The noise level."""
        return str(self.settings["noise"])

    @property
    def run(self) -> int:
        """The run's number."""
        return int(self.settings["run"])

    @property
    def place(self) -> str:
        """Where in the tables it stands: what is drawn for its interval hangs on this alone.

        Not on the key, which is another one with each version of the program.
        """
        return " ".join(str(self.settings[name]) for name in ("policy", "noise", "seed", "run"))

    @property
    def growth(self) -> tuple[Checkpoint, ...]:
        """The checkpoints, and at last the whole; none where there are no checkpoints."""
        whole = tuple(Score(c.document, c.ied, c.sji) for c in self.commands)
        return (*self.checkpoints, Checkpoint(self.lessons, whole)) if self.checkpoints else ()

    def observations(self, value: str) -> list[Observation]:
        """One figure of every command: ``ied``, ``sji``, ``total``, ``goal`` and so on."""
        return [Observation(c.document, float(getattr(c, value))) for c in self.commands]

    def learned(self, kind: str) -> float:
        """Mean questions per lesson of a kind, or in ``total``."""
        return sum(self.learning.values()) if kind == "total" else self.learning[kind]

    def to_json(self) -> dict[str, Any]:
        """Plain JSON, one line of a file of rows."""
        return {
            "key": self.key,
            "settings": dict(self.settings),
            "commands": [list(command) for command in self.commands],
            "learning": dict(self.learning),
            "lessons": self.lessons,
            "kept": self.kept,
            "checkpoints": [[one.lessons, *map(list, one.scores)] for one in self.checkpoints],
            "seconds": self.seconds,
        }

    @classmethod
    def from_json(cls, data: Any) -> Row:
        """Read a row. Raises ``ValueError`` where it is none or its key does not fit."""
        try:
            row = cls(
                data["settings"],
                tuple(_command(one) for one in data["commands"]),
                data["learning"],
                int(data["lessons"]),
                float(data["kept"]),
                tuple(_checkpoint(one) for one in data["checkpoints"]),
                float(data["seconds"]),
            )
            fits = row.key == data["key"]
        except (KeyError, TypeError, ValueError, IndexError) as error:
            raise ValueError(f"not a row of results: {error!r}") from error
        if not fits:
            raise ValueError(f"the row {data['key']} was made with another configuration")
        return row


def row_of(task: Task, result: Result) -> Row:
    """A task's result as a row."""
    taught = result.taught
    lessons = max(1, taught.dialogues)
    return Row(
        task.to_json(),
        tuple(_went(tested) for tested in result.tested),
        {kind: count(taught.questions, kind) / lessons for kind in ("ground", "env", "goal")},
        taught.dialogues,
        taught.right / lessons,
        tuple(
            Checkpoint(one.lessons, tuple(Score(t.group, t.ied, t.sji) for t in one.tested))
            for one in result.checkpoints
        ),
    )


def count(questions: Mapping[str, int], kind: str) -> int:
    """How many questions are of a kind."""
    return sum(questions.get(name, 0) for name in KINDS[kind])


def _went(tested: Tested) -> Command:
    return Command(
        tested.instance,
        tested.group,
        tested.ied,
        tested.sji,
        tested.right,
        tested.certainty,
        count(tested.questions, "ground"),
        count(tested.questions, "env"),
        count(tested.questions, "goal"),
        tested.trace,
    )


def _command(values: Sequence[Any]) -> Command:
    *fields, trace = values
    return Command._make((*fields, tuple((ied, sji) for ied, sji in trace)))


def _checkpoint(values: Sequence[Any]) -> Checkpoint:
    lessons, *scores = values
    return Checkpoint(int(lessons), tuple(Score(*one) for one in scores))

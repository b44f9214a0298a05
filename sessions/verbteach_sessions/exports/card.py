"""The dataset card: what a corpus holds, in figures, and what its columns mean."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from pathlib import PurePosixPath

from verbteach_sessions.exports.columns import SESSIONS, TURNS, Table
from verbteach_sessions.exports.dialogue import Dialogue
from verbteach_sessions.exports.front_matter import Written, front_matter
from verbteach_sessions.exports.kinds import word


class Figures:
    """Counts over dialogues, grown one by one so that none is kept."""

    def __init__(self) -> None:
        self.sessions = 0
        self.turns = 0
        self.commands = 0
        self.seconds = 0.0
        self.people: set[str] = set()
        self.verbs: set[str] = set()
        self.scenes: set[str] = set()
        self.teachers: Counter[str] = Counter()
        self.questions: Counter[str] = Counter()
        self.splits: Counter[str] = Counter()

    def add(self, dialogue: Dialogue) -> None:
        """Count one dialogue more."""
        self.sessions += 1
        self.turns += len(dialogue.turns)
        commands = {turn.command for turn in dialogue.turns if turn.command is not None}
        self.commands += len(commands)
        self.seconds += dialogue.seconds
        if dialogue.participant:
            self.people.add(dialogue.participant)
        self.verbs |= set(dialogue.verbs_learned)
        self.scenes |= {turn.scene for turn in dialogue.turns}
        self.teachers[dialogue.teacher] += 1
        self.questions.update(turn.question for turn in dialogue.held if turn.question)
        self.splits[dialogue.split] += 1

    @property
    def rows(self) -> list[tuple[str, str]]:
        """The figures with their names, for a table."""
        kinds = ", ".join(f"{self.teachers[name]} {name}" for name in sorted(self.teachers))
        splits = ", ".join(f"{name} {self.splits[name]}" for name in sorted(self.splits))
        return [
            ("sessions", str(self.sessions)),
            ("taught by", kinds),
            ("sessions in each split", splits),
            ("people, by their codes", str(len(self.people))),
            ("turns", str(self.turns)),
            ("commands", str(self.commands)),
            ("questions asked", str(sum(self.questions.values()))),
            ("verbs learned", ", ".join(sorted(self.verbs)) or "none"),
            ("scenes", ", ".join(sorted(self.scenes))),
            ("hours of session time", f"{self.seconds / 3600:.2f}"),
        ]


def card(figures: Figures, written: Written) -> str:
    """The card as Markdown, led by the YAML that the hub reads."""
    front = front_matter(figures.turns, written)
    return "\n".join([*front, *_about(figures), *_tables(written)]) + "\n"


def _about(figures: Figures) -> Iterator[str]:
    yield from ("# Teaching sessions with a household robot", "")
    yield (
        "Someone gives a simulated robot a command, answers its questions, shows it what to do or"
        " judges what it did. The sessions were recorded and exported with verbteach."
    )
    simulated = figures.teachers["simulated"]
    if simulated:
        yield from ("", f"**{simulated} of {figures.sessions} sessions were taught by a program**,")
        yield "not by people: the column `teacher` of the table `sessions` tells which."
    yield from ("", "| | |", "|---|---|")
    yield from (f"| {name} | {value} |" for name, value in figures.rows)
    yield from ("", "Times are seconds since a session began; no time of day is in the data.")
    yield "Participant codes are random and stand for nobody outside the records."
    yield from ("", "Before it is published: state who collected this, under what consent, and")
    yield "under which licence it may be used (`license` at the top of this file)."


def _tables(written: Written) -> Iterator[str]:
    for table in (TURNS, SESSIONS):
        paths = ", ".join(f"`{PurePosixPath(path)}`" for _, path in written[table.name])
        yield from ("", f"## {table.name}", "", f"{table.meaning} In {paths};")
        yield f"the schema is `schema/{table.name}.schema.json`."
        yield from ("", "| column | type | meaning |", "|---|---|---|")
        yield from _columns(table)


def _columns(table: Table) -> Iterator[str]:
    for column in table.columns:
        yield f"| `{column.name}` | {word(column.kind)} | {column.meaning} |"

"""The scan of sessions for personal data, and what of it is still to be decided."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from verbteach_sessions.corpus.personal import Scanner
from verbteach_sessions.corpus.redactions import Choice, Decision, Redactions
from verbteach_sessions.exports.dialogue import Dialogue, Turn
from verbteach_sessions.exports.reading import nothing, read_dialogue


@dataclass(frozen=True)
class Finding:
    """A text that looks personal: in which session, first at which event, and what was decided.

    ``seq`` is ``None`` where it stands in no turn but in the header or a questionnaire.
    """

    session: str
    seq: int | None
    kind: str
    text: str
    choice: Choice | None

    def to_json(self) -> dict[str, Any]:
        """The fields."""
        return dict(vars(self))

    def decision(self, choice: Choice) -> Decision:
        """The decision about it."""
        return Decision(self.session, self.kind, self.text, choice)


def scan(path: Path, scanner: Scanner, redactions: Redactions) -> Iterator[Finding]:
    """What looks personal in the session at ``path``, each text once. Raises as reading does."""
    yield from _found(path.name, read_dialogue(path, nothing), scanner, redactions)


def left_over(path: Path, scanner: Scanner, redactions: Redactions) -> Iterator[Finding]:
    """What an export of the session would still hold, texts that may go out apart."""
    redactor = redactions.redactor(path.name)
    for finding in _found(path.name, read_dialogue(path, redactor), scanner, redactions):
        if finding.choice != "keep":
            yield finding


def _found(
    session: str, dialogue: Dialogue, scanner: Scanner, redactions: Redactions
) -> Iterator[Finding]:
    seen: set[str] = set()
    told: set[str] = set()
    for seq, text in _texts(dialogue):
        if text in seen:
            continue
        seen.add(text)
        for hit in scanner.hits(text):
            if hit.text.casefold() not in told:
                told.add(hit.text.casefold())
                choice = redactions.decided(session, hit.text)
                yield Finding(session, seq, hit.kind, hit.text, choice)


def _texts(dialogue: Dialogue) -> Iterator[tuple[int | None, str]]:
    for turn in dialogue.turns:
        yield from ((turn.seq, text) for text in _of_turn(turn))
    about = [dialogue.study, dialogue.questionnaires, dialogue.interface]
    yield from ((None, text) for text in _strings(about))


def _of_turn(turn: Turn) -> Iterable[str]:
    """All that a person typed, and where the robot may have it from them."""
    yield from turn.texts
    yield turn.raw
    yield from _strings(list(turn.acts))
    grounding = (turn.beliefs or {}).get("grounding", [])
    yield from (str(phrase["phrase"]) for phrase in grounding)
    experience = (turn.learned or {}).get("experience", [])
    yield from (str(phrase) for phrase, _ in experience)


def _strings(value: Any) -> Iterator[str]:
    if isinstance(value, str):
        yield value
    elif isinstance(value, Mapping):
        for item in value.values():
            yield from _strings(item)
    elif isinstance(value, list):
        for item in value:
            yield from _strings(item)

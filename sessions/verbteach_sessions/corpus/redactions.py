"""The redaction log: what was found in the sessions of a folder, and what was decided about it.

It is kept in the folder, apart from every export, since it holds what exports
must not. Records are never changed: what is to be redacted is replaced on the
way out, wherever it stands, the robot's repeating it included.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Mapping
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any, Literal

from verbteach_sessions.corpus.folder import append_lines, read_lines
from verbteach_sessions.errors import LogError

REDACTIONS_NAME = "redactions.jsonl"

Choice = Literal["redact", "keep"]


@dataclass(frozen=True)
class Decision:
    """About one text in one session: whether it goes out as it is."""

    session: str
    kind: str
    text: str
    choice: Choice


class Redactions:
    """The decisions of a folder. The last one about a text is the one that counts."""

    def __init__(self, path: Path, decisions: Iterable[Decision] = ()) -> None:
        self.path = path
        self._chosen: dict[tuple[str, str], Decision] = {}
        self._remember(decisions)

    @classmethod
    def of(cls, folder: Path) -> Redactions:
        """Those kept in ``folder``. Raises :class:`LogError` on a line that is none."""
        path = folder / REDACTIONS_NAME
        lines = enumerate(read_lines(path), start=1)
        return cls(path, [_decision(path, number, line) for number, line in lines])

    def decided(self, session: str, text: str) -> Choice | None:
        """What was decided about a text."""
        decision = self._chosen.get((session, text.casefold()))
        return None if decision is None else decision.choice

    def choices(self, session: str) -> Counter[str]:
        """How many texts of a session are to be redacted, and how many kept."""
        own = (one for one in self._chosen.values() if one.session == session)
        return Counter(one.choice for one in own)

    def decide(self, decisions: Iterable[Decision]) -> None:
        """Write decisions to the log; they hold from now on. Raises ``StorageError``."""
        made = list(decisions)
        append_lines(self.path, [asdict(decision) for decision in made])
        self._remember(made)

    def redactor(self, session: str) -> Redactor:
        """What replaces the texts to be redacted in this session."""
        own = [one for one in self._chosen.values() if one.session == session]
        return Redactor([one for one in own if one.choice == "redact"])

    def _remember(self, decisions: Iterable[Decision]) -> None:
        for one in decisions:
            self._chosen[one.session, one.text.casefold()] = one


class Redactor:
    """Replaces texts in JSON values by their kind in brackets; ``count`` says how often it did."""

    def __init__(self, decisions: Iterable[Decision]) -> None:
        self.count = 0
        longest = sorted(decisions, key=lambda one: (-len(one.text), one.text))
        self._kinds: Mapping[str, str] = {_key(one.text): one.kind for one in longest}
        texts = "|".join(map(_loosely, longest))
        self._pattern = re.compile(rf"(?i)(?<!\w)(?:{texts})(?!\w)") if longest else None

    def __call__(self, value: Any) -> Any:
        """The value with every text to be redacted replaced, names of members as well."""
        return value if self._pattern is None else self._redacted(value)

    def _redacted(self, value: Any) -> Any:
        if isinstance(value, str):
            return self._replaced(value)
        if isinstance(value, Mapping):
            return {self._redacted(key): self._redacted(item) for key, item in value.items()}
        if isinstance(value, list | tuple):
            return [self._redacted(item) for item in value]
        return value

    def _replaced(self, text: str) -> str:
        if self._pattern is None:
            return text
        replaced, count = self._pattern.subn(lambda m: f"[{self._kinds[_key(m[0])]}]", text)
        self.count += count
        return replaced


def _key(text: str) -> str:
    return " ".join(text.casefold().split())


def _loosely(decision: Decision) -> str:
    """A pattern of the text in which any blanks do: the robot repeats words, not blanks."""
    return r"\s+".join(map(re.escape, decision.text.split()))


def _decision(path: Path, number: int, line: Mapping[str, Any]) -> Decision:
    session, kind, text = (str(line.get(name) or "") for name in ("session", "kind", "text"))
    choice = line.get("choice")
    if not (session.strip() and kind.strip() and text.strip()):
        raise LogError(path, number, "needs the texts 'session', 'kind' and 'text'")
    if choice not in ("redact", "keep"):
        raise LogError(path, number, "'choice' is neither 'redact' nor 'keep'")
    return Decision(session, kind, text, choice)

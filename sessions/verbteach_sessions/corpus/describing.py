"""Everything the records of a corpus can say for its datasheet, gathered in one pass."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import Any

from verbteach_sessions.corpus.datasheet import facts_of
from verbteach_sessions.corpus.folder import corpus_of
from verbteach_sessions.corpus.redactions import Redactions
from verbteach_sessions.corpus.stats import Stats
from verbteach_sessions.exports.dialogue import Dialogue
from verbteach_sessions.exports.reading import read_dialogue
from verbteach_sessions.visible import visible

Heard = Callable[[int], None]


def describe(sessions: Iterable[Path], heard: Heard = lambda done: None) -> dict[str, list[str]]:
    """The facts of a datasheet by heading. ``heard`` is told how many sessions have been read.

    Raises the errors of reading.
    """
    stats, about = Stats(), _About()
    for done, path in enumerate(sessions, start=1):
        dialogue = read_dialogue(path)
        stats.add(dialogue)
        about.add(dialogue, path)
        heard(done)
    return facts_of(stats.to_json(), about.to_json())


class _About:
    """What differs from session to session and is no figure."""

    def __init__(self) -> None:
        self._seen: dict[str, Counter[str]] = {}
        self._choices: Counter[str] = Counter()
        self._folders: dict[Path, Redactions] = {}

    def add(self, dialogue: Dialogue, path: Path) -> None:
        """Look at one session more."""
        study = dialogue.study or {}
        consent = study.get("consent")
        text = consent.get("text") if isinstance(consent, Mapping) else None
        for name, value in (
            ("interface", dialogue.interface),
            ("question policy", dialogue.policy),
            ("noise of the robot's eyes (spread)", dialogue.noise.get("spread")),
            ("scene it began in", dialogue.scene),
            ("study", study.get("id") or "none"),
            ("software", f"verbteach {dialogue.software.get('verbteach')}"),
            ("consent", _hash(text) if text else f"none on record ({dialogue.teacher})"),
        ):
            self._seen.setdefault(name, Counter())[visible(str(value))] += 1
        folder = corpus_of(path)
        if folder not in self._folders:
            self._folders[folder] = Redactions.of(folder)
        self._choices.update(self._folders[folder].choices(path.name))

    def to_json(self) -> dict[str, Any]:
        """What :func:`facts_of` takes."""
        told = {name: _counted(counts) for name, counts in self._seen.items()}
        consent = told.pop("consent", "no session")
        return {
            "method": told,
            "consent": {"text agreed to, by its SHA-256": consent},
            "personal": {
                "texts redacted in exports": self._choices["redact"],
                "texts found and kept as harmless": self._choices["keep"],
            },
        }


def _hash(text: Any) -> str:
    return str(text)[:16]


def _counted(counts: Counter[str]) -> str:
    return ", ".join(f"{name} ({counts[name]})" for name in sorted(counts))

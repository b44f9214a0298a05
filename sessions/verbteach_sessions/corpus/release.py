"""May a corpus go out? Every reason against it, by name."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Any

from verbteach.dialogue.setting import Settings
from verbteach_sessions.corpus.datasheet import datasheet, figures_in, left_to_do
from verbteach_sessions.corpus.describing import describe
from verbteach_sessions.corpus.findings import left_over
from verbteach_sessions.corpus.folder import corpus_of
from verbteach_sessions.corpus.personal import Scanner
from verbteach_sessions.corpus.redactions import Redactions
from verbteach_sessions.corpus.splits import grouped, member, read_splits
from verbteach_sessions.corpus.withdrawal import withdrawn
from verbteach_sessions.errors import SessionError
from verbteach_sessions.exports.reading import read_dialogue
from verbteach_sessions.header import versions
from verbteach_sessions.validate import validate

Heard = Callable[[str, int], None]

REASONS: Mapping[str, str] = {
    "valid": "A record breaks a rule of `sessions validate`.",
    "withdrawn": "A person who withdrew is still in it.",
    "personal": "An export would still hold what looks personal and was not decided to be kept.",
    "consent": "A participant of a study has no consent on record.",
    "datasheet": "There is no datasheet, something in it is left to do, or its figures are old.",
    "splits": "A part of the corpus shares a person, words or a history with another part.",
}


@dataclass(frozen=True)
class Reason:
    """What speaks against a release: by which rule, in which session if in one, and how."""

    rule: str
    session: str | None
    message: str


@dataclass(frozen=True)
class Release:
    """What was found. ``warnings`` are for a person to weigh; they stop nothing."""

    problems: tuple[Reason, ...]
    warnings: tuple[Reason, ...]

    @property
    def ready(self) -> bool:
        """Whether nothing speaks against it."""
        return not self.problems

    def to_json(self) -> dict[str, Any]:
        """What ``sessions release --json`` prints."""
        return {
            "ready": self.ready,
            "problems": [asdict(one) for one in self.problems],
            "warnings": [asdict(one) for one in self.warnings],
        }


@dataclass(frozen=True)
class Corpus:
    """What is to go out: sessions, the datasheet's file, and a file of splits if there is one."""

    sessions: Sequence[Path]
    datasheet: Path
    splits: Path | None = None
    names: tuple[str, ...] = ()


def check_release(
    corpus: Corpus, settings: Settings, heard: Heard = lambda stage, done: None
) -> Release:
    """Look at everything. ``heard`` is told how many sessions each stage has done.

    Raises ``SplitError``, and ``LogError`` on a file kept beside the sessions that cannot be read.
    """
    problems: list[Reason] = []
    warnings: list[Reason] = []
    for done, path in enumerate(corpus.sessions, start=1):
        _validated(path, settings, problems, warnings)
        heard("records", done)
    # What cannot be read cannot be looked at either; all else is said at once.
    readable = replace(corpus, sessions=[path for path in corpus.sessions if _reads(path)])
    scanner = Scanner(corpus.names)
    for done, path in enumerate(readable.sessions, start=1):
        problems += _about_people(path, scanner)
        warnings += _without_study(path)
        heard("people", done)
    problems += _about_splits(readable)
    problems += _about_datasheet(readable)
    return Release(tuple(problems), tuple(warnings))


def _validated(
    path: Path, settings: Settings, problems: list[Reason], warnings: list[Reason]
) -> None:
    found = validate(path, settings)
    # What looks personal is looked at again, with what was decided about it.
    others = [one for one in found.warnings if one.rule != "personal"]
    warnings += [Reason("valid", path.name, one.message) for one in others]
    old = bool(found.problems) and _is_of_other_software(path)
    for one in found.problems:
        # Another version may word or choose otherwise; what was recorded stays the authority.
        kind = warnings if one.rule == "replay" and old else problems
        kind.append(Reason("valid", path.name, f"{one.rule}: {one.message}"))


def _reads(path: Path) -> bool:
    try:
        read_dialogue(path)
    except SessionError:
        return False
    return True


def _is_of_other_software(path: Path) -> bool:
    """Whether the record was made by other versions than those that would recompute it."""
    try:
        made = read_dialogue(path).software
    except SessionError:
        return False
    return any(made.get(name) != version for name, version in versions().items())


def _about_people(path: Path, scanner: Scanner) -> Iterator[Reason]:
    folder, dialogue = corpus_of(path), read_dialogue(path)
    if dialogue.participant in withdrawn(folder):
        yield Reason("withdrawn", path.name, f"{dialogue.participant} withdrew")
    if dialogue.study is not None and not _consented(dialogue.study):
        yield Reason("consent", path.name, "the header names a study and no consent")
    for finding in left_over(path, scanner, Redactions.of(folder)):
        place = "" if finding.seq is None else f" (event {finding.seq})"
        yield Reason("personal", path.name, f"{finding.kind}: {finding.text}{place}")


def _without_study(path: Path) -> Iterator[Reason]:
    dialogue = read_dialogue(path)
    if dialogue.teacher == "human" and dialogue.study is None:
        yield Reason(
            "consent", path.name, "taught by a person outside a study: no consent is on record"
        )


def _consented(study: Mapping[str, Any]) -> bool:
    consent = study.get("consent")
    return isinstance(consent, Mapping) and bool(consent.get("text"))


def _about_splits(corpus: Corpus) -> Iterator[Reason]:
    if corpus.splits is None:
        return
    parts = read_splits(corpus.splits)
    members = [member(read_dialogue(path)) for path in corpus.sessions]
    for one in members:
        if one.session not in parts:
            yield Reason("splits", one.session, "is in no part")
    for group in grouped(members):
        found = sorted({parts[session] for session in group if session in parts})
        if len(found) > 1:
            yield Reason("splits", None, f"{', '.join(group)} belong together: {', '.join(found)}")


def _about_datasheet(corpus: Corpus) -> Iterator[Reason]:
    path = corpus.datasheet
    try:
        text = path.read_text("utf-8")
    except (OSError, UnicodeDecodeError):
        yield Reason("datasheet", None, f"{path}: cannot be read; make it with sessions datasheet")
        return
    for title in left_to_do(text):
        yield Reason("datasheet", None, f"{path}: something is left to do under {title!r}")
    now = datasheet(describe(corpus.sessions), {})
    if figures_in(text) != figures_in(now):
        yield Reason("datasheet", None, f"{path}: its figures are old; make it again")

"""What a session taught, read from its record alone: for sessions that go on from it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from verbteach.dialogue.acts import AskAgain, Learned
from verbteach.dialogue.moves import Phase
from verbteach.policy.learned_policy import LearnedPolicy
from verbteach.verbs.knowledge import VerbKnowledge
from verbteach_sessions.account import Account
from verbteach_sessions.errors import LogError, NotASessionError
from verbteach_sessions.header import Header, Source
from verbteach_sessions.history import History
from verbteach_sessions.method import Method, knowledge_of, practised
from verbteach_sessions.names import safe_name

Experience = Mapping[tuple[str, str], int]


@dataclass(frozen=True)
class Taught:
    """What a session taught: the verbs, and how to ask where its policy is one that learns.

    ``method`` is the session's own; ``asked`` counts the questions after each
    demonstration that a verb was learned from.
    """

    source: Source
    policy: LearnedPolicy | None
    method: Method
    asked: tuple[int, ...]


def source_from(path: Path) -> Source:
    """The verbs that ``path`` (a session's folder or log) taught, to begin another session with.

    Nothing is recomputed. Raises the errors of reading a log.
    """
    return taught_by(path).source


def taught_by(path: Path) -> Taught:
    """What ``path`` (a session's folder or log) taught, to begin another session with.

    Nothing is recomputed: the weights follow from the recorded steps. Raises
    the errors of reading a log.
    """
    account = Account(path)
    for _ in account:
        pass
    history, log = account.history, account.reader.path
    header = history.header
    if header is None or history.current is None:
        raise NotASessionError(f"{log}: nothing was said in this session")
    records = (*header.data["learned_before"], *history.records())
    try:
        knowledge_of(records)
        method = Header.from_json(header.data).method
        policy = practised(method.policy, records)
    except ValueError as error:
        raise LogError(log, 0, f"what was learned cannot be read, {error}") from error
    # The weights travel in the next session's own header, as they have become.
    verbs = tuple(_without_steps(record) for record in records)
    source = Source(safe_name(header.data["id"]), account.content.hexdigest, verbs)
    learned = policy if isinstance(policy, LearnedPolicy) else None
    return Taught(source, learned, method, tuple(_asked_while_learning(history)))


def knowledge_from(path: Path) -> tuple[VerbKnowledge, Experience]:
    """What a session's robot knew in the end: its verbs, and what phrases meant how often."""
    return knowledge_of(source_from(path).records)


def _asked_while_learning(history: History) -> Iterator[int]:
    """The questions of each learning phase that came to a verb; one put again counts once."""
    asked = 0
    for node in history.effective():
        if node.phase == Phase.LEARNING.value:
            asked += AskAgain.name not in node.acts
        elif Learned.name in node.acts:
            yield asked
        if node.phase not in _LEARNING:
            asked = 0


_LEARNING = frozenset({Phase.LEARNING.value, Phase.READ_BACK.value})


def _without_steps(record: Mapping[str, Any]) -> Mapping[str, Any]:
    return {name: value for name, value in record.items() if name != "policy"}

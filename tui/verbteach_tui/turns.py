"""The turns of a session to pick from: those to go back to, and those that were taken back."""

from __future__ import annotations

from typing import NamedTuple

from verbteach_sessions.history import Node
from verbteach_sessions.session import Session
from verbteach_sessions.transcript import said_in
from verbteach_tui.snapshot import Snapshot
from verbteach_tui.spoken import in_words
from verbteach_tui.views.visible import shortened


class TurnChoice(NamedTuple):
    """A turn: what the teacher had said last, and how many acts are undone to get there.

    Below 0 they are done again; 0 is the turn on the screen.
    """

    number: int
    text: str
    undone: int


def turns_of(session: Session, snapshot: Snapshot) -> tuple[TurnChoice, ...]:
    """All turns there are to go to, in order."""
    holding, taken_back = session.turns(), session.redoable
    now = len(holding) - 1
    first = next((i for i in range(now, -1, -1) if holding[i].root), 0)
    choices = [
        TurnChoice(index, _said(turn, snapshot), now - index)
        for index, turn in enumerate(holding)
        if index >= first
    ]
    for ahead, turn in enumerate(taken_back, 1):
        choices.append(TurnChoice(now + ahead, _said(turn, snapshot), -ahead))
    return tuple(choices)


def _said(turn: Node, snapshot: Snapshot) -> str:
    line = said_in(turn)
    if line is None:
        return "the beginning"
    return shortened(in_words(line.kind, line.text, snapshot.wording), 120)

"""Hearing a command: read it clause by clause, or ask for other words."""

from __future__ import annotations

from verbteach.dialogue import execution
from verbteach.dialogue.acts import AskRephrase, AwaitCommand, StartClause
from verbteach.dialogue.draft import Draft
from verbteach.dialogue.moves import Phase
from verbteach.dialogue.understanding import (
    attached,
    clause_text,
    read_command,
    read_reply,
)


def hear(draft: Draft, text: str) -> None:
    """Take up a command, or a yes to the command that the robot offered instead."""
    offered = draft.state.suggested
    draft.remember(suggested="")
    if offered and (label := read_reply(text).label):
        if label == "yes":
            hear(draft, offered)
        else:
            draft.wait(AskRephrase("Then please say it in other words."), Phase.COMMAND)
        return
    reading = read_command(draft, text)
    if not reading.frames:
        draft.remember(suggested=reading.suggestion)
        draft.wait(AskRephrase(reading.problem), Phase.COMMAND)
        return
    draft.reading = "; ".join(clause_text(frame) for frame in reading.frames)
    draft.remember(clauses=reading.frames, referents=())
    go_on(draft)


def go_on(draft: Draft) -> None:
    """Turn to the next clause of the command, or wait for the next command."""
    if not draft.state.clauses:
        draft.wait(AwaitCommand(), Phase.COMMAND)
        return
    frame, *rest = draft.state.clauses
    several = rest or draft.acts
    draft.remember(clauses=tuple(rest))
    if several:
        draft.say(StartClause(clause_text(frame)))
    execution.begin(draft, clause_text(frame), attached(draft, frame))

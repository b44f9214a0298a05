"""Hearing a command: read it clause by clause, or ask for other words."""

from __future__ import annotations

from verbteach.dialogue import enquiries, execution
from verbteach.dialogue.acts import AskRephrase, AwaitCommand, StartClause
from verbteach.dialogue.draft import Draft
from verbteach.dialogue.moves import Phase
from verbteach.dialogue.referring import attached
from verbteach.dialogue.replies import Reply, read_reply
from verbteach.dialogue.understanding import CommandReading, clause_text, read_command
from verbteach.language.ellipsis import read_ellipsis
from verbteach.language.frames import VerbFrame
from verbteach.language.tokens import tokenise
from verbteach.language.wordlist import word_set

_BEFORE_A_VERB = frozenset({",", "."}) | word_set(
    "now then next please and so also you can could may should would must i want to"
)


def hear(draft: Draft, text: str) -> None:
    """Take up a command, or the answer to the command that the robot offered instead.

    A no to a word that the robot offered means the word that was said, unless
    another command comes behind it.
    """
    suggested, heard, offered = draft.state.suggested, draft.state.heard, draft.state.offered
    draft.remember(suggested="", heard="", offered=())
    reply = read_reply(text) if suggested else Reply("")
    label, instead = reply.label, reply.rest
    if label == "no" and instead and (meant := read_command(draft, instead)).frames:
        _consider(draft, instead, meant)
    elif not label:
        _consider(draft, text, read_command(draft, text))
    elif label == "no" and heard and not instead:
        _consider(draft, heard, read_command(draft, heard, as_said=True))
    elif label != "yes":
        draft.wait(AskRephrase("Then please say it in other words."), Phase.COMMAND)
    elif offered:
        _take_up(draft, offered)
    else:
        hear(draft, suggested)


def _consider(draft: Draft, text: str, reading: CommandReading) -> None:
    """Take up what was read, or ask where nothing was or it may not be meant like this."""
    if not reading.frames:
        draft.remember(suggested=reading.suggestion, heard=text if reading.suggestion else "")
        said = enquiries.answer(draft, text) if reading.asks else ""
        draft.wait(AskRephrase(said or reading.problem), Phase.COMMAND)
    elif reading.disputed or reading.question:
        _offer(draft, reading.frames, reading.question)
    else:
        _take_up(draft, reading.frames, shown=reading.shown)


def _offer(draft: Draft, frames: tuple[VerbFrame, ...], question: str) -> None:
    """Ask whether the robot's own reading is what the teacher means."""
    said = ", then ".join(clause_text(frame) for frame in frames)
    draft.remember(suggested=said, offered=frames)
    asked = question or f"I read that as: {said}. Is that what you mean?"
    draft.wait(AskRephrase(asked), Phase.COMMAND)


def put_behind(draft: Draft, text: str) -> bool:
    """Keep a command that was said behind a yes until its turn; whether it is one."""
    reading = read_command(draft, text) if text else None
    if reading is None or not reading.frames or reading.disputed or reading.question:
        return False
    words = [word for word in tokenise(text) if word not in _BEFORE_A_VERB]
    if read_ellipsis(text) is None and words[:1] != [reading.frames[0].verb.split(" ")[0]]:
        return False
    draft.remember(clauses=(*draft.state.clauses, *reading.frames))
    return True


def _take_up(draft: Draft, frames: tuple[VerbFrame, ...], *, shown: bool = False) -> None:
    draft.reading = "; ".join(clause_text(frame) for frame in frames)
    draft.remember(clauses=frames, referents=())
    go_on(draft, shown=shown)


def go_on(draft: Draft, *, shown: bool = False) -> None:
    """Turn to the next clause of the command, or wait for the next command.

    ``shown``: the teacher wants to show it, known or not.
    """
    if not draft.state.clauses:
        draft.wait(AwaitCommand(), Phase.COMMAND)
        return
    frame, *rest = draft.state.clauses
    several = rest or draft.acts
    draft.remember(clauses=tuple(rest), latest=frame)
    if several:
        draft.say(StartClause(clause_text(frame)))
    execution.begin(draft, clause_text(frame), attached(draft, frame), shown=shown)

"""Correcting what was learned, between two commands: a fluent is struck out or confirmed."""

from __future__ import annotations

from verbteach.dialogue.acts import Confirm, ReviseVerb, RuleOut
from verbteach.dialogue.closing import await_command
from verbteach.dialogue.draft import Draft
from verbteach.dialogue.moves import IllegalMoveError
from verbteach.verbs.revision import Revision, RevisionError, revised
from verbteach.verbs.space import FrameKey


def revise(draft: Draft, act: RuleOut | Confirm) -> None:
    """Take the teacher's word. Raises ``IllegalMoveError`` where it fits nothing that is known."""
    before = draft.state.knowledge
    try:
        frame = FrameKey.parse(act.frame)
        hypothesis = tuple(sorted(act.hypothesis))
        revision = Revision(frame, hypothesis, act.literal, isinstance(act, Confirm))
        knowledge = revised(before, revision)
    except (RevisionError, ValueError) as error:
        raise IllegalMoveError(str(error)) from error
    if knowledge.digest == before.digest:
        raise IllegalMoveError("that is so already: nothing would change")
    draft.remember(knowledge=knowledge)
    draft.revisions.append(revision)
    counts = (len(one.frames[frame].nodes) for one in (before, knowledge))
    draft.say(ReviseVerb(frame.verb, act.literal, revision.wanted, *counts))
    await_command(draft)

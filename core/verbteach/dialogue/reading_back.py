"""The goal was read back: the teacher says whether it is right, or what should be different."""

from __future__ import annotations

from verbteach.dialogue import acts, commands, demonstration, learning
from verbteach.dialogue.acts import DemonstrationReason, TeacherAct
from verbteach.dialogue.draft import Draft
from verbteach.dialogue.replies import offers_to_show, read_verdict


def hear(draft: Draft, act: TeacherAct) -> None:
    """Take the verdict on the goal, or what should be different about it."""
    match act:
        case acts.Good():
            learning.accept(draft)
            commands.go_on(draft)
        case acts.Bad():
            learning.reject(draft)
        case acts.Strike(literal=literal):
            learning.strike(draft, literal)
        case acts.Keep(literal=literal):
            learning.keep(draft, literal)
        case acts.Show():
            demonstration.request(draft, DemonstrationReason.SHOW_AGAIN)
        case acts.Skip():
            learning.abandon(draft)
            commands.go_on(draft)
        case acts.Say(text=text):
            _read_back_in_words(draft, text)


def _read_back_in_words(draft: Draft, text: str) -> None:
    reply = read_verdict(text)
    draft.reading = reply.label
    if offers_to_show(acts.Say(text)):
        hear(draft, acts.Show())
    elif reply.reserved:
        draft.ask_again(
            "Is it right just as I said it? Say yes; or say no, and then what to change."
        )
    elif reply.label == "yes":
        commands.put_behind(draft, reply.rest)
        hear(draft, acts.Good())
    elif reply.label == "no":
        hear(draft, acts.Bad())
    elif reply.label == "skip":
        hear(draft, acts.Skip())
    else:
        problem = "Say yes if this is the goal, no if it is not, or skip. You can also strike parts"
        draft.ask_again(f"{problem} of it, keep what I left out, or show me again.")

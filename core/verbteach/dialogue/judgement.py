"""The teacher judges what was carried out, and may say what should have been done instead."""

from __future__ import annotations

from collections.abc import Sequence

from verbteach.dialogue import acts, carrying_out, commands, demonstration, execution
from verbteach.dialogue.acts import DemonstrationReason, Outcome, TeacherAct
from verbteach.dialogue.closing import close
from verbteach.dialogue.corrections import another_noun, another_reference, other_things
from verbteach.dialogue.draft import Draft
from verbteach.dialogue.replies import offers_to_show, read_verdict
from verbteach.dialogue.speech import Speech
from verbteach.language.corrections import read_correction
from verbteach.language.morphology import listing
from verbteach.language.refer import Candidates


def hear(draft: Draft, act: TeacherAct) -> None:
    """Take the verdict on what was carried out, in a key or in words."""
    match act:
        case acts.Good():
            carrying_out.approve(draft)
            commands.go_on(draft)
        case acts.Bad() | acts.Stop():
            carrying_out.disapprove(draft)
            demonstration.request(draft, DemonstrationReason.WRONG_EXECUTION)
        case acts.Show():
            demonstration.request(draft, DemonstrationReason.TAKEN_OVER)
        case acts.Skip():
            close(draft, Outcome.UNJUDGED)
            commands.go_on(draft)
        case acts.Say(text=text):
            _judgement_in_words(draft, text)


def _judgement_in_words(draft: Draft, text: str) -> None:
    reply = read_verdict(text)
    draft.reading = reply.label
    if offers_to_show(acts.Say(text)):
        hear(draft, acts.Show())
    elif reply.reserved:
        draft.ask_again("Was it right just as I did it? Say yes or no first, and then the rest.")
    elif reply.label == "yes":
        commands.put_behind(draft, reply.rest)
        hear(draft, acts.Good())
    elif _corrected(draft, text):
        return
    elif reply.label == "no":
        hear(draft, acts.Bad())
    elif reply.label == "skip":
        hear(draft, acts.Skip())
    else:
        draft.ask_again("Say yes if it was right, no if it was not, or skip.")


def _corrected(draft: Draft, text: str) -> bool:
    """Whether the words said what should have been meant.

    The robot starts over with it; where it could be several things, it asks which.
    """
    correction = read_correction(text)
    if correction is None:
        return False
    reference = another_reference(draft, correction)
    if reference is not None:
        return _with_other_words(draft, *reference)
    exchanges = other_things(draft, correction)
    if len(exchanges) > 1:
        _ask_which(draft, [exchange.now for exchange in exchanges])
        return True
    for exchange in exchanges:
        draft.reading = f"{exchange.was}: {exchange.now}"
        if execution.correct_goal(draft, exchange.goal):
            return True
    reference = another_noun(draft, correction)
    return reference is not None and _with_other_words(draft, *reference)


def _with_other_words(draft: Draft, phrase: str, things: Candidates) -> bool:
    draft.reading = f"{phrase}: {', '.join(thing for thing, _ in things)}"
    execution.correct_reference(draft, phrase, things)
    return True


def _ask_which(draft: Draft, things: Sequence[str]) -> None:
    """A correction that fits several things: which one, asked with the judgement still open."""
    name = Speech.of(draft.mind.setting, draft.state.world).thing
    named = listing([name(thing) for thing in dict.fromkeys(things)], "or")
    draft.ask_again(f"Do you mean {named}? Say which one, or no if none of them.")

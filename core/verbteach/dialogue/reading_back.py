"""The goal was read back: the teacher says whether it is right, or what should be different."""

from __future__ import annotations

from verbteach.dialogue import acts, commands, demonstration, enquiries, learning
from verbteach.dialogue.acts import DemonstrationReason, TeacherAct
from verbteach.dialogue.demonstration import ordered
from verbteach.dialogue.draft import Draft
from verbteach.dialogue.goal_words import restated
from verbteach.dialogue.replies import Reply, offers_to_show, read_verdict
from verbteach.dialogue.speech import Speech
from verbteach.dialogue.worth import without_departures
from verbteach.language.first_person import first_person
from verbteach.language.morphology import listing
from verbteach.world.fluents import Goal, Literal


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
    elif told := enquiries.asked(draft, text):
        draft.ask_again(told)
    elif _restated(draft, text, reply):
        return
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
        draft.ask_again(_OTHERWISE)


def _restated(draft: Draft, text: str, reply: Reply) -> bool:
    """Whether the words said what the goal is, or what of it matters; it is read back again.

    What cannot be taken in is said, and nothing changes.
    """
    read_back = draft.episode.read_back
    if read_back is None or reply.label == "skip":
        return False
    said = restated(draft, text, read_back.goal, read_back.whole)
    if said is None or (said.problem and reply.label == "yes" and not reply.reserved):
        return False
    if problem := said.problem or _not_shown(draft, said.goal):
        draft.ask_again(problem)
        return True
    words = Speech.of(draft.mind.setting, draft.state.world).words
    draft.reading = words.goal(without_departures(ordered(said.goal))) or "nothing"
    learning.restate(draft, said.goal)
    return True


def _not_shown(draft: Draft, goal: Goal) -> str:
    """What of a goal does not hold after the demonstration, as a sentence."""
    world, words = draft.state.world, Speech.of(draft.mind.setting, draft.state.world).words
    missing = [one for one in ordered(goal) if not one.holds(world)]
    if not missing:
        return ""
    now = listing([words.describe(Literal(one.fluent, not one.positive)) for one in missing])
    return f"You have shown me something else: {first_person(now)} now. {_SHOW_AGAIN}"


_SHOW_AGAIN = "Say show to show me again, or say otherwise what must hold."
_OTHERWISE = (
    "Say yes if this is the goal, no if it is not, or skip."
    " You can also say what must hold and what does not matter, or show me again."
)

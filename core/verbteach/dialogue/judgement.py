"""The teacher judges what was carried out, and may say what should have been done instead."""

from __future__ import annotations

from collections.abc import Sequence

from verbteach.dialogue import acts, carrying_out, commands, demonstration, enquiries, execution
from verbteach.dialogue.acts import DemonstrationReason, Outcome, TeacherAct
from verbteach.dialogue.closing import close
from verbteach.dialogue.corrections import another_noun, another_reference, other_things
from verbteach.dialogue.demonstration import ordered
from verbteach.dialogue.draft import Draft
from verbteach.dialogue.goal_corrections import Meant, goals_meant, said_anew, says_how_it_should_be
from verbteach.dialogue.replies import offers_to_show, read_verdict
from verbteach.dialogue.speech import Speech
from verbteach.dialogue.understanding import clause_text
from verbteach.dialogue.worth import without_departures
from verbteach.language.corrections import read_correction
from verbteach.language.first_person import first_person
from verbteach.language.frames import VerbFrame
from verbteach.language.goal_talk import read_goal_talk
from verbteach.language.morphology import listing
from verbteach.language.refer import Candidates
from verbteach.language.wordlist import word_set
from verbteach.world.fluents import Goal, satisfied


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
    elif told := enquiries.asked(draft, text):
        draft.ask_again(told)
    elif _put_right(draft, text):
        return
    elif reply.label == "no":
        hear(draft, acts.Bad())
    elif reply.label == "skip":
        hear(draft, acts.Skip())
    else:
        draft.ask_again("Say yes if it was right, no if it was not, or skip.")


def _put_right(draft: Draft, text: str) -> bool:
    """Whether the words said what should have been done, or come of it, and it was taken up.

    A thing that was taken wrongly comes before a goal where the words may choose one:
    "no, take the other one".
    """
    anew, meant = said_anew(draft, text), goals_meant(draft, text)
    if anew and len(anew[0].arguments) > 1:
        return _begun_anew(draft, anew, meant.goals[-1:])
    goal_first = says_how_it_should_be(text) or not (anew or _chooses(text))
    if goal_first and not meant.doubtful and _with_goal(draft, meant):
        return True
    if _corrected(draft, text) or (anew and _begun_anew(draft, anew)):
        return True
    return _with_goal(draft, meant)


def _chooses(text: str) -> bool:
    """Whether it may only say what to take for it: "no, use the pot"."""
    talk = read_goal_talk(text)
    return talk is not None and not _CHOOSING.isdisjoint(talk.tokens[:4])


def _begun_anew(draft: Draft, frames: Sequence[VerbFrame], goals: Sequence[Goal] = ()) -> bool:
    """The command was said again in other words: everything is put back, and it is taken up.

    The words may tell its goal as well: "no, put it on the table".
    """
    carrying_out.disapprove(draft)
    draft.remember(world=draft.episode.start)
    close(draft, Outcome.ABANDONED)
    (frame,) = frames
    command = clause_text(frame)
    draft.reading = command
    draft.remember(latest=frame)
    if any(execution.begin_with_goal(draft, command, frame, goal) for goal in goals):
        return True
    draft.say(acts.AskAgain("I see, and have put everything back first."))
    draft.remember(clauses=(frame, *draft.state.clauses))
    commands.go_on(draft)
    return True


def _with_goal(draft: Draft, meant: Meant) -> bool:
    """Whether the words said how things should be; the robot makes them so, or says why not.

    How to go about it is shown, not told: such words are a no, and the robot says so.
    """
    if meant.first:
        draft.say(acts.AskAgain(_BY_SHOWING))
        hear(draft, acts.Bad())
        return True
    if meant.problem:
        draft.ask_again(meant.problem)
        return True
    for goal in meant.goals:
        draft.reading = _in_words(draft, goal)
        if execution.correct_goal(draft, goal):
            return True
    if meant.goals:
        draft.ask_again(_unreached(draft, meant.goals[-1]))
    return bool(meant.goals)


def _unreached(draft: Draft, goal: Goal) -> str:
    words = Speech.of(draft.mind.setting, draft.state.world).words
    said = first_person(listing([words.describe(one) for one in without_departures(ordered(goal))]))
    if satisfied(goal, draft.episode.start):
        return f"That was so before I began: {said}. {_OTHERWISE}"
    return f"I find no way to this: {said}. {_OTHERWISE}"


def _in_words(draft: Draft, goal: Goal) -> str:
    words = Speech.of(draft.mind.setting, draft.state.world).words
    return words.goal(without_departures(ordered(goal)))


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


_CHOOSING = word_set("use take try with pick get choose grab taken used")
_BY_SHOWING = (
    "How to go about it I learn by seeing it: show me one step after the other,"
    " and say done after the last one."
)
_OTHERWISE = "Say otherwise how it should be, or say show and show me."

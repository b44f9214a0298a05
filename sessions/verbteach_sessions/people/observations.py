"""What people did with the robot's questions, one observation an answer that holds.

An episode is looked at as a whole, since what a phrase meant often shows only
when the command has been carried out or shown.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from verbteach.dialogue import acts
from verbteach.dialogue.acts import RobotAct, TeacherAct
from verbteach.dialogue.replies import read_reply
from verbteach.dialogue.setting import Settings
from verbteach_sessions.header import SIMULATED
from verbteach_sessions.people.golds import Gold, Later, LessonBook
from verbteach_sessions.people.habits import ASKED
from verbteach_sessions.people.recorded import Recorded, Said
from verbteach_sessions.people.standing import Standing

YES, NO, UNSURE, GAVE_UP, OBJECT, UNREAD = "yes", "no", "unsure", "gave up", "object", "unread"


@dataclass(frozen=True)
class Observed:
    """One answer.

    ``question`` is the act's name, ``asked`` how many of the command's
    questions came before. ``answer`` is one of this module's six; good and bad
    are yes and no. ``right`` says whether it was the right one and ``truth``
    whether yes would have been; both ``None`` where nothing tells. ``words`` is
    what was said where that was nothing but the answer, ``spoken`` whether
    words were used at all.
    """

    person: str
    session: str
    seq: int
    question: str
    asked: int
    answer: str
    right: bool | None
    truth: bool | None
    words: str
    spoken: bool


def observe(recorded: Recorded, book: LessonBook, settings: Settings) -> tuple[Observed, ...]:
    """The answers of a session. ``book`` tells what simulated teachers and study tasks meant.

    A person who says what they like may use a lesson's words and mean something
    else, so the book is asked only about the others.
    """
    told = recorded.header.teacher == SIMULATED or recorded.header.study is not None
    found: list[Observed] = []
    for episode in recorded.episodes():
        last = episode[-1].before
        lessons = book.meant(last.scene, last.command) if told else ()
        found += _answers(recorded, episode, Gold(lessons, later(episode), settings))
    return tuple(found)


def later(episode: Sequence[Said]) -> Later:
    """What an episode showed in the end.

    Phrases meant what they were taken for if the execution was judged right,
    and of their candidates the only one that the demonstration handled. The
    goal is the one that was read back and accepted.
    """
    last = episode[-1]
    before, outcome = last.before, last.after.outcome
    if outcome is acts.Outcome.EXECUTED:
        return Later({phrase: o[0] for phrase, o in (before.grounding or {}).items() if o})
    if outcome is acts.Outcome.LEARNED and isinstance(before.waiting, acts.IncludeFluent):
        return Later(_handled(before), before.waiting.goal)
    return Later()


def _handled(last: Standing) -> Mapping[str, str]:
    touched = {word for action in last.shown for word in action.args}
    found = {}
    for phrase, things in (last.first or {}).items():
        among = [thing for thing in things if thing in touched]
        if len(among) == 1:
            found[phrase] = among[0]
    return found


def _answers(recorded: Recorded, episode: Sequence[Said], gold: Gold) -> Iterator[Observed]:
    for one in episode:
        question = one.before.waiting
        answer = answer_of(one)
        # A second word on the same thing is a correction and no answer.
        if question.name not in ASKED or answer is None or one.before.again or one.before.corrected:
            continue
        right, truth = _rightness(question, answer, one, gold)
        text = one.act.text if isinstance(one.act, acts.Say) else ""
        yield Observed(
            recorded.person,
            recorded.header.id,
            one.seq,
            question.name,
            one.before.asked,
            answer,
            right,
            truth,
            text if text and not read_reply(text).rest else "",
            bool(text),
        )


def answer_of(said: Said) -> str | None:
    """What the teacher's act comes to; ``None`` for what is no answer, as striking a fluent."""
    if said.after.again:
        return UNREAD
    if isinstance(said.act, acts.Say):
        reading = said.after.reading
        label, _, thing = reading.partition(" ")
        return label if label in (YES, NO, UNSURE) and not thing else OBJECT if reading else UNREAD
    return _PLAIN.get(type(said.act))


def _rightness(
    question: RobotAct, answer: str, said: Said, gold: Gold
) -> tuple[bool | None, bool | None]:
    if isinstance(question, acts.NpGrdWhq):
        meant, named = gold.objects(question.np), _named(said)
        known = answer == OBJECT and meant is not None and named
        return (named in meant if known and meant is not None else None), None
    truth = gold.truth(question, said.before)
    if truth is None or answer not in (YES, NO):
        return None, truth
    return truth == (answer == YES), truth


def _named(said: Said) -> str:
    """The object that was pointed at or, in words, understood."""
    if isinstance(said.act, acts.Point):
        return said.act.object
    return said.after.reading.split()[-1] if said.after.reading else ""


_PLAIN: dict[type[TeacherAct], str] = {
    acts.Yes: YES,
    acts.No: NO,
    acts.Unsure: UNSURE,
    acts.Skip: GAVE_UP,
    acts.Show: GAVE_UP,
    acts.Point: OBJECT,
    acts.Good: YES,
    acts.Bad: NO,
    acts.Stop: NO,
}

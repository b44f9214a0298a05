"""What an answer or a verdict says: yes, no, don't know, and what else was said."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from verbteach.dialogue import acts
from verbteach.language.answers import read_answer
from verbteach.language.small_talk import Talk, small_talk


@dataclass(frozen=True)
class Reply:
    """An answer's label (yes, no, unsure or empty), what else was said, and what is unclear.

    ``reserved``: a yes with something against it or beside it.
    """

    label: str
    rest: str = ""
    problem: str = ""
    reserved: bool = False


def read_reply(text: str, *, verdict: bool = False) -> Reply:
    """Read yes, no, don't know and what else was said."""
    reading = read_answer(text, verdict=verdict)
    if reading.label is not None:
        return Reply(reading.label.value, reading.rest, reserved=reading.reserved)
    if reading.contradictory:
        return Reply("", "", "Is that a yes or a no? I heard both.")
    talk = Talk.WAIT if text.strip(" .!").lower() == "wait" else small_talk(text)
    if talk in _PASSING:
        return Reply("unsure")
    if talk is not None and talk in _ANSWERED:
        return Reply("", "", _ANSWERED[talk])
    return Reply("", reading.rest, "I did not understand that. Is it yes, no, or don't you know?")


def read_verdict(text: str) -> Reply:
    """Read yes, no or skip as a verdict on what was done or read back; else no label."""
    reply = read_reply(text, verdict=True)
    if reply.label == "unsure":
        return Reply("skip" if small_talk(text) in _PASSING else "")
    return reply


def offers_to_show(act: acts.TeacherAct) -> bool:
    """Whether the teacher takes over, in a word or in words: "no, let me show you"."""
    if not isinstance(act, acts.Say):
        return isinstance(act, acts.Show)
    return Talk.SHOW in {small_talk(act.text), small_talk(read_verdict(act.text).rest)}


_PASSING = frozenset({Talk.GIVE_UP, Talk.ABSENT})
_ANSWERED: Mapping[Talk, str] = {
    Talk.HELP: "To hear why I ask, say why. You can also skip the question.",
    Talk.REPEAT: "Once more:",
    Talk.WAIT: "I am waiting.",
    Talk.BACK: "To take back what you said last, say undo.",
    Talk.LEAVE: "To leave, say quit; you can go on later.",
    Talk.SHOW: "To show me yourself, say show.",
}

"""What speaks against taking a command as it was read, and what the robot says then.

A command that cannot be carried out as it is meant is turned down with what to
say instead; one that leaves something out, or may not be meant, is asked about.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from verbteach.dialogue.draft import Draft
from verbteach.language import household
from verbteach.language.frames import Argument, VerbFrame
from verbteach.language.grammar import EMPTY_LEXICON
from verbteach.language.looks import Looks
from verbteach.language.refer import refer
from verbteach.language.tokens import sentences, tokenise
from verbteach.language.wording import Wording
from verbteach.language.wordlist import word_set
from verbteach.language.words import ADVERB_PHRASES


class Doubt(NamedTuple):
    """``problem``: why the command is not taken up; ``question``: whether it is meant like this."""

    problem: str = ""
    question: str = ""


_CONDITIONS = word_set("if unless when whenever once before after while until till soon")
_NO_CONDITIONS = frozenset({("once", "more"), ("once", "again"), ("after", "that"), ("at", "once")})
_STATES = frozenset({"make", "ensure", "check", "see", "be", "keep", "know", "think"})
_MOVING = frozenset({"go", "move", "walk", "drive", "come", "change", "switch", "get"})
_ROOMS = frozenset({"kitchen", "room"})
_WAITING = frozenset({"wait", "stay"})
_HELPED = frozenset({"me", "us"})
_HANDING = (household.FOR_DATIVE | household.TO_DATIVE) - word_set(
    "open wash clean mix play fix choose peel warm heat boil fill leave book build"
)
"""Whom it is for matters: "make a cup of tea for me"."""


def doubt(draft: Draft, text: str, frames: Sequence[VerbFrame], looks: Looks) -> Doubt:
    """The first doubt that the command raises; empty where it raises none."""
    said = ", then ".join(_in_words(frame) for frame in frames)
    if problem := _problem(draft, frames, looks):
        return Doubt(problem)
    if any("where" in sentence[1:] for sentence in sentences(tokenise(text))):
        return Doubt(_WHERE)
    if _has_condition(text):
        return Doubt(question=_CONDITION.format(said=said))
    if _is_one_unknown_word(draft, frames):
        return Doubt(question=_UNKNOWN.format(said=said))
    return Doubt()


def _problem(draft: Draft, frames: Sequence[VerbFrame], looks: Looks) -> str:
    """Why the command cannot be taken up as it is."""
    if any(frame.verb.startswith("not ") for frame in frames):
        return _NEVER
    if any(_is_of_another_room(frame, looks) for frame in frames):
        return _ROOM
    bare = [frame.verb for frame in frames if not frame.arguments]
    if any(verb.split(" ")[0] in _STATES for verb in bare):
        return WISH
    if any(verb in _WAITING - {*draft.state.knowledge.verbs} for verb in bare):
        return "I am waiting: tell me when there is something to do."
    lacking = next((frame.verb for frame in frames if _lacks_object(draft, frame)), "")
    asked, named = ("where", "place") if lacking in _MOVING else ("what", "thing")
    return f"I should {lacking}, but {asked}? Please name the {named} as well." if lacking else ""


def without_helped(frame: VerbFrame) -> VerbFrame:
    """Without a "for me" that is only said for politeness: "open the door for me"."""
    if frame.verb.split(" ")[0] in _HANDING:
        return frame
    kept = tuple(argument for argument in frame.arguments if not _is_politeness(argument))
    return VerbFrame(frame.verb, kept)


def _is_politeness(argument: Argument) -> bool:
    return argument.role == "for" and argument.phrase.head in _HELPED


def _in_words(frame: VerbFrame) -> str:
    return Wording(EMPTY_LEXICON, str).clause(frame)


def _is_of_another_room(frame: VerbFrame, looks: Looks) -> bool:
    """Whether it asks for another room: "go to the kitchen"; this one has nothing of that name."""
    goes = frame.verb.split(" ")[0] in _MOVING
    return goes and any(
        phrase.head in _ROOMS and not refer(phrase, looks) for phrase in frame.phrases
    )


def _lacks_object(draft: Draft, frame: VerbFrame) -> bool:
    """Whether the verb needs a thing and was given none: "open"."""
    known = any(key.verb == frame.verb and not key.arity for key in draft.state.knowledge.frames)
    first = frame.verb.split(" ")[0]
    alone = first in household.INTRANSITIVE | _MAY_STAND_ALONE and frame.verb not in _NEEDING
    return not frame.arguments and first in household.VERBS and not alone and not known


def _is_one_unknown_word(draft: Draft, frames: Sequence[VerbFrame]) -> bool:
    """Whether nothing was said but a word that no list knows."""
    if len(frames) != 1 or frames[0].arguments or " " in frames[0].verb:
        return False
    known = {*draft.state.knowledge.verbs, *draft.mind.setting.lexicon.verbs, *household.VERBS}
    return frames[0].verb not in known


def _has_condition(text: str) -> bool:
    """Whether something is to be done only if or when something else is so."""
    return any(
        token in _CONDITIONS and not _is_figure_of_speech(sentence, at)
        for sentence in sentences(tokenise(text))
        for at, token in enumerate(sentence)
    )


def _is_figure_of_speech(tokens: Sequence[str], at: int) -> bool:
    """As in "if you can", "once more", "when you are done"."""
    if tokens[at] == "soon" and tokens[at - 1 : at] != ["as"]:
        return True
    if tokens[at] == "soon":
        return _is_figure_of_speech_at(tokens, at - 1)
    around = [tuple(tokens[at : at + 2]), tuple(tokens[max(at - 1, 0) : at + 1])]
    if not _NO_CONDITIONS.isdisjoint(around) or tuple(tokens[at + 1 : at + 4]) in _READY:
        return True
    return _is_figure_of_speech_at(tokens, at)


def _is_figure_of_speech_at(tokens: Sequence[str], at: int) -> bool:
    fixed = ADVERB_PHRASES.get(tokens[at], ())
    return any(tuple(tokens[at : at + len(words)]) == words for words in fixed)


_READY = frozenset(
    {("you", "are", "done"), ("you", "are", "ready"), ("you", "have", "time"), ("you", "do", "not")}
)
_MAY_STAND_ALONE = household.MOVING | word_set(
    "wait cook clean tidy wash relax start stop begin finish eat drink iron vacuum sweep dust "
    "look listen sit stand dance sing play help work turn go leave return knock"
)
_NEEDING = frozenset({"turn on", "turn off", "turn up", "turn down", "go", "move", "walk"})
_NEVER = (
    "I do nothing that I am not told to do, and I cannot keep in mind what not to do."
    " Tell me only what to do."
)
_ROOM = (
    "I know the rooms by their numbers: say it as in go to kitchen-2."
    " If you mean a thing here, please give its name."
)
WISH = "Please say it as something to do with a thing: open it, close it, turn it off."
_WHERE = "I cannot tell what place that is. Name the place itself, as in: on the table."
_CONDITION = (
    "I cannot wait for anything, or do something only if something else is so."
    " Shall I do this now: {said}?"
)
_UNKNOWN = 'I do not know the word "{said}". Is it something to do, that you want to show me?'

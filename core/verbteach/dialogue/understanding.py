"""What the teacher's words mean here: the language room's readings, applied to this scene."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass, replace

from verbteach.dialogue.doubts import WISH, doubt, without_helped
from verbteach.dialogue.draft import Draft
from verbteach.dialogue.referring import fitting_objects, guesses, looks_now, read_noun_phrase
from verbteach.dialogue.setting import Setting
from verbteach.dialogue.speech import Speech
from verbteach.language import household
from verbteach.language.agreement import agree
from verbteach.language.anaphora import resolve
from verbteach.language.ellipsis import Ellipsis, applied, read_ellipsis
from verbteach.language.frames import VerbFrame
from verbteach.language.grammar import EMPTY_LEXICON, Unread, explain_unread, parse
from verbteach.language.looking import asks_whether_able, is_looking, is_mental, what_it_can
from verbteach.language.small_talk import (
    Talk,
    asks_in_a_command,
    small_talk,
    to_be_shown,
    without_greeting,
)
from verbteach.language.statements import read_statements
from verbteach.language.tokens import spelled_out, tokenise
from verbteach.language.typos import suggest_verb
from verbteach.language.wording import Wording

_CALLED = re.compile(r"(?:,|(?<=please)|(?<=thanks)|(?<=now))\s+robot[\s.!?]*$", re.IGNORECASE)
"""The robot called at the end of a command."""
_LONGEST_COMMAND = 1000
"""Letters: nobody says more in one command, and the record need not carry a book."""


@dataclass(frozen=True)
class CommandReading:
    """A command's clauses; where there are none, the problem and perhaps a command meant.

    ``disputed``: there is a second reader, and it reads the command differently.
    ``question``: what to ask before the clauses are taken up. ``asks``: it is a
    question of the teacher's. ``shown``: the teacher wants to show it.
    """

    frames: tuple[VerbFrame, ...]
    problem: str = ""
    suggestion: str = ""
    disputed: bool = False
    question: str = ""
    asks: bool = False
    shown: bool = False


def read_command(
    draft: Draft, text: str, *, as_said: bool = False, taught: bool = False
) -> CommandReading:
    """Read a command's clauses; a verb near a known one is offered, never taken for it.

    ``as_said``: the teacher has said that the verb is no slip. ``taught``: the
    command is to be shown, so that it asks nothing.
    """
    if len(text) > _LONGEST_COMMAND:
        return CommandReading((), "That is too long for me. Please say it in a sentence or two.")
    text = _CALLED.sub("", without_greeting(text)) or text
    if shown := to_be_shown(text):
        reading = read_command(draft, shown, as_said=as_said, taught=True)
        return replace(reading, shown=len(reading.frames) == 1)
    leaning = read_ellipsis(text)
    if leaning is not None and (read := _once_more(draft, leaning)) is not None:
        return read
    talk = small_talk(text)
    frames = () if talk or asks_in_a_command(text) else _clauses(draft, text)
    if not frames:
        return _unread(draft, text, talk)
    asking = None if taught else _a_question(draft, text, frames)
    return asking or _to_do(draft, text, frames, as_said=as_said)


def _clauses(draft: Draft, text: str) -> tuple[VerbFrame, ...]:
    """The clauses; behind "can you" an unknown word is a verb."""
    setting = draft.mind.setting
    frames = parse(text, setting.lexicon, setting.vocabulary)
    rest = what_it_can(text)
    if rest and (not frames or frames[0].verb in {"can", "could"}):
        return parse(rest, setting.lexicon, setting.vocabulary)
    return frames


def _a_question(draft: Draft, text: str, frames: tuple[VerbFrame, ...]) -> CommandReading | None:
    """What reads like a command and asks something: "can you fly?", "look at the fridge"."""
    mental = any(is_mental(frame) and not _is_known(draft, frame) for frame in frames)
    if asks_whether_able(text) and (mental or not _is_about_the_room(draft, frames)):
        return _asking(draft, _UNREAD[Unread.QUESTION])
    if all(_only_looks(draft, frame) for frame in frames):
        return _asking(draft, _LOOK)
    return None


def _unread(draft: Draft, text: str, talk: Talk | None) -> CommandReading:
    """What is said to words that are no command."""
    setting = draft.mind.setting
    unread = explain_unread(text, setting.lexicon, setting.vocabulary) or Unread.NO_VERB
    why = Unread.QUESTION if asks_in_a_command(text) else unread
    if talk is None and why is Unread.NO_VERB and _wishes(text):
        return CommandReading((), WISH)
    problem = _TALKED[talk] if talk else _UNREAD[why]
    asks = talk is Talk.HELP or (talk is None and why is Unread.QUESTION)
    return replace(_asking(draft, problem), asks=asks)


def _wishes(text: str) -> bool:
    """Whether it says how something should be, and not what to do: "the mug must be clean"."""
    statements = read_statements(tokenise(spelled_out(text)))
    said = {word for word in tokenise(text) if word in {"should", "must", "has", "needs", "shall"}}
    return bool(said) and any(one.subject and one.said for one in statements)


def _asking(draft: Draft, otherwise: str) -> CommandReading:
    """A question of the teacher's; ``otherwise`` is said where there is no answer."""
    example = _example(draft.mind.setting)
    return CommandReading((), otherwise.format(example=example), asks=True)


def _to_do(
    draft: Draft, text: str, frames: tuple[VerbFrame, ...], *, as_said: bool
) -> CommandReading:
    """What is to be done, or what speaks against it."""
    frames = _without_looking(draft, frames)
    typo = None if as_said else _verb_typo(draft, text, frames)
    if typo is None and _is_nonsense(draft, frames):
        return CommandReading((), _NONSENSE.format(example=_example(draft.mind.setting)))
    return typo or _weighed(draft, text, frames)


def _weighed(draft: Draft, text: str, frames: tuple[VerbFrame, ...]) -> CommandReading:
    """The clauses with what their pronouns stand for, and what speaks against them."""
    problem, question = doubt(draft, text, frames, looks_now(draft))
    if problem:
        return CommandReading((), problem)
    disputed = _is_disputed(draft.mind.setting, text, frames)
    resolved = resolve([without_helped(frame) for frame in frames])
    return CommandReading(resolved, disputed=disputed, question=question)


def _once_more(draft: Draft, leaning: Ellipsis) -> CommandReading | None:
    """The last clause again, about another thing if one is named."""
    latest = draft.state.latest
    phrase = read_noun_phrase(draft, leaning.about) if leaning.about else None
    if leaning.about and phrase is None:
        return None
    if latest is None:
        return CommandReading((), _NOT_YET.format(example=_example(draft.mind.setting)))
    return CommandReading((applied(latest, phrase) if phrase else latest,))


def _example(setting: Setting) -> str:
    """A command that makes sense here: to open what is there for little else, if anything is."""
    uses = Counter(thing for ground in setting.task.actions for thing in ground.action.args)
    one = [g.action for g in setting.task.actions if len(g.action.args) == 1]
    openings = [action for action in one if action.name == "open"] or one[:1]
    action = min(openings, key=lambda action: (uses[action.args[0]], action.args), default=None)
    speech = Speech.of(setting, setting.scene.initial)
    return speech.words.action(action) if action else "go"


def _is_about_the_room(draft: Draft, frames: tuple[VerbFrame, ...]) -> bool:
    """Whether something here is spoken of: "can you boil the water?" asks the robot to do it."""
    looks = looks_now(draft)
    return any(
        argument.phrase.is_pronoun
        or fitting_objects(draft, argument, looks)
        or guesses(draft, argument, looks)
        for frame in frames
        for argument in frame.arguments
    )


def _only_looks(draft: Draft, frame: VerbFrame) -> bool:
    """Whether it asks for no more than a look, unless that was taught as something to do."""
    return is_looking(frame) and not _is_known(draft, frame)


def _is_known(draft: Draft, frame: VerbFrame) -> bool:
    return frame.verb in draft.state.knowledge.verbs


def _without_looking(draft: Draft, frames: tuple[VerbFrame, ...]) -> tuple[VerbFrame, ...]:
    """Without the looking around before: "find the mug and wash it"."""
    kept = [frame for frame in frames if not _only_looks(draft, frame)]
    return resolve(list(frames))[-len(kept) :] if 0 < len(kept) < len(frames) else frames


def _is_nonsense(draft: Draft, frames: tuple[VerbFrame, ...]) -> bool:
    """Whether no word of the command is known: an unknown verb alone may be taught."""
    looks = looks_now(draft)
    known = {*draft.state.knowledge.verbs, *draft.mind.setting.lexicon.verbs, *household.VERBS}
    return all(
        frame.arguments and frame.verb not in known and frame.verb.split()[0] not in known
        for frame in frames
    ) and not any(
        fitting_objects(draft, argument, looks) or guesses(draft, argument, looks)
        for frame in frames
        for argument in frame.arguments
    )


def _is_disputed(setting: Setting, text: str, frames: tuple[VerbFrame, ...]) -> bool:
    """Whether the second reader finds other verbs, roles or heads; finding nothing is no reading.

    Compared before pronouns are resolved: the second reader leaves them as they are.
    """
    other = setting.second.read(text) if setting.second is not None else ()
    return bool(other) and not agree(frames, other)


def _verb_typo(draft: Draft, text: str, frames: tuple[VerbFrame, ...]) -> CommandReading | None:
    known = {*draft.state.knowledge.verbs, *draft.mind.setting.lexicon.verbs}
    for frame in frames:
        word = frame.verb.split()[0]
        english = frame.verb in known or word in known or is_looking(frame)
        near = () if english else suggest_verb(word, known)
        if near:
            meant = text.lower().replace(word, near[0], 1)
            problem = f'I do not know the word "{word}". Did you mean "{near[0]}", as in "{meant}"?'
            return CommandReading((), problem, meant)
    return None


def clause_text(frame: VerbFrame) -> str:
    """The clause in words."""
    return Wording(EMPTY_LEXICON, str).clause(frame)


_UNREAD: Mapping[Unread, str] = {
    Unread.EMPTY: "I heard nothing. Tell me what to do, as in: {example}.",
    Unread.NO_WORDS: "I see no words in that. Tell me what to do, as in: {example}.",
    Unread.NOT_ENGLISH: "I understand only English. Tell me what to do, as in: {example}.",
    Unread.QUESTION: (
        "That I cannot answer: I can say where things are, how they are, and what I have learned."
        " Tell me what to do, as in: {example}."
    ),
    Unread.NO_VERB: "I find no verb in that. Tell me what to do with what, as in: {example}.",
}
_LOOK = (
    "I look all the time: ask me where a thing is or how it is. Tell me what to do,"
    " as in: {example}."
)
_NONSENSE = "I know none of these words. Say it in other words, as in: {example}."
_NOTHING = "There is nothing that I am asking or doing. "
_NEXT = "Tell me what to do, as in: {example}."
_TALKED: Mapping[Talk, str] = {
    Talk.HELP: (
        "Tell me what to do, as in: {example}. If I do not know the verb, you show me, one step"
        " after the other; next time, in another room too, I do it myself."
    ),
    Talk.GREETING: "Hello. " + _NEXT,
    Talk.REPLY: "Thank you. " + _NEXT,
    Talk.DONE: _NOTHING + _NEXT,
    Talk.GIVE_UP: _NOTHING + _NEXT,
    Talk.ABSENT: _NOTHING + _NEXT,
    Talk.BACK: "To take back what you said last, say undo. " + _NEXT,
    Talk.LEAVE: "To leave, say quit; you can go on later. " + _NEXT,
    Talk.REPEAT: "I wait to hear what I should do. " + _NEXT,
    Talk.SHOW: "Please tell me first what it is that you want to show, as in: {example}.",
    Talk.WAIT: "I am waiting. " + _NEXT,
}
_NOT_YET = "There is nothing yet that I could do again. " + _NEXT

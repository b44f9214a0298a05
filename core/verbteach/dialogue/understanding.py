"""What the teacher's words mean here: the language room's readings, applied to this scene."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass, replace

from verbteach.dialogue.doubts import doubt, without_helped
from verbteach.dialogue.draft import Draft
from verbteach.dialogue.grounding import GroundingBelief
from verbteach.dialogue.setting import Setting, UnknownObjectError
from verbteach.dialogue.speech import Speech
from verbteach.dialogue.whence import together
from verbteach.language import household
from verbteach.language.agreement import agree
from verbteach.language.anaphora import resolve
from verbteach.language.answers import read_answer
from verbteach.language.attachment import attach
from verbteach.language.ellipsis import Ellipsis, applied, read_ellipsis
from verbteach.language.frames import Argument, NounPhrase, VerbFrame
from verbteach.language.grammar import EMPTY_LEXICON, Unread, explain_unread, parse
from verbteach.language.looks import Looks
from verbteach.language.refer import Candidates, refer
from verbteach.language.small_talk import (
    Talk,
    asks_in_a_command,
    small_talk,
    to_be_shown,
    without_greeting,
)
from verbteach.language.typos import suggest, suggest_verb
from verbteach.language.wording import Wording

_ALL = frozenset({"all", "both"})
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


@dataclass(frozen=True)
class Reply:
    """An answer's label (yes, no, unsure or empty), what else was said, and what is unclear.

    ``reserved``: a yes with something against it or beside it.
    """

    label: str
    rest: str = ""
    problem: str = ""
    reserved: bool = False


def read_command(draft: Draft, text: str, *, as_said: bool = False) -> CommandReading:
    """Read a command's clauses; a verb near a known one is offered, never taken for it.

    ``as_said``: the teacher has said that the verb is no slip.
    """
    if len(text) > _LONGEST_COMMAND:
        return CommandReading((), "That is too long for me. Please say it in a sentence or two.")
    text = _CALLED.sub("", without_greeting(text)) or text
    if shown := to_be_shown(text):
        reading = read_command(draft, shown, as_said=as_said)
        return replace(reading, shown=len(reading.frames) == 1)
    leaning = read_ellipsis(text)
    if leaning is not None and (read := _once_more(draft, leaning)) is not None:
        return read
    setting = draft.mind.setting
    talk, asks = small_talk(text), asks_in_a_command(text)
    frames = () if talk or asks else parse(text, setting.lexicon, setting.vocabulary)
    if not frames:
        unread = explain_unread(text, setting.lexicon, setting.vocabulary) or Unread.NO_VERB
        why = Unread.QUESTION if asks else unread
        problem = _TALKED[talk] if talk else _UNREAD[why]
        asks = talk is Talk.HELP or (talk is None and why is Unread.QUESTION)
        return CommandReading((), problem.format(example=_example(setting)), asks=asks)
    typo = None if as_said else _verb_typo(draft, text, frames)
    if typo is None and _is_nonsense(draft, frames):
        return CommandReading((), _NONSENSE.format(example=_example(setting)))
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


def _is_nonsense(draft: Draft, frames: tuple[VerbFrame, ...]) -> bool:
    """Whether no word of the command is known: an unknown verb alone may be taught."""
    looks = looks_now(draft)
    known = {*draft.state.knowledge.verbs, *draft.mind.setting.lexicon.verbs, *household.VERBS}
    return all(
        frame.arguments and frame.verb not in known and frame.verb.split()[0] not in known
        for frame in frames
    ) and not any(
        fitting_objects(draft, argument, looks) or _guesses(draft, argument, looks)
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
        near = () if frame.verb in known or word in known else suggest_verb(word, known)
        if near:
            meant = text.lower().replace(word, near[0], 1)
            problem = f'I do not know the word "{word}". Did you mean "{near[0]}", as in "{meant}"?'
            return CommandReading((), problem, meant)
    return None


def clause_text(frame: VerbFrame) -> str:
    """The clause in words."""
    return Wording(EMPTY_LEXICON, str).clause(frame)


def attached(draft: Draft, frame: VerbFrame) -> VerbFrame:
    """The frame with its prepositional phrases where the scene says that they belong."""
    return attach(frame, looks_now(draft), [thing for _, thing in draft.state.spoken])


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


def ground_phrases(draft: Draft, frame: VerbFrame) -> tuple[GroundingBelief, frozenset[str]]:
    """The grounding belief at the start, and the phrases whose words had to be guessed.

    The words alone weigh here, without the contents that ``own.ground`` passes
    on: in the bundled lessons those make clear phrases unclear. What a phrase
    has meant before speaks for it (section 4.3: *Grd* is initialised with
    existing knowledge). In one command a phrase keeps the meaning that it had
    in an earlier clause. Something taken from somewhere is there.
    """
    looks = looks_now(draft)
    weights: dict[str, Mapping[str, float]] = {}
    guessed = set()
    same = dict(draft.state.referents)
    for argument in frame.arguments:
        if argument.phrase.text in same:
            weights[argument.phrase.text] = {same[argument.phrase.text]: 1.0}
            continue
        found = fitting_objects(draft, argument, looks)
        if not found:
            found = _guesses(draft, argument, looks)
            guessed |= {argument.phrase.text} if found else set()
        weights[argument.phrase.text] = _experienced(draft, argument.phrase.text, found)
    return GroundingBelief.of(together(frame, weights, looks)), frozenset(guessed)


def fitting_objects(draft: Draft, argument: Argument, looks: Looks) -> Candidates:
    """The objects that an argument of the command may mean by its own words.

    "There" is the last place spoken of, "both" and "all of them" are no single thing.
    """
    spoken = [thing for _, thing in draft.state.spoken]
    if argument.phrase.head == "there":
        return tuple((thing, 1.0) for thing in spoken if _is_place(draft, thing))[-1:]
    found = refer(argument.phrase, looks, spoken, argument.role)
    points = argument.phrase.is_pronoun or argument.phrase.head in _ALL
    several = points and argument.phrase.text.split(" ")[0] in _ALL
    return () if several and len(found) == 1 else found


def _is_place(draft: Draft, thing: str) -> bool:
    """Whether it is something that stands where it stands: nothing puts it anywhere."""
    scene = draft.mind.setting.scene
    first = Looks.at(scene, scene.initial, draft.mind.setting.lexicon)
    return first.is_thing(thing) and first.place(thing) is None


def _guesses(draft: Draft, argument: Argument, looks: Looks) -> Candidates:
    """What the phrase would mean if its noun were a known one that is spelled much like it.

    Else what its noun means without the words before it that describe nothing here ("teh tv").
    """
    phrase = argument.phrase
    heads = suggest(phrase.head, draft.mind.setting.vocabulary)
    for head in heads:
        found = refer(replace(phrase, head=head), looks)
        if found:
            return found
    fitting = tuple(
        word for word in phrase.modifiers if any(looks.has_mark(o, word) for o in looks.objects)
    )
    for head in (phrase.head, *heads) if fitting != phrase.modifiers else ():
        found = refer(replace(phrase, head=head, modifiers=fitting), looks)
        if found:
            return found
    return ()


def _experienced(draft: Draft, phrase: str, found: Candidates) -> dict[str, float]:
    """Each past use of the phrase for an object counts as much as a perfect fit."""
    experience = draft.state.experience
    return {thing: fit + experience.get((phrase, thing), 0) for thing, fit in found}


def read_noun_phrase(draft: Draft, text: str) -> NounPhrase | None:
    """Read a bare noun phrase: as the object of a verb that takes any."""
    setting = draft.mind.setting
    bare = text.removeprefix("it 's ").removeprefix("it is ").removeprefix("that is ")
    frames = parse(f"take {bare}", setting.lexicon, setting.vocabulary)
    return frames[0].phrases[0] if frames and frames[0].phrases else None


def check_object(setting: Setting, object_id: str) -> None:
    """Raise ``UnknownObjectError`` unless the scene has the object."""
    if object_id not in setting.scene.objects:
        near = suggest(object_id, setting.scene.objects)
        offer = f"; did you mean {near[0]}?" if near else ""
        raise UnknownObjectError(f"there is no object {object_id!r} in {setting.scene.id}{offer}")


def looks_now(draft: Draft) -> Looks:
    """How things are just now, for words to refer to."""
    setting = draft.mind.setting
    return Looks.at(setting.scene, draft.state.world, setting.lexicon)


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
_PASSING = frozenset({Talk.GIVE_UP, Talk.ABSENT})
_ANSWERED: Mapping[Talk, str] = {
    Talk.HELP: "To hear why I ask, say why. You can also skip the question.",
    Talk.REPEAT: "Once more:",
    Talk.WAIT: "I am waiting.",
    Talk.BACK: "To take back what you said last, say undo.",
    Talk.LEAVE: "To leave, say quit; you can go on later.",
    Talk.SHOW: "To show me yourself, say show.",
}
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

"""What the teacher's words mean here: the language room's readings, applied to this scene."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from verbteach.dialogue.draft import Draft
from verbteach.dialogue.grounding import GroundingBelief
from verbteach.dialogue.setting import Setting, UnknownObjectError
from verbteach.language.agreement import agree
from verbteach.language.anaphora import resolve
from verbteach.language.answers import read_answer
from verbteach.language.attachment import attach
from verbteach.language.frames import Argument, NounPhrase, VerbFrame
from verbteach.language.grammar import EMPTY_LEXICON, Unread, explain_unread, parse
from verbteach.language.looks import Looks
from verbteach.language.refer import Candidates, refer
from verbteach.language.typos import suggest
from verbteach.language.wording import Wording
from verbteach.world.plan import Action

_LONGEST_COMMAND = 1000
"""Letters: nobody says more in one command, and the record need not carry a book."""


@dataclass(frozen=True)
class CommandReading:
    """A command's clauses; where there are none, the problem and perhaps a command meant.

    ``disputed``: there is a second reader, and it reads the command differently.
    """

    frames: tuple[VerbFrame, ...]
    problem: str = ""
    suggestion: str = ""
    disputed: bool = False


@dataclass(frozen=True)
class Reply:
    """An answer's label (yes, no, unsure or empty), what else was said, and what is unclear."""

    label: str
    rest: str = ""
    problem: str = ""


@dataclass(frozen=True)
class Found:
    """Objects that words may mean, weighted; where there are none, the problem."""

    objects: Candidates = ()
    problem: str = ""


def read_command(draft: Draft, text: str, *, as_said: bool = False) -> CommandReading:
    """Read a command's clauses; a verb near a known one is offered, never taken for it.

    ``as_said``: the teacher has said that the verb is no slip.
    """
    if len(text) > _LONGEST_COMMAND:
        return CommandReading((), "That is too long for me. Please say it in a sentence or two.")
    setting = draft.mind.setting
    frames = parse(text, setting.lexicon, setting.vocabulary)
    if not frames:
        why = explain_unread(text, setting.lexicon, setting.vocabulary)
        return CommandReading((), _UNREAD[why] if why else _UNREAD[Unread.NO_VERB])
    typo = None if as_said else _verb_typo(draft, text, frames)
    return typo or CommandReading(resolve(frames), disputed=_is_disputed(setting, text, frames))


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
        near = () if frame.verb in known or word in known else suggest(word, known)
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
    return attach(frame, _looks(draft), [thing for _, thing in draft.state.spoken])


def read_reply(text: str) -> Reply:
    """Read yes, no, don't know and what else was said."""
    reading = read_answer(text)
    if reading.label is not None:
        return Reply(reading.label.value, reading.rest)
    if reading.contradictory:
        return Reply("", "", "Is that a yes or a no? I heard both.")
    return Reply("", reading.rest, "I did not understand that. Is it yes, no, or don't you know?")


def ground_phrases(draft: Draft, frame: VerbFrame) -> tuple[GroundingBelief, frozenset[str]]:
    """The grounding belief at the start, and the phrases whose words had to be guessed.

    The words alone weigh here, without the contents that ``own.ground`` passes
    on: in the bundled lessons those make clear phrases unclear. What a phrase
    has meant before speaks for it (section 4.3: *Grd* is initialised with
    existing knowledge). In one command a phrase keeps the meaning that it had
    in an earlier clause.
    """
    looks = _looks(draft)
    weights: dict[str, Mapping[str, float]] = {}
    guessed = set()
    same = dict(draft.state.referents)
    for argument in frame.arguments:
        if argument.phrase.text in same:
            weights[argument.phrase.text] = {same[argument.phrase.text]: 1.0}
            continue
        found = _candidates(draft, argument, looks)
        if not found:
            found = _guesses(draft, argument, looks)
            guessed |= {argument.phrase.text} if found else set()
        weights[argument.phrase.text] = _experienced(draft, argument.phrase.text, found)
    return GroundingBelief.of(weights), frozenset(guessed)


def _candidates(draft: Draft, argument: Argument, looks: Looks) -> Candidates:
    spoken = [thing for _, thing in draft.state.spoken]
    return refer(argument.phrase, looks, spoken, argument.role)


def _guesses(draft: Draft, argument: Argument, looks: Looks) -> Candidates:
    """What the phrase would mean if its noun were a known one that is spelled much like it."""
    for head in suggest(argument.phrase.head, draft.mind.setting.vocabulary):
        near = NounPhrase(argument.phrase.text, head, argument.phrase.modifiers)
        found = refer(near, looks)
        if found:
            return found
    return ()


def _experienced(draft: Draft, phrase: str, found: Candidates) -> dict[str, float]:
    """Each past use of the phrase for an object counts as much as a perfect fit."""
    experience = draft.state.experience
    return {thing: fit + experience.get((phrase, thing), 0) for thing, fit in found}


def find_objects(draft: Draft, phrase: str, text: str) -> Found:
    """Objects that an answer's words mean, among the question's candidates if any of them fit."""
    told = _noun_phrase(draft, text)
    if told is None:
        return Found((), "I did not understand that. Name the thing, or point at it.")
    current = [thing for thing, _ in draft.episode.grounding[phrase]]
    spoken = [*(thing for _, thing in draft.state.spoken), *current[:1]]
    found = refer(told, _looks(draft), spoken, listed=current)
    among = tuple(row for row in found if row[0] in current)
    if among or found:
        return Found(among or found)
    near = suggest(told.head, draft.mind.setting.vocabulary)
    offer = f' Did you mean "{near[0]}"?' if near else ""
    return Found((), f'I see nothing here that I would call "{text}".{offer}')


def _noun_phrase(draft: Draft, text: str) -> NounPhrase | None:
    """Read a bare noun phrase: as the object of a verb that takes any."""
    setting = draft.mind.setting
    bare = text.removeprefix("it 's ").removeprefix("it is ").removeprefix("that is ")
    frames = parse(f"take {bare}", setting.lexicon, setting.vocabulary)
    return frames[0].phrases[0] if frames and frames[0].phrases else None


def find_correction(draft: Draft, reply: Reply) -> tuple[str, str] | None:
    """A noun phrase of the command and the one object it should have meant: "no, the other pot"."""
    told = _noun_phrase(draft, reply.rest) if reply.label == "no" and reply.rest else None
    if told is None:
        return None
    looks = _looks(draft)
    for phrase in draft.episode.phrases:
        was = draft.episode.grounding.best(phrase)
        found = refer(told, looks, [was] if was else [])
        if len(found) == 1 and found[0][0] != was and _alike(looks, phrase, was, found[0][0], told):
            return phrase, found[0][0]
    return None


def _alike(looks: Looks, phrase: str, was: str | None, now: str, told: NounPhrase) -> bool:
    """Whether the correction speaks of the same kind of thing as the phrase did."""
    if told.head in phrase.lower().split() or told.head == "one":
        return True
    return was is not None and bool(
        set(looks.objects[was].names).intersection(looks.objects[now].names)
    )


def check_object(setting: Setting, object_id: str) -> None:
    """Raise ``UnknownObjectError`` unless the scene has the object."""
    if object_id not in setting.scene.objects:
        near = suggest(object_id, setting.scene.objects)
        offer = f"; did you mean {near[0]}?" if near else ""
        raise UnknownObjectError(f"there is no object {object_id!r} in {setting.scene.id}{offer}")


def read_action(setting: Setting, text: str) -> tuple[Action | None, str]:
    """A demonstrated action that was typed, letters' case ignored; else the problem."""
    words = text.strip().removeprefix("(").removesuffix(")").split()
    names = {name.lower(): name for name in setting.task.domain.actions}
    if words and words[0].lower() in names:
        ids = {name.lower(): name for name in setting.scene.objects}
        return Action(names[words[0].lower()], tuple(ids.get(w.lower(), w) for w in words[1:])), ""
    near = suggest(words[0].lower(), names) if words else ()
    offer = f'Did you mean "{near[0]}"?' if near else "Say done when you have shown all of it."
    return None, f"That is no action I know. {offer}"


def _looks(draft: Draft) -> Looks:
    setting = draft.mind.setting
    return Looks(setting.scene, draft.state.world, setting.lexicon)


_UNREAD: Mapping[Unread, str] = {
    Unread.EMPTY: "I heard nothing. Tell me what to do, as in: open the fridge.",
    Unread.NO_WORDS: "I see no words in that. Tell me what to do, as in: open the fridge.",
    Unread.NOT_ENGLISH: "I understand only English. Tell me what to do, as in: open the fridge.",
    Unread.QUESTION: "I cannot answer questions. Tell me what to do, as in: open the fridge.",
    Unread.NO_VERB: (
        "I find no verb in that. Tell me what to do with what, as in: open the fridge."
    ),
}

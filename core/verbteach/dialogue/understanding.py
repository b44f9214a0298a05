"""What the teacher's words mean here: the language room's readings, applied to this scene."""

from __future__ import annotations

import re
from dataclasses import dataclass

from verbteach.dialogue.draft import Draft
from verbteach.dialogue.grounding import GroundingBelief
from verbteach.dialogue.setting import Setting, UnknownObjectError
from verbteach.language.frames import NounPhrase, VerbFrame
from verbteach.language.grammar import explain_unread, parse
from verbteach.world.plan import Action


@dataclass(frozen=True)
class CommandReading:
    """A command's clauses; where there are none, the problem and perhaps a command meant."""

    frames: tuple[VerbFrame, ...]
    problem: str = ""
    suggestion: str = ""


@dataclass(frozen=True)
class Reply:
    """An answer's label (yes, no, unsure or empty), what else was said, and what is unclear."""

    label: str
    rest: str = ""
    problem: str = ""


@dataclass(frozen=True)
class Found:
    """Objects that words may mean, weighted; where there are none, the problem."""

    objects: tuple[tuple[str, float], ...] = ()
    problem: str = ""


def read_command(draft: Draft, text: str) -> CommandReading:
    """Read a command's clauses."""
    setting = draft.mind.setting
    vocabulary = [name for thing in setting.scene.objects.values() for name in thing.names]
    frames = parse(text, setting.lexicon, vocabulary)
    if frames:
        return CommandReading(frames)
    why = explain_unread(text, setting.lexicon, vocabulary)
    return CommandReading((), f"I could not read that ({why.value if why else 'unclear'}).")


def clause_text(frame: VerbFrame) -> str:
    """The clause in words."""
    words = [frame.verb]
    for argument in frame.arguments:
        words += [] if argument.role in {"obj", "loc"} else [argument.role]
        words.append(argument.phrase.text)
    return " ".join(words)


def read_reply(text: str) -> Reply:
    """Read yes, no, don't know and what else was said."""
    words = re.findall(r"[a-z']+", text.lower())
    first = words[0] if words else ""
    label = {"yes": "yes", "yeah": "yes", "y": "yes", "no": "no", "nope": "no"}.get(first, "")
    rest = text.split(",", 1)[1].strip() if "," in text else ("" if label else text)
    problem = "" if label else "Was that a yes or a no?"
    return Reply(label, rest, problem)


def ground_phrases(draft: Draft, frame: VerbFrame) -> tuple[GroundingBelief, frozenset[str]]:
    """The grounding belief at the start, and the phrases whose words had to be guessed."""
    weights = {phrase.text: _weights(draft, phrase) for phrase in frame.phrases}
    return GroundingBelief.of(weights), frozenset()


def _weights(draft: Draft, phrase: NounPhrase) -> dict[str, float]:
    objects = draft.mind.setting.scene.objects.values()
    fitting = [thing.id for thing in objects if phrase.head in thing.names]
    wanted = [t for t in fitting if all(m in _marks(draft, t) for m in phrase.modifiers)]
    return dict.fromkeys(wanted or fitting, 1.0)


def _marks(draft: Draft, thing: str) -> set[str]:
    found = draft.mind.setting.scene.objects[thing]
    return {*found.attributes.values(), *(w for name in found.names for w in name.split())}


def find_objects(draft: Draft, phrase: str, text: str) -> Found:
    """Objects that an answer's words mean."""
    for one in (NounPhrase(text, text.rsplit(maxsplit=1)[-1] if text.split() else ""),):
        weights = _weights(draft, one)
        if weights:
            return Found(tuple(sorted(weights.items())))
    return Found((), f'I see nothing that I would call "{text}".')


def find_correction(draft: Draft, reply: Reply) -> tuple[str, str] | None:
    """A noun phrase of the command and the object it should have meant."""
    if reply.label != "no" or not reply.rest:
        return None
    for phrase in draft.episode.phrases:
        found = find_objects(draft, phrase, reply.rest)
        if len(found.objects) == 1:
            return phrase, found.objects[0][0]
    return None


def check_object(setting: Setting, object_id: str) -> None:
    """Raise ``UnknownObjectError`` unless the scene has the object."""
    if object_id not in setting.scene.objects:
        raise UnknownObjectError(f"there is no object {object_id!r} in {setting.scene.id}")


def read_action(setting: Setting, text: str) -> tuple[Action | None, str]:
    """A demonstrated action that was typed; else ``None`` and the problem."""
    words = text.split()
    if words and words[0] in setting.task.domain.actions:
        ids = {name.lower(): name for name in setting.scene.objects}
        return Action(words[0], tuple(ids.get(w.lower(), w) for w in words[1:])), ""
    return None, "That is no action I know. Say done when you have shown all of it."

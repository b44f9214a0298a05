"""What a command's noun phrases mean in this scene, by their words, by use and by guess."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from verbteach.dialogue.draft import Draft
from verbteach.dialogue.grounding import GroundingBelief
from verbteach.dialogue.setting import Setting, UnknownObjectError
from verbteach.dialogue.whence import together
from verbteach.language.attachment import attach
from verbteach.language.frames import Argument, NounPhrase, VerbFrame
from verbteach.language.grammar import parse
from verbteach.language.looks import Looks
from verbteach.language.refer import Candidates, refer
from verbteach.language.typos import suggest

_ALL = frozenset({"all", "both"})


def attached(draft: Draft, frame: VerbFrame) -> VerbFrame:
    """The frame with its prepositional phrases where the scene says that they belong."""
    return attach(frame, looks_now(draft), [thing for _, thing in draft.state.spoken])


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
            found = guesses(draft, argument, looks)
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


def guesses(draft: Draft, argument: Argument, looks: Looks) -> Candidates:
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

"""What an answer to "which is it?" means here: things among those that were asked about."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from verbteach.dialogue import enquiries
from verbteach.dialogue.draft import Draft
from verbteach.dialogue.referring import looks_now, read_noun_phrase
from verbteach.language import household
from verbteach.language.choices import Choice, Chosen, read_choice
from verbteach.language.frames import NounPhrase
from verbteach.language.refer import Candidates, refer
from verbteach.language.typos import suggest


@dataclass(frozen=True)
class Found:
    """Objects that words may mean, weighted; else the problem, or the label they come to."""

    objects: Candidates = ()
    problem: str = ""
    label: str = ""


def find_objects(draft: Draft, phrase: str, text: str) -> Found:
    """Objects that an answer's words mean, among the question's candidates if any of them fit."""
    setting = draft.mind.setting
    choice = read_choice(text, {*setting.lexicon.verbs, *household.VERBS, "repeat"})
    current = [thing for thing, _ in draft.episode.grounding[phrase]]
    if choice.kind is Chosen.POINTED and len(current) == 1:
        return Found(((current[0], 1.0),))
    if _WISHING.search(text):
        return Found((), _PROBLEMS[Chosen.NONE])
    if choice.kind is Chosen.NONE and (told := enquiries.answer(draft, text)):
        return Found((), told)
    if choice.kind is not Chosen.NAMED:
        return Found((), _PROBLEMS.get(choice.kind, ""), _LABELS.get(choice.kind, ""))
    if choice.index is not None:
        return _numbered(current, choice.index)
    return _without(draft, phrase, choice) if not choice.named else _named(draft, phrase, choice)


def _numbered(current: Sequence[str], index: int) -> Found:
    if index < len(current):
        return Found(((current[index], 1.0),))
    return Found((), f"There are only {len(current)} that it could be." if current else _WHICH)


def _without(draft: Draft, phrase: str, choice: Choice) -> Found:
    """All but what was denied; where that leaves nothing, it is a no."""
    current = draft.episode.grounding[phrase]
    denied = {thing for words in choice.denied for thing, _ in _referred(draft, phrase, words)}
    kept = tuple(row for row in current if row[0] not in denied)
    if len(kept) == len(current):
        return Found((), _WHICH)
    return Found(kept) if kept else Found(label="no")


def _named(draft: Draft, phrase: str, choice: Choice) -> Found:
    found: dict[str, float] = {}
    for words in choice.named:
        things = _referred(draft, phrase, words)
        if not things:
            return Found((), _nothing_called(draft, words))
        found |= {thing: weight for thing, weight in things if thing not in found}
    return Found(tuple(found.items()))


def _referred(draft: Draft, phrase: str, words: str) -> Candidates:
    """What the words mean, as they are or as what describes one: "blue" is the blue one."""
    for said in (words, f"the {words} one"):
        told = read_noun_phrase(draft, said)
        found = _among(draft, phrase, told) if told is not None else ()
        if found:
            return found
    return ()


def _among(draft: Draft, phrase: str, told: NounPhrase) -> Candidates:
    current = [thing for thing, _ in draft.episode.grounding[phrase]]
    spoken = [*(thing for _, thing in draft.state.spoken), *current[:1]]
    found = refer(told, looks_now(draft), spoken, listed=current)
    among = tuple(row for row in found if row[0] in current)
    points_back = told.head == "one" and bool(current)
    return among or (() if points_back else found)


def _nothing_called(draft: Draft, words: str) -> str:
    told = read_noun_phrase(draft, words)
    near = _respelled(draft, told) if told is not None else ""
    offer = f' Did you mean "{near}"?' if near else ""
    return f'I see nothing here that I would call "{words}".{offer}'


def _respelled(draft: Draft, told: NounPhrase) -> str:
    """The noun, or what describes it, as it may have been meant; empty where all is known."""
    setting, looks = draft.mind.setting, looks_now(draft)
    if told.head != "one" and (near := suggest(told.head, setting.vocabulary)):
        return near[0]
    marks = {mark for thing in looks.objects for mark in looks.names.lasting_marks(thing)}
    words = {mark for mark in marks if mark.isalpha()}
    for word in told.modifiers:
        near = () if word in words else suggest(word, words)
        if near:
            return told.text.replace(word, near[0], 1)
    return ""


_WISHING = re.compile(
    r"\b(?:should|must|shall|ought to|has to|have to)\b"
    r"(?!\s+(?:be|have been)\s+(?:the|a|an|my|your|that|this|one)\b)",
    re.IGNORECASE,
)
"""How something should be names no thing; "it should be the blue one" does."""
_WHICH = "I asked which one it is."
_PROBLEMS: Mapping[Chosen, str] = {
    Chosen.ALL: "I can do it with only one thing at a time. Which one now?",
    Chosen.POINTED: "I do not see where you point. Name the thing, or say its number.",
    Chosen.NONE: "First tell me which one it is: name the thing, or point at it.",
}
_LABELS: Mapping[Chosen, str] = {
    Chosen.ANY: "unsure",
    Chosen.OTHER: "no",
    Chosen.ABSENT: "unsure",
}

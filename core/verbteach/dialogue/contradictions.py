"""Answers that cannot both be right: noticed, and asked about once more.

The second answer counts, and what it contradicts is taken back. Only what the
teacher said for this command is compared.
"""

from __future__ import annotations

from dataclasses import dataclass

from verbteach.dialogue.acts import (
    EnvPredYnq,
    GoalPredYnq,
    GoalRelevantYnq,
    NpGrdWhq,
    NpGrdYnq,
    PredChangeYnq,
    RobotAct,
)
from verbteach.dialogue.draft import Draft
from verbteach.dialogue.speech import Speech
from verbteach.dialogue.state import EpisodeState, Exchange
from verbteach.dialogue.worth import PLACED
from verbteach.world.fluents import Literal

CONTRADICTORY, WITHDRAWN = "contradictory", "withdrawn"
"""How an answer is recorded that was asked about once more, and one that gave way."""


@dataclass(frozen=True)
class Contradiction:
    """What an answer does not go with: the earlier exchange, and what was said then, in words."""

    earlier: Exchange
    said: str


def contradiction(
    draft: Draft, question: RobotAct, label: str, objects: tuple[str, ...]
) -> Contradiction | None:
    """The earlier answer that this one contradicts, if one does."""
    speech = Speech.of(draft.mind.setting, draft.state.world)
    for earlier in draft.episode.asked:
        said = _against(earlier, question, label, objects, speech)
        if said:
            return Contradiction(earlier, said)
    return None


def was_put_again(episode: EpisodeState, question: RobotAct) -> bool:
    """Whether the question has been put again for a contradiction."""
    return Exchange(question, CONTRADICTORY) in episode.asked


def withdrawn(episode: EpisodeState, earlier: Exchange) -> tuple[Exchange, ...]:
    """The exchanges with an earlier answer taken back."""
    return tuple(
        Exchange(one.question, WITHDRAWN) if one == earlier else one for one in episode.asked
    )


def _against(
    earlier: Exchange, question: RobotAct, label: str, objects: tuple[str, ...], speech: Speech
) -> str:
    match earlier.question, question:
        case NpGrdYnq(np=phrase, object=thing), NpGrdWhq(np=same) | NpGrdYnq(np=same):
            if phrase == same and earlier.answer == "no" and objects == (thing,):
                return f'"{phrase}" is not {speech.thing(thing)}'
        case PredChangeYnq(literal=literal), GoalRelevantYnq(literal=same_literal):
            if literal == same_literal and earlier.answer == "no" and label == "yes":
                return f"it did not come to be that {speech.words.describe(literal)}"
        case _ if earlier.answer == "yes" and label == "yes":
            before, now = _literal(earlier.question), _literal(question)
            alike = type(earlier.question) is type(question)
            if alike and before and now and _exclude(before, now):
                return _said(earlier.question, before, speech)
    return ""


def _literal(question: RobotAct) -> Literal | None:
    if isinstance(question, EnvPredYnq):
        return Literal(question.fluent)
    if isinstance(question, GoalPredYnq | PredChangeYnq | GoalRelevantYnq):
        return question.literal
    return None


def _exclude(one: Literal, other: Literal) -> bool:
    """Whether a fluent is wanted both true and false, or a thing in two places."""
    if one.fluent == other.fluent:
        return one.positive != other.positive
    thing = PLACED.group(one.fluent)
    both = one.positive and other.positive
    return both and thing is not None and thing == PLACED.group(other.fluent)


def _said(question: RobotAct, literal: Literal, speech: Speech) -> str:
    if isinstance(question, GoalPredYnq | GoalRelevantYnq):
        return speech.words.should(literal)
    return speech.words.describe(literal)

"""What an answer came to, in one line: "I am now sure that the pot is the kettle"."""

from __future__ import annotations

from verbteach.dialogue import acts
from verbteach.dialogue.speech import Speech
from verbteach.dialogue.state import EpisodeState, Exchange
from verbteach.world.fluents import Literal

_SURE = "I am now sure that"


def consequence(before: EpisodeState | None, after: EpisodeState | None, speech: Speech) -> str:
    """What changed in the robot's mind between two turns of one command; empty if nothing did."""
    if before is None or after is None or before.number != after.number:
        return ""
    told = [
        f"{_SURE} {_the(phrase)} is {speech.thing(thing)}."
        for phrase in after.grounding.names
        if phrase in after.grounding.settled and phrase not in before.grounding.settled
        for thing in [after.grounding.best(phrase)]
        if thing is not None
    ]
    if not told:
        new = after.asked[len(before.asked) :]
        told = [text for one in new if (text := _answered(one, speech) or _without(one, after))]
    return " ".join(told)


def _answered(exchange: Exchange, speech: Speech) -> str:
    question, yes = exchange.question, exchange.answer == "yes"
    if exchange.answer not in ("yes", "no"):
        return ""
    words = speech.words
    match question:
        case acts.NpGrdYnq(np=phrase, object=thing):
            return "" if yes else f"{_SURE} {_the(phrase)} is not {speech.thing(thing)}."
        case acts.EnvPredYnq(fluent=fluent) | acts.PredChangeYnq(literal=Literal(fluent=fluent)):
            holds = yes
            if isinstance(question, acts.PredChangeYnq):
                holds = yes == question.literal.positive
            return f"{_SURE} {words.describe(Literal(fluent, holds))}."
        case acts.GoalPredYnq(literal=literal) | acts.GoalRelevantYnq(literal=literal):
            if yes:
                return f"{_SURE} {words.should(literal)}."
            return f"{_SURE} it is no part of the goal that {words.describe(literal)}."
    return ""


def _without(exchange: Exchange, after: EpisodeState) -> str:
    """What follows where a thing that was spoken of is not there, or nobody can say which it is."""
    question = exchange.question
    if exchange.answer != "unsure" or not isinstance(question, acts.NpGrdWhq):
        return ""
    if after.grounding[question.np]:
        return ""
    return f"I go on without {_the(question.np)}; to leave the command, skip."


def _the(phrase: str) -> str:
    return f'"{phrase}"'

"""What the robot is unsure of when it asks, in words and with the numbers it has."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

from verbteach.dialogue import acts
from verbteach.dialogue.decision import Candidate
from verbteach.dialogue.draft import Draft
from verbteach.dialogue.speech import Speech
from verbteach.language.morphology import listing
from verbteach.world.fluents import Literal

_NAMED = 3
_SURE = 0.995  # what is told as 100%


def uncertainty(draft: Draft, chosen: Candidate, speech: Speech) -> str:
    """A sentence about what the act is there to settle; empty where it settles nothing."""
    said = _SAID.get(type(chosen.act))
    return said(chosen.act, _Doubt(draft, chosen, speech)) if said else ""


class _Doubt(NamedTuple):
    draft: Draft
    chosen: Candidate
    speech: Speech


def _grounding(act: acts.NpGrdWhq | acts.NpGrdYnq, doubt: _Doubt) -> str:
    return _phrase(doubt.draft, act.np, doubt.speech)


def _groundings(act: acts.BulkNpGrdYnq, doubt: _Doubt) -> str:
    return " ".join(_phrase(doubt.draft, phrase, doubt.speech) for phrase, _ in act.pairs)


def _environment(act: acts.EnvPredYnq, doubt: _Doubt) -> str:
    seen = doubt.draft.episode.belief[act.fluent]
    fact = doubt.speech.words.describe(Literal(act.fluent))
    return f"My eyes are not sure whether {fact}: I believe it to {seen:.0%}."


def _goal(act: acts.GoalPredYnq, doubt: _Doubt) -> str:
    chance = doubt.chosen.features.get("goal_pred_ynq.probability")
    return _likely(f"whether {doubt.speech.words.should(act.literal)} in the end", chance)


def _change(act: acts.PredChangeYnq, doubt: _Doubt) -> str:
    chance = doubt.chosen.features.get("pred_change_ynq.probability")
    fact = doubt.speech.words.describe(act.literal)
    return _likely(f"whether you made it so that {fact}", chance)


def _relevance(act: acts.GoalRelevantYnq, doubt: _Doubt) -> str:
    became = doubt.speech.words.became(act.literal)
    return f"I saw that {became}, but not whether you wanted that or it came along."


def _execution(act: acts.SelectHypo, doubt: _Doubt) -> str:
    return _expected(doubt.chosen, "select_hypo", "what I take you to mean")


def _inclusion(act: acts.IncludeFluent, doubt: _Doubt) -> str:
    return _expected(doubt.chosen, "include_fluent", "what I take to have changed")


def _phrase(draft: Draft, phrase: str, speech: Speech) -> str:
    objects = draft.episode.grounding[phrase]
    if not objects:
        return f'I see nothing that I would call "{phrase}".'
    if len(objects) == 1:
        return f'"{phrase}" may be {speech.thing(objects[0][0])}; I know of nothing else.'
    named = [f"{speech.thing(thing)} ({chance:.0%})" for thing, chance in objects[:_NAMED]]
    rest = len(objects) - len(named)
    more = [f"{rest} other thing{'s' * (rest != 1)}"] if rest else []
    return f'I am not sure what "{phrase}" is: {listing([*named, *more], "or")}.'


def _likely(what: str, chance: float | None) -> str:
    if chance is None:
        return f"I am not sure {what}."
    return f"I am not sure {what}: I expect a yes at {chance:.0%}."


def _expected(chosen: Candidate, act: str, what: str) -> str:
    sure = chosen.features.get(f"{act}.certainty")
    if sure is None:
        return ""
    value = chosen.features.get(f"{act}.value")
    most = value is not None and sure < _SURE
    near = f", and expect it to be {value:.0%} of the way there" if most else ""
    return f"I am {sure:.0%} sure that {what} is exactly right{near}."


_SAID: Mapping[type[acts.RobotAct], Callable[[Any, _Doubt], str]] = {
    acts.NpGrdWhq: _grounding,
    acts.NpGrdYnq: _grounding,
    acts.BulkNpGrdYnq: _groundings,
    acts.EnvPredYnq: _environment,
    acts.GoalPredYnq: _goal,
    acts.PredChangeYnq: _change,
    acts.GoalRelevantYnq: _relevance,
    acts.SelectHypo: _execution,
    acts.IncludeFluent: _inclusion,
}

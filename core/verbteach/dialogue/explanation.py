"""Why do you ask? The same numbers that chose the act, in words.

Three things are told: what is unsure, the acts that were weighed with their
values and what made them up, and what a yes and a no would change.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from verbteach.dialogue import acts
from verbteach.dialogue.acts.execution import CORRECTED
from verbteach.dialogue.asking import execution_inquiry, sensible
from verbteach.dialogue.consequences import consequences
from verbteach.dialogue.decision import Candidate, Decision
from verbteach.dialogue.draft import Draft
from verbteach.dialogue.moves import Phase
from verbteach.dialogue.speech import Speech
from verbteach.dialogue.uncertainty import uncertainty
from verbteach.world.fluents import Literal

_SHOWN = 3
_SEEN = 0.005  # what two decimals show


def explain(draft: Draft) -> tuple[str, ...]:
    """The robot's last turn, in a few sentences each of which can stand for itself."""
    turn = draft.state.turn
    act = turn.waiting_act
    if isinstance(act, acts.SelectHypo) and act.hypothesis == CORRECTED:
        return ("You said what was meant: I did the same with that instead.",)
    if not turn.decisions and not isinstance(act, acts.QUESTIONS):
        return ("I did not have to choose: this is what comes next.",)
    speech = Speech.of(draft.mind.setting, draft.state.world)
    decision = turn.decisions[-1] if turn.decisions else None
    weighed = decision.candidates[decision.chosen] if decision else Candidate(act, {})
    told = [
        uncertainty(draft, weighed, speech),
        _weighed(decision, speech) if decision else "",
        _promised(draft),
        consequences(draft, act, speech),
    ]
    return tuple(sentence for sentence in told if sentence)


def _promised(draft: Draft) -> str:
    """How the promise bears on the execution phase's choice: how sure it is, and has to be."""
    promise, turn = draft.mind.promise, draft.state.turn
    shown = acts.DemonstrationReason.NOT_SURE
    not_sure = getattr(turn.waiting_act, "reason", None) is shown
    acting = turn.phase in {Phase.EXECUTION, Phase.JUDGEMENT} or not_sure
    if promise is None or not acting or not turn.decisions:
        return ""
    now = promise.sureness.now(_execution_options(draft, turn.decisions[-1]))
    if now is None:
        return ""
    return (
        f"I promised that {promise.rate:.0%} of what I carry out is right: I act when I am at least"
        f" {promise.sure:.0%} sure, and am {now:.0%} sure now."
    )


def _execution_options(draft: Draft, decision: Decision) -> Sequence[Candidate]:
    """The execution phase's acts with the one that the promise may have taken out."""
    if isinstance(decision.candidates[-1].act, acts.SelectHypo):
        return decision.candidates
    return sensible(draft, execution_inquiry(draft).candidates())


def _weighed(decision: Decision, speech: Speech) -> str:
    """The acts that were weighed, the chosen one first, then by their value."""
    order = sorted(
        range(len(decision.candidates)),
        key=lambda i: (i != decision.chosen, -(decision.candidates[i].value or 0.0), i),
    )
    shown = [_option(decision.candidates[index], speech) for index in order[:_SHOWN]]
    rest = len(order) - len(shown)
    more = f"; and {rest} more" if rest else ""
    return f"I weighed: {'; '.join(shown)}{more}.{_why(decision)}"


def _why(decision: Decision) -> str:
    return f" I took the first: {decision.reason}." if decision.reason else ""


def _option(candidate: Candidate, speech: Speech) -> str:
    numbers = _parts(candidate.shares) if candidate.shares else _features(candidate.features)
    if candidate.value is not None:
        numbers = f"Q {candidate.value:.2f} = {numbers}" if numbers else f"Q {candidate.value:.2f}"
    return (
        f"{label(candidate.act, speech)} ({numbers})" if numbers else label(candidate.act, speech)
    )


def _parts(shares: Mapping[str, float]) -> str:
    """The largest parts of a value, and the sum of the others, so that they add up."""
    order = sorted(shares, key=lambda name: (-abs(shares[name]), name))
    shown = [name for name in order[:_SHOWN] if abs(shares[name]) >= _SEEN]
    rest = sum(shares[name] for name in order if name not in shown)
    parts = [f"{shares[name]:+.2f} {name}" for name in shown]
    return " ".join([*parts, *([f"{rest:+.2f} others"] if abs(rest) >= _SEEN else [])])


def _features(features: Mapping[str, float]) -> str:
    return ", ".join(f"{name} {value:.2f}" for name, value in sorted(features.items())[:_SHOWN])


def label(act: acts.RobotAct, speech: Speech) -> str:
    """The act as something that could be done: "ask whether the mug should be in the sink"."""
    said = _LABELS.get(type(act))
    return said(act, speech) if said else act.name


def _parts_of(act: acts.IncludeFluent, speech: Speech) -> str:
    count = len(act.goal)
    return f"read back a goal of {count} part{'s' * (count != 1)}"


_Label = Callable[[Any, Speech], str]
_LABELS: Mapping[type[acts.RobotAct], _Label] = {
    acts.NpGrdWhq: lambda act, speech: f'ask which is "{act.np}"',
    acts.NpGrdYnq: lambda act, speech: f'ask whether "{act.np}" is {speech.thing(act.object)}',
    acts.BulkNpGrdYnq: lambda act, speech: f"ask about {len(act.pairs)} things at once",
    acts.EnvPredYnq: lambda act, speech: (
        f"ask whether now {speech.words.describe(Literal(act.fluent))}"
    ),
    acts.GoalPredYnq: lambda act, speech: (
        f"ask whether {speech.words.should(act.literal)} in the end"
    ),
    acts.PredChangeYnq: lambda act, speech: (
        f"ask whether you made it so that {speech.words.describe(act.literal)}"
    ),
    acts.GoalRelevantYnq: lambda act, speech: (
        f"ask whether it matters that {speech.words.describe(act.literal)}"
    ),
    acts.SelectHypo: lambda act, speech: (
        f"carry it out in {len(act.plan)} steps" if act.plan else "carry out my best guess"
    ),
    acts.IncludeFluent: _parts_of,
    acts.RequestDemonstration: lambda act, speech: "ask to be shown",
}

"""Why do you ask? The same numbers that chose the act, in words."""

from __future__ import annotations

from verbteach.dialogue import acts
from verbteach.dialogue.decision import Candidate, Decision
from verbteach.dialogue.setting import Setting
from verbteach.dialogue.speech import Speech
from verbteach.dialogue.state import RobotState

_SHOWN = 3


def explain(state: RobotState, setting: Setting) -> str:
    """The last decision: its reason, the alternatives with their numbers, what an answer does."""
    if not state.turn.decisions:
        return "I did not have to choose: this is what comes next."
    decision = state.turn.decisions[-1]
    speech = Speech.of(setting, state.world)
    parts = [f"Because {decision.reason}." if decision.reason else "", _options(decision)]
    parts.append(_consequence(decision.act, speech))
    return " ".join(part for part in parts if part)


def _options(decision: Decision) -> str:
    ranked = sorted(
        range(len(decision.candidates)),
        key=lambda i: (i != decision.chosen, -(decision.candidates[i].value or 0.0), i),
    )
    shown = [_option(decision.candidates[index]) for index in ranked[:_SHOWN]]
    return f"I weighed: {'; '.join(shown)}."


def _option(candidate: Candidate) -> str:
    numbers = [f"{name} {value:.2f}" for name, value in sorted(candidate.features.items())]
    if candidate.value is not None:
        numbers.insert(0, f"Q {candidate.value:.2f}")
    told = f" ({', '.join(numbers)})" if numbers else ""
    return f"{_label(candidate.act)}{told}"


def _label(act: acts.RobotAct) -> str:
    match act:
        case acts.NpGrdWhq(np=phrase):
            return f'ask which is "{phrase}"'
        case acts.NpGrdYnq(np=phrase, object=thing):
            return f'ask whether "{phrase}" is {thing}'
        case acts.SelectHypo(plan=plan):
            return f"carry it out in {len(plan)} steps"
        case acts.IncludeFluent(goal=goal):
            return f"keep a goal of {len(goal)} fluents"
        case acts.RequestDemonstration():
            return "ask to be shown"
        case _:
            return act.name


def _consequence(act: acts.RobotAct, speech: Speech) -> str:
    if isinstance(act, acts.NpGrdYnq):
        thing = speech.thing(act.object)
        return f'A yes makes me sure that "{act.np}" is {thing}; a no rules it out.'
    if isinstance(act, acts.NpGrdWhq):
        return f'Your answer makes me sure what "{act.np}" is.'
    if isinstance(act, acts.SelectHypo):
        return "If it was right I keep to this goal; if not I put everything back and watch you."
    if isinstance(act, acts.IncludeFluent):
        return "If it is right I keep this goal for the verb; if not you can correct it."
    return ""

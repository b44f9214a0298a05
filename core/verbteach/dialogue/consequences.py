"""What an answer to the robot's question would change, worked out by taking the answer in."""

from __future__ import annotations

from collections.abc import Mapping

from verbteach.dialogue import acts
from verbteach.dialogue.acts import RobotAct
from verbteach.dialogue.asking import execution_inquiry
from verbteach.dialogue.demonstration import ordered
from verbteach.dialogue.draft import Draft
from verbteach.dialogue.execution_inquiry import ExecutionInquiry
from verbteach.dialogue.inquiry import Label, Reply
from verbteach.dialogue.moves import Phase
from verbteach.dialogue.speech import Speech
from verbteach.dialogue.worth import without_departures
from verbteach.language.morphology import listing
from verbteach.world.fluents import Goal

_TOLD = 4
_ALWAYS: Mapping[type[RobotAct], str] = {
    acts.NpGrdWhq: "Your answer makes me sure what the words mean.",
    acts.BulkNpGrdYnq: "A yes settles all of them; a no leaves me doubting each a little more.",
    acts.PredChangeYnq: "A yes keeps it in what I read back to you; a no leaves it out.",
    acts.GoalRelevantYnq: "A yes keeps it in what I read back to you; a no leaves it out.",
    acts.SelectHypo: (
        "If it was right I keep to this goal; if not I put everything back and watch you."
    ),
    acts.IncludeFluent: (
        "If it is right I keep this goal for the verb; if not you can correct it."
    ),
}
"""What follows from an answer to these whatever the robot believes."""


def consequences(draft: Draft, act: RobotAct, speech: Speech) -> str:
    """What a yes and a no would do; empty where the act asks nothing."""
    if type(act) in _ALWAYS:
        return _ALWAYS[type(act)]
    if isinstance(act, acts.QUESTIONS) and draft.episode.phase is Phase.EXECUTION:
        return _of_command(draft, act, speech)
    if isinstance(act, acts.NpGrdYnq):
        return _of_reference(act, speech)
    return ""


def _of_reference(act: acts.NpGrdYnq, speech: Speech) -> str:
    return f'A yes makes me sure that "{act.np}" is {speech.thing(act.object)}; a no rules it out.'


def _of_command(draft: Draft, act: RobotAct, speech: Speech) -> str:
    """The best guess after each answer, and how good the robot then expects it to be."""
    if draft.episode.frame.verb not in draft.state.knowledge.verbs:
        return _of_reference(act, speech) if isinstance(act, acts.NpGrdYnq) else ""
    inquiry = execution_inquiry(draft)
    if inquiry.pool.empty:
        return _of_reference(act, speech) if isinstance(act, acts.NpGrdYnq) else ""
    now, yes, no = (
        _best(one)
        for one in (
            inquiry,
            inquiry.after(act, Reply(Label.YES)),
            inquiry.after(act, Reply(Label.NO)),
        )
    )
    return (
        f"My best guess now: {_guess(now, speech)}."
        f" {_change('yes', yes, now, speech)}; {_change('no', no, now, speech)}."
    )


def _best(inquiry: ExecutionInquiry) -> tuple[Goal, float]:
    goals = inquiry.pool.goals(1)
    return goals[0] if goals else (frozenset(), 0.0)


def _guess(best: tuple[Goal, float], speech: Speech) -> str:
    goal, value = best
    if not goal:
        return "nothing that I could do"
    told = [speech.words.describe(one) for one in without_departures(ordered(goal))]
    more = [f"{len(told) - _TOLD} more"] if len(told) > _TOLD else []
    return f"{listing([*told[:_TOLD], *more])} (worth {value:.0%})"


def _change(answer: str, after: tuple[Goal, float], now: tuple[Goal, float], speech: Speech) -> str:
    lead = f"{'A' if answer == 'yes' else 'a'} {answer}"
    if after[0] == now[0]:
        return f"{lead} leaves it so, worth {after[1]:.0%}"
    return f"{lead} makes it: {_guess(after, speech)}"

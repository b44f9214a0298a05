"""How a command would have gone, had the robot known better: one thing put right at a time.

Everything else stays as it was when the robot stopped asking, answers
included, so that what each mend brings can be compared.
"""

from __future__ import annotations

from dataclasses import dataclass

from verbteach.dialogue.acts import NpGrdWhq
from verbteach.dialogue.execution_inquiry import ExecutionInquiry
from verbteach.dialogue.inquiry import Label, Reply
from verbteach.dialogue.rewards import Rewards
from verbteach.experiments.asked_command import AskedCommand
from verbteach.experiments.carrying_out import carry_out
from verbteach.experiments.interactive import hold
from verbteach.experiments.judging import Score
from verbteach.experiments.metrics import ied, jaccard
from verbteach.experiments.sight import stream
from verbteach.perception.belief import Belief
from verbteach.policy.fixed_rules import ManualPolicy
from verbteach.world.fluents import Goal, State
from verbteach.world.plan import Plan


@dataclass(frozen=True)
class Outcomes:
    """One command's scores as it went, ``own``, and with one thing put right.

    ``asked_on``: the questions that ManualPolicy still has were asked too,
    ``further`` of them. ``grounded``: the noun phrases were settled on the right
    objects. ``seen``: the room was seen as it is. ``answered``: the teacher had
    said of every literal among the candidates whether it should hold. ``goal``:
    the plan was made to the true change, from the true room. ``chosen`` is the
    SJI if exactly the chosen goal had come about.
    """

    own: Score
    asked_on: Score
    grounded: Score
    seen: Score
    answered: Score
    goal: Score
    chosen: float
    further: int


MENDS = ("own", "grounded", "seen", "asked_on", "answered", "goal")
"""The outcomes that have scores, in the order that tables have them."""


def outcomes(command: AskedCommand) -> Outcomes:
    """Carry the command out again with each thing put right in turn."""
    end, change = command.end, command.human.change.literals
    later = asked_on(command)
    return Outcomes(
        own=Score(command.carried.ied, command.carried.sji),
        asked_on=_carried(command, later),
        grounded=_carried(command, grounded(command)),
        seen=_carried(command, seen(command)),
        answered=_planned(command, end.believed, change & frozenset(end.pool.literals)),
        goal=_planned(command, command.instance.start, change),
        chosen=jaccard(end.best, change),
        further=len(later.asked) - len(end.asked),
    )


def asked_on(command: AskedCommand) -> ExecutionInquiry:
    """The state after all the questions that ManualPolicy would still ask."""
    rng = stream("asked on", command.instance.id)
    return hold(command.end, ManualPolicy(), command.human, Rewards(), rng).state


def grounded(command: AskedCommand) -> ExecutionInquiry:
    """The state with every noun phrase settled on what the human means by it."""
    state, instance = command.end, command.instance
    for phrase, things in zip(instance.phrases, instance.narrowed, strict=True):
        state = state.after(NpGrdWhq(phrase), Reply(Label.OBJECTS, things))
    return state


def seen(command: AskedCommand) -> ExecutionInquiry:
    """The state with the room seen as it is."""
    end = command.end
    true = command.instance.start - end.static
    return end.believing(Belief.certain(true, end.belief.exclusive))


def _carried(command: AskedCommand, state: ExecutionInquiry) -> Score:
    carried = carry_out(state, command.human, command.gold)
    return Score(carried.ied, carried.sji)


def _planned(command: AskedCommand, state: State, goal: Goal) -> Score:
    """Plan to a goal from a state and do it in the true room; nothing is done without a plan."""
    answer = command.human.room.planner.plan(state, goal) if goal else None
    actions = answer.actions if isinstance(answer, Plan) else ()
    return Score(ied(command.gold, actions), command.human.score(actions))

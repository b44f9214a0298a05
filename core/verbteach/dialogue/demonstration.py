"""Being shown: the robot asks for a demonstration, watches it step by step, and sums it up."""

from __future__ import annotations

from dataclasses import replace

from verbteach.dialogue.acts import (
    DemonstrationReason,
    Insert,
    Move,
    ObserveStep,
    RefuseRevision,
    RefuseStep,
    Remove,
    RequestDemonstration,
    ReviseSteps,
)
from verbteach.dialogue.draft import Draft
from verbteach.dialogue.moves import IllegalMoveError, Phase
from verbteach.dialogue.obstacles import obstacle
from verbteach.dialogue.state import Demonstrated
from verbteach.verbs.change import StateChange
from verbteach.world.fluents import Goal, Literal
from verbteach.world.plan import Action
from verbteach.world.simulator import apply, run


def request(draft: Draft, reason: DemonstrationReason) -> None:
    """Ask to be shown, from the world as it was before the command."""
    episode = draft.episode
    restored = draft.state.world != episode.start
    draft.end_phase()
    draft.remember(world=episode.start)
    draft.update(
        demonstrated=Demonstrated((), (episode.start,)),
        execution=None,
        question=None,
        read_back=None,
    )
    draft.wait(RequestDemonstration(reason, restored), Phase.DEMONSTRATION)


def ask_for_more(draft: Draft, reason: DemonstrationReason) -> None:
    """Ask to go on: what was shown so far stays."""
    draft.wait(RequestDemonstration(reason), Phase.DEMONSTRATION)


def observe(draft: Draft, action: Action) -> None:
    """Watch one step; one that cannot be done is refused with its reason, the world unchanged."""
    reason = obstacle(draft.mind.setting, draft.state.world, action)
    if reason:
        draft.wait(RefuseStep(action, reason), Phase.DEMONSTRATION)
        return
    world = apply(draft.mind.setting.task, draft.state.world, action)
    shown = draft.episode.demonstrated or Demonstrated((), (draft.episode.start,))
    shown = replace(shown, actions=(*shown.actions, action), states=(*shown.states, world))
    draft.remember(world=world)
    draft.update(demonstrated=shown)
    draft.wait(ObserveStep(action, ordered(change(draft))), Phase.DEMONSTRATION)


def edit(draft: Draft, act: Insert | Remove | Move) -> None:
    """Change the steps shown so far; refused where one of them would not be possible any more.

    The world then is as the steps leave it. Raises ``IllegalMoveError`` for a
    number that no step has.
    """
    shown = draft.episode.demonstrated or Demonstrated((), (draft.episode.start,))
    steps = edited(shown.actions, act)
    setting = draft.mind.setting
    states = run(setting.task, draft.episode.start, steps)
    possible = len(states) - 1
    if possible < len(steps):
        reason = obstacle(setting, states[-1], steps[possible])
        draft.wait(RefuseRevision(possible + 1, steps[possible], reason), Phase.DEMONSTRATION)
        return
    draft.remember(world=states[-1])
    draft.update(demonstrated=Demonstrated(steps, tuple(states)))
    draft.wait(ReviseSteps(steps, ordered(change(draft))), Phase.DEMONSTRATION)


def edited(steps: tuple[Action, ...], act: Insert | Remove | Move) -> tuple[Action, ...]:
    """The steps after an edit, possible or not. Raises ``IllegalMoveError``."""
    match act:
        case Insert(at=at, action=action):
            _check_number(at, len(steps) + 1)
            return (*steps[: at - 1], action, *steps[at - 1 :])
        case Remove(first=first, last=last):
            _check_number(first, len(steps))
            _check_number(last, len(steps), first)
            return (*steps[: first - 1], *steps[last:])
        case Move(at=at, to=to):
            _check_number(at, len(steps))
            _check_number(to, len(steps))
            rest = (*steps[: at - 1], *steps[at:])
            return (*rest[: to - 1], steps[at - 1], *rest[to - 1 :])


def _check_number(number: int, last: int, first: int = 1) -> None:
    if last == 0:
        raise IllegalMoveError("there is no step yet")
    if not first <= number <= last:
        raise IllegalMoveError(f"there is no step {number}: it must be from {first} to {last}")


def change(draft: Draft) -> Goal:
    """What the demonstration has changed so far in the true world."""
    static = draft.mind.setting.scene.domain.static
    return StateChange.between(draft.episode.start, draft.state.world, static).literals


def ordered(goal: Goal) -> tuple[Literal, ...]:
    """The literals in the order they are told: what holds first, then what no longer does."""
    return tuple(sorted(goal, key=lambda literal: (not literal.positive, literal.fluent)))

"""Being shown: the robot asks for a demonstration, watches it step by step, and sums it up."""

from __future__ import annotations

from dataclasses import replace

from verbteach.dialogue.acts import (
    DemonstrationReason,
    ObserveStep,
    RefuseStep,
    RequestDemonstration,
)
from verbteach.dialogue.draft import Draft
from verbteach.dialogue.moves import Phase
from verbteach.dialogue.obstacles import obstacle
from verbteach.dialogue.state import Demonstrated
from verbteach.verbs.change import StateChange
from verbteach.world.fluents import Goal, Literal
from verbteach.world.plan import Action
from verbteach.world.simulator import apply


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


def change(draft: Draft) -> Goal:
    """What the demonstration has changed so far in the true world."""
    static = draft.mind.setting.scene.domain.static
    return StateChange.between(draft.episode.start, draft.state.world, static).literals


def ordered(goal: Goal) -> tuple[Literal, ...]:
    """The literals in the order they are told: what holds first, then what no longer does."""
    return tuple(sorted(goal, key=lambda literal: (not literal.positive, literal.fluent)))

"""Which parts of a goal that is about to be read back may not belong to it.

A demonstration shows more than what is meant: a pot that ends up on a heat pad
may be put there by habit (She & Chai 2017, Table 1, R6). Parts about nothing
that the command names are the doubtful ones.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

from verbteach.dialogue.acts import GoalRelevantYnq, IncludeFluent
from verbteach.dialogue.asking import answered
from verbteach.dialogue.decision import Candidate
from verbteach.dialogue.demonstration import ordered
from verbteach.dialogue.draft import Draft
from verbteach.dialogue.worth import without_departures
from verbteach.world.fluents import Goal, Literal

NAMED, ASIDE = 0.95, 0.7
"""How likely a part belongs to the goal, by whether it is about something the command names."""
_CERTAIN = ("ask.certainty", "include_fluent.certainty")


def weighed_by_relevance(
    draft: Draft, options: Sequence[Candidate], include: IncludeFluent
) -> list[Candidate]:
    """The learning phase's candidates, with what would be read back as the last of them.

    Questions about relevance are those about doubtful parts, the most doubtful
    first. Certainty is that what changed is right and that all of it is meant.
    """
    doubtful = _doubtful(draft, include.goal)
    sure = math.prod(_chance(draft, literal) for literal in doubtful)
    *rest, last = (_less_sure(one, sure) for one in options)
    others = [one for one in rest if not isinstance(one.act, GoalRelevantYnq)]
    asking = {one.act.literal: one for one in rest if isinstance(one.act, GoalRelevantYnq)}
    ranked = sorted(doubtful, key=lambda literal: (_chance(draft, literal), literal))
    relevance = [asking[literal] for literal in ranked if literal in asking]
    return [*others, *relevance, replace(last, act=include)]


def _doubtful(draft: Draft, goal: Goal) -> list[Literal]:
    """The parts not asked about yet. A goal of one part is that part: there is no doubt."""
    parts = without_departures(ordered(goal))
    settled = {
        act.literal
        for act in answered(draft.episode, GoalRelevantYnq, "yes")
        if isinstance(act, GoalRelevantYnq)
    }
    return [part for part in parts if part not in settled] if len(parts) > 1 else []


def _chance(draft: Draft, literal: Literal) -> float:
    named = set(draft.episode.best_objects)
    return NAMED if named.intersection(literal.fluent.args) else ASIDE


def _less_sure(candidate: Candidate, sure: float) -> Candidate:
    features = {
        name: value * sure if name in _CERTAIN else value
        for name, value in candidate.features.items()
    }
    return replace(candidate, features=features)

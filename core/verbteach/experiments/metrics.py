"""How well a command was carried out: IED on the actions, SJI on what changed.

She & Chai 2017, section 5.2, after Misra et al. 2015. Both lie between 0 and 1; 1 is best.
"""

from __future__ import annotations

from collections.abc import Sequence

from verbteach.verbs.agreement import agreement
from verbteach.verbs.change import StateChange
from verbteach.world.fluents import Literal
from verbteach.world.plan import Action


def ied(gold: Sequence[Action], predicted: Sequence[Action]) -> float:
    """Score a plan by its instruction edit distance to the gold sequence.

    1 - Levenshtein distance / length of the longer one, over whole actions,
    arguments included. Two empty sequences are the same: 1.
    """
    return agreement(gold, predicted)


def sji(gold: StateChange, predicted: StateChange) -> float:
    """Score an execution by the state Jaccard index of what it changed.

    Each fluent added and each one removed is an item of its own. Where
    neither changed anything the score is 0 (as in the published figures):
    doing nothing never pays.
    """
    return jaccard(gold.literals, predicted.literals)


def jaccard(left: frozenset[Literal], right: frozenset[Literal]) -> float:
    """Return the share of the union that both hold; 0 for two empty sets."""
    union = len(left | right)
    return len(left & right) / union if union else 0.0

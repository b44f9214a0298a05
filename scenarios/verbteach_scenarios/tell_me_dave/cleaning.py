"""Needless moves taken out of a demonstration before anything is compared with it.

Demonstrators wait, pick up what they hold, and put things back where they
took them from. `wait` goes, and so does every move that only re-creates a
relation that held before it: ``moveto x``, ``grasp x``, ``moveto z``,
``keep x On z`` where x was on z all along.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from verbteach.world.fluents import Fluent, State
from verbteach.world.plan import Action
from verbteach_scenarios.tell_me_dave.documents import Clause, Document
from verbteach_scenarios.tell_me_dave.rooms import ROBOT

_MAKES = {"keep-on": "On", "keep-in": "In"}


class _Move(NamedTuple):
    before: State
    action: Action


def cleaned(document: Document, clause: Clause) -> tuple[Action, ...]:
    """Return a clause's actions without needless ones; all of them if none would be left."""
    recorded = document.steps[clause.start : clause.end + 1]
    moves = [_Move(state, action) for state, action in recorded if action and action.name != "wait"]
    position = 0
    while position < len(moves):
        start = _stretch(moves, position)
        relation = _relation(moves[position].action)
        if relation is not None and relation in moves[start].before:
            del moves[start : position + 1]
            position = start
        else:
            position += 1
    return tuple(move.action for move in moves) or document.actions(clause)


def _relation(action: Action) -> Fluent | None:
    """Return what a move is for; None for actions that are no moves."""
    if action.name in _MAKES:
        return Fluent(_MAKES[action.name], action.args)
    if action.name == "grasp":
        return Fluent("Grasping", (ROBOT, *action.args))
    return Fluent("Near", (ROBOT, *action.args)) if action.name == "moveto" else None


def _stretch(moves: Sequence[_Move], end: int) -> int:
    """Return where the moves begin that lead up to the one at ``end`` without a break."""
    name, args = moves[end].action
    wanted = [("moveto", args)]
    if name in _MAKES:
        wanted = [("moveto", args[1:]), ("grasp", args[:1]), ("moveto", args[:1])]
    elif name == "moveto":
        wanted = []
    start = end
    for words in wanted:
        if start > 0 and moves[start - 1].action == words:
            start -= 1
    return start

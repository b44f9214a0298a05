"""Making a greedy plan shorter and its order more like a person's.

Needless actions go (action elimination, Nakhost and Mueller 2010), and a step
that needs nothing from the plan, such as moving to something, is moved next
to the first step that needs it. Every change is kept only if the plan still
runs and still reaches the goal.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from verbteach.world.task import GroundAction


class EncodedGoal(NamedTuple):
    """Bits that must be set at the end, and bits that must not be."""

    true: int
    false: int

    def holds(self, bits: int) -> bool:
        """Whether the goal holds in the encoded state."""
        return bits & self.true == self.true and not bits & self.false


def refined(bits: int, plan: Sequence[GroundAction], goal: EncodedGoal) -> list[GroundAction]:
    """Return the plan from ``bits`` without needless steps, each step near its use."""
    kept = without_needless(bits, plan, goal)
    if len(kept) < 3:  # two steps have no other order worth trying
        return kept
    order = _chained(_links(bits, kept), len(kept))
    if order == sorted(order):
        return kept
    chained = [kept[step] for step in order]
    return chained if _runs(bits, chained, goal) else _gathered(bits, kept, goal)


def without_needless(
    bits: int, plan: Sequence[GroundAction], goal: EncodedGoal
) -> list[GroundAction]:
    """Drop steps, each with all later steps that only it made possible, while the goal holds.

    The first steps are tried first, again from the start after each success.
    """
    kept = list(plan)
    before = [bits]
    while len(before) <= len(kept):
        position = len(before) - 1
        rest = _without_first(before[position], kept[position:], goal)
        if rest is None:
            before.append(kept[position].result(before[position]))
        else:
            kept, before = kept[:position] + rest, [bits]
    return kept


def _without_first(
    bits: int, steps: Sequence[GroundAction], goal: EncodedGoal
) -> list[GroundAction] | None:
    """Leave out the first step and what can then not be done; none where the goal is lost."""
    kept = []
    for step in steps[1:]:
        if step.applicable(bits):
            kept.append(step)
            bits = step.result(bits)
    return kept if goal.holds(bits) else None


def _gathered(bits: int, plan: list[GroundAction], goal: EncodedGoal) -> list[GroundAction]:
    """Move each step that needs nothing from the plan to just before its first use, last first."""
    links = _links(bits, plan)
    for position in range(len(plan) - 2, -1, -1):
        first = min((use for maker, use in links if maker == position), default=0)
        if first <= position + 1 or any(use == position for _, use in links):
            continue
        moved = [*plan[:position], *plan[position + 1 : first], plan[position], *plan[first:]]
        if _runs(bits, moved, goal):
            plan, links = moved, _links(bits, moved)
    return plan


def _chained(links: Sequence[tuple[int, int]], length: int) -> list[int]:
    """Order a plan's steps by what serves what: one purpose after another, longest chain first.

    Whether the order can be carried out is for the caller to see.
    """
    makers: list[list[int]] = [[] for _ in range(length)]
    serving_others = set()
    for maker, use in links:
        makers[use].append(maker)
        serving_others.add(maker)
    depth: list[int] = []
    for serving in makers:
        depth.append(1 + max([depth[maker] for maker in serving], default=0))
        if len(serving) > 1:
            serving.sort(key=lambda m: (-depth[m], m))
    order: list[int] = []
    for step in range(length):
        if step not in serving_others:
            _visit(step, makers, order)
    return order


def _visit(step: int, makers: Sequence[Sequence[int]], order: list[int]) -> None:
    """Add the step to the order after all that serve it."""
    if step not in order:
        for maker in makers[step]:
            _visit(maker, makers, order)
        order.append(step)


def _links(bits: int, plan: Sequence[GroundAction]) -> list[tuple[int, int]]:
    """Pairs of steps (maker, use): the maker was the last to bring about what the use needs."""
    made: list[tuple[int, int]] = []
    found: list[tuple[int, int]] = []
    ever_came = ever_went = 0
    for use, step in enumerate(plan):
        true, false = step.needs_true, step.needs_false
        for needs_true, needs_false, _, _ in step.conditional:
            if bits & needs_true == needs_true and not bits & needs_false:
                true, false = true | needs_true, false | needs_false
        true, false = true & ever_came, false & ever_went  # the rest nobody brought about
        for maker in range(use - 1, -1, -1):
            if not true and not false:
                break
            came, went = made[maker]
            if true & came or false & went:
                found.append((maker, use))
                true, false = true & ~came, false & ~went
        after = step.result(bits)
        came, went = after & ~bits, bits & ~after
        made.append((came, went))
        ever_came, ever_went = ever_came | came, ever_went | went
        bits = after
    return found


def _runs(bits: int, plan: Sequence[GroundAction], goal: EncodedGoal) -> bool:
    for step in plan:
        if not step.applicable(bits):
            return False
        bits = step.result(bits)
    return goal.holds(bits)

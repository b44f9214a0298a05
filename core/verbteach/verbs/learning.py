"""Learning: a demonstration, or a goal that a teacher gives, becomes a hypothesis space.

Knowledge is then just the merge of spaces (``VerbKnowledge``).
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence
from dataclasses import replace
from itertools import combinations

from verbteach.verbs.hypothesis import (
    GoalHypothesis,
    Learner,
    NoHypothesis,
    Shown,
    base_hypothesis,
    generalisations,
)
from verbteach.verbs.knowledge import VerbKnowledge
from verbteach.verbs.lifting import Binding, Lifted, bind, lift
from verbteach.verbs.space import Demonstration, HypothesisSpace, SpaceNode
from verbteach.verbs.surroundings import Surroundings
from verbteach.world.fluents import Goal, Literal


def derive(
    demonstration: Demonstration, shown: Shown, learner: Learner
) -> HypothesisSpace | NoHypothesis:
    """The space of one demonstration; plans, and depends on no other demonstration."""
    base = base_hypothesis(shown, demonstration.grounding, learner)
    if isinstance(base, NoHypothesis):
        return base
    goals = _generalised(base, shown, learner)
    confirmed = shown.goal is not None
    return lifted_space(demonstration, goals, learner.surroundings, confirmed)


def learn(
    knowledge: VerbKnowledge, demonstration: Demonstration, shown: Shown, learner: Learner
) -> tuple[VerbKnowledge, HypothesisSpace | NoHypothesis]:
    """Knowledge with one demonstration more, and what that one taught."""
    space = derive(demonstration, shown, learner)
    if isinstance(space, NoHypothesis):
        return knowledge, space
    return knowledge.with_space(space), space


def struck(
    space: HypothesisSpace, literal: Literal, surroundings: Surroundings
) -> HypothesisSpace | None:
    """The space after the teacher said that ``literal`` (of the base) is no part of the goal.

    The rest of the base becomes the base; of the other goals those without the
    literal stay. Needs no plan. None when nothing is left.
    """
    rest = frozenset(space.base) - {literal}
    if not rest:
        return None
    goals = [goal for goal in ground_goals(space) if literal not in goal and goal != rest]
    return lifted_space(space.demonstration, (rest, *goals), surroundings, confirmed=True)


def insisted(
    space: HypothesisSpace, literal: Literal, surroundings: Surroundings
) -> HypothesisSpace:
    """The space after the teacher said that ``literal`` must hold: goals without it go."""
    goals = [goal for goal in ground_goals(space) if literal in goal]
    if not goals:
        raise ValueError(f"{literal} is not in the goal that was learned")
    return lifted_space(space.demonstration, goals, surroundings, confirmed=True)


def ground_goals(space: HypothesisSpace) -> tuple[Goal, ...]:
    """The ground goals that the space was lifted from, the base first."""
    grounding = space.demonstration.grounding
    pairs = ((node.literals, b) for node in space.nodes for b in node.bindings)
    goals = (bind(literals, grounding, binding) for literals, binding in pairs)
    base = frozenset(space.base)
    return (base, *(goal for goal in goals if goal is not None and goal != base))


def lifted_space(
    demonstration: Demonstration,
    goals: Sequence[Goal],
    surroundings: Surroundings,
    confirmed: bool = False,
) -> HypothesisSpace:
    """Lift ground goals, the base first, into a space; equal ones share a node."""
    lifted = {goal: lift(goal, demonstration.grounding, surroundings) for goal in goals}
    bindings: dict[Lifted, list[Binding]] = defaultdict(list)
    for hypothesis, binding in lifted.values():
        bindings[hypothesis].append(binding)
    order = sorted(bindings, key=lambda h: (-len(h), h))
    index = {hypothesis: i for i, hypothesis in enumerate(order)}
    nodes = tuple(SpaceNode(h, tuple(sorted(set(bindings[h])))) for h in order)
    links = {
        (index[lifted[goal][0]], index[lifted[smaller][0]])
        for goal in goals
        for smaller in _one_less(goal)
        if smaller in lifted
    }
    base = tuple(sorted(goals[0]))
    return HypothesisSpace(demonstration, base, nodes, tuple(sorted(links)), confirmed)


def without_generalisations(space: HypothesisSpace) -> HypothesisSpace:
    """Only the base of a space: what memory alone would keep."""
    return replace(space, nodes=space.nodes[:1], edges=())


def _generalised(base: GoalHypothesis, shown: Shown, learner: Learner) -> tuple[Goal, ...]:
    parameters = learner.parameters
    if shown.goal is not None:
        large = len(base.goal) >= parameters.too_many
        if large or not parameters.generalise_confirmed:
            return (base.goal,)
    return generalisations(base, shown.start, learner)


def _one_less(goal: Goal) -> list[Goal]:
    return [frozenset(rest) for rest in combinations(sorted(goal), len(goal) - 1)]

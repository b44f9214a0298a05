"""Applying what is known of a verb in a new situation: the candidate goals.

Each stored instance of each hypothesis gives a goal: variables become the new
command's objects, abstract terms the things they stood for in the
demonstration. Which goal is wanted is not decided here.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import combinations, islice, product
from typing import NamedTuple, TypeAlias

from verbteach.verbs.knowledge import Bindings, FrameSpace, HypothesisNode, Use, VerbKnowledge
from verbteach.verbs.lifting import Binding, Lifted, affordances_of, terms_of
from verbteach.verbs.space import Demonstration, FrameKey
from verbteach.verbs.surroundings import Surroundings
from verbteach.world.fluents import Goal, Literal, State

Objects: TypeAlias = tuple[str, ...]
GroundingBelief: TypeAlias = tuple[tuple[Objects, float], ...]
"""Joint groundings (an object for each noun phrase) with their probabilities."""


@dataclass(frozen=True)
class Situation:
    """A command in a scene, as the robot believes it."""

    frame: FrameKey
    phrases: tuple[str, ...]
    groundings: GroundingBelief
    state: State
    surroundings: Surroundings

    @cached_property
    def likenesses(self) -> dict[tuple[tuple[str | None, ...], Objects], tuple[float, float]]:
        """Room to remember how like arguments are to a demonstration's objects (``features``)."""
        return {}

    @cached_property
    def expectations(self) -> dict[tuple[int, str], tuple[float, float]]:
        """Room to remember how like a phrase's objects are to another one (``features``)."""
        return {}

    @cached_property
    def marginals(self) -> tuple[Mapping[str, float], ...]:
        """For each noun phrase the probability of each object."""
        found: list[dict[str, float]] = [{} for _ in self.phrases]
        for objects, probability in self.groundings:
            for own, thing in zip(found, objects, strict=True):
                own[thing] = own.get(thing, 0.0) + probability
        return tuple(found)


@dataclass(frozen=True)
class ApplicationParameters:
    """How far a hypothesis may reach.

    ``replace_missing``: a thing that the new scene lacks is replaced by each
    thing with the same affordance set (at most that many, 0 drops the goal:
    She & Chai 2016 keep things "where they exist").
    ``whole_verb``: the verb's other frames give goals too, their variables
    bound to the new objects in every order-keeping way, left-over ones to the
    object they had; a wider pool than the papers'.
    ``borrow_below``: a verb with fewer demonstrations than this borrows the
    goals of all verbs (1: one that nobody taught; 0: none does).
    ``least_only``: of each demonstration only the most general hypotheses
    apply, which loses little and is four times faster.
    ``groundings``: at most this many joint groundings, the likeliest first.
    """

    replace_missing: int = 0
    whole_verb: bool = False
    borrow_below: int = 0
    least_only: bool = False
    groundings: int = 64


class Support(NamedTuple):
    """Why a goal is a candidate: a hypothesis, bound, and the demonstrations that bound it so.

    ``arguments`` are the frame's, None where the hypothesis does not speak of
    one; ``grounding`` is the likeliest joint grounding that gives them, and
    ``probability`` that of all such groundings together.
    """

    frame: FrameSpace
    node: HypothesisNode
    uses: tuple[Use, ...]
    arguments: tuple[str | None, ...]
    grounding: Objects
    probability: float
    replaced: bool

    @property
    def demonstrations(self) -> tuple[Demonstration, ...]:
        """The demonstrations, sorted."""
        return tuple(use.demonstration for use in self.uses)

    @property
    def votes(self) -> float:
        """The expected number of demonstrations that speak for the goal here."""
        return self.probability * len(self.uses)


Block: TypeAlias = list[tuple[Goal, Support]]
"""What one hypothesis speaks for about the same things; demonstrations' own arguments
come in the order of the first demonstration that has them."""


@dataclass(frozen=True)
class Evidence:
    """A goal with everything that speaks for it."""

    goal: Goal
    supports: tuple[Support, ...]
    situation: Situation

    @cached_property
    def key(self) -> tuple[Literal, ...]:
        """The goal, sorted."""
        return tuple(sorted(self.goal))

    @cached_property
    def satisfied(self) -> float:
        """The share of the goal's fluents that hold already."""
        held = sum(literal.holds(self.situation.state) for literal in self.goal)
        return held / len(self.goal)


def uniform(candidates: Sequence[Sequence[str]]) -> GroundingBelief:
    """Every combination of the noun phrases' candidate objects, equally likely."""
    joint = list(dict.fromkeys(product(*candidates)))
    return tuple((objects, 1 / len(joint)) for objects in joint)


def certain(grounding: Sequence[str]) -> GroundingBelief:
    """One grounding, known."""
    return ((tuple(grounding), 1.0),)


def likeliest(belief: GroundingBelief, count: int) -> GroundingBelief:
    """The ``count`` likeliest groundings, normalised; ties in the objects' order."""
    best = sorted((row for row in belief if row[1] > 0), key=lambda row: (-row[1], row[0]))[:count]
    total = sum(probability for _, probability in best)
    return tuple((objects, probability / total) for objects, probability in best)


def evidence(
    knowledge: VerbKnowledge,
    situation: Situation,
    parameters: ApplicationParameters | None = None,
) -> tuple[Evidence, ...]:
    """All candidate goals with their support; equal goals are one.

    They come in the order of the hypotheses that gave them first, the
    command's own frame before others: a fixed order for the same knowledge.
    """
    parameters = parameters or ApplicationParameters()
    borrows = knowledge.taught(situation.frame.verb) < parameters.borrow_below
    found: dict[Goal, list[Support]] = defaultdict(list)
    for block in supports(knowledge, situation, parameters, borrows):
        for goal, support in block:
            found[goal].append(support)
    return tuple(Evidence(goal, tuple(s), situation) for goal, s in found.items())


def supports(
    knowledge: VerbKnowledge,
    situation: Situation,
    parameters: ApplicationParameters,
    borrows: bool,
) -> Iterator[Block]:
    """Everything that speaks for a goal, in the order of ``evidence``.

    ``borrows``: the goals of all verbs are taken.
    """
    belief = likeliest(situation.groundings, parameters.groundings)
    things = _Things(situation.surroundings, parameters.replace_missing)
    arguments: dict[int, _Arguments] = {}
    for frame in _frames(knowledge, situation.frame, parameters.whole_verb, borrows):
        arity = frame.key.arity
        fitting = arguments.setdefault(arity, _Arguments(arity, belief))
        for node in frame.nodes.values():
            bindings = node.least if parameters.least_only else node.bindings
            yield from _supports(frame, node, bindings, fitting, things)


def _frames(
    knowledge: VerbKnowledge, key: FrameKey, whole_verb: bool, borrows: bool
) -> list[FrameSpace]:
    if borrows:
        chosen = list(knowledge.frames)
    elif whole_verb:
        chosen = [k for k in knowledge.frames if k.verb == key.verb]
    else:
        chosen = [key] if key in knowledge.frames else []
    order = sorted(chosen, key=lambda k: (k != key, k.verb != key.verb, k))
    return [knowledge.frames[k] for k in order]


def _supports(
    frame: FrameSpace,
    node: HypothesisNode,
    bindings: Bindings,
    arguments: _Arguments,
    things: _Things,
) -> Iterator[Block]:
    mould = node.mould
    for binding, uses in bindings:
        for used, share, replaced in things.choices(node.literals, binding):
            yield [
                (goal, Support(frame, node, alike, key, grounding, probability * share, replaced))
                for alike, (key, grounding, probability) in arguments.choices(mould.variables, uses)
                if (goal := mould.filled(key, used)) is not None
            ]


class _Chosen(NamedTuple):
    arguments: tuple[str | None, ...]
    grounding: Objects
    probability: float


class _Arguments:
    """The new objects as arguments of frames of one arity, the command's own or another."""

    def __init__(self, arity: int, belief: GroundingBelief) -> None:
        self._arity = arity
        self._belief = belief
        self._fewer = bool(belief) and self._arity > len(belief[0][0])
        self._known: dict[tuple[frozenset[int], Objects], tuple[_Chosen, ...]] = {}

    def choices(
        self, needed: frozenset[int], uses: tuple[Use, ...]
    ) -> list[tuple[tuple[Use, ...], _Chosen]]:
        """Arguments for the variables that are needed, with the uses that may have them.

        Where the command has fewer objects than the frame, the left-over ones
        are each demonstration's own.
        """
        if not self._fewer:
            return [(uses, chosen) for chosen in self._chosen(needed, ())]
        by_old: dict[Objects, list[Use]] = {}
        for use in uses:
            by_old.setdefault(use.demonstration.grounding, []).append(use)
        return [
            (tuple(own), chosen)
            for old, own in by_old.items()
            for chosen in self._chosen(needed, old)
        ]

    def _chosen(self, needed: frozenset[int], old: Objects) -> tuple[_Chosen, ...]:
        """Arguments with their probability; equal ones are one."""
        if (needed, old) not in self._known:
            found: dict[tuple[str | None, ...], _Chosen] = {}
            for objects, probability in self._belief:
                filled = self._filled(objects, old)
                share = probability / len(filled) if filled else 0.0
                for full in filled:
                    key = tuple([o if i in needed else None for i, o in enumerate(full)])
                    before = found.get(key)
                    total = share if before is None else before.probability + share
                    found[key] = _Chosen(key, before.grounding if before else objects, total)
            self._known[needed, old] = tuple(found.values())
        return self._known[needed, old]

    def _filled(self, objects: Objects, old: Objects) -> list[Objects]:
        if not self._fewer:
            return list(combinations(objects, self._arity))
        places = combinations(range(self._arity), len(objects))
        return [_put(objects, at, old) for at in places]


def _put(objects: Objects, places: Sequence[int], into: Objects) -> Objects:
    arguments = list(into)
    for place, thing in zip(places, objects, strict=True):
        arguments[place] = thing
    return tuple(arguments)


class _Things:
    """The things of a binding in this scene: the old ones, or others alike for missing ones."""

    def __init__(self, surroundings: Surroundings, replace_missing: int) -> None:
        self._here = surroundings.affordances
        self._names = frozenset(self._here)
        self._most = replace_missing

    @cached_property
    def _alike(self) -> dict[frozenset[str], list[str]]:
        """The things here by what they afford, each list sorted."""
        found: dict[frozenset[str], list[str]] = defaultdict(list)
        for thing in sorted(self._here):
            found[self._here[thing]].append(thing)
        return found

    def choices(
        self, hypothesis: Lifted, binding: Binding
    ) -> Sequence[tuple[Binding, float, bool]]:
        """Bindings with their shares, and whether a thing was replaced."""
        if self._names.issuperset(binding):
            return ((binding, 1.0, False),)
        if not self._most:
            return ()
        options = [
            [thing] if thing in self._here else self._alike.get(affordances_of(term), [])
            for term, thing in zip(terms_of(hypothesis), binding, strict=True)
        ]
        apart = (b for b in product(*options) if len(set(b)) == len(b))
        fitting = list(islice(apart, self._most))
        return [(other, 1 / len(fitting), True) for other in fitting]

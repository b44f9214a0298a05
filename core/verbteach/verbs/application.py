"""Applying what is known of a verb in a new situation: the candidate goals.

Each stored instance of each hypothesis gives a goal: variables become the new
command's objects, abstract terms the things they stood for in the
demonstration. Which goal is wanted is not decided here.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import combinations, product
from typing import NamedTuple, TypeAlias

from verbteach.verbs.knowledge import FrameSpace, HypothesisNode, VerbKnowledge
from verbteach.verbs.lifting import Binding, affordances_of, bind, terms_of
from verbteach.verbs.setting import Setting
from verbteach.verbs.space import Demonstration, FrameKey
from verbteach.world.fluents import Goal, Literal, State

GroundingBelief: TypeAlias = tuple[tuple[tuple[str, ...], float], ...]
"""Joint groundings (an object for each noun phrase) with their probabilities."""


@dataclass(frozen=True)
class Situation:
    """A command in a scene, as the robot believes it."""

    frame: FrameKey
    phrases: tuple[str, ...]
    groundings: GroundingBelief
    state: State
    setting: Setting


@dataclass(frozen=True)
class ApplicationParameters:
    """How far a hypothesis may reach.

    ``replace_missing``: a thing that the new scene lacks is replaced by each
    thing with the same affordance set (at most that many, 0 drops the goal:
    She & Chai 2016 keep things "where they exist").
    ``whole_verb``: the verb's other frames give goals too, their variables
    bound to the new objects in every order-keeping way, left-over ones to the
    object they had; a wider pool than the papers'.
    ``groundings``: at most this many joint groundings, the likeliest first.
    """

    replace_missing: int = 0
    whole_verb: bool = False
    groundings: int = 24


class Support(NamedTuple):
    """Why a goal is a candidate: a hypothesis, bound, and the demonstrations that bound it so."""

    frame: FrameSpace
    node: HypothesisNode
    demonstrations: tuple[Demonstration, ...]
    grounding: tuple[str, ...]
    probability: float
    replaced: bool


@dataclass(frozen=True)
class Evidence:
    """A goal with everything that speaks for it."""

    goal: Goal
    supports: tuple[Support, ...]
    situation: Situation

    @cached_property
    def key(self) -> tuple[Literal, ...]:
        """The goal, sorted: what ties are broken by."""
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


def evidence(
    knowledge: VerbKnowledge,
    situation: Situation,
    parameters: ApplicationParameters | None = None,
) -> tuple[Evidence, ...]:
    """All candidate goals with their support, sorted by goal; equal goals are one."""
    parameters = parameters or ApplicationParameters()
    found: dict[Goal, list[Support]] = defaultdict(list)
    for frame in _frames(knowledge, situation.frame, parameters.whole_verb):
        for goal, support in _supports(frame, situation, parameters):
            found[goal].append(support)
    gathered = [Evidence(goal, tuple(s), situation) for goal, s in found.items()]
    return tuple(sorted(gathered, key=lambda e: e.key))


def likeliest(belief: GroundingBelief, count: int) -> GroundingBelief:
    """The ``count`` likeliest groundings, normalised; ties in the objects' order."""
    best = sorted((row for row in belief if row[1] > 0), key=lambda row: (-row[1], row[0]))[:count]
    total = sum(probability for _, probability in best)
    return tuple((objects, probability / total) for objects, probability in best)


def _frames(knowledge: VerbKnowledge, key: FrameKey, whole_verb: bool) -> list[FrameSpace]:
    if not whole_verb:
        return [knowledge.frames[key]] if key in knowledge.frames else []
    own = [k for k in knowledge.frames if k.verb == key.verb]
    return [knowledge.frames[k] for k in sorted(own, key=lambda k: (k != key, k))]


def _supports(
    frame: FrameSpace, situation: Situation, parameters: ApplicationParameters
) -> Iterator[tuple[Goal, Support]]:
    belief = likeliest(situation.groundings, parameters.groundings)
    things = _thing_chooser(situation.setting, parameters.replace_missing)
    for node in frame.nodes.values():
        terms = terms_of(node.literals)
        for binding, demonstrations in node.bindings:
            for used, share, replaced in things(terms, binding):
                for objects, probability in belief:
                    for arguments, part in _arguments(frame.key, objects, demonstrations):
                        goal = bind(node.literals, arguments, used)
                        if goal is not None:
                            yield goal, Support(
                                frame, node, demonstrations, objects,
                                probability * share * part, replaced,
                            )  # fmt: skip


def _arguments(
    key: FrameKey, objects: tuple[str, ...], demonstrations: tuple[Demonstration, ...]
) -> list[tuple[tuple[str, ...], float]]:
    """The new objects as arguments of a frame of this or another arity, each with its share."""
    if key.arity <= len(objects):
        chosen = list(combinations(objects, key.arity))
    else:
        old = dict.fromkeys(d.grounding for d in demonstrations)
        places = list(combinations(range(key.arity), len(objects)))
        chosen = [_put(objects, at, into) for into in old for at in places]
    return [(arguments, 1 / len(chosen)) for arguments in chosen]


def _put(objects: Sequence[str], places: Sequence[int], into: Sequence[str]) -> tuple[str, ...]:
    arguments = list(into)
    for place, thing in zip(places, objects, strict=True):
        arguments[place] = thing
    return tuple(arguments)


_Chooser: TypeAlias = Callable[[tuple[str, ...], Binding], Sequence[tuple[Binding, float, bool]]]


def _thing_chooser(setting: Setting, replace_missing: int) -> _Chooser:
    """Bindings for this scene: the old things, or others alike where they are missing."""
    alike: Mapping[frozenset[str], tuple[str, ...]] = {
        marks: setting.alike(marks) for marks in dict.fromkeys(setting.affordances.values())
    }

    def choose(terms: tuple[str, ...], binding: Binding) -> Sequence[tuple[Binding, float, bool]]:
        if all(thing in setting.affordances for thing in binding):
            return ((binding, 1.0, False),)
        if not replace_missing:
            return ()
        choices = [
            (thing,) if thing in setting.affordances else alike.get(affordances_of(term), ())
            for term, thing in zip(terms, binding, strict=True)
        ]
        fitting = [b for b in product(*choices) if len(set(b)) == len(b)][:replace_missing]
        return [(other, 1 / len(fitting), True) for other in fitting]

    return choose

"""Lifting: from a goal about these objects to a hypothesis about any, and back.

The command's arguments become variables ``?0``, ``?1``. Any other thing is
abstracted to its affordance set, ``<graspable+pourable>0``; the number tells
apart things with the same set. Lifted literals are ordinary literals over such
terms, and their sorted tuple is the same for all goals that are equal up to
renaming, so that equality means merging.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import lru_cache
from typing import TypeAlias, cast

from verbteach.verbs.surroundings import Surroundings
from verbteach.world.fluents import Fluent, Goal, Literal

Lifted: TypeAlias = tuple[Literal, ...]
"""A lifted conjunction, sorted: a hypothesis."""

Binding: TypeAlias = tuple[str, ...]
"""The things that stand for the abstract terms of a hypothesis, in the terms' sorted order."""

_Colours: TypeAlias = dict[str, int]
_Shade: TypeAlias = tuple[int, str]
_Signature: TypeAlias = tuple[int, tuple[tuple[bool, str, tuple[_Shade, ...]], ...]]

_REMEMBERED = 1024
"""Goals that a mould remembers; then it begins anew."""

_BRANCHING = 24
"""Orders of interchangeable things that are tried before the first one is taken as it is."""


def variable(index: int) -> str:
    """The variable of the command's noun phrase number ``index``."""
    return f"?{index}"


def is_variable(term: str) -> bool:
    """Whether a term is an argument's variable."""
    return term.startswith("?")


def is_abstract(term: str) -> bool:
    """Whether a term stands for a thing that is no argument."""
    return term.startswith("<")


def affordances_of(term: str) -> frozenset[str]:
    """The affordance set that an abstract term names."""
    return frozenset(word for word in term[1 : term.rindex(">")].split("+") if word)


@lru_cache(maxsize=65_536)
def terms_of(hypothesis: Lifted) -> tuple[str, ...]:
    """The hypothesis's abstract terms, sorted: what a binding binds."""
    words = {word for literal in hypothesis for word in literal.fluent.args}
    return tuple(sorted(word for word in words if is_abstract(word)))


@lru_cache(maxsize=65_536)
def variables_of(hypothesis: Lifted) -> frozenset[int]:
    """The numbers of the hypothesis's variables."""
    words = (word for literal in hypothesis for word in literal.fluent.args)
    return frozenset(int(word[1:]) for word in words if is_variable(word))


def rename(literals: Iterable[Literal], names: Mapping[str, str]) -> Iterable[Literal]:
    """Replace words in the literals' arguments, those that ``names`` knows."""
    known = names.get
    for (predicate, args), positive in literals:
        yield Literal(Fluent(predicate, tuple(map(known, args, args))), positive)


def lift(
    goal: Goal, grounding: Sequence[str], surroundings: Surroundings
) -> tuple[Lifted, Binding]:
    """Abstract a goal; the binding says which things its abstract terms stood for.

    Two noun phrases with the same object share the first one's variable.
    """
    own = frozenset(grounding)
    words = {word for literal in goal for word in literal.fluent.args}
    others = sorted(w for w in words if w in surroundings.affordances and w not in own)
    labels = tuple([(o, "+".join(sorted(surroundings.affordances[o]))) for o in others])
    return _lifted(goal, tuple(grounding), labels)


@lru_cache(maxsize=16_384)  # what one demonstration changed is seen again under other noise
def _lifted(
    goal: Goal, grounding: tuple[str, ...], labels: tuple[tuple[str, str], ...]
) -> tuple[Lifted, Binding]:
    """Abstract a goal whose things, beside the grounding's, have these labels."""
    names: dict[str, str] = {}
    for index, thing in enumerate(grounding):
        names.setdefault(thing, variable(index))
    order = _canonical_order(tuple(rename(goal, names)), dict(labels))
    names.update(_number(order, dict(labels)))
    hypothesis = tuple(sorted(rename(goal, names)))
    stands_for = {names[thing]: thing for thing, _ in labels}
    return hypothesis, tuple(stands_for[term] for term in sorted(stands_for))


@dataclass(frozen=True)
class Mould:
    """A hypothesis ready to be filled: each literal with the places of its words.

    Places count through the things that fill abstract terms, then ``constants``,
    then the arguments; ``variables`` are the arguments needed. ``mixed``: a
    fluent must hold and one of the same predicate must not, so that the two
    might come to be one. ``about_others`` is the share of literals about a
    thing that is no argument.
    """

    literals: tuple[tuple[str, tuple[int, ...], bool], ...]
    terms: int
    constants: tuple[str, ...]
    variables: frozenset[int]
    mixed: bool
    about_others: float = 0.0
    _goals: dict[tuple[Sequence[str | None], Binding], Goal | None] = field(
        default_factory=dict, repr=False, compare=False
    )

    def filled(self, arguments: Sequence[str | None], binding: Binding) -> Goal | None:
        """See ``bind``. Goals are remembered: in one room the same ones are asked for often."""
        key = (tuple(arguments), binding)
        try:
            return self._goals[key]
        except KeyError:
            if len(self._goals) >= _REMEMBERED:
                self._goals.clear()
            return self._goals.setdefault(key, self._filled(arguments, binding))

    def _filled(self, arguments: Sequence[str | None], binding: Binding) -> Goal | None:
        if any(i >= len(arguments) or arguments[i] is None for i in self.variables):
            return None
        if len(binding) != self.terms:
            raise ValueError(f"{len(binding)} things for {self.terms} abstract terms")
        words = cast(tuple[str, ...], (*binding, *self.constants, *arguments))
        goal = frozenset(
            [
                Literal(Fluent(predicate, tuple([words[i] for i in places])), positive)
                for predicate, places, positive in self.literals
            ]
        )
        if self.mixed and len({literal.fluent for literal in goal}) < len(goal):
            return None
        return goal


@lru_cache(maxsize=65_536)
def mould_of(hypothesis: Lifted) -> Mould:
    """The hypothesis, prepared for being bound many times."""
    words = {word for literal in hypothesis for word in literal.fluent.args}
    terms = terms_of(hypothesis)
    constants = tuple(sorted(w for w in words if not is_abstract(w) and not is_variable(w)))
    place = {word: index for index, word in enumerate((*terms, *constants))}
    variables = variables_of(hypothesis)
    before = len(place)
    place.update({variable(index): before + index for index in sorted(variables)})
    predicates = [
        {fluent.predicate for fluent, positive in hypothesis if positive is wanted}
        for wanted in (True, False)
    ]
    return Mould(
        tuple((f.predicate, tuple(place[w] for w in f.args), p) for f, p in hypothesis),
        len(terms),
        constants,
        variables,
        bool(predicates[0] & predicates[1]),
        _share([any(map(is_abstract, fluent.args)) for fluent, _ in hypothesis]),
    )


def _share(marks: Sequence[bool]) -> float:
    return sum(marks) / len(marks) if marks else 0.0


def bind(hypothesis: Lifted, arguments: Sequence[str | None], binding: Binding) -> Goal | None:
    """The goal for new arguments and things; None if it contradicts itself or lacks an argument.

    An argument may be None where the hypothesis does not speak of it. Raises
    ``ValueError`` unless there is one thing for each abstract term.
    """
    return mould_of(hypothesis).filled(arguments, binding)


def _number(order: Sequence[str], labels: Mapping[str, str]) -> dict[str, str]:
    seen: dict[str, int] = {}
    names = {}
    for thing in order:
        label = labels[thing]
        names[thing] = f"<{label}>{seen.setdefault(label, 0)}"
        seen[label] += 1
    return names


def _canonical_order(literals: Lifted, labels: Mapping[str, str]) -> list[str]:
    """Order things by label and then by their place in the literals, blind to their ids."""
    if len(set(labels.values())) == len(labels):
        return sorted(labels, key=lambda o: labels[o])
    ranks = {label: i for i, label in enumerate(sorted(set(labels.values())))}
    colours = _refine(literals, {o: ranks[label] for o, label in labels.items()})
    return _individualise(literals, colours, labels, _BRANCHING)[1]


def _refine(literals: Lifted, colours: _Colours) -> _Colours:
    """Split things of one colour by the literals they occur in, until nothing splits."""
    while True:
        signatures = {o: _signature(o, literals, colours) for o in colours}
        ranks = {s: i for i, s in enumerate(sorted(set(signatures.values())))}
        finer = {o: ranks[s] for o, s in signatures.items()}
        if len(ranks) == len(set(colours.values())):
            return finer
        colours = finer


def _signature(thing: str, literals: Lifted, colours: _Colours) -> _Signature:
    own = (
        (positive, predicate, tuple(_shade(a, thing, colours) for a in args))
        for (predicate, args), positive in literals
        if thing in args
    )
    return (colours[thing], tuple(sorted(own)))


def _shade(word: str, thing: str, colours: _Colours) -> _Shade:
    if word == thing:
        return (-2, "")
    return (colours[word], "") if word in colours else (-1, word)


def _individualise(
    literals: Lifted, colours: _Colours, labels: Mapping[str, str], budget: int
) -> tuple[Lifted, list[str]]:
    """Break the first tie each way (within ``budget``) and take the least reading."""
    order = sorted(colours, key=lambda o: (colours[o], o))
    ties = [[o for o in order if colours[o] == colour] for colour in sorted(set(colours.values()))]
    tied = next((cell for cell in ties if len(cell) > 1), None)
    if tied is None:
        return tuple(sorted(rename(literals, _number(order, labels)))), order
    tried = tied if len(tied) <= budget else tied[:1]
    doubled = {o: 2 * colour + 1 for o, colour in colours.items()}
    readings = (
        _individualise(
            literals,
            _refine(literals, {**doubled, first: doubled[first] - 1}),
            labels,
            budget // len(tied),
        )
        for first in tried
    )
    return min(readings, key=lambda reading: reading[0])

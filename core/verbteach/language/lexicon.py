"""The words the robot knows, as data that is passed in: nouns, verbs, and how fluents read."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field


@dataclass(frozen=True)
class FluentWording:
    """How a predicate reads. Slots ``{0}``, ``{1}`` are the arguments' names.

    ``is_true`` "{0} is on {1}", ``is_false`` "{0} is not on {1}", ``question``
    "is {0} on {1}?", ``should`` "{0} should be on {1}", ``should_not``
    "{0} should not be on {1}", ``became`` "{0} is now on {1}", ``ceased``
    "{0} is no longer on {1}".
    """

    is_true: str
    is_false: str
    question: str
    should: str
    should_not: str
    became: str
    ceased: str


@dataclass(frozen=True)
class Lexicon:
    """Word knowledge; every field may be empty, and then the robot asks more.

    ``synonyms`` maps a noun to nouns that may mean the same ("cup": "mug").
    ``attributes`` maps an attribute's value to its kind ("red": "colour").
    ``particles`` maps a verb to the particles it takes ("turn": "on", "off").
    ``fluents`` and ``actions`` word predicates and primitive actions. Predicates
    in ``unspoken`` are the robot's own bookkeeping, which it neither says nor
    asks; those in ``incidental`` are only meant where nothing else changes.
    ``steps`` has further ways of saying an action, understood and never said;
    ``handles`` are predicates by which a thing works another, as a knob a burner.
    """

    synonyms: Mapping[str, frozenset[str]] = field(default_factory=dict)
    attributes: Mapping[str, str] = field(default_factory=dict)
    verbs: frozenset[str] = frozenset()
    particles: Mapping[str, frozenset[str]] = field(default_factory=dict)
    fluents: Mapping[str, FluentWording] = field(default_factory=dict)
    actions: Mapping[str, str] = field(default_factory=dict)
    steps: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    unspoken: frozenset[str] = frozenset()
    incidental: frozenset[str] = frozenset()
    handles: frozenset[str] = frozenset()

"""Learners from demonstrations alone: She & Chai (2016) and its variants, by name."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

from verbteach.verbs.application import ApplicationParameters
from verbteach.verbs.change import ObjectSet
from verbteach.verbs.criteria import PLAIN_CRITERIA
from verbteach.verbs.hypothesis import LearningParameters
from verbteach.verbs.regression import FittingParameters
from verbteach.verbs.selection import Pooling, SelectionParameters

REGRESSION, ORACLE = "regression", "oracle"
CRITERIA: tuple[str, ...] = (*PLAIN_CRITERIA, REGRESSION, ORACLE)
"""Names of the selection criteria; ``oracle`` is the upper bound, not a method."""


@dataclass(frozen=True)
class Variant:
    """A learner from demonstrations.

    ``reenacts``: it does not trust what it sees at the end, but carries the
    demonstrated actions out in its mind from what it believes of the start.
    ``selection.criterion`` is replaced by ``criterion``, which may need fitting.
    """

    name: str
    criterion: str = REGRESSION
    learning: LearningParameters = field(default_factory=LearningParameters)
    reenacts: bool = False
    selection: SelectionParameters = field(default_factory=SelectionParameters)
    fitting: FittingParameters = field(default_factory=FittingParameters)

    def __post_init__(self) -> None:
        if self.criterion not in CRITERIA:
            known = ", ".join(CRITERIA)
            raise ValueError(f"no selection criterion {self.criterion!r}; there are {known}")

    def with_objects(self, objects: ObjectSet) -> Variant:
        """The same learner with hypotheses about other objects."""
        return replace(self, learning=replace(self.learning, object_set=objects))


STRONG = SelectionParameters(
    application=ApplicationParameters(whole_verb=True, least_only=True, borrow_below=1),
    pooling=Pooling.CONSENSUS,
)
"""How the strongest variant applies what it knows."""

VARIANTS: Mapping[str, Variant] = {
    variant.name: variant
    for variant in (
        Variant("she16", selection=STRONG, reenacts=True).with_objects(ObjectSet.MANIPULATED),
        Variant("she16-all"),
    )
}


def variant(
    name: str = "she16", criterion: str | None = None, objects: str | None = None
) -> Variant:
    """A variant by name.

    A criterion or an object set that is named picks one of She & Chai's own,
    applied as in their paper: what is not named is the paper's default (all
    objects, regression). Raises ``ValueError`` for names that are none.
    """
    if name not in VARIANTS:
        raise ValueError(f"no demonstration-only learner {name!r}; there are {', '.join(VARIANTS)}")
    if criterion is None and objects is None:
        return VARIANTS[name]
    chosen = Variant(
        "-".join(["she16", *filter(None, (criterion, objects))]), criterion or REGRESSION
    )
    try:
        return chosen.with_objects(ObjectSet(objects or ObjectSet.ALL.value))
    except ValueError:
        known = ", ".join(kind.value for kind in ObjectSet)
        raise ValueError(f"no object set {objects!r}; there are {known}") from None

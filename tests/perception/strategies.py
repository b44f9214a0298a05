"""Hypothesis strategies for states and beliefs."""

from __future__ import annotations

from hypothesis import strategies as st

from verbteach.perception.belief import Belief, Exclusivity
from verbteach.world.fluents import Fluent, State

things = st.sampled_from(["Cup_1", "Cup_2", "Tray_1", "Sink"])
fluents = st.builds(Fluent, st.sampled_from(["on", "in", "near"]), st.tuples(things, things))
PLACE = Exclusivity((("on", 0), ("in", 0)))
WHERE = PLACE._replace(joint=True)


def states() -> st.SearchStrategy[State]:
    return st.frozensets(fluents, max_size=8)


def beliefs(exclusive: tuple[Exclusivity, ...] = ()) -> st.SearchStrategy[Belief]:
    rows = st.dictionaries(fluents, st.floats(0, 1), max_size=10)
    return rows.map(lambda found: Belief.of(found, exclusive))

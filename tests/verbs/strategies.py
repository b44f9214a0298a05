"""Hypothesis strategies for demonstrations in the toy world."""

from __future__ import annotations

from typing import TypeAlias

from hypothesis import settings
from hypothesis import strategies as st

from tests.verbs.toy import NaivePlanner, Toy
from verbteach.verbs.hypothesis import Learner, LearningParameters, Shown
from verbteach.verbs.learning import derive
from verbteach.verbs.space import Demonstration, HypothesisSpace
from verbteach.world.plan import Action

TOY = Toy(("Box_1", "Box_2"), ("Table_1", "Table_2"), ("Lamp_1",))
PLANNER = NaivePlanner(TOY)
"""Shared, so that its answers are remembered between examples."""

FEW = settings(max_examples=25)
"""For properties of several demonstrations, each of which takes plans to make."""

Taught: TypeAlias = tuple[Demonstration, Shown]


@st.composite
def walks(draw: st.DrawFn, longest: int = 6) -> tuple[Action, ...]:
    """Random applicable actions from the toy's start."""
    state, actions = TOY.start, []
    for _ in range(draw(st.integers(1, longest))):
        action, state = draw(st.sampled_from(list(TOY.steps(state))))
        actions.append(action)
    return tuple(actions)


@st.composite
def taught(draw: st.DrawFn) -> Taught:
    """A demonstration with up to two noun phrases."""
    actions = draw(walks())
    things = st.sampled_from(sorted(TOY.surroundings.affordances))
    grounding = tuple(draw(st.lists(things, min_size=1, max_size=2)))
    who = Demonstration(
        draw(st.sampled_from(["a", "b", "c", "d"])),
        draw(st.sampled_from(["move", "light"])),
        tuple(draw(st.sampled_from(["the box", "it", "table"])) for _ in grounding),
        grounding,
    )
    return who, Shown(TOY.start, actions, TOY.run(TOY.start, actions))


def learner(parameters: LearningParameters | None = None) -> Learner:
    return Learner(PLANNER, TOY.surroundings, parameters or LearningParameters())


@st.composite
def spaces(draw: st.DrawFn) -> HypothesisSpace:
    """The space of a random demonstration that teaches something."""
    derived = st.builds(lambda pair: derive(pair[0], pair[1], learner()), taught())
    found = draw(derived.filter(lambda space: isinstance(space, HypothesisSpace)))
    assert isinstance(found, HypothesisSpace)
    return found

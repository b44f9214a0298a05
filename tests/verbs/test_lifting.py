"""Lifting is blind to ids and exact when undone."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from tests.verbs.toy import on
from verbteach.verbs.lifting import affordances_of, bind, lift, rename, terms_of
from verbteach.verbs.surroundings import Surroundings
from verbteach.world.fluents import Fluent, Goal, Literal

THINGS = tuple(f"{kind}_{i}" for kind in ("Cup", "Tray") for i in range(1, 4))
MARKS = {o: frozenset({"graspable", o.partition("_")[0].lower()}) for o in THINGS}
SETTING = Surroundings(affordances=MARKS)

words = st.sampled_from((*THINGS, "Robot", "Water"))
literals = st.builds(
    Literal,
    st.builds(Fluent, st.sampled_from(["on", "state"]), st.tuples(words, words)),
    st.booleans(),
)


def consistent(goal: Goal) -> bool:
    return len({literal.fluent for literal in goal}) == len(goal)


goals = st.frozensets(literals, min_size=1, max_size=6).filter(consistent)
groundings = st.lists(st.sampled_from(THINGS), max_size=3).map(tuple)


@st.composite
def shuffles(draw: st.DrawFn) -> dict[str, str]:
    """Exchange things for others with the same affordance set."""
    cups, trays = THINGS[:3], THINGS[3:]
    return {
        **dict(zip(cups, draw(st.permutations(cups)), strict=True)),
        **dict(zip(trays, draw(st.permutations(trays)), strict=True)),
    }


@given(goals, groundings)
def test_binding_undoes_lifting(goal: Goal, grounding: tuple[str, ...]) -> None:
    lifted, binding = lift(goal, grounding, SETTING)
    assert bind(lifted, grounding, binding) == goal


@given(goals, groundings, shuffles())
def test_goals_equal_up_to_alike_things_lift_alike(
    goal: Goal, grounding: tuple[str, ...], names: dict[str, str]
) -> None:
    other = frozenset(rename(goal, names))
    assert lift(goal, grounding, SETTING)[0] == lift(
        other, tuple(names[g] for g in grounding), SETTING
    )[0]  # fmt: skip


@given(goals, groundings)
def test_nothing_of_the_room_is_left(goal: Goal, grounding: tuple[str, ...]) -> None:
    lifted, binding = lift(goal, grounding, SETTING)
    assert not {a for x in lifted for a in x.fluent.args} & set(THINGS)
    for term, thing in zip(terms_of(lifted), binding, strict=True):
        assert affordances_of(term) == MARKS[thing]
    assert list(lifted) == sorted(lifted)


@given(goals, goals)
def test_goals_that_differ_otherwise_lift_apart(one: Goal, other: Goal) -> None:
    """Equal hypotheses mean that some exchange of alike things makes the goals equal."""
    (first, things), (second, others) = lift(one, (), SETTING), lift(other, (), SETTING)
    if first == second:
        names = dict(zip(things, others, strict=True))
        assert frozenset(rename(one, names)) == other


def test_arguments_become_variables_and_constants_stay() -> None:
    goal = frozenset({Literal(on("Cup_1", "Tray_1")), Literal(Fluent("in", ("Water", "Cup_1")))})
    lifted, binding = lift(goal, ("Cup_1",), SETTING)
    assert lifted == (
        Literal(Fluent("in", ("Water", "?0"))),
        Literal(Fluent("on", ("?0", "<graspable+tray>0"))),
    )
    assert binding == ("Tray_1",)


def test_many_interchangeable_things_are_lifted_in_reasonable_time() -> None:
    things = {f"Cup_{i}": frozenset({"cup"}) for i in range(9)}
    goal = frozenset(Literal(Fluent("full", (o,))) for o in things)
    lifted, binding = lift(goal, (), Surroundings(affordances=things))
    assert len(lifted) == len(binding) == 9


def test_a_goal_that_contradicts_itself_or_lacks_an_argument_is_none() -> None:
    goal = frozenset({Literal(on("Cup_1", "Tray_1")), Literal(on("Cup_2", "Tray_1"), False)})
    lifted, _ = lift(goal, ("Cup_1", "Cup_2", "Tray_1"), SETTING)
    assert bind(lifted, ("Cup_3", "Cup_3", "Tray_1"), ()) is None
    assert bind(lifted, ("Cup_3", "Cup_1"), ()) is None

from __future__ import annotations

from dataclasses import replace
from itertools import compress

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from tests.verbs.test_pool import TOY, distinct, example, source
from verbteach.verbs.examples import Memory
from verbteach.verbs.in_hand import handed, held_things
from verbteach.verbs.pool import GoalPool, PoolParameters
from verbteach.verbs.resemblance import Kernel, Said
from verbteach.verbs.surroundings import Surroundings
from verbteach.world.fluents import Fluent, Goal, Literal, State

STORE = Said("store", ("box",))


def grasped(box: str) -> Fluent:
    return Fluent("grasping", ("Robot", box))


def stored(box: str, place: str = "l1") -> Goal:
    """What putting a held box somewhere changes."""
    return frozenset({Literal(grasped(box), False), Literal(Fluent("on", (box, place)))})


def pool(
    state: State, hand: float = 2.0, surroundings: Surroundings = TOY.surroundings
) -> GoalPool:
    """The belief about "store the box", taken for the table; shown were b1 stored, and t1 lit."""
    known = Memory.keeping(
        [
            example("d0", "store", ("box",), ("t1",), stored("b1")),
            example("d1", "store", ("box",), ("t1",), frozenset({Literal(Fluent("lit", ("t1",)))})),
        ]
    )
    parameters = PoolParameters(kernel=Kernel(possible=4.0, hand=hand))
    return source(known, STORE, (("t1",),), parameters, surroundings).pool(state, np.ones(1))


def test_what_was_let_go_of_stands_for_what_is_held() -> None:
    goals = distinct(pool(frozenset({grasped("b2")})))
    assert stored("b2") in goals
    assert stored("b2") not in distinct(pool(frozenset({grasped("b2")}), hand=0.0))


def test_a_change_of_the_held_thing_is_likelier_the_more_the_hand_weighs() -> None:
    chances = [distinct(pool(frozenset({grasped("b2")}), hand=w))[stored("b2")] for w in (1, 2, 4)]
    assert chances == sorted(chances)
    assert chances[0] < chances[-1]


def test_an_empty_hand_changes_nothing() -> None:
    state = frozenset({Fluent("on", ("b2", "t1"))})
    assert distinct(pool(state)) == distinct(pool(state, hand=0.0))


def test_the_thing_that_was_shown_is_taken_as_it_is_when_it_is_held_now() -> None:
    goals = distinct(pool(frozenset({grasped("b1")})))
    assert stored("b1") in goals
    assert not any("b2" in literal.fluent.args for goal in goals for literal in goal)


def test_what_cannot_be_with_the_held_thing_is_left_out_and_counts_against_it() -> None:
    ended = frozenset({grasped("b1"), grasped("b2")})
    here = replace(TOY.surroundings, made=frozenset({Fluent("on", ("b1", "l1"))}), ended=ended)
    offered = distinct(pool(frozenset({grasped("b2")}), surroundings=here))
    assert frozenset({Literal(grasped("b2"), False)}) in offered
    assert not any(stored("b2") <= goal for goal in offered)
    literals = sorted(stored("b1"))
    found = handed(literals, np.ones((1, 2), dtype=bool), ["b2"], here.possible)
    assert found.possible.tolist() == [0.5]
    assert found.source.tolist() == [0]


def test_held_things_are_read_in_both_domains_words() -> None:
    state = frozenset(
        {grasped("b2"), Fluent("Grasping", ("Robot", "a")), Fluent("on", ("b1", "x"))}
    )
    assert held_things(state) == ("a", "b2")


@given(st.permutations(sorted(stored("b1") | stored("b3"))))
def test_the_rows_come_in_one_order_whatever_order_literals_turned_up_in(
    literals: list[Literal],
) -> None:
    def told(known: list[Literal]) -> list[tuple[Goal, int]]:
        wanted = [stored("b1"), stored("b3"), stored("b1") | stored("b3")]
        bound = np.array([[one in goal for one in known] for goal in wanted])
        now = handed(known, bound, ("b2",), lambda _: True)
        added = now.bound[len(wanted) :].tolist()
        goals = [frozenset(compress(now.literals, row)) for row in added]
        return list(zip(goals, now.source.tolist(), strict=True))

    assert told(literals) == told(sorted(literals))

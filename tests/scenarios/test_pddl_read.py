"""PDDL files become the core's values, nothing lost and nothing folded."""

from __future__ import annotations

from pathlib import Path

import pytest

from verbteach.world.domain import Condition, Effect, Parameter
from verbteach.world.fluents import Fluent, Literal
from verbteach_scenarios.pddl import parse_domain, parse_problem, read_domain, read_problem

KITCHENETTE = Path(__file__).parent.parent / "world" / "data" / "kitchenette.pddl"

PROBLEM = """
(define (problem tea)
  (:domain kitchenette)
  (:objects Cup_1 cup_1 - cup Rice - food Cupboard_1 - box Hob - stove Table)
  (:init (on Cup_1 Sink_1) (hinged Cupboard_1) (not (open Cupboard_1)))
  (:goal (and (hot Cup_1) (and (not (open Cupboard_1))) (not (on cup_1 Sink_1)))))
"""


def test_types_constants_and_predicates_keep_their_order_and_spelling() -> None:
    domain = read_domain(KITCHENETTE)
    assert domain.types["stove"] == "fixture"
    assert domain.types["thing"] == "object"
    assert domain.is_a("cup", "thing")
    assert not domain.is_a("thing", "cup")
    assert list(domain.constants.items()) == [("Sink_1", "sink"), ("Tap_1", "fixture")]
    assert list(domain.actions)[:3] == ["moveto", "grasp", "puton"]
    assert domain.static == {"hinged"}
    on = domain.predicates["on"]
    assert on.parameters == (Parameter("?i", "item"), Parameter("?o", "thing"))


def test_preconditions_and_effects_are_read_whole() -> None:
    domain = read_domain(KITCHENETTE)
    moveto = domain.actions["moveto"]
    assert moveto.precondition == (Condition("near", ("?o",), positive=False),)
    assert moveto.effects == (
        Effect("near", ("?o",)),
        Effect(
            "near",
            ("?x",),
            positive=False,
            condition=(Condition("near", ("?x",)), Condition("=", ("?x", "?o"), positive=False)),
            parameters=(Parameter("?x", "thing"),),
        ),
    )
    turn = domain.actions["turn"]
    assert turn.parameters == ()
    assert turn.effects[0] == Effect("running", (), False, (Condition("running", ()),))


def test_nested_forall_gathers_its_variables() -> None:
    domain = parse_domain(
        """(define (domain d) (:types a b) (:predicates (p ?x - a ?y - b))
        (:action wipe :parameters () :effect
          (forall (?x - a) (and (forall (?y - b) (not (p ?x ?y)))))))"""
    )
    parameters = (Parameter("?x", "a"), Parameter("?y", "b"))
    assert domain.actions["wipe"].effects == (Effect("p", ("?x", "?y"), False, (), parameters),)
    assert domain.actions["wipe"].precondition == ()


def test_a_problem_keeps_names_that_differ_only_by_case(tmp_path: Path) -> None:
    path = tmp_path / "tea.pddl"
    path.write_text(PROBLEM.replace(" Table)", ")"), encoding="utf-8")
    problem = read_problem(path, read_domain(KITCHENETTE))
    assert problem.name == "tea"
    assert problem.objects["Cup_1"] == problem.objects["cup_1"] == "cup"
    assert problem.objects["Sink_1"] == "sink"
    assert problem.initial == {
        Fluent("on", ("Cup_1", "Sink_1")),
        Fluent("hinged", ("Cupboard_1",)),
    }
    assert problem.goal == {
        Literal(Fluent("hot", ("Cup_1",))),
        Literal(Fluent("open", ("Cupboard_1",)), positive=False),
        Literal(Fluent("on", ("cup_1", "Sink_1")), positive=False),
    }


def test_an_object_without_a_type_is_an_object() -> None:
    problem = parse_problem(PROBLEM, read_domain(KITCHENETTE))
    assert problem.objects["Table"] == "object"


@pytest.mark.parametrize("name", ["on-fire", "X", "a_b-c9", "orange", "not-x", "openable"])
def test_names_may_contain_keywords_dashes_and_capitals(name: str) -> None:
    domain = parse_domain(
        f"""(define (domain {name}) (:types {name}) (:predicates ({name} ?{name} - {name}))
        (:action {name} :parameters (?x - {name}) :effect ({name} ?x)))"""
    )
    assert domain.actions[name].effects == (Effect(name, ("?x",)),)

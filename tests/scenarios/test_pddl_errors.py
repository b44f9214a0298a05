"""Every misfit in a PDDL file is one error that names file, line and construct."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from verbteach_scenarios.pddl import (
    DomainFileError,
    SceneFileError,
    WorldFileError,
    parse_domain,
    parse_problem,
    read_domain,
    read_problem,
)

DOMAIN = """(define (domain shed)
  (:requirements :strips :typing)
  (:types tool cup - item item place)
  (:constants Hook - place)
  (:predicates
    (at ?i - item ?p - place)
    (clean ?i - item))
  (:action carry
    :parameters (?i - item ?from ?to - place)
    :precondition (and (at ?i ?from) (not (= ?from ?to)))
    :effect (and
      (at ?i ?to)
      (when (clean ?i) (not (at ?i ?from))))))
"""

PROBLEM = """(define (problem tidy)
  (:domain shed)
  (:objects Saw - tool
            Shelf - place)
  (:init
    (at Saw Shelf))
  (:goal
    (at Saw Hook)))
"""

DOMAIN_MISFITS = [
    ("(:types tool", "(:types tool tool", 3, "type tool is declared twice"),
    ("item item place", "itm item place", 3, "type itm is not declared"),
    ("cup - item item place", "cup - item item - tool tool - item place", 3, "twice"),
    ("tool cup - item item", "tool - item item - tool", 3, "its own ancestor"),
    ("Hook - place", "Hook - plaice", 4, "type plaice is not declared"),
    ("Hook - place", "Hook Hook - place", 4, "constant Hook is declared twice"),
    ("(clean ?i - item)", "(clean ?i - item) (clean ?p - place)", 7, "predicate clean"),
    ("(clean ?i - item)", "(clean ?i ?i - item)", 7, "variable ?i is declared twice"),
    ("(clean ?i - item)", "(clean ?i - (either item place))", 7, "either"),
    ("?from ?to - place)", "?from ?to - plaice)", 9, "type plaice is not declared"),
    ("?from ?to - place)", "?from ?i - place)", 9, "variable ?i is declared twice"),
    ("(and (at ?i ?from)", "(and (att ?i ?from)", 10, "predicate att is not declared"),
    ("(and (at ?i ?from)", "(and (at ?i)", 10, "at takes 2 arguments, not 1"),
    (
        "(and (at ?i ?from)",
        "(and (at ?from ?i)",
        10,
        "at takes a item for ?i, but ?from is a place",
    ),
    ("(and (at ?i ?from)", "(and (at ?i ?there)", 10, "variable ?there is not declared"),
    ("(and (at ?i ?from)", "(and (at ?i Nail)", 10, "object Nail is not declared"),
    ("(and (at ?i ?from)", "(or (at ?i ?from)", 10, "disjunction (or)"),
    ("(at ?i ?from)", "(imply (clean ?i) (at ?i ?from))", 10, "implication (imply)"),
    ("(at ?i ?from)", "(exists (?x - item) (at ?x ?from))", 10, "(exists)"),
    ("(at ?i ?from)", "(forall (?x - item) (at ?x ?from))", 10, "(forall) in a condition"),
    ("(at ?i ?from)", "(not (and (clean ?i)))", 10, "a negation of (and ...)"),
    ("(at ?i ?from)", "(not (not (clean ?i)))", 10, "a negation of (not ...)"),
    ("(at ?i ?from)", "(> (load ?i) 3)", 10, "a numeric condition (>)"),
    ("(at ?i ?to)", "(increase (load) 3)", 12, "a numeric effect"),
    ("(at ?i ?to)", "(not (= ?i ?to))", 12, "cannot change equality"),
    ("(at ?i ?to)", "(oneof (at ?i ?to) (clean ?i))", 12, "non-deterministic"),
    ("(at ?i ?to)", "(forall (?to - item) (clean ?to))", 12, "variable ?to is declared twice"),
    ("(not (at ?i ?from))))))", "(when (clean ?i) (clean ?i))))))", 13, "a condition (when)"),
    ("(not (at ?i ?from))))))", "(forall (?x - item) (clean ?x))))))", 13, "(forall) here"),
    (":action carry", ":durative-action carry", 8, "durative actions"),
    ("(:action carry", "(:derived (clean ?x - item) (clean ?x)) (:action carry", 8, "derived"),
    ("(:predicates", "(:functions (load)) (:predicates", 5, ":predicates stands out of order"),
    ("(clean ?i - item))", "(clean ?i - item)) (:functions (load))", 7, "numeric fluents"),
    (":strips", ":fluents", 2, "the requirement :fluents"),
    (":strips", ":durative-actions", 2, "':durative-actions' is not expected"),
    (":parameters", ":params", 9, "':params' is not expected here, in (:action carry)"),
    ("(define", "define", 1, "'define' is not expected"),
    ("?from))))))\n", "?from))))))\n)", 14, "a closing parenthesis too many"),
]

PROBLEM_MISFITS = [
    ("(:domain shed)", "(:domain barn)", 2, "the domain barn, but is read with shed"),
    ("Saw - tool", "Saw - tol", 3, "type tol is not declared"),
    ("Saw - tool", "Saw saw Saw - tool", 3, "object Saw is declared twice"),
    ("Shelf - place", "Shelf - (either place tool)", 4, "(either)"),
    ("Shelf - place", "Shelf Hook - place", 4, "object Hook is declared twice"),
    ("(at Saw Shelf)", "(on Saw Shelf)", 6, "predicate on is not declared"),
    ("(at Saw Shelf)", "(at Saw)", 6, "at takes 2 arguments, not 1"),
    ("(at Saw Shelf)", "(at saw Shelf)", 6, "object saw is not declared"),
    ("(at Saw Shelf)", "(at Shelf Saw)", 6, "but Shelf is a place"),
    ("(at Saw Shelf)", "(= (load Saw) 4)", 6, "a number as a starting fact"),
    ("(at Saw Shelf)", "(at Saw Shelf)\n(not (at Saw Shelf))", 7, "both to hold and not to hold"),
    ("(at Saw Shelf)", "(when (at Saw Shelf) (clean Saw))", 6, "a condition (when)"),
    ("(at Saw Hook)", "(or (at Saw Hook))", 8, "disjunction"),
    ("(at Saw Hook)", "(at Saw Nail)", 8, "object Nail is not declared"),
    ("(at Saw Hook)", "(at ?s Hook)", 8, "variable ?s is not declared"),
    ("(at Saw Hook)", "(forall (?x - item) (at ?x Hook))", 8, "(forall) in a condition"),
    ("(at Saw Hook)", "(= Saw Saw)", 8, "equality (=) in a goal"),
    ("Hook)))", "Hook))\n(:metric minimize (total-cost)))", 9, "a metric"),
]


@pytest.mark.parametrize(("old", "new", "line", "reason"), DOMAIN_MISFITS)
def test_a_misfit_in_a_domain(old: str, new: str, line: int, reason: str) -> None:
    assert old in DOMAIN
    with pytest.raises(DomainFileError) as caught:
        parse_domain(DOMAIN.replace(old, new, 1), Path("shed.pddl"))
    assert reason in caught.value.reason
    assert caught.value.line == line
    assert str(caught.value).startswith(f"shed.pddl:{line}: ")
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(("old", "new", "line", "reason"), PROBLEM_MISFITS)
def test_a_misfit_in_a_problem(old: str, new: str, line: int, reason: str) -> None:
    assert old in PROBLEM
    with pytest.raises(SceneFileError) as caught:
        parse_problem(PROBLEM.replace(old, new, 1), parse_domain(DOMAIN), Path("tidy.pddl"))
    assert reason in caught.value.reason
    assert caught.value.line == line
    assert str(caught.value).startswith(f"tidy.pddl:{line}: ")


def test_the_originals_are_sound() -> None:
    assert parse_problem(PROBLEM, parse_domain(DOMAIN)).objects["Hook"] == "place"


def test_a_torn_file_names_the_parenthesis_left_open() -> None:
    with pytest.raises(DomainFileError) as caught:
        parse_domain(DOMAIN[: DOMAIN.index("(when (clean")])
    assert caught.value.line == 12
    assert caught.value.reason.endswith("the parenthesis opened in line 11 is closed")


@pytest.mark.parametrize("text", ["", "; only a comment\n"])
def test_an_empty_file(text: str) -> None:
    with pytest.raises(DomainFileError, match="a PDDL domain should begin"):
        parse_domain(text)


def test_a_file_cut_anywhere_is_refused_or_read() -> None:
    domain = parse_domain(DOMAIN)
    for end in range(len(PROBLEM.rstrip()) - 1):
        with pytest.raises(SceneFileError):
            parse_problem(PROBLEM[:end], domain)
    for end in range(len(DOMAIN.rstrip()) - 1):
        with pytest.raises(DomainFileError):
            parse_domain(DOMAIN[:end])


def test_a_missing_file_and_one_that_is_no_text(tmp_path: Path) -> None:
    with pytest.raises(DomainFileError, match="cannot be read: No such file"):
        read_domain(tmp_path / "none.pddl")
    path = tmp_path / "bytes.pddl"
    path.write_bytes(b"(define\n(problem \xff\xfe")
    with pytest.raises(SceneFileError) as caught:
        read_problem(path, parse_domain(DOMAIN))
    assert (caught.value.line, caught.value.reason) == (2, "is not UTF-8 text")


@settings(max_examples=150, deadline=None)
@given(st.data())
def test_a_damaged_file_never_fails_otherwise(data: st.DataObject) -> None:
    start = data.draw(st.integers(0, len(DOMAIN) - 1))
    stop = data.draw(st.integers(start, min(len(DOMAIN), start + 12)))
    put = data.draw(st.sampled_from(["", "(", ")", "?x", "not", "when", "(and)", "\0", "é", "-"]))
    lines: list[int] = []
    try:
        parse_domain(DOMAIN[:start] + put + DOMAIN[stop:])
    except WorldFileError as error:
        lines.append(error.line)
    assert all(1 <= line <= DOMAIN.count("\n") + 1 for line in lines)

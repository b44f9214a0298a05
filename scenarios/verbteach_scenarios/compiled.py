"""Domains and problems as plain JSON, so that the bundled ones open without a parser.

A compiled file carries the digest of the texts it was made from; one that does
not fit its texts is passed over. Building the PDDL parser takes about 0.3 s,
reading a compiled scene a few milliseconds.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from verbteach.world.domain import (
    ActionSchema,
    Condition,
    Domain,
    Effect,
    Parameter,
    Predicate,
)
from verbteach.world.fluents import Fluent, Literal
from verbteach_scenarios.pddl.problem_file import Problem

FORMAT = 1


def digest(*texts: str) -> str:
    """SHA-256 over texts; line ends do not count."""
    made = hashlib.sha256(str(FORMAT).encode())
    for text in texts:
        made.update(b"\0" + "\n".join(text.splitlines()).encode())
    return made.hexdigest()


def read_compiled(path: Path, wanted: str) -> dict[str, Any] | None:
    """The compiled value, or nothing where there is none made from the wanted texts."""
    try:
        data = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return None
    return data if isinstance(data, dict) and data.get("digest") == wanted else None


def compiled_text(value: dict[str, Any], made_from: str) -> str:
    """A compiled file's text: one line, the same for the same value."""
    return json.dumps({"digest": made_from, **value}, separators=(",", ":")) + "\n"


def domain_to_json(domain: Domain) -> dict[str, Any]:
    """The domain as plain JSON values, in its own order."""
    return {
        "name": domain.name,
        "types": dict(domain.types),
        "constants": dict(domain.constants),
        "predicates": list(domain.predicates.values()),
        "actions": list(domain.actions.values()),
    }


def domain_from_json(data: dict[str, Any]) -> Domain:
    """The domain again."""
    predicates = (Predicate(name, _parameters(listed)) for name, listed in data["predicates"])
    actions = (_action(*parts) for parts in data["actions"])
    return Domain(
        data["name"],
        data["types"],
        data["constants"],
        {predicate.name: predicate for predicate in predicates},
        {action.name: action for action in actions},
    )


def problem_to_json(problem: Problem) -> dict[str, Any]:
    """The problem as plain JSON values; facts and goal sorted."""
    return {
        "name": problem.name,
        "objects": dict(problem.objects),
        "initial": [str(fluent) for fluent in sorted(problem.initial)],
        "goal": [str(literal) for literal in sorted(problem.goal)],
    }


def problem_from_json(data: dict[str, Any]) -> Problem:
    """The problem again."""
    return Problem(
        data["name"],
        data["objects"],
        frozenset(Fluent.parse(text) for text in data["initial"]),
        frozenset(Literal.parse(text) for text in data["goal"]),
    )


def _parameters(listed: Sequence[Sequence[str]]) -> tuple[Parameter, ...]:
    return tuple(Parameter(*pair) for pair in listed)


def _conditions(listed: Sequence[Sequence[Any]]) -> tuple[Condition, ...]:
    return tuple(Condition(name, tuple(args), positive) for name, args, positive in listed)


def _effect(
    predicate: str,
    args: Sequence[str],
    positive: bool,
    condition: Sequence[Sequence[Any]],
    parameters: Sequence[Sequence[str]],
) -> Effect:
    return Effect(predicate, tuple(args), positive, _conditions(condition), _parameters(parameters))


def _action(
    name: str,
    parameters: Sequence[Sequence[str]],
    precondition: Sequence[Sequence[Any]],
    effects: Sequence[Sequence[Any]],
) -> ActionSchema:
    made = tuple(_effect(*parts) for parts in effects)
    return ActionSchema(name, _parameters(parameters), _conditions(precondition), made)

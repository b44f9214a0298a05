"""A domain and a problem as PDDL text, for planners and validators of other people's making.

Reading the text back gives the same values.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from verbteach.world.domain import ActionSchema, Condition, Domain, Effect
from verbteach.world.fluents import Goal, State


def domain_text(domain: Domain) -> str:
    """Write a domain."""
    predicates = (
        _form(p.name, _typed([(q.name, q.type) for q in p.parameters]))
        for p in domain.predicates.values()
    )
    sections = [
        "(:requirements :strips :typing :negative-preconditions :equality\n"
        "                 :conditional-effects :universal-preconditions)",
        _section(":types", [_typed(list(domain.types.items()))]) if domain.types else "",
        _section(":constants", [_typed(list(domain.constants.items()))])
        if domain.constants
        else "",
        _section(":predicates", predicates) if domain.predicates else "",
        *(_action(schema) for schema in domain.actions.values()),
    ]
    body = "".join(f"\n  {section}" for section in sections if section)
    return f"(define (domain {domain.name}){body})\n"


def problem_text(
    name: str, domain: Domain, objects: Mapping[str, str], initial: State, goal: Goal
) -> str:
    """Write a problem; ``objects`` (name to type) may include the domain's constants."""
    own = [(o, kind) for o, kind in objects.items() if o not in domain.constants]
    listed = [_section(":objects", [_typed(own)])] if own else []
    sections = [
        f"(:domain {domain.name})",
        *listed,
        _section(":init", map(str, sorted(initial))),
        _section(":goal", [_together(map(str, sorted(goal)))]),
    ]
    body = "".join(f"\n  {section}" for section in sections)
    return f"(define (problem {name}){body})\n"


def _action(schema: ActionSchema) -> str:
    parameters = _typed([(p.name, p.type) for p in schema.parameters])
    return (
        f"(:action {schema.name}\n"
        f"    :parameters ({parameters})\n"
        f"    :precondition {_together(map(_condition, schema.precondition))}\n"
        f"    :effect {_together(map(_effect, schema.effects))})"
    )


def _condition(condition: Condition) -> str:
    atom = _form(condition.predicate, *condition.args)
    return atom if condition.positive else f"(not {atom})"


def _effect(effect: Effect) -> str:
    text = _condition(Condition(effect.predicate, effect.args, effect.positive))
    if effect.condition:
        text = f"(when {_together(map(_condition, effect.condition))} {text})"
    if effect.parameters:
        text = f"(forall ({_typed([(p.name, p.type) for p in effect.parameters])}) {text})"
    return text


def _typed(listed: Sequence[tuple[str, str]]) -> str:
    return " ".join(f"{name} - {kind}" for name, kind in listed)


def _form(*words: str) -> str:
    return f"({' '.join(word for word in words if word)})"


def _section(head: str, lines: Iterable[str]) -> str:
    return f"({head}" + "".join(f"\n    {line}" for line in lines) + ")"


def _together(parts: Iterable[str]) -> str:
    return "(and" + "".join(f"\n      {part}" for part in parts) + ")"

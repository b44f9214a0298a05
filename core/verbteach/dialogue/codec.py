"""Acts and decisions as JSON-ready values and back: ``{"act": name, field: ...}``.

Literals, goals and actions travel as text, goals sorted, so that equal acts
give equal bytes. A value of the wrong shape is refused with a reason.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import fields
from typing import Any, TypeVar, get_args, get_type_hints

from verbteach.dialogue.acts import (
    DemonstrationReason,
    Outcome,
    RobotAct,
    TeacherAct,
)
from verbteach.dialogue.decision import Candidate, Decision
from verbteach.world.fluents import Fluent, Goal, Literal
from verbteach.world.plan import Action

ROBOT_ACTS: Mapping[str, type[RobotAct]] = {kind.name: kind for kind in get_args(RobotAct)}
TEACHER_ACTS: Mapping[str, type[TeacherAct]] = {kind.name: kind for kind in get_args(TeacherAct)}

_Act = TypeVar("_Act")


class ActFormatError(ValueError):
    """A JSON value is not an act; the message says what is wrong with it."""


def goal_to_json(goal: Goal) -> list[str]:
    """The goal's literals as sorted text."""
    return sorted(str(literal) for literal in goal)


def goal_from_json(texts: list[str]) -> Goal:
    """A goal from its literals' text."""
    return frozenset(Literal.parse(text) for text in texts)


def _text(value: Any) -> str:
    if not isinstance(value, str):
        raise ActFormatError(f"expected text, got {type(value).__name__}")
    return value


def _integer(value: Any) -> int:
    if not isinstance(value, int) or isinstance(value, bool):
        raise ActFormatError(f"expected an integer, got {type(value).__name__}")
    return value


def _flag(value: Any) -> bool:
    if not isinstance(value, bool):
        raise ActFormatError(f"expected true or false, got {type(value).__name__}")
    return value


def _texts(value: Any) -> list[str]:
    if not isinstance(value, list):
        raise ActFormatError(f"expected a list, got {type(value).__name__}")
    return [_text(item) for item in value]


def _pair(value: Any) -> tuple[str, str]:
    first, second = _texts(value)
    return first, second


def _pairs(value: Any) -> tuple[tuple[str, str], ...]:
    if not isinstance(value, list):
        raise ActFormatError(f"expected a list of pairs, got {type(value).__name__}")
    return tuple(_pair(item) for item in value)


# How each type of field is written and read.
_FIELDS: Mapping[Any, tuple[Callable[[Any], Any], Callable[[Any], Any]]] = {
    str: (str, _text),
    int: (int, _integer),
    bool: (bool, _flag),
    Fluent: (str, lambda v: Fluent.parse(_text(v))),
    Literal: (str, lambda v: Literal.parse(_text(v))),
    Goal: (goal_to_json, lambda v: goal_from_json(_texts(v))),
    Action: (str, lambda v: Action.parse(_text(v))),
    Action | None: (
        lambda v: None if v is None else str(v),
        lambda v: None if v is None else Action.parse(_text(v)),
    ),
    tuple[Action, ...]: (
        lambda v: [str(a) for a in v],
        lambda v: tuple(Action.parse(t) for t in _texts(v)),
    ),
    tuple[Literal, ...]: (
        lambda v: [str(a) for a in v],
        lambda v: tuple(Literal.parse(t) for t in _texts(v)),
    ),
    tuple[tuple[str, str], ...]: (lambda v: [list(pair) for pair in v], _pairs),
    DemonstrationReason: (lambda v: v.value, lambda v: DemonstrationReason(_text(v))),
    Outcome: (lambda v: v.value, lambda v: Outcome(_text(v))),
}


# Resolving a class's annotations takes longer than all the rest of a conversion.
_HINTS: dict[type[object], dict[str, Any]] = {}


def _hints(kind: type[object]) -> dict[str, Any]:
    if kind not in _HINTS:
        _HINTS[kind] = get_type_hints(kind)
    return _HINTS[kind]


def _encode(act: RobotAct | TeacherAct) -> dict[str, Any]:
    hints = _hints(type(act))
    encoded: dict[str, Any] = {"act": act.name}
    for field in fields(act):
        write, _ = _FIELDS[hints[field.name]]
        encoded[field.name] = write(getattr(act, field.name))
    return encoded


def _decode(kinds: Mapping[str, type[_Act]], value: Any) -> _Act:
    if not isinstance(value, dict) or not isinstance(value.get("act"), str):
        raise ActFormatError("an act is an object with a text field 'act'")
    kind = kinds.get(value["act"])
    if kind is None:
        raise ActFormatError(f"unknown act {value['act']!r}; known: {', '.join(kinds)}")
    hints = _hints(kind)
    names = [field.name for field in fields(kind)]  # type: ignore[arg-type]
    if set(value) != {"act", *names}:
        raise ActFormatError(f"{value['act']} has the fields {names}, got {sorted(value)}")
    try:
        return kind(**{name: _FIELDS[hints[name]][1](value[name]) for name in names})
    except ActFormatError as error:
        raise ActFormatError(f"{value['act']}: {error}") from error
    except ValueError as error:
        raise ActFormatError(f"{value['act']}: {error}") from error


def robot_act_to_json(act: RobotAct) -> dict[str, Any]:
    """A robot act as a JSON-ready value."""
    return _encode(act)


def robot_act_from_json(value: Any) -> RobotAct:
    """A robot act from its JSON value; :class:`ActFormatError` if it is none."""
    return _decode(ROBOT_ACTS, value)


def teacher_act_to_json(act: TeacherAct) -> dict[str, Any]:
    """A teacher act as a JSON-ready value."""
    return _encode(act)


def teacher_act_from_json(value: Any) -> TeacherAct:
    """A teacher act from its JSON value; :class:`ActFormatError` if it is none."""
    return _decode(TEACHER_ACTS, value)


def _candidate_to_json(candidate: Candidate) -> dict[str, Any]:
    return {
        "act": _encode(candidate.act),
        "features": {name: candidate.features[name] for name in sorted(candidate.features)},
        "q": candidate.value,
    }


def decision_to_json(decision: Decision) -> dict[str, Any]:
    """A decision: every candidate with features and Q, the one chosen, its propensity."""
    return {
        "candidates": [_candidate_to_json(candidate) for candidate in decision.candidates],
        "chosen": decision.chosen,
        "propensity": decision.propensity,
        "explored": decision.explored,
        "reason": decision.reason,
        **({"weights": decision.weights} if decision.weights else {}),
    }

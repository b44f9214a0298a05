"""The robot's whole state as plain JSON and back, exactly: for checkpoints, never for the record.

Fields are written by their declared types, so a field that is added to a state
is kept without a word here. Hypothesis spaces, the bulk of what a robot knows,
are written once each and referred to by number.
"""

from __future__ import annotations

import types
from collections.abc import Callable, Mapping
from dataclasses import fields, is_dataclass
from enum import Enum
from functools import cache, lru_cache
from typing import Any, NamedTuple, Union, get_args, get_origin, get_type_hints

from verbteach.dialogue.policy import LearningPolicy
from verbteach.dialogue.state import RobotState
from verbteach.policy.learned_policy import LearnedPolicy
from verbteach.verbs.knowledge import VerbKnowledge
from verbteach.verbs.space import HypothesisSpace
from verbteach.world.fluents import Fluent, Literal
from verbteach.world.plan import Action
from verbteach_sessions.space_pool import SpacePool


class StateFormatError(ValueError):
    """A value is not the JSON of a state, or a state holds what has no JSON."""


class _Codec(NamedTuple):
    """How values of one type are written and read."""

    write: Callable[[Any, SpacePool], Any]
    read: Callable[[Any, SpacePool], Any]


def state_to_plain(state: RobotState, spaces: SpacePool) -> Any:
    """The state as JSON-ready values. Raises :class:`StateFormatError`."""
    return _guarded(_codec(RobotState).write, state, spaces)


def state_from_plain(value: Any, spaces: SpacePool) -> RobotState:
    """Read what :func:`state_to_plain` wrote. Raises :class:`StateFormatError`."""
    state: RobotState = _guarded(_codec(RobotState).read, value, spaces)
    return state


def _guarded(convert: Callable[[Any, SpacePool], Any], value: Any, spaces: SpacePool) -> Any:
    try:
        return convert(value, spaces)
    except StateFormatError:
        raise
    except (LookupError, TypeError, ValueError, AttributeError) as error:
        raise StateFormatError(f"not a robot's state: {error!r}"[:200]) from error


@cache
def _codec(kind: Any) -> _Codec:
    if kind in _SPECIAL:
        return _SPECIAL[kind]
    if get_origin(kind) is not None:
        return _generic(get_origin(kind), get_args(kind))
    if isinstance(kind, type) and issubclass(kind, Enum):
        return _Codec(lambda value, _: value.value, lambda value, _: kind(value))
    if isinstance(kind, type) and (is_dataclass(kind) or hasattr(kind, "_fields")):
        return _record(kind)
    raise StateFormatError(f"there is no JSON for {kind!r}")


def _generic(origin: Any, inner: tuple[Any, ...]) -> _Codec:
    if origin in (Union, types.UnionType):
        return _union(inner)
    if origin is tuple:
        return _tuple(inner)
    if origin is frozenset:
        return _set(inner[0])
    if issubclass(origin, Mapping):
        return _mapping(*inner)
    raise StateFormatError(f"there is no JSON for {origin!r}")


def _scalar(*kinds: type) -> _Codec:
    def checked(value: Any, _: SpacePool) -> Any:
        if type(value) not in kinds:
            raise StateFormatError(f"{value!r} is no {kinds[0].__name__}"[:100])
        return value

    return _Codec(checked, checked)


def _text(parse: Callable[[str], Any]) -> _Codec:
    return _Codec(lambda value, _: str(value), lambda value, _: parse(value))


def _union(inner: tuple[Any, ...]) -> _Codec:
    """A value that may be missing is ``null`` or a list of one; others bear their class's name."""
    members = {one.__name__: _codec(one) for one in inner if one is not types.NoneType}

    def write(value: Any, spaces: SpacePool) -> Any:
        if value is None:
            return None
        name = type(value).__name__ if len(members) > 1 else next(iter(members))
        return [name, members[name].write(value, spaces)]

    def read(value: Any, spaces: SpacePool) -> Any:
        if value is None:
            return None
        name, inside = value
        return members[name].read(inside, spaces)

    return _Codec(write, read)


def _tuple(inner: tuple[Any, ...]) -> _Codec:
    if inner[-1] is Ellipsis:
        one = _codec(inner[0])
        return _Codec(
            lambda value, spaces: [one.write(item, spaces) for item in value],
            lambda value, spaces: tuple([one.read(item, spaces) for item in value]),
        )
    return _row([_codec(kind) for kind in inner], tuple)


def _row(codecs: list[_Codec], make: Callable[[list[Any]], Any]) -> _Codec:
    def write(value: Any, spaces: SpacePool) -> Any:
        return [one.write(item, spaces) for one, item in zip(codecs, value, strict=True)]

    def read(value: Any, spaces: SpacePool) -> Any:
        return make([one.read(item, spaces) for one, item in zip(codecs, value, strict=True)])

    return _Codec(write, read)


def _set(kind: Any) -> _Codec:
    one = _codec(kind)
    return _Codec(
        lambda value, spaces: sorted(one.write(item, spaces) for item in value),
        lambda value, spaces: frozenset([one.read(item, spaces) for item in value]),
    )


def _mapping(key: Any, item: Any) -> _Codec:
    """Pairs, in the mapping's own order; what is plain JSON already stays as it is."""
    if item is Any:
        return _Codec(lambda value, _: dict(value), lambda value, _: dict(value))
    row = _tuple((key, item))
    return _Codec(
        lambda value, spaces: [row.write(pair, spaces) for pair in value.items()],
        lambda value, spaces: dict([row.read(pair, spaces) for pair in value]),
    )


def _record(kind: Any) -> _Codec:
    """A dataclass or named tuple: its fields in order, without those that are no arguments."""
    hints = get_type_hints(kind, localns={"LearningPolicy": LearningPolicy})
    names = [f.name for f in fields(kind) if f.init] if is_dataclass(kind) else kind._fields
    row = _row([_later(hints[name]) for name in names], lambda items: kind(*items))

    def write(value: Any, spaces: SpacePool) -> Any:
        if type(value) is not kind:
            raise StateFormatError(f"{type(value).__name__} stands where {kind.__name__} should")
        return row.write([getattr(value, name) for name in names], spaces)

    return _Codec(write, row.read)


def _later(kind: Any) -> _Codec:
    """The codec of a type, looked up when it is used: types may contain themselves."""
    return _Codec(
        lambda value, spaces: _codec(kind).write(value, spaces),
        lambda value, spaces: _codec(kind).read(value, spaces),
    )


_SPECIAL: Mapping[Any, _Codec] = {
    str: _scalar(str),
    int: _scalar(int),
    bool: _scalar(bool),
    float: _scalar(float, int),
    Fluent: _text(lru_cache(maxsize=4096)(Fluent.parse)),
    Literal: _text(lru_cache(maxsize=4096)(Literal.parse)),
    Action: _text(lru_cache(maxsize=4096)(Action.parse)),
    LearningPolicy: _later(LearnedPolicy),
    HypothesisSpace: _Codec(
        lambda space, spaces: spaces.number(space), lambda number, spaces: spaces[number]
    ),
    VerbKnowledge: _Codec(
        lambda knowledge, spaces: [spaces.number(space) for space in knowledge.spaces],
        lambda numbers, spaces: VerbKnowledge.merged([spaces[number] for number in numbers]),
    ),
}

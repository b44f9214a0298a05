"""Shapes of JSON values: what kinds there are, how they are called, and whether a value is of one.

A shape is an object with named fields, no others allowed, and all of them needed but
those that are optional.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from typing import Any, NamedTuple

# No honest value comes near; more could exhaust the stack of whoever walks it.
MAX_DEPTH = 32


class Kind(NamedTuple):
    """A kind of value. ``problems`` yields what is wrong with one, each with a path into it.

    ``schema`` says the same in JSON Schema's words, but for how deep a value may be.
    ``fits`` says in less time only whether there are none.
    """

    name: str
    problems: Callable[[Any], Iterator[str]]
    schema: Mapping[str, Any]
    fits: Callable[[Any], bool]


class Field(NamedTuple):
    """A member of an object. ``content`` fields of an event enter the session's content hash.

    ``optional`` fields may be missing, as in records older than the field.
    """

    name: str
    kind: Kind
    meaning: str
    content: bool = False
    optional: bool = False


class Shape(NamedTuple):
    """An object: its name in the documentation, what it is, and its fields."""

    name: str
    meaning: str
    fields: tuple[Field, ...]


def wrong_fields(shape: Shape, value: Any) -> Iterator[str]:
    """What is missing, unknown or of the wrong kind in an object."""
    if not isinstance(value, dict):
        yield ": is no object"
        return
    for field in shape.fields:
        if field.name not in value:
            if not field.optional:
                yield f".{field.name}: is missing"
            continue
        for problem in field.kind.problems(value[field.name]):
            yield f".{field.name}{problem}"
    unknown = value.keys() - {field.name for field in shape.fields}
    yield from (f".{name[:40]}: is unknown" for name in sorted(unknown))


def fitting(shape: Shape) -> Callable[[Any], bool]:
    """Whether a value is of a shape, which :func:`wrong_fields` finds nothing wrong with."""
    needed = frozenset(field.name for field in shape.fields if not field.optional)
    fits = {field.name: field.kind.fits for field in shape.fields}

    def of_the_shape(value: Any) -> bool:
        if (
            not isinstance(value, dict)
            or not needed <= value.keys()
            or not value.keys() <= fits.keys()
        ):
            return False
        return all(fits[name](inner) for name, inner in value.items())

    return of_the_shape


def of_shape(shape: Shape) -> Kind:
    """Values of a shape."""
    reference = {"$ref": f"#/$defs/{shape.name}"}
    return Kind(shape.name, lambda value: wrong_fields(shape, value), reference, fitting(shape))


def list_of(kind: Kind) -> Kind:
    """Lists of one kind of value."""

    def problems(value: Any) -> Iterator[str]:
        if not isinstance(value, list):
            yield ": is no list"
            return
        for index, item in enumerate(value):
            yield from (f"[{index}]{problem}" for problem in kind.problems(item))

    schema = {"type": "array", "items": kind.schema}
    fits = kind.fits
    return Kind(
        f"list of {kind.name}",
        problems,
        schema,
        lambda value: isinstance(value, list) and all(map(fits, value)),
    )


def row_of(*kinds: Kind) -> Kind:
    """Lists of a fixed length, each place of its own kind."""

    def problems(value: Any) -> Iterator[str]:
        if not isinstance(value, list) or len(value) != len(kinds):
            yield f": is no list of {len(kinds)}"
            return
        for index, (kind, item) in enumerate(zip(kinds, value, strict=True)):
            yield from (f"[{index}]{problem}" for problem in kind.problems(item))

    size = {"minItems": len(kinds), "maxItems": len(kinds)}
    schema = {"type": "array", "prefixItems": [kind.schema for kind in kinds], **size}
    each = [kind.fits for kind in kinds]

    def fits(value: Any) -> bool:
        return (
            isinstance(value, list)
            and len(value) == len(each)
            and all(fit(item) for fit, item in zip(each, value, strict=True))
        )

    return Kind(f"[{', '.join(kind.name for kind in kinds)}]", problems, schema, fits)


def mapping_of(kind: Kind) -> Kind:
    """Objects with any names, all members of one kind."""

    def problems(value: Any) -> Iterator[str]:
        if not isinstance(value, dict):
            yield ": is no object"
            return
        for name, item in value.items():
            yield from (f".{name[:40]}{problem}" for problem in kind.problems(item))

    schema = {"type": "object", "additionalProperties": kind.schema}
    fits = kind.fits
    return Kind(
        f"object of {kind.name}",
        problems,
        schema,
        lambda value: isinstance(value, dict) and all(map(fits, value.values())),
    )


def or_null(kind: Kind) -> Kind:
    """The kind, or ``null``."""
    schema = {"anyOf": [kind.schema, {"type": "null"}]}
    return Kind(
        f"{kind.name} or null",
        lambda value: iter(()) if value is None else kind.problems(value),
        schema,
        lambda value: value is None or kind.fits(value),
    )


def _plain(name: str, fits: Callable[[Any], bool], *types: str) -> Kind:
    def problems(value: Any) -> Iterator[str]:
        if not fits(value):
            yield f": is no {name}"

    return Kind(name, problems, {"type": types[0] if len(types) == 1 else list(types)}, fits)


def _is_integer(value: Any) -> bool:
    return type(value) is int


def _is_number(value: Any) -> bool:
    return type(value) is int or (type(value) is float and math.isfinite(value))


def _object_problems(value: Any) -> Iterator[str]:
    if type(value) is not dict:
        yield ": is no object"
    elif depth(value) > MAX_DEPTH:
        yield f": is nested deeper than {MAX_DEPTH}"


TEXT = _plain("text", lambda value: type(value) is str, "string")
INTEGER = _plain("integer", _is_integer, "integer")
NUMBER = _plain("number", _is_number, "number")
FLAG = _plain("true or false", lambda value: type(value) is bool, "boolean")
OBJECT = Kind(
    "object",
    _object_problems,
    {"type": "object"},
    lambda value: next(_object_problems(value), None) is None,
)
TEXTS = list_of(TEXT)
ANSWER = _plain(
    "integer, text or null",
    lambda value: type(value) in (int, str, type(None)),
    "integer",
    "string",
    "null",
)


def depth(value: Any) -> int:
    """How deep lists and objects are nested in each other; 0 for a plain value."""
    deepest, level = 0, [value]
    while level := [inner for item in level for inner in _members(item)]:
        deepest += 1
    return deepest


def _members(value: Any) -> Iterator[Any]:
    if isinstance(value, Mapping):
        yield from value.values()
    elif isinstance(value, list):
        yield from value

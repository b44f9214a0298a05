"""Parameter classes as plain JSON and back: an object for each dataclass, its fields by name.

It knows dataclasses of numbers, texts, flags, enumerations, tuples and
mappings. A value of the wrong type is refused with the path of the field.
"""

from __future__ import annotations

import math
import types
from collections.abc import Mapping
from dataclasses import MISSING, Field, fields, is_dataclass
from enum import Enum
from typing import Any, Union, get_args, get_origin, get_type_hints

from verbteach.dialogue.preference import Confirmed
from verbteach.verbs.criteria import PLAIN_CRITERIA, Criterion


class ParameterError(ValueError):
    """A recorded parameter is missing, unknown or of the wrong type."""


def to_plain(value: Any) -> Any:
    """The JSON value of a parameter. An infinite number travels as the text ``inf``."""
    if getattr(value, "name", None) in PLAIN_CRITERIA and value is PLAIN_CRITERIA[value.name]:
        return {"name": value.name}
    if is_dataclass(value):
        return {field.name: to_plain(getattr(value, field.name)) for field in fields(value)}
    if isinstance(value, Enum):
        return value.value
    if isinstance(value, Mapping):
        return {str(key): to_plain(value[key]) for key in sorted(value)}
    if isinstance(value, tuple):
        return [to_plain(item) for item in value]
    return str(value) if isinstance(value, float) and math.isinf(value) else value


def from_plain(kind: Any, value: Any, path: str = "parameters") -> Any:
    """The parameter of type ``kind``. Raises :class:`ParameterError`."""
    try:
        return _read(kind, value, path)
    except (TypeError, ValueError, LookupError) as error:
        if isinstance(error, ParameterError):
            raise
        raise ParameterError(f"{path}: {error}") from error


def _read(kind: Any, value: Any, path: str) -> Any:
    if kind is Criterion:
        return _criterion(value, path)
    if get_origin(kind) is not None:
        return _generic(kind, value, path)
    if is_dataclass(kind):
        return _dataclass(kind, value, path)
    if issubclass(kind, Enum):
        return kind(value)
    return float(value) if kind is float and value == "inf" else _scalar(kind, value, path)


def _generic(kind: Any, value: Any, path: str) -> Any:
    origin, inner = get_origin(kind), get_args(kind)
    if origin in (Union, types.UnionType):
        some = next(one for one in inner if one is not type(None))
        return None if value is None else from_plain(some, value, path)
    if origin is tuple:
        return _tuple(inner, _checked(list, value, path), path)
    items = _checked(dict, value, path).items()
    return {key: from_plain(inner[1], item, f"{path}.{key}") for key, item in items}


def _dataclass(kind: Any, value: Any, path: str) -> Any:
    hints = get_type_hints(kind)
    names = [field.name for field in fields(kind)]
    given = _checked(dict, value, path)
    missing = {field.name for field in fields(kind) if _is_needed(field)}.difference(given)
    if missing or not set(given) <= set(names):
        raise ParameterError(f"{path}: has the fields {sorted(given)}, should have {names}"[:400])
    return kind(**{name: from_plain(hints[name], given[name], f"{path}.{name}") for name in given})


def _is_needed(field: Field[Any]) -> bool:
    """A parameter that came in later is missing in older records, and has its default."""
    return field.default is MISSING and field.default_factory is MISSING


def _criterion(value: Any, path: str) -> Criterion:
    name = _checked(dict, value, path).get("name")
    if name == Confirmed.name:
        confirmed: Criterion = _dataclass(Confirmed, value, path)
        return confirmed
    return PLAIN_CRITERIA[_checked(str, name, f"{path}.name")]


def _tuple(kinds: tuple[Any, ...], items: list[Any], path: str) -> tuple[Any, ...]:
    if kinds[-1] is Ellipsis:
        kinds = (kinds[0],) * len(items)
    if len(kinds) != len(items):
        raise ParameterError(f"{path}: has {len(items)} items, should have {len(kinds)}")
    pairs = enumerate(zip(kinds, items, strict=True))
    return tuple(from_plain(kind, item, f"{path}[{index}]") for index, (kind, item) in pairs)


def _scalar(kind: Any, value: Any, path: str) -> Any:
    if kind is float and isinstance(value, int) and not isinstance(value, bool):
        return float(value)
    if isinstance(value, bool) and kind is not bool:
        raise ParameterError(f"{path}: is no {kind.__name__}")
    return _checked(kind, value, path)


def _checked(kind: Any, value: Any, path: str) -> Any:
    if not isinstance(value, kind):
        raise ParameterError(f"{path}: is no {kind.__name__}")
    return value

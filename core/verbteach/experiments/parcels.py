"""What travels to other processes with many jobs: packed once, and unpacked there once."""

from __future__ import annotations

import pickle
from collections import OrderedDict
from functools import cached_property
from hashlib import sha256
from typing import Any, Generic, TypeVar

_T = TypeVar("_T")
KEPT = 64
"""So many unpacked values are kept in a process, those longest unused given up first."""
_UNPACKED: OrderedDict[bytes, Any] = OrderedDict()


class Parcel(Generic[_T]):
    """A value with its bytes: pickling many jobs that hold it costs little more than copying them.

    Where nothing is pickled it is the value and nothing else.
    """

    def __init__(self, value: _T) -> None:
        self.value = value

    @cached_property
    def _packed(self) -> tuple[bytes, bytes]:
        content = pickle.dumps(self.value, pickle.HIGHEST_PROTOCOL)
        return sha256(content).digest(), content

    def __reduce__(self) -> tuple[Any, ...]:
        """Travel as bytes."""
        return _unpacked, self._packed


def _unpacked(digest: bytes, content: bytes) -> Parcel[Any]:
    """The parcel of these bytes; the same value each time while it is kept."""
    if digest not in _UNPACKED:
        _UNPACKED[digest] = pickle.loads(content)
    _UNPACKED.move_to_end(digest)
    while len(_UNPACKED) > KEPT:
        _UNPACKED.popitem(last=False)
    return Parcel(_UNPACKED[digest])

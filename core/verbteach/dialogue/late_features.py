"""Features of which some are worked out only when somebody reads them.

What an answer would be worth takes longer to find out than all else about a
question, and the rules that ask never look at it.
"""

from __future__ import annotations

from collections.abc import Callable, ItemsView, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property


@dataclass(frozen=True, eq=False)
class LateFeatures(Mapping[str, float]):
    """``ready`` features, and others that ``late`` gives when one of them is asked for."""

    ready: Mapping[str, float]
    late: Callable[[], Mapping[str, float]]

    def __getitem__(self, name: str) -> float:
        found = self.ready.get(name)
        return self._all[name] if found is None else found

    def items(self) -> ItemsView[str, float]:
        """All of them."""
        return self._all.items()

    def __iter__(self) -> Iterator[str]:
        return iter(self._all)

    def __len__(self) -> int:
        return len(self._all)

    @cached_property
    def _all(self) -> dict[str, float]:
        return {**self.ready, **self.late()}

"""What can be wrong with a folder of the corpus: which file, which line, why."""

from __future__ import annotations

from verbteach_scenarios.errors import WorldFileError


class CorpusError(WorldFileError):
    """A folder or file of the corpus does not fit; ``line`` is 0 where the whole is meant."""

"""A folder to learn from and a folder to test on, told apart by what their documents are.

Folders may number their documents alike, and one may lie in the other: what is
tested is never learned, and two documents of one name stay two.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TypeAlias

from verbteach_scenarios.tell_me_dave.documents import Corpus, Document, Step
from verbteach_scenarios.tell_me_dave.errors import CorpusError

TEST_DATA = " (test data)"
"""What stands after the name of what is tested, where two have one name."""

_Recording: TypeAlias = tuple[tuple[tuple[str, tuple[str, ...]], ...], tuple[Step, ...], str]


@dataclass(frozen=True)
class Parting:
    """What is learned and what is tested; ``left_out`` names documents that both folders had."""

    learned: Corpus
    tested: Corpus
    left_out: tuple[str, ...]

    @classmethod
    def of(cls, data: Corpus, test: Corpus) -> Parting:
        """Leave what is tested out of what is learned, and name apart what has one name.

        Raises ``CorpusError`` where nothing is left to learn from.
        """
        recorded = {_recording(document) for document in test.documents}
        learned = tuple(d for d in data.documents if _recording(d) not in recorded)
        if not learned:
            reason = f"every document of {data.folder} is here too: test on what was not learned"
            raise CorpusError(test.folder, 0, reason)
        names = {document.name for document in learned}
        tested = tuple(
            replace(d, name=d.name + TEST_DATA) if d.name in names else d for d in test.documents
        )
        left_out = tuple(d.name for d in data.documents if _recording(d) in recorded)
        return cls(replace(data, documents=learned), replace(test, documents=tested), left_out)


def _recording(document: Document) -> _Recording:
    """What makes two documents the same one, whatever they are called."""
    return tuple(sorted(document.objects.items())), document.steps, document.sentence

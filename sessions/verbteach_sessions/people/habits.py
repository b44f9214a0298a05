"""How one person takes questions: rates by question type, and the words said for each answer."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import NamedTuple, TypeAlias

import numpy as np

from verbteach.dialogue.acts import QUESTIONS, IncludeFluent, SelectHypo

JUDGED: tuple[str, ...] = (SelectHypo.name, IncludeFluent.name)
"""What a person is asked to judge rather than asked: an execution, a goal read back."""

ASKED: tuple[str, ...] = (*(kind.name for kind in QUESTIONS), *JUDGED)
"""Everything that a person answers, by the act's name."""

STAGES = ("first", "later", "late")


def stage(asked: int) -> str:
    """How far a command's questions have come: patience wears out as they go on."""
    return STAGES[0] if asked < 2 else STAGES[1] if asked < 5 else STAGES[2]


class Rates(NamedTuple):
    """One person and one type of question, each a probability.

    ``gives_up``, by stage: passes over the question. Of the rest ``unsure``
    are answered with "I don't know", and ``error`` of what then remains with
    the wrong thing. ``words`` is the share of answers said in words.
    """

    gives_up: tuple[float, float, float] = (0.0, 0.0, 0.0)
    unsure: float = 0.0
    error: float = 0.0
    words: float = 0.0

    def passes(self, asked: int) -> float:
        """The probability of passing over a question that comes after ``asked`` others."""
        return self.gives_up[STAGES.index(stage(asked))]


Phrasings: TypeAlias = tuple[tuple[str, int], ...]
"""Texts with how often each was said, sorted."""


@dataclass(frozen=True)
class Habits:
    """One person: rates by question type, and texts by answer (``yes``, ``no``, ``unsure``)."""

    rates: Mapping[str, Rates] = field(default_factory=dict)
    wording: Mapping[str, Phrasings] = field(default_factory=dict)

    def phrase(self, answer: str, rng: np.random.Generator) -> str:
        """Words for an answer, each as likely as it was said; empty where none ever were."""
        texts = self.wording.get(answer, ())
        if not texts:
            return ""
        shares = np.array([count for _, count in texts], dtype=float)
        return texts[int(rng.choice(len(texts), p=shares / shares.sum()))][0]

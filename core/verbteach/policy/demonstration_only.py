"""The policy of She & Chai (2016): learn from demonstrations, ask no question about the goal.

A person's command can leave open which object is meant; there the robot asks,
and only there. Otherwise it executes the selected hypothesis if it has one and
asks to be shown if not, and keeps a demonstration's goal as it is.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from verbteach.dialogue.acts import (
    IncludeFluent,
    NpGrdWhq,
    NpGrdYnq,
    RequestDemonstration,
    RobotAct,
    SelectHypo,
)
from verbteach.dialogue.decision import Candidate, Decision
from verbteach.dialogue.state import EpisodeState


@dataclass(frozen=True)
class DemonstrationOnlyPolicy:
    """Asks about a noun phrase when its likeliest object leads by less than ``clear_margin``.

    ``clear_margin`` is a difference of probabilities, in [0, 1]. With
    ``ask_references`` off the robot asks nothing at all, as in the paper.
    """

    clear_margin: float = 0.2
    ask_references: bool = True
    name: str = "she16"
    asks: ClassVar[bool] = False

    def choose(
        self, episode: EpisodeState, candidates: Sequence[Candidate], rng: np.random.Generator
    ) -> Decision:
        """The first unclear reference, else the hypothesis, else a demonstration."""
        for kind in (NpGrdYnq, NpGrdWhq, SelectHypo, IncludeFluent, RequestDemonstration):
            for index, candidate in enumerate(candidates):
                if isinstance(candidate.act, kind) and self._wanted(candidate):
                    return Decision(tuple(candidates), index, reason=_REASONS[kind])
        return Decision(tuple(candidates), len(candidates) - 1, reason="nothing else is left")

    def _wanted(self, candidate: Candidate) -> bool:
        if isinstance(candidate.act, NpGrdWhq):
            return self.ask_references and candidate.features["margin"] < self.clear_margin
        if isinstance(candidate.act, NpGrdYnq):
            return self.ask_references and candidate.features["guessed"] > 0
        return True


_REASONS: dict[type[RobotAct], str] = {
    NpGrdYnq: "the word is not one I know, and this may be what it means",
    NpGrdWhq: "more than one thing, or nothing I know, fits these words",
    SelectHypo: "this goal is the most wanted of those I know for the verb",
    IncludeFluent: "this is the smallest part of what changed that asks for the same actions",
    RequestDemonstration: "I know no goal for the verb that I can reach from here",
}

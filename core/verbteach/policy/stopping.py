"""A stop rule that can promise: execute only where calibration says that it is right often enough.

Commands of a calibration set are scored by how sure the robot was when it
executed and whether the execution was right. Cutting at a score keeps those
above it; the cut is the lowest for which the share of wrong executions, with
one wrong one more for the command to come, stays within what was asked for.
With exchangeable commands the expected share of commands that are executed
wrongly is then at most ``1 - wanted`` (conformal risk control, Angelopoulos et
al. 2022; the loss, executed and wrong, falls as the cut rises).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from verbteach.dialogue.acts import SelectHypo
from verbteach.dialogue.decision import Candidate, Decision
from verbteach.policy.asking_policy import AskingPolicy, questions


@dataclass(frozen=True)
class Cut:
    """Execute at ``certainty`` or above; infinite where nothing can be promised."""

    certainty: float
    wanted: float
    calibrated_on: int


def calibrate(scores: Sequence[float], right: Sequence[bool], wanted: float) -> Cut:
    """The lowest cut that keeps the promise. Raises ``ValueError`` unless 0 < wanted < 1."""
    if not 0.0 < wanted < 1.0:
        raise ValueError(f"a success rate is between 0 and 1, not {wanted}")
    pairs = sorted(zip(scores, right, strict=True), key=lambda pair: -pair[0])
    allowed = (1.0 - wanted) * (len(pairs) + 1)
    cut, wrong, position = math.inf, 0, 0
    while position < len(pairs):
        score = pairs[position][0]
        while position < len(pairs) and pairs[position][0] == score:
            wrong += not pairs[position][1]
            position += 1
        if wrong + 1 > allowed:
            break
        cut = score
    return Cut(cut, wanted, len(pairs))


@dataclass(frozen=True)
class PromisingPolicy:
    """Asks on, by another policy's order, while it is less certain than the cut.

    Where no question is left it executes as it must; whether it kept the
    promise is then for the caller to see (``promised``).
    """

    asking: AskingPolicy
    cut: Cut
    name: str = "promising"

    def choose(
        self, episode: object, candidates: Sequence[Candidate], rng: np.random.Generator
    ) -> Decision:
        """Execute if certain enough, else ask what the other policy finds best to ask."""
        left = questions(candidates)
        if promised(candidates, self.cut) or not left:
            return Decision(tuple(candidates), len(candidates) - 1, reason="certain enough")
        asked = self.asking.choose(episode, [candidates[i] for i in left], rng)
        return Decision(tuple(candidates), left[asked.chosen], reason="not certain enough")


def promised(candidates: Sequence[Candidate], cut: Cut) -> bool:
    """Whether executing now is covered by the promise."""
    last = candidates[-1]
    if not isinstance(last.act, SelectHypo):
        return False
    return last.features["select_hypo.certainty"] >= cut.certainty

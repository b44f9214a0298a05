"""What both phases of asking share: a reply, the acts still open, and how answers settle a phrase.

An inquiry is a phase's state as an immutable value: it proposes candidate acts
with named features and takes replies in. Live dialogue, experiments and
training all use it. It does not know who answers or how an act is chosen.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from enum import Enum
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from verbteach.dialogue.acts import NpGrdWhq, NpGrdYnq, RobotAct
from verbteach.dialogue.decision import Candidate
from verbteach.dialogue.grounding import GroundingBelief


class Label(Enum):
    """What an answer comes to; ``OBJECTS`` answers a wh-question."""

    YES = "yes"
    NO = "no"
    UNSURE = "unsure"
    OBJECTS = "objects"


class Reply(NamedTuple):
    """An answer as understood."""

    label: Label
    objects: tuple[str, ...] = ()

    @property
    def positive(self) -> bool:
        """Whether it counts as a yes when the question is priced."""
        return self.label in {Label.YES, Label.OBJECTS}

    @classmethod
    def of(cls, truth: bool) -> Reply:
        """Yes or no."""
        return cls(Label.YES if truth else Label.NO)


@dataclass(frozen=True)
class InquiryParameters:
    """How many acts of each kind are candidates at a step, the best few.

    ``goal_questions`` and ``environment_questions`` in execution,
    ``change_questions`` in learning, ``object_questions`` for each noun
    phrase. Fluents less doubtful than ``environment_doubt`` and literals less
    doubtful than ``doubt`` (the lesser of p and 1 - p) are never asked about.
    In execution an object is asked about only where the answer raises the
    expected Jaccard index by ``object_gain`` or more: below that the question
    cost as much as one about the goal and brought less. ``cap`` ends the
    questions of a phase.
    ``trust`` is how likely the robot takes a yes or no to be right: below 1 an
    answer makes things likelier and settles nothing. A plan relies on nothing
    believed with less than the confidence ``caution`` where a way that is
    hardly longer does without; 0 for eyes that see only what is there.
    ``goal_relevance`` adds the act that the paper's Table 2 lacks.
    """

    goal_questions: int = 5
    environment_questions: int = 1
    change_questions: int = 4
    object_questions: int = 1
    object_gain: float = 0.1
    doubt: float = 0.02
    environment_doubt: float = 0.3
    cap: int = 12
    trust: float = 1.0
    caution: float = 0.0
    goal_relevance: bool = False


def grounding_questions(
    grounding: GroundingBelief, asked: Sequence[RobotAct], most: int
) -> Iterator[tuple[RobotAct, dict[str, float]]]:
    """Table 2's acts 1 and 2 with Table 3's features, for phrases that are not settled."""
    for phrase in grounding.names:
        objects = grounding[phrase]
        if phrase in grounding.settled or len(objects) < 2:
            continue
        which = NpGrdWhq(phrase)
        if which not in asked:
            yield which, which_features(grounding, phrase)
        for thing, chance in objects[:most]:
            question = NpGrdYnq(phrase, thing)
            if question not in asked:
                yield question, {"np_grd_ynq": 1.0, "np_grd_ynq.probability": chance}


def which_features(grounding: GroundingBelief, phrase: str) -> dict[str, float]:
    """Table 3: the entropy (nats) of the phrase's candidates, and whether there are more than 4."""
    return {
        "np_grd_whq": 1.0,
        "np_grd_whq.entropy": grounding.entropy(phrase),
        "np_grd_whq.many": float(len(grounding[phrase]) > 4),
    }


def settle(
    grounding: GroundingBelief, act: NpGrdWhq | NpGrdYnq, reply: Reply, trust: float = 1.0
) -> GroundingBelief:
    """The grounding after a reply: a yes makes a probability 1, a no 0 (section 4.3).

    A wh-question may be answered with several objects, each of which is right.
    A yes or no that is right with the probability ``trust`` only shifts probabilities.
    """
    if reply.label is Label.OBJECTS and reply.objects:
        settled = grounding.restrict(act.np, dict.fromkeys(reply.objects, 1.0))
        return GroundingBelief(settled.phrases, settled.settled | {act.np})
    if isinstance(act, NpGrdWhq):
        return grounding
    if trust < 1.0 and reply.label in {Label.YES, Label.NO}:
        return shifted(grounding, act.np, act.object, trust if reply.positive else 1.0 - trust)
    if reply.label is Label.YES:
        return grounding.confirm(act.np, act.object)
    if reply.label is Label.NO and len(grounding[act.np]) > 1:
        return grounding.deny(act.np, act.object)
    return grounding


def shifted(grounding: GroundingBelief, phrase: str, thing: str, right: float) -> GroundingBelief:
    """The grounding after an answer that is ``right`` likely where the phrase means the thing."""
    weights = {o: p * (right if o == thing else 1.0 - right) for o, p in grounding[phrase]}
    moved = grounding.restrict(phrase, weights)
    return GroundingBelief(moved.phrases, grounding.settled)


def joint_chances(
    grounding: GroundingBelief, groundings: Sequence[tuple[str, ...]]
) -> NDArray[np.float64]:
    """The probability of each joint grounding, phrases taken for independent; uniform if all 0."""
    tables = [dict(grounding[phrase]) for phrase in grounding.names]
    chances = np.ones(len(groundings))
    for place, table in enumerate(tables):
        chances *= [table.get(objects[place], 0.0) for objects in groundings]
    total = chances.sum()
    return chances / total if total > 0 else np.full(len(groundings), 1.0 / len(groundings))


def doubt(probability: float) -> float:
    """1 at one half, 0 when settled."""
    return 1.0 - abs(2.0 * probability - 1.0)


def candidates(
    proposed: Iterable[tuple[RobotAct, dict[str, float]]], asking: dict[str, float]
) -> list[Candidate]:
    """Candidates of questions; ``asking`` are features that every question has."""
    return [Candidate(act, {**features, **asking}) for act, features in proposed]

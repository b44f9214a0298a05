"""The parameters of a robot that is taught, as data: the paper's values are the defaults."""

from __future__ import annotations

from dataclasses import dataclass, field

from verbteach.dialogue.inquiry import InquiryParameters
from verbteach.dialogue.preference import Confirmed
from verbteach.dialogue.rewards import Rewards
from verbteach.perception.noise import NoiseModel
from verbteach.verbs.application import ApplicationParameters
from verbteach.verbs.hypothesis import LearningParameters
from verbteach.verbs.pool import PoolParameters
from verbteach.verbs.selection import SelectionParameters


def _live_selection() -> SelectionParameters:
    # A person's rooms differ in what they hold, so missing things are replaced by others alike.
    return SelectionParameters(
        criterion=Confirmed(), application=ApplicationParameters(replace_missing=4), planned=12
    )


@dataclass(frozen=True)
class RobotParameters:
    """How a robot perceives, learns, chooses and asks.

    ``selection`` serves the policy that asks nothing about goals, ``pool`` and
    ``inquiry`` those that do. ``question_cap`` is the most questions about
    unclear words for one command; past it the robot acts on what it believes.
    ``same_question`` bounds how often one question is put again after an
    answer that could not be read.
    """

    seed: int = 0
    noise: NoiseModel = field(default_factory=NoiseModel)
    rewards: Rewards = field(default_factory=Rewards)
    learning: LearningParameters = field(default_factory=LearningParameters)
    selection: SelectionParameters = field(default_factory=_live_selection)
    pool: PoolParameters = field(default_factory=PoolParameters)
    inquiry: InquiryParameters = field(
        # What words mean is asked sooner than in experiments: a person expects that.
        default_factory=lambda: InquiryParameters(goal_relevance=True, object_gain=0.03)
    )
    question_cap: int = 12
    same_question: int = 3

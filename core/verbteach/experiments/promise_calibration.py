"""Calibrating promises: live sessions in rooms that nothing was trained on, command by command.

Split by whole environments: the weights and the sureness come from the lessons
of some rooms, the courses (``policy/courses.py``) from those of the others.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

from verbteach.dialogue.lesson import Lesson
from verbteach.dialogue.parameters import RobotParameters
from verbteach.dialogue.policy import Policy
from verbteach.dialogue.promise import Sureness
from verbteach.dialogue.simulated import seeded_order
from verbteach.experiments.live_courses import live_courses
from verbteach.experiments.live_practice import Classroom
from verbteach.experiments.sight import stream
from verbteach.perception.noise import NoiseModel
from verbteach.policy.calibration import Calibration, Calibrations
from verbteach.policy.fixed_rules import ManualPolicy, SplitPolicy
from verbteach.policy.learned_policy import LearnedPolicy
from verbteach.policy.weights_file import PolicyWeights


@dataclass(frozen=True)
class CalibrationPlan:
    """What is calibrated: every policy at every noise level, on ``lessons`` given in one session.

    At most all lessons there are, each once. ``share`` of the environments is
    set apart for it.
    """

    policies: tuple[str, ...] = ("rl", "manual", "split")
    noises: tuple[str, ...] = ("perfect", "std3")
    reading: str = "literal"
    lessons: int = 400
    share: float = 1 / 3
    seed: int = 0

    def set_apart(self, lessons: Sequence[Lesson]) -> frozenset[str]:
        """The scenes kept for calibrating, drawn by the seed; none where there is only one."""
        scenes = sorted({lesson.scene for lesson in lessons})
        count = round(self.share * len(scenes)) if self.lessons else 0
        order = stream(self.seed, "calibration").permutation(len(scenes)).tolist()
        return frozenset(scenes[i] for i in order[: min(count, len(scenes) - 1)])


def calibrated(
    weights: PolicyWeights,
    sureness: Sureness,
    room: Classroom,
    plan: CalibrationPlan,
    heard: Callable[[int, int], None] = lambda done, total: None,
) -> Calibrations:
    """Calibrate on the room's lessons, which the weights have not met.

    ``heard`` is told how many lessons of how many have been given. Raises
    ``ValueError`` for a policy that cannot be held to a promise.
    """
    policies = _policies(weights, plan)
    lessons = seeded_order(room.lessons, min(plan.lessons, len(room.lessons)), plan.seed)
    total = len(lessons) * len(policies) * len(plan.noises)
    each: list[Calibration] = []
    for name, policy in policies.items():
        for noise in plan.noises:
            before = len(lessons) * len(each)
            courses = live_courses(
                policy,
                sureness,
                RobotParameters(seed=plan.seed, noise=NoiseModel.named(noise, plan.reading)),
                Classroom(lessons, room.settings, room.human),
                _counting(heard, before, total),
            )
            found = tuple(course for _, course in courses)
            scenes = tuple(sorted({lesson.scene for lesson in lessons}))
            each.append(Calibration(name, noise, plan.reading, scenes, found))
    return Calibrations(sureness, tuple(each))


def _counting(heard: Callable[[int, int], None], before: int, total: int) -> Callable[[int], None]:
    return lambda given: heard(before + given, total)


def _policies(weights: PolicyWeights, plan: CalibrationPlan) -> Mapping[str, Policy]:
    known: Mapping[str, Callable[[], Policy]] = {
        "rl": lambda: LearnedPolicy.beginning(weights),
        "manual": ManualPolicy,
        "split": SplitPolicy,
    }
    for name in plan.policies:
        if name not in known:
            raise ValueError(f"{name} cannot be held to a promise; there are {', '.join(known)}")
    return {name: known[name]() for name in plan.policies}

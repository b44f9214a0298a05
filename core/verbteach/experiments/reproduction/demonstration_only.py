"""She16 in the protocol of the policies that ask: the same lessons, test commands and draws.

It asks nothing, and keeps every demonstration: nobody is asked whether it is right.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from verbteach.collecting import without_collecting
from verbteach.experiments.evaluation import Grounds, run_trials
from verbteach.experiments.folds import Fold
from verbteach.experiments.instance_split import InstanceSplit
from verbteach.experiments.interactive_protocol import Config
from verbteach.experiments.interactive_results import Checkpoint, Result, Taught, Tested
from verbteach.experiments.jobs import Setup, Trial
from verbteach.experiments.polling import Lesson, School
from verbteach.experiments.she16 import VARIANTS
from verbteach.experiments.sight import Sight
from verbteach.perception.noise import NoiseModel
from verbteach.verbs.instance import Instance


@dataclass(frozen=True)
class _Cut(Grounds):
    """Folds over part of the instances; what is true elsewhere is known of ``whole``.

    So that the noise is the same as for those who work on all of them.
    """

    whole: tuple[Instance, ...] = ()

    @property
    def instances(self) -> tuple[Instance, ...]:
        """Every instance, learned from or not."""
        return self.whole


def demonstration_only(
    instances: Sequence[Instance],
    grounds: Grounds,
    config: Config,
    setup: Setup,
    sight: Sight,
    known: dict[str, Lesson],
) -> Result:
    """Carry out one configuration with the learner of ``setup``, which sees through ``sight``.

    ``grounds`` has the tasks and the planner; its folds are not used. ``known``
    are lessons of the same learner with the same eyes, by instance; those that
    are learned now are added: a demonstration teaches the same among however many.
    """
    split, school = InstanceSplit.of(instances, config), School()

    def tested(share: float) -> tuple[int, tuple[Tested, ...]]:
        lessons = split.lessons(share)
        folds = tuple(_folds(instances, lessons, config))
        cut = _Cut(folds, grounds.tasks, grounds.planner, tuple(instances))
        trials = run_trials(cut, setup, config.run, known=known, sight=sight, school=school)
        return len(lessons), tuple(_tested(one, config) for one in trials)

    with without_collecting():
        lessons, rows = tested(config.verb_share)
        checkpoints = tuple(Checkpoint(*tested(share)) for share in config.checkpoints)
    return Result(rows, Taught(lessons, lessons, {}), {}, checkpoints)


def setup_of(config: Config) -> Setup:
    """The learner that the configuration names. Raises ``KeyError`` for another policy."""
    noise = NoiseModel.named(config.noise, config.reading)
    return Setup(VARIANTS[config.policy], noise, seed=config.seed)


def _folds(
    instances: Sequence[Instance], lessons: Sequence[Instance], config: Config
) -> Iterator[Fold]:
    """What is tested, with what may be learned from for it."""
    wanted = config.held_out or tuple(sorted({i.environment for i in instances}))
    for names in [wanted] if config.together else [(name,) for name in wanted]:
        taught = tuple(i for i in lessons if i.environment not in names)
        yield Fold(" ".join(names), taught, tuple(i for i in instances if i.environment in names))


def _tested(trial: Trial, config: Config) -> Tested:
    ied, sji = trial.score
    right = sji >= config.human.right_from
    return Tested(trial.instance, trial.group, ied, sji, right, 0.0, 0.0, {})

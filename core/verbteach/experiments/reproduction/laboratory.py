"""Where tasks are carried out: the instances, their rooms, and how noun phrases are grounded."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from hashlib import sha256

from verbteach.experiments.evaluation import Grounds
from verbteach.experiments.groundings import Grounder
from verbteach.experiments.instance_split import InstanceSplit
from verbteach.experiments.interactive_bench import Bench
from verbteach.experiments.interactive_protocol import Config, run
from verbteach.experiments.polling import Lesson
from verbteach.experiments.reproduction.demonstration_only import demonstration_only, setup_of
from verbteach.experiments.reproduction.design import DEMONSTRATION_ONLY, PERFECT, Design
from verbteach.experiments.reproduction.rows import Row, row_of
from verbteach.experiments.reproduction.task import Task
from verbteach.verbs.instance import Instance


@dataclass(frozen=True)
class Laboratory:
    """A bench, and the same instances' tasks for learners from demonstrations alone.

    ``grounding`` names the mode for both; ``grounder`` does it where the mode
    is the robot's own. ``apart`` are the environments of test data.
    """

    bench: Bench
    grounds: Grounds
    grounding: str = "corpus"
    grounder: Grounder | None = None
    apart: tuple[str, ...] = ()
    _lessons: dict[str, dict[str, Lesson]] = field(
        default_factory=dict, init=False, repr=False, compare=False
    )

    @property
    def environments(self) -> tuple[str, ...]:
        """The environments that may be held out, sorted."""
        found = {i.environment for i in self.bench.instances}
        return tuple(sorted(found.difference(self.apart)))

    def check(self, design: Design) -> None:
        """Raise ``ValueError`` unless every run has something to practise, to learn and to test."""
        for task in design.sections()["main"]:
            split = InstanceSplit.of(self.bench.instances, task.config)
            shares = (task.config.verb_share, *task.config.checkpoints)
            if not split.practice or not all(split.lessons(share) for share in shares):
                count = len(self.bench.instances)
                raise ValueError(f"{count} instances are too few to learn from and to test")

    def row(self, task: Task) -> Row:
        """Carry a task out; the same task gives the same row."""
        config = task.config
        if config.policy not in DEMONSTRATION_ONLY:
            return row_of(task, run(self.bench, config))
        setup = replace(setup_of(config), grounding=self.grounding, grounder=self.grounder)
        sight = self.bench.sight(setup.noise, config.seed, config.run).unruled
        known = self._known(config)
        result = demonstration_only(self.bench.instances, self.grounds, config, setup, sight, known)
        return row_of(task, result)

    def _known(self, config: Config) -> dict[str, Lesson]:
        """What a learner from demonstrations alone knows: eyes that see all saw the same before."""
        return self._lessons.setdefault(config.policy, {}) if config.noise == PERFECT else {}


def fingerprint(instances: Sequence[Instance]) -> str:
    """A short hash of everything about the instances that a row may hang on."""
    made = sha256()
    for one in sorted(instances, key=lambda i: i.id):
        names = (one.id, one.group, one.environment, one.verb, one.phrases, one.candidates)
        world = (sorted(map(str, one.start)), sorted(map(str, one.end)), [*map(str, one.actions)])
        goal = None if one.goal is None else sorted(map(str, one.goal))
        made.update(repr((names, world, goal)).encode())
    return made.hexdigest()[:16]

"""Examining a robot as it is: the verbs it knows and the way it asks, on commands it has not met.

Nothing is learned on the way. Each command gets one execution phase with
questions and one execution, which is not judged to the robot: the test half of
the interactive protocol.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

from verbteach.experiments.carrying_out import carry_out
from verbteach.experiments.interactive import hold
from verbteach.experiments.interactive_bench import Bench
from verbteach.experiments.interactive_results import Tested
from verbteach.experiments.interactive_training import TrainingParameters
from verbteach.experiments.sight import Sight, stream
from verbteach.experiments.simulated_human import HumanParameters, SimulatedHuman
from verbteach.perception.noise import NoiseModel
from verbteach.policy.asking_policy import AskingPolicy
from verbteach.verbs.examples import Memory
from verbteach.verbs.instance import Instance


@dataclass(frozen=True)
class Pupil:
    """What is examined: what it remembers of demonstrations, and how it asks."""

    memory: Memory
    policy: AskingPolicy


@dataclass(frozen=True)
class Examination:
    """On which commands, with which eyes and which human. ``run`` tells the noise's draws apart."""

    bench: Bench
    commands: Sequence[Instance]
    noise: NoiseModel
    seed: int = 0
    human: HumanParameters = field(default_factory=HumanParameters)

    def held(
        self, pupil: Pupil, run: int = 0, heard: Callable[[int], None] | None = None
    ) -> tuple[Tested, ...]:
        """Every command once, in order; ``heard`` is told how many are done."""
        sight = Sight.of(self.noise, self.bench.instances, self.seed, run)
        rows = []
        for instance in self.commands:
            rows.append(self._tested(instance, pupil, sight, run))
            if heard is not None:
                heard(len(rows))
        return tuple(rows)

    def _tested(self, instance: Instance, pupil: Pupil, sight: Sight, run: int) -> Tested:
        human = SimulatedHuman(instance, self.bench.room(instance), self.human)
        start = self.bench.command(instance, sight, pupil.memory)
        rng = stream(self.seed, run, "examination", instance.id)
        held = hold(start, pupil.policy, human, TrainingParameters().rewards, rng)
        carried = carry_out(held.state, human, self.bench.gold(instance))
        pool = held.state.pool
        return Tested(
            instance=instance.id,
            group=instance.group,
            ied=carried.ied,
            sji=carried.sji,
            right=carried.sji >= self.human.right_from,
            expected=0.0 if pool.empty else float(pool.decision.values.max()),
            certainty=0.0 if pool.empty else pool.certainty,
            questions=dict(sorted(held.questions.items())),
        )

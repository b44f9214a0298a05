"""Which instances teach the policy and which teach verbs: the same for every learner of a run.

She & Chai (2017), section 5.1: 200 of 979 instances teach the policy, 600 the
verbs, the rest are tested. Where there are fewer, the shares stay.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from verbteach.experiments.sight import stream
from verbteach.verbs.instance import Instance

if TYPE_CHECKING:
    from verbteach.experiments.interactive_protocol import Config


@dataclass(frozen=True)
class InstanceSplit:
    """Instances to learn from, in a drawn order: the first ``practice`` teach the policy."""

    instances: tuple[Instance, ...]
    order: tuple[int, ...]
    first: int

    @classmethod
    def of(cls, instances: Sequence[Instance], config: Config) -> InstanceSplit:
        """Split what is not held out altogether, as drawn for the run."""
        away = config.held_out if config.together else ()
        found = tuple(i for i in instances if i.environment not in away)
        drawn = stream(config.seed, config.run, "parts").permutation(len(found)).tolist()
        return cls(found, tuple(drawn), round(config.policy_share * len(found)))

    @property
    def practice(self) -> list[Instance]:
        """Those that teach the policy, in the instances' order."""
        return [self.instances[i] for i in sorted(self.order[: self.first])]

    def lessons(self, share: float = 1.0) -> list[Instance]:
        """A share of those that teach verbs; a smaller share is part of a larger one."""
        last = self.first + round(share * (len(self.order) - self.first))
        return [self.instances[i] for i in sorted(self.order[self.first : last])]

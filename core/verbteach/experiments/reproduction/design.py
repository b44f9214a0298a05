"""Which runs a reproduction has: policies, noise levels, held-out environments, and what for.

Every policy of a run meets the same lessons, the same test commands and the
same draws of the noise.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import TypeAlias

import numpy as np

from verbteach.experiments.interactive_protocol import Config
from verbteach.experiments.reproduction.task import Task
from verbteach.experiments.sight import stream

POLICIES = ("rl", "manual", "random", "split", "she16", "she16-all")
DEMONSTRATION_ONLY = ("she16", "she16-all")
LEARNED = "rl"
MATCHED = ("split", "manual", "random")
"""The rules that are also compared at the mean number of questions of the learned policy."""
NOISES = ("perfect", "std3", "std5", "uniform")
PERFECT = "perfect"
STUDIED = "std3"
"""The noise level of Table 5 and Figure 5."""
CHECKPOINTS = (0.1, 0.25, 0.5, 0.75)
"""Shares of the lessons at which Figure 5 has a point, beside the whole."""
TARGETS = ("table4", "table5", "figure5")
EXTRAS = ("phantom", "harder-teacher", "paper-prices")

Sections: TypeAlias = dict[str, list[Task]]
"""Tasks by what their rows are for; a task may serve several purposes."""


@dataclass(frozen=True)
class Design:
    """What to reproduce.

    ``environments`` are those of the data; ``apart`` those of the test data,
    if any: then every run tests them and learns from all others. Else
    ``folds`` is ``groups`` (each run holds a group of environments out, and in
    ``groups`` runs each has had its turn) or ``all`` (each run holds every
    environment out in turn). ``extras`` are reported beside: the harder
    reading of the noise, and a teacher of whose yes/no answers the share
    ``error`` is wrong, first taken at their word, then with ``trust``, and so
    once more with questions at the paper's prices.
    """

    environments: tuple[str, ...]
    targets: tuple[str, ...] = TARGETS
    runs: int = 20
    seed: int = 0
    reading: str = "literal"
    folds: str = "groups"
    groups: int = 5
    apart: tuple[str, ...] = ()
    extras: tuple[str, ...] = ()
    about: Mapping[str, str] = field(default_factory=dict)
    error: float = 0.2
    trust: float = 0.8
    base: Config = field(default_factory=Config)

    def __post_init__(self) -> None:
        if not self.apart and len(self.environments) < 2:
            raise ValueError("whole environments are held out, and there is only one")

    def sections(self) -> Sections:
        """The tasks, run by run so that a sweep broken off has whole runs."""
        found: Sections = {"main": list(self._main())}
        if "phantom" in self.extras:
            phantom = replace(self.base, reading="phantom")
            found["phantom"] = self._beside(phantom, ("rl", "manual", "split", "she16"), NOISES)
        if "harder-teacher" in self.extras:
            found |= self._harder()
        if "paper-prices" in self.extras:
            found["paper_prices"] = self._beside(self._at_paper_prices, ("rl",), NOISES)
        return found

    def _harder(self) -> Sections:
        erring = replace(self._plain, human=replace(self.base.human, error=self.error))
        doubted = replace(erring, trust=self.trust)
        cheaper = replace(self._at_paper_prices, human=erring.human, trust=self.trust)
        three = ("rl", "manual", "split")
        return {
            "harder_teacher": self._beside(erring, three, (STUDIED,)),
            "harder_teacher_doubted": self._beside(doubted, three, (STUDIED,)),
            "harder_teacher_paper_prices": self._beside(cheaper, ("rl",), (STUDIED,)),
        }

    def _beside(self, config: Config, policies: Sequence[str], noises: Sequence[str]) -> list[Task]:
        return [
            self._task(run, policy, noise, config)
            for run, noise, policy in self._cells(policies, noises)
        ]

    @property
    def _at_paper_prices(self) -> Config:
        return replace(self._plain, training=replace(self.base.training, price=1.0))

    @property
    def _plain(self) -> Config:
        return replace(self.base, reading=self.reading)

    def _main(self) -> Iterator[Task]:
        noises = NOISES if "table4" in self.targets else (STUDIED,)
        for run, noise, policy in self._cells(POLICIES, noises):
            yield self._task(run, policy, noise)

    def _cells(
        self, policies: Sequence[str], noises: Sequence[str]
    ) -> Iterator[tuple[int, str, str]]:
        return (
            (run, noise, policy)
            for run in range(self.runs)
            for noise in noises
            for policy in policies
        )

    def _task(
        self,
        run: int,
        policy: str,
        noise: str,
        other: Config | None = None,
    ) -> Task:
        """A task, ``other`` than the main ones where that is given."""
        base = self._plain if other is None else other
        drawn = other is None and "figure5" in self.targets and noise == STUDIED
        config = replace(
            base,
            policy=policy,
            noise=noise,
            # Perfect eyes see no phantoms: one row serves both readings.
            reading="literal" if noise == PERFECT else base.reading,
            seed=self.seed,
            run=run,
            held_out=self.held_out(run),
            together=bool(self.apart) or self.folds == "groups",
            checkpoints=CHECKPOINTS if drawn else (),
            trace=policy in MATCHED or (policy == LEARNED and noise == STUDIED),
        )
        return Task(config, self.about)

    def held_out(self, run: int) -> tuple[str, ...]:
        """The environments that a run tests; none stands for each in turn."""
        if self.apart:
            return self.apart
        if self.folds == "all":
            return ()
        groups = min(self.groups, len(self.environments))
        cycle, turn = divmod(run, groups)
        order = stream(self.seed, cycle, "held out").permutation(len(self.environments))
        part = np.array_split(order, groups)[turn]
        return tuple(self.environments[i] for i in sorted(part.tolist()))

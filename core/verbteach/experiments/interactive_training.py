"""Learning to ask: dialogues with simulated humans, and a learner that is told of each step.

Dialogues begin in the given situations over and over, in a newly seeded order
each round (She & Chai 2017, section 5.1: an instance may be used many times).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Generic

import numpy as np
from numpy.typing import NDArray

from verbteach.dialogue.acts import RobotAct
from verbteach.dialogue.decision import Candidate
from verbteach.dialogue.inquiry import Reply
from verbteach.dialogue.rewards import Rewards
from verbteach.experiments.interactive import Dialogue, Phase, hold, judged
from verbteach.experiments.simulated_human import SimulatedHuman
from verbteach.policy.asking_policy import AskingPolicy
from verbteach.policy.fixed_rules import ManualPolicy, RandomPolicy
from verbteach.policy.learners import (
    REWARD_SCALE,
    BayesianTD,
    Learner,
    Sarsa,
    Step,
    TrueOnlineSarsa,
    lspi,
)
from verbteach.policy.linear import FeatureSpace, LinearPolicy, Weights

Floats = NDArray[np.float64]

LEARNERS: Mapping[str, Callable[[int, float], Learner]] = {
    "sarsa": Sarsa,
    "true-online": TrueOnlineSarsa,
    "bayesian": BayesianTD,
}
"""Learners by name; ``lspi`` refits what ``bayesian`` has logged."""


@dataclass(frozen=True)
class TrainingParameters:
    """How a policy is learned.

    ``dialogues`` in all, the first ``warm`` of them led by ManualPolicy and
    RandomPolicy in turn. ``epsilon`` is the exploration afterwards. ``price``
    multiplies what questions cost against the reward of success; 1 is the
    paper's. ``graded``: success in execution earns its share (the SJI) of the
    reward; without it all or nothing, as in the paper. ``levels`` gives each
    situation a level of its own when refitting, which was found no better. The
    values were chosen on every second environment of the shared corpus.
    """

    learner: str = "lspi"
    dialogues: int = 600
    warm: int = 250
    epsilon: float = 0.3
    gamma: float = 0.99
    price: float = 3.5
    graded: bool = True
    levels: bool = False
    rewards: Rewards = field(default_factory=Rewards)

    @property
    def priced(self) -> Rewards:
        """The rewards with dearer or cheaper questions."""
        final = ("select_hypo", "include_fluent")
        return Rewards(
            {
                name: pair if name in final else (pair[0] * self.price, pair[1] * self.price)
                for name, pair in self.rewards.prices.items()
            }
        )


@dataclass(frozen=True)
class Practice(Generic[Phase]):
    """A situation to practise on: how it begins, who answers, and how right (0 to 1) it was."""

    start: Phase
    human: SimulatedHuman
    right: Callable[[Dialogue[Phase]], float]


@dataclass(frozen=True)
class Trained:
    """What was learned, and the return of each dialogue in the paper's rewards.

    ``covariance`` is the posterior's (features x features) where the learner has one.
    """

    weights: Weights
    returns: tuple[float, ...]
    questions: tuple[int, ...]
    covariance: tuple[tuple[float, ...], ...] | None = None


Heard = Callable[[str, int, int, float], None]
"""Told how an experiment goes: the stage, how much of how much is done, and the last figure."""


def unheard(stage: str, done: int, total: int, figure: float) -> None:
    """Tell nobody."""


def train(
    practice: Sequence[Practice[Phase]],
    space: FeatureSpace,
    parameters: TrainingParameters,
    rng: np.random.Generator,
    heard: Callable[[int, float], None] | None = None,
) -> Trained:
    """Hold dialogues and learn. Raises ``ValueError`` where there is nothing to practise on.

    ``heard`` is told the number and the return of each dialogue; nothing hangs on it.
    """
    if not practice:
        raise ValueError("there is nothing to practise on")
    size = len(space.names)
    online = "bayesian" if parameters.learner == "lspi" else parameters.learner
    learner = LEARNERS[online](size, parameters.gamma)
    log: list[Step] = []
    returns, questions = [], []
    remembered = [Remembering(one.start) for one in practice]
    for number, index in enumerate(_order(len(practice), parameters.dialogues, rng)):
        policy = _acting(number, learner, space, parameters, rng)
        one = practice[index]
        held = hold(remembered[index], policy, one.human, parameters.priced, rng)
        dialogue = Dialogue(held.state.state, held.turns, held.questions)
        if held.state.right is None:
            held.state.right = one.right(dialogue)
        dialogue = judged(dialogue, held.state.right, parameters.priced)
        learner.begin()
        for step in steps(dialogue, space, index):
            learner.learn(step)
            log.append(step)
        returns.append(sum(turn.reward for turn in dialogue.turns))
        questions.append(dialogue.asked)
        if heard is not None:
            heard(number + 1, returns[-1])
    values = learner.weights
    if parameters.learner == "lspi":
        levels = len(practice) if parameters.levels else 0
        values = lspi(log, size, parameters.gamma, situations=levels)
    covariance = None
    if isinstance(learner, BayesianTD):
        covariance = tuple(tuple(row) for row in learner.covariance.tolist())
    weights = Weights(space, tuple(values.tolist()))
    return Trained(weights, tuple(returns), tuple(questions), covariance)


def steps(dialogue: Dialogue[Phase], space: FeatureSpace, situation: int = 0) -> Iterator[Step]:
    """A dialogue as learners see it, rewards in hundreds."""
    matrices = [space.matrix(turn.decision.candidates) for turn in dialogue.turns]
    chosen = [turn.decision.chosen for turn in dialogue.turns]
    last = len(chosen) - 1
    for place, turn in enumerate(dialogue.turns):
        taken = matrices[place][chosen[place]]
        reward = turn.reward * REWARD_SCALE
        if place == last:
            yield Step(taken, reward, None, 0, situation)
        else:
            yield Step(taken, reward, matrices[place + 1], chosen[place + 1], situation)


def _acting(
    number: int,
    learner: Learner,
    space: FeatureSpace,
    parameters: TrainingParameters,
    rng: np.random.Generator,
) -> AskingPolicy:
    if number < parameters.warm:
        return RandomPolicy() if number % 2 else ManualPolicy()
    weights = Weights(space, tuple(learner.acting(rng).tolist()))
    return LinearPolicy(weights, parameters.epsilon)


def _order(size: int, count: int, rng: np.random.Generator) -> Iterator[int]:
    left = count
    while left > 0:
        yield from rng.permutation(size)[:left].tolist()
        left -= size


@dataclass
class Remembering(Generic[Phase]):
    """A state that remembers where each reply led and how it was judged: it is met many times."""

    state: Phase
    children: dict[tuple[RobotAct, Reply], Remembering[Phase]] = field(default_factory=dict)
    right: float | None = None

    def candidates(self) -> tuple[Candidate, ...]:
        """The state's."""
        return self.state.candidates()

    def after(self, act: RobotAct, reply: Reply) -> Remembering[Phase]:
        """The state after a reply, made once."""
        key = (act, reply)
        if key not in self.children:
            self.children[key] = Remembering(self.state.after(act, reply))
        return self.children[key]

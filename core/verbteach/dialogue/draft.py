"""A robot turn while it is being made: the state so far, what has been said, what was learned."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, TypeVar

import numpy as np

from verbteach.dialogue.acts import AskAgain, RobotAct
from verbteach.dialogue.decision import Candidate, Decision
from verbteach.dialogue.moves import Phase
from verbteach.dialogue.parameters import RobotParameters
from verbteach.dialogue.policy import Policy, Taken
from verbteach.dialogue.promise import Promise
from verbteach.dialogue.setting import Setting
from verbteach.dialogue.state import EpisodeState, Pending, RobotState, Totals
from verbteach.dialogue.turn import Trace
from verbteach.verbs.revision import Revision
from verbteach.verbs.space import HypothesisSpace

_WORD = 0xFFFFFFFF
_State = TypeVar("_State", EpisodeState, RobotState, Totals)


@dataclass(frozen=True)
class Mind:
    """What stays the same while a turn is made: parameters, policy and where the robot is.

    With a ``promise`` it carries out only what it is sure enough of.
    """

    parameters: RobotParameters
    policy: Policy
    setting: Setting
    promise: Promise | None = None

    @property
    def asks(self) -> bool:
        """Whether the policy chooses among all question types."""
        return self.policy.asks


@dataclass
class Draft:
    """Mutable only while one call of ``Robot.receive`` lasts."""

    mind: Mind
    state: RobotState
    phase: Phase = Phase.COMMAND
    acts: list[RobotAct] = field(default_factory=list)
    decisions: list[Decision] = field(default_factory=list)
    learned: list[HypothesisSpace] = field(default_factory=list)
    experience: list[tuple[str, str]] = field(default_factory=list)
    practice: list[Mapping[str, Any]] = field(default_factory=list)
    revisions: list[Revision] = field(default_factory=list)
    reading: str = ""
    reward: float = 0.0
    trace: Trace | None = None

    @property
    def episode(self) -> EpisodeState:
        """The episode under way; there is one outside the command phase."""
        if self.state.episode is None:
            raise RuntimeError("no episode is under way")
        return self.state.episode

    def update(self, **changes: Any) -> None:
        """Replace fields of the episode."""
        self.state = _changed(self.state, {"episode": _changed(self.episode, changes)})

    def remember(self, **changes: Any) -> None:
        """Replace fields of the robot's state."""
        self.state = _changed(self.state, changes)

    def count(self, **more: float) -> None:
        """Add to the session's totals."""
        totals = self.state.totals
        sums = {name: getattr(totals, name) + number for name, number in more.items()}
        self.remember(totals=_changed(totals, sums))

    def say(self, act: RobotAct) -> None:
        """Say something and go on."""
        self.acts.append(act)

    def wait(self, act: RobotAct, phase: Phase) -> None:
        """Say something and wait for the teacher."""
        self.acts.append(act)
        self.phase = phase
        if self.state.episode is not None:
            self.update(phase=phase)

    def ask_again(self, problem: str) -> None:
        """Say what is unclear, and wait for the same."""
        self.reading = ""
        self.say(AskAgain(problem))
        self.wait(self.state.turn.waiting_act, self.state.turn.phase)

    def earn(self, reward: float) -> None:
        """Add a reward to the turn, the episode and the session."""
        self.reward += reward
        if self.state.episode is not None:
            self.update(reward=self.episode.reward + reward)
            if self.episode.pending is not None:
                pending = self.episode.pending
                self.update(pending=pending._replace(reward=pending.reward + reward))
        self.count(reward=reward)

    @property
    def policy(self) -> Policy:
        """The policy as it is now."""
        return self.state.policy or self.mind.policy

    def choose(self, candidates: Sequence[Candidate], phase: Phase) -> RobotAct:
        """Let the policy choose, keep the decision, and learn from the choice before it.

        As in Algorithm 1 of She & Chai (2017), the next act is chosen before the weights change.
        """
        self.update(phase=phase)
        decision = self.policy.choose(self.episode, candidates, self._rng())
        self.decisions.append(decision)
        features = decision.candidates[decision.chosen].features
        self._learn(phase.value, features)
        if self.state.policy is not None:
            self.update(pending=Pending(phase.value, features))
        return decision.act

    def end_phase(self) -> None:
        """The last choice led to no other: learn from what it earned."""
        self._learn("", None)

    def _learn(self, phase: str, following: Mapping[str, float] | None) -> None:
        pending, policy = self.episode.pending, self.state.policy
        if pending is None or policy is None:
            return
        ends = following if pending.phase == phase else None
        policy, record = policy.told(Taken(pending.phase, pending.features, pending.reward, ends))
        if record is not None:
            self.practice.append(record)
        self.remember(policy=policy)
        self.update(pending=None)

    def _rng(self) -> np.random.Generator:
        """Draws depend on the seed, the episode and how far it has come, on nothing else."""
        episode = self.episode
        shown = episode.demonstrated
        progress = (len(episode.asked), len(episode.rejected), len(shown.actions) if shown else 0)
        return generator(self.mind.parameters.seed, episode.number, len(self.decisions), *progress)


def _changed(value: _State, changes: Mapping[str, Any]) -> _State:
    """As ``dataclasses.replace``, for states that hold just what they are given.

    A turn does this a dozen times, and calling the initialiser was an eighth of it.
    """
    kind = type(value)
    fields = kind.__dataclass_fields__
    new = object.__new__(kind)
    held = {**vars(value), **changes}
    if len(held) > len(fields):  # a misspelt change, or what the old value has cached
        if not changes.keys() <= fields.keys():
            raise TypeError(f"{kind.__name__} has no {sorted(changes.keys() - fields.keys())}")
        for name in held.keys() - fields.keys():
            del held[name]
    object.__setattr__(new, "__dict__", held)
    return new


def generator(*numbers: int) -> np.random.Generator:
    """As ``default_rng`` of the list, which takes most of its time to read the numbers."""
    words = [word for number in numbers for word in _words(number)]
    return np.random.default_rng(np.array(words, dtype=np.uint32))


def _words(number: int) -> Iterator[int]:
    """The number's 32-bit words, the lowest first; 0 has one."""
    yield number & _WORD
    while (number := number >> 32) > 0:
        yield number & _WORD

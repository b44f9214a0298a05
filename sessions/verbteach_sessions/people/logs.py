"""Records as logs of choices, for evaluating a policy that other sessions were held under.

Each phase of an episode is a trajectory of its own: execution ends with what
is carried out or shown, learning with the goal that is read back. What a
teacher's act earned belongs to the choice before it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from verbteach.dialogue.acts import RequestDemonstration
from verbteach.dialogue.codec import ActFormatError, robot_act_from_json
from verbteach.dialogue.decision import Candidate
from verbteach.experiments.off_policy.trajectories import Choice, Log, Trajectory
from verbteach.policy.weights_file import SPACES
from verbteach_sessions.errors import SessionError
from verbteach_sessions.people.recorded import Recorded, Said

Floats = NDArray[np.float64]

Chances = Callable[[str, Sequence[Candidate]], Floats]
"""The evaluated policy: the phase and the candidates to the probability of each."""


@dataclass(frozen=True)
class LoggedChoice:
    """A recorded decision and what was earned until the next one of its phase."""

    phase: str
    candidates: tuple[Candidate, ...]
    chosen: int
    propensity: float
    reward: float


@dataclass(frozen=True)
class LoggedPhase:
    """One phase of one episode under the policy that was logged."""

    person: str
    choices: tuple[LoggedChoice, ...]

    @property
    def phase(self) -> str:
        """``execution`` or ``learning``."""
        return self.choices[0].phase


def logged(recorded: Recorded) -> Iterator[LoggedPhase]:
    """The phases of a record in which the policy chose; one that the session ended in is left out.

    Decisions that no asking policy takes part in (unclear words, which are asked
    about by rule) are no choices. Raises ``SessionError`` for one that cannot be read.
    """
    under_way: list[LoggedChoice] = []
    for one in recorded.said:
        data = one.reply.data
        if under_way:
            earned = under_way[-1].reward + float(data["reward"])
            under_way[-1] = replace(under_way[-1], reward=earned)
        closes = one.after.outcome is not None
        chosen = _read(recorded, one)
        for choice in [None, *chosen] if closes else chosen:
            if under_way and (choice is None or choice.phase != under_way[-1].phase):
                yield LoggedPhase(recorded.person, tuple(under_way))
                under_way = []
            under_way += [] if choice is None else [choice]
        if under_way and isinstance(one.after.waiting, RequestDemonstration):
            yield LoggedPhase(recorded.person, tuple(under_way))
            under_way = []


def log_of(phases: Sequence[LoggedPhase], chances: Chances, gamma: float) -> Log:
    """Phases of one kind as tables for the estimators."""
    index = SPACES[phases[0].phase].index
    trajectories = [
        Trajectory(tuple(_tabled(choice, chances, index) for choice in one.choices), one.person)
        for one in phases
    ]
    return Log(tuple(trajectories), gamma)


def _read(recorded: Recorded, said: Said) -> list[LoggedChoice]:
    try:
        return list(_choices(said.reply.data))
    except (ActFormatError, IndexError) as error:
        place = f"{recorded.header.id}, event {said.reply.seq}"
        raise SessionError(f"{place}: a decision that cannot be read, {error}") from error


def _choices(data: Mapping[str, Any]) -> Iterator[LoggedChoice]:
    for decision in data["decisions"]:
        candidates = tuple(
            Candidate(robot_act_from_json(one["act"]), one["features"], one["q"])
            for one in decision["candidates"]
        )
        phase = _phase(candidates)
        if not 0 <= decision["chosen"] < len(candidates):
            raise IndexError(f"there is no candidate {decision['chosen']}")
        if phase:
            yield LoggedChoice(phase, candidates, decision["chosen"], decision["propensity"], 0.0)


def _phase(candidates: Sequence[Candidate]) -> str:
    """The phase whose features these are; none where they are those of a rule."""
    names = {name for one in candidates for name in one.features}
    fitting = (name for name, space in SPACES.items() if names <= set(space.names))
    return next(fitting, "") if names else ""


def _tabled(choice: LoggedChoice, chances: Chances, index: Mapping[str, int]) -> Choice:
    features = np.zeros((len(choice.candidates), len(index)))
    for row, candidate in enumerate(choice.candidates):
        for name, value in candidate.features.items():
            features[row, index[name]] = value
    target = chances(choice.phase, choice.candidates)
    return Choice(features, choice.chosen, choice.propensity, choice.reward, target)

"""What a teaching dialogue carries from turn to turn, as values that never change.

Keeping a reference to a :class:`RobotState` is a snapshot of everything: the
true world, what was learned, the episode under way and the last robot turn.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING, Any, NamedTuple

from verbteach.dialogue.acts import IncludeFluent, RobotAct, SelectHypo
from verbteach.dialogue.codec import goal_to_json, robot_act_to_json
from verbteach.dialogue.grounding import GroundingBelief
from verbteach.dialogue.moves import Phase
from verbteach.dialogue.turn import RobotTurn
from verbteach.language.frames import VerbFrame
from verbteach.perception.belief import Belief
from verbteach.verbs.knowledge import VerbKnowledge
from verbteach.verbs.space import HypothesisSpace
from verbteach.world.fluents import Goal, State
from verbteach.world.plan import Action

if TYPE_CHECKING:
    from verbteach.dialogue.policy import LearningPolicy


class RankedGoal(NamedTuple):
    """A goal that the command may mean; ``share`` says how much it is wanted, from 0 to 1."""

    goal: Goal
    share: float


class Exchange(NamedTuple):
    """A question of this episode and what it was answered with, as read."""

    question: RobotAct
    answer: str


class Pending(NamedTuple):
    """An act that the policy has chosen, with what it has earned; it is learned from next."""

    phase: str
    features: Mapping[str, float]
    reward: float = 0.0


@dataclass(frozen=True)
class Demonstrated:
    """A demonstration under way or over: its steps and the worlds between them."""

    actions: tuple[Action, ...] = ()
    states: tuple[State, ...] = ()


@dataclass(frozen=True)
class ReadBack:
    """What the robot is about to keep of a demonstration.

    ``whole`` is the demonstrated change, ``goal`` the part that the robot
    takes for the verb's goal and reads back; ``space`` is the demonstration's
    hypothesis space, or ``None`` where none could be made. ``first`` is the
    goal as it was read back first. ``rejected``: the teacher has called it wrong.
    """

    whole: Goal
    goal: Goal
    space: HypothesisSpace | None
    first: Goal = frozenset()
    rejected: bool = False
    edited: bool = False


@dataclass(frozen=True)
class EpisodeState:
    """One command from the request to the outcome: the paper's <l, e, KB, Grd, Goal> less KB.

    ``start`` is the true world before the command; ``belief`` what the robot
    makes of it. ``asked`` holds this command's questions; ``question`` the one
    that waits for an answer. ``guessed`` are the phrases whose words the robot
    does not know and grounds in words near them. ``rejected`` are the goals
    whose execution was judged wrong.
    """

    number: int
    phase: Phase
    command: str
    frame: VerbFrame
    start: State
    belief: Belief
    grounding: GroundingBelief
    guessed: frozenset[str] = frozenset()
    goals: tuple[RankedGoal, ...] = ()
    asked: tuple[Exchange, ...] = ()
    question: RobotAct | None = None
    execution: SelectHypo | None = None
    rejected: frozenset[Goal] = frozenset()
    demonstrated: Demonstrated | None = None
    read_back: ReadBack | None = None
    reward: float = 0.0
    pending: Pending | None = None

    @property
    def phrases(self) -> tuple[str, ...]:
        """The noun phrases that at least one object fits: the frame's grounded arguments."""
        return self.grounding.grounded

    @property
    def best_objects(self) -> tuple[str, ...]:
        """The likeliest object of each grounded phrase."""
        best = (self.grounding.best(phrase) for phrase in self.phrases)
        return tuple(thing for thing in best if thing is not None)


@dataclass(frozen=True)
class Totals:
    """What the session has come to so far; ``successes`` are executions judged right."""

    episodes: int = 0
    successes: int = 0
    learned: int = 0
    questions: int = 0
    reward: float = 0.0


@dataclass(frozen=True)
class RobotState:
    """Everything that a fold over a session's events carries.

    ``experience`` counts how often a noun phrase meant an object, over all
    scenes. ``spoken`` are the last clause's phrases with their objects, for
    pronouns, and ``referents`` those of this command's earlier clauses;
    ``clauses`` are the clauses still to come; ``suggested`` is a command the
    robot has offered instead of what it ``heard``, and ``offered`` its
    clauses where they are the robot's own reading, which a second one disputes.
    ``latest`` is the last clause that was taken up, for "again"; it follows from
    what was said, so that no digest needs it. ``policy`` is the question policy
    as it has learned to be, where it learns.
    """

    scene: str
    world: State
    turn: RobotTurn
    knowledge: VerbKnowledge = field(default_factory=VerbKnowledge)
    experience: Mapping[tuple[str, str], int] = field(default_factory=dict)
    episode: EpisodeState | None = None
    spoken: tuple[tuple[str, str], ...] = ()
    referents: tuple[tuple[str, str], ...] = ()
    clauses: tuple[VerbFrame, ...] = ()
    suggested: str = ""
    heard: str = ""
    offered: tuple[VerbFrame, ...] = ()
    latest: VerbFrame | None = None
    totals: Totals = field(default_factory=Totals)
    policy: LearningPolicy | None = None

    @cached_property
    def digest(self) -> str:
        """SHA-256 of the state's canonical JSON; equal states have equal digests."""
        text = json.dumps(state_to_json(self), sort_keys=True, separators=(",", ":"))
        return hashlib.sha256(text.encode()).hexdigest()


def state_to_json(state: RobotState) -> dict[str, Any]:
    """The state as plain JSON values: knowledge by its digest, worlds as sorted fluents."""
    episode = state.episode
    return {
        "scene": state.scene,
        "world": _world(state.world),
        "knowledge": state.knowledge.digest,
        "experience": [[*pair, count] for pair, count in sorted(state.experience.items())],
        "phase": state.turn.phase.value,
        "acts": [robot_act_to_json(act) for act in state.turn.acts],
        "texts": list(state.turn.texts),
        "spoken": [list(pair) for pair in state.spoken],
        "referents": [list(pair) for pair in state.referents],
        "clauses": [repr(clause) for clause in state.clauses],
        "suggested": state.suggested,
        # Absent where nothing is disputed: digests are then as they were before there was this.
        **({"offered": [repr(clause) for clause in state.offered]} if state.offered else {}),
        **({"heard": state.heard} if state.heard else {}),
        **({"policy": state.policy.digest} if state.policy else {}),
        "totals": vars(state.totals),
        "episode": None if episode is None else _episode(episode),
    }


def _episode(episode: EpisodeState) -> dict[str, Any]:
    shown = episode.demonstrated
    return {
        "number": episode.number,
        "phase": episode.phase.value,
        "command": episode.command,
        "start": _world(episode.start),
        "belief": [[str(fluent), confidence] for fluent, confidence in episode.belief.items()],
        "grounding": [[p, [list(pair) for pair in d]] for p, d in episode.grounding.phrases],
        "settled": sorted(episode.grounding.settled),
        "goals": [[goal_to_json(goal.goal), goal.share] for goal in episode.goals],
        "asked": [[robot_act_to_json(one.question), one.answer] for one in episode.asked],
        "rejected": sorted(goal_to_json(goal) for goal in episode.rejected),
        "demonstrated": None if shown is None else [str(action) for action in shown.actions],
        "read_back": None if episode.read_back is None else _read_back(episode.read_back),
        "reward": episode.reward,
        **({"pending": _pending(episode.pending)} if episode.pending else {}),
    }


def _pending(pending: Pending) -> list[Any]:
    return [pending.phase, dict(pending.features), pending.reward]


def _read_back(read_back: ReadBack) -> dict[str, Any]:
    return {
        "act": robot_act_to_json(IncludeFluent(read_back.goal)),
        "whole": goal_to_json(read_back.whole),
        "rejected": read_back.rejected,
        "edited": read_back.edited,
        **({"first": goal_to_json(read_back.first)} if read_back.edited else {}),
    }


def _world(world: State) -> list[str]:
    return sorted(str(fluent) for fluent in world)

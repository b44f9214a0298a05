"""The robot's choices as episodes of reinforcement learning: one command each, what holds only.

A step is a decision: its candidates, the one chosen, and what came of it. What
is earned until the next decision counts for the last one before, so a
command's rewards add up to what the record says.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from itertools import groupby
from typing import Any

from verbteach_sessions.exports.dialogue import ROBOT, Dialogue, Turn


@dataclass(frozen=True)
class Step:
    """One decision, and the reward that followed it."""

    candidates: tuple[Mapping[str, Any], ...]
    chosen: int
    propensity: float
    explored: bool
    reward: float


@dataclass(frozen=True)
class RlEpisode:
    """The decisions under one command; ``closed`` unless the session left it unfinished.

    ``about`` says where it comes from: session, command, participant, policy,
    scene, and part of the corpus.
    """

    about: Mapping[str, Any]
    steps: tuple[Step, ...]
    closed: bool

    @property
    def command(self) -> int:
        """Which of its session's commands it is, from 0."""
        return int(self.about["command"])


def episodes(dialogue: Dialogue) -> Iterator[RlEpisode]:
    """The session's commands in order, those in which the robot decided something."""
    turns = [turn for turn in dialogue.held if turn.speaker == ROBOT]
    earned = [*(turn.reward or 0.0 for turn in turns[1:]), 0.0]
    paired = zip(turns, earned, strict=True)
    for command, group in groupby(paired, key=lambda pair: pair[0].command):
        members = list(group)
        steps: list[Step] = []
        for turn, reward in members:
            steps += _steps(turn)
            if steps:
                steps[-1] = replace(steps[-1], reward=steps[-1].reward + reward)
        if command is not None and steps:
            closed = any("close_episode" in turn.act_names for turn, _ in members)
            yield RlEpisode(_about(dialogue, members[0][0]), tuple(steps), closed)


def _about(dialogue: Dialogue, turn: Turn) -> Mapping[str, Any]:
    return {
        "session": dialogue.id,
        "command": turn.command,
        "participant": dialogue.participant,
        "policy": dialogue.policy,
        "scene": turn.scene,
        "split": dialogue.split,
    }


def _steps(turn: Turn) -> Iterator[Step]:
    for decision in turn.decisions:
        candidates = tuple(decision["candidates"])
        if 0 <= decision["chosen"] < len(candidates):
            yield Step(
                candidates=candidates,
                chosen=decision["chosen"],
                propensity=float(decision["propensity"]),
                explored=decision["explored"],
                reward=0.0,
            )

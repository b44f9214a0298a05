"""What a robot turn leaves in the record: the data of the events that follow the teacher's act."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from verbteach.dialogue.codec import decision_to_json, goal_to_json, robot_act_to_json
from verbteach.dialogue.state import EpisodeState, RobotState
from verbteach.dialogue.turn import Trace
from verbteach.world.fluents import State
from verbteach_sessions.lines import canonical, digest


def robot_data(reply_to: int, state: RobotState) -> dict[str, Any]:
    """The data of a ``robot`` event: the turn of ``state``, and the state that now holds."""
    turn = state.turn
    return {
        "reply_to": reply_to,
        "reading": turn.reading,
        "acts": [robot_act_to_json(act) for act in turn.acts],
        "texts": list(turn.texts),
        "phase": turn.phase.value,
        "reward": turn.reward,
        "decisions": [decision_to_json(decision) for decision in turn.decisions],
        "beliefs": None if state.episode is None else beliefs(state.episode),
        "trace": None if turn.trace is None else _trace(turn.trace),
        "after": after(state),
    }


def after(state: RobotState) -> dict[str, Any]:
    """The state in short: enough to compare it, and to list the session by."""
    return {
        "scene": state.scene,
        "digest": state.digest,
        "world": world_digest(state.world),
        "knowledge": state.knowledge.digest,
        "totals": dict(vars(state.totals)),
        "verbs_learned": list(state.knowledge.verbs),
    }


def beliefs(episode: EpisodeState) -> dict[str, Any]:
    """What the robot believes: only fluents it is not sure of are listed, as [fluent, p]."""
    uncertain = ((str(f), p) for f, p in episode.belief.items() if 0 < p < 1)
    return {
        "grounding": [
            {"phrase": phrase, "objects": [list(pair) for pair in objects]}
            for phrase, objects in episode.grounding.phrases
        ],
        "goals": [{"goal": goal_to_json(goal.goal), "share": goal.share} for goal in episode.goals],
        "uncertain": [list(pair) for pair in uncertain],
    }


def world_digest(world: State) -> str:
    """SHA-256 of a world's fluents as sorted text."""
    return digest(canonical(sorted(str(fluent) for fluent in world)))


def _trace(trace: Trace) -> Mapping[str, Any]:
    return {
        "done": [str(action) for action in trace.done],
        "failed": None if trace.failed is None else str(trace.failed),
        "obstacle": trace.obstacle,
        "worlds": [world_digest(world) for world in trace.states],
    }

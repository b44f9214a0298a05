"""The legal moves: everything about which act may follow which lives in this file.

A phase is what the robot waits for. For each phase the tables say which robot
acts bring it about and which teacher acts may answer, with the phases that may
come next. Nothing here knows how an act is read, worded or carried out.
"""

from __future__ import annotations

from collections.abc import Mapping
from enum import Enum

from verbteach.dialogue import acts
from verbteach.dialogue.acts import RobotAct, TeacherAct


class Phase(Enum):
    """What the robot waits for."""

    COMMAND = "command"
    EXECUTION = "execution"
    JUDGEMENT = "judgement"
    DEMONSTRATION = "demonstration"
    LEARNING = "learning"
    READ_BACK = "read_back"


# Execution and learning are the paper's two phases (section 4.1): in each of them the
# robot waits for the answer to a question. The others wait for a person's own move.
ROBOT_MOVES: Mapping[Phase, tuple[type[RobotAct], ...]] = {
    Phase.COMMAND: (acts.AwaitCommand, acts.AskRephrase),
    Phase.EXECUTION: (acts.NpGrdWhq, acts.NpGrdYnq, acts.EnvPredYnq, acts.GoalPredYnq),
    Phase.JUDGEMENT: (acts.SelectHypo,),
    Phase.DEMONSTRATION: (
        acts.RequestDemonstration,
        acts.ObserveStep,
        acts.RefuseStep,
        acts.ReviseSteps,
        acts.RefuseRevision,
        acts.AskAgain,
    ),
    Phase.LEARNING: (
        acts.NpGrdWhq,
        acts.NpGrdYnq,
        acts.BulkNpGrdYnq,
        acts.PredChangeYnq,
        acts.GoalRelevantYnq,
    ),
    Phase.READ_BACK: (acts.IncludeFluent, acts.ReviseGoal),
}

_AFTER_COMMAND = (Phase.EXECUTION, Phase.JUDGEMENT, Phase.DEMONSTRATION)
_AFTER_DEMONSTRATION = (Phase.LEARNING, Phase.READ_BACK)

_EXECUTION_ANSWER = (*_AFTER_COMMAND,)
_LEARNING_ANSWER = (*_AFTER_DEMONSTRATION, Phase.DEMONSTRATION)

TEACHER_MOVES: Mapping[Phase, Mapping[type[TeacherAct], tuple[Phase, ...]]] = {
    Phase.COMMAND: {
        acts.Command: (Phase.COMMAND, *_AFTER_COMMAND),
        acts.GoToScene: (Phase.COMMAND,),
        acts.RuleOut: (Phase.COMMAND,),
        acts.Confirm: (Phase.COMMAND,),
    },
    Phase.EXECUTION: {
        acts.Yes: _EXECUTION_ANSWER,
        acts.No: _EXECUTION_ANSWER,
        acts.Unsure: _EXECUTION_ANSWER,
        acts.Skip: _EXECUTION_ANSWER,
        acts.Say: _EXECUTION_ANSWER,
        acts.Point: _EXECUTION_ANSWER,
        acts.Show: (Phase.DEMONSTRATION,),
    },
    Phase.JUDGEMENT: {
        acts.Good: (Phase.COMMAND, *_AFTER_COMMAND),
        acts.Bad: (Phase.DEMONSTRATION,),
        acts.Stop: (Phase.DEMONSTRATION,),
        acts.Skip: (Phase.COMMAND, *_AFTER_COMMAND),
        acts.Show: (Phase.DEMONSTRATION,),
        acts.Say: (Phase.COMMAND, *_AFTER_COMMAND),
    },
    Phase.DEMONSTRATION: {
        acts.Do: (Phase.DEMONSTRATION,),
        acts.Insert: (Phase.DEMONSTRATION,),
        acts.Remove: (Phase.DEMONSTRATION,),
        acts.Move: (Phase.DEMONSTRATION,),
        acts.Done: (Phase.DEMONSTRATION, *_AFTER_DEMONSTRATION),
        acts.Skip: (Phase.COMMAND, *_AFTER_COMMAND),
        acts.Say: (Phase.DEMONSTRATION, *_AFTER_DEMONSTRATION, Phase.COMMAND, *_AFTER_COMMAND[:2]),
    },
    Phase.LEARNING: {
        acts.Yes: _LEARNING_ANSWER,
        acts.No: _LEARNING_ANSWER,
        acts.Unsure: _LEARNING_ANSWER,
        acts.Skip: _LEARNING_ANSWER,
        acts.Say: _LEARNING_ANSWER,
        acts.Point: _LEARNING_ANSWER,
        acts.Show: (Phase.DEMONSTRATION,),
    },
    Phase.READ_BACK: {
        acts.Good: (Phase.COMMAND, *_AFTER_COMMAND),
        acts.Bad: (Phase.READ_BACK,),
        acts.Strike: (Phase.READ_BACK,),
        acts.Keep: (Phase.READ_BACK,),
        acts.Skip: (Phase.COMMAND, *_AFTER_COMMAND),
        acts.Show: (Phase.DEMONSTRATION,),
        acts.Say: (Phase.COMMAND, *_AFTER_COMMAND, Phase.READ_BACK),
    },
}


_WAITS: Mapping[Phase, str] = {
    Phase.COMMAND: "for a command, as in: boil the water (in a script, command: boil the water)",
    Phase.EXECUTION: "for an answer: yes, no, unsure, skip, an object, or show",
    Phase.LEARNING: "for an answer: yes, no, unsure, skip, an object, or show",
    Phase.JUDGEMENT: "to hear whether it was right: good, bad, stop, skip or show",
    Phase.DEMONSTRATION: "to be shown: a step, or done after the last one, or skip",
    Phase.READ_BACK: "to hear whether the goal is right: good, bad, strike, keep, skip or show",
}
"""What fits each phase, for a person to read."""


class IllegalMoveError(ValueError):
    """The teacher's act does not fit what the robot waits for."""


def expected(phase: Phase) -> tuple[str, ...]:
    """The names of the teacher acts that fit ``phase``, in the table's order."""
    return tuple(kind.name for kind in TEACHER_MOVES[phase])


def check_teacher_act(phase: Phase, act: TeacherAct) -> None:
    """Raise :class:`IllegalMoveError` unless ``act`` is legal in ``phase``."""
    if type(act) not in TEACHER_MOVES[phase]:
        raise IllegalMoveError(f"'{act.name}' does not fit: the robot waits {_WAITS[phase]}")

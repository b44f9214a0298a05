"""What the robot and the teacher can say and do, one frozen dataclass a kind.

Acts 1 to 8 of She & Chai (2017), Table 2, carry the paper's names. The other
robot acts keep the conversation going and have no price. Acts know nothing of
how they are worded, priced or stored. The modules follow the paper: what is
said in the execution phase, in the learning phase, and in both; between them
the demonstration; and the teacher's side.
"""

from __future__ import annotations

from typing import TypeAlias

from verbteach.dialogue.acts.conversation import (
    AskAgain,
    AskRephrase,
    AwaitCommand,
    CloseEpisode,
    NpGrdWhq,
    NpGrdYnq,
    Outcome,
    StartClause,
)
from verbteach.dialogue.acts.demonstration import (
    DemonstrationReason,
    ObserveStep,
    RefuseRevision,
    RefuseStep,
    RequestDemonstration,
    ReviseSteps,
)
from verbteach.dialogue.acts.execution import (
    EnvPredYnq,
    GoalPredYnq,
    ReportExecution,
    SelectHypo,
)
from verbteach.dialogue.acts.learning import (
    BulkNpGrdYnq,
    GoalRelevantYnq,
    IncludeFluent,
    Learned,
    PredChangeYnq,
    ReviseGoal,
    ReviseVerb,
)
from verbteach.dialogue.acts.teacher import (
    Bad,
    Command,
    Confirm,
    Do,
    Done,
    Good,
    GoToScene,
    Insert,
    Keep,
    Move,
    No,
    Point,
    Remove,
    RuleOut,
    Say,
    Show,
    Skip,
    Stop,
    Strike,
    Unsure,
    Yes,
)

RobotAct: TypeAlias = (
    NpGrdWhq
    | NpGrdYnq
    | EnvPredYnq
    | GoalPredYnq
    | SelectHypo
    | BulkNpGrdYnq
    | PredChangeYnq
    | IncludeFluent
    | GoalRelevantYnq
    | AwaitCommand
    | StartClause
    | AskRephrase
    | AskAgain
    | RequestDemonstration
    | ReportExecution
    | ObserveStep
    | RefuseStep
    | ReviseSteps
    | RefuseRevision
    | ReviseVerb
    | ReviseGoal
    | Learned
    | CloseEpisode
)

QUESTIONS: tuple[type[RobotAct], ...] = (
    NpGrdWhq,
    NpGrdYnq,
    EnvPredYnq,
    GoalPredYnq,
    BulkNpGrdYnq,
    PredChangeYnq,
    GoalRelevantYnq,
)

TeacherAct: TypeAlias = (
    Command
    | Yes
    | No
    | Unsure
    | Skip
    | Say
    | Point
    | Do
    | Insert
    | Remove
    | Move
    | Done
    | Good
    | Bad
    | Stop
    | Strike
    | Keep
    | RuleOut
    | Confirm
    | Show
    | GoToScene
)

__all__ = [
    "QUESTIONS",
    "AskAgain",
    "AskRephrase",
    "AwaitCommand",
    "Bad",
    "BulkNpGrdYnq",
    "CloseEpisode",
    "Command",
    "Confirm",
    "DemonstrationReason",
    "Do",
    "Done",
    "EnvPredYnq",
    "GoToScene",
    "GoalPredYnq",
    "GoalRelevantYnq",
    "Good",
    "IncludeFluent",
    "Insert",
    "Keep",
    "Learned",
    "Move",
    "No",
    "NpGrdWhq",
    "NpGrdYnq",
    "ObserveStep",
    "Outcome",
    "Point",
    "PredChangeYnq",
    "RefuseRevision",
    "RefuseStep",
    "Remove",
    "ReportExecution",
    "RequestDemonstration",
    "ReviseGoal",
    "ReviseSteps",
    "ReviseVerb",
    "RobotAct",
    "RuleOut",
    "Say",
    "SelectHypo",
    "Show",
    "Skip",
    "StartClause",
    "Stop",
    "Strike",
    "TeacherAct",
    "Unsure",
    "Yes",
]

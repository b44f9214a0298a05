"""What the robot and the teacher can say and do, one frozen dataclass a kind.

Acts 1 to 8 of She & Chai (2017), Table 2, carry the paper's names. The other
robot acts keep the conversation going and have no price. Acts know nothing of
how they are worded, priced or stored.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from typing import ClassVar, TypeAlias

from verbteach.world.fluents import Fluent, Goal, Literal
from verbteach.world.plan import Action


@dataclass(frozen=True)
class NpGrdWhq:
    """Table 2, act 1: which object is the noun phrase?"""

    np: str
    name: ClassVar[str] = "np_grd_whq"


@dataclass(frozen=True)
class NpGrdYnq:
    """Table 2, act 2: is the noun phrase this object?"""

    np: str
    object: str
    name: ClassVar[str] = "np_grd_ynq"


@dataclass(frozen=True)
class EnvPredYnq:
    """Table 2, act 3: does the fluent hold now?"""

    fluent: Fluent
    name: ClassVar[str] = "env_pred_ynq"


@dataclass(frozen=True)
class GoalPredYnq:
    """Table 2, act 4: should the literal hold at the end?"""

    literal: Literal
    name: ClassVar[str] = "goal_pred_ynq"


@dataclass(frozen=True)
class SelectHypo:
    """Table 2, act 5: choose a goal hypothesis, plan to it and execute the plan.

    ``goal`` is grounded; ``hypothesis`` names the node of the hypothesis space
    that it came from; ``plan`` is what the robot will do.
    """

    goal: Goal
    hypothesis: str
    plan: tuple[Action, ...]
    name: ClassVar[str] = "select_hypo"


@dataclass(frozen=True)
class BulkNpGrdYnq:
    """Table 2, act 6: are all these noun phrases these objects?"""

    pairs: tuple[tuple[str, str], ...]
    name: ClassVar[str] = "bulk_np_grd_ynq"


@dataclass(frozen=True)
class PredChangeYnq:
    """Table 2, act 7: did the demonstration make this literal true?"""

    literal: Literal
    name: ClassVar[str] = "pred_change_ynq"


@dataclass(frozen=True)
class IncludeFluent:
    """Table 2, act 8: keep the conjunction as the verb's goal, after reading it back."""

    goal: Goal
    name: ClassVar[str] = "include_fluent"


@dataclass(frozen=True)
class GoalRelevantYnq:
    """Beyond Table 2 (after Table 1, R6): does this change belong to the goal?"""

    literal: Literal
    name: ClassVar[str] = "goal_relevant_ynq"


@dataclass(frozen=True)
class AwaitCommand:
    """The robot is ready for a command."""

    name: ClassVar[str] = "await_command"


@dataclass(frozen=True)
class StartClause:
    """The command had several clauses; the robot turns to this one."""

    clause: str
    name: ClassVar[str] = "start_clause"


@dataclass(frozen=True)
class AskRephrase:
    """The robot could not read the command; ``reason`` says why in words."""

    reason: str
    name: ClassVar[str] = "ask_rephrase"


@dataclass(frozen=True)
class AskAgain:
    """The robot could not read the answer to its question, and asks it once more."""

    reason: str
    name: ClassVar[str] = "ask_again"


class DemonstrationReason(Enum):
    """Why the robot asks to be shown."""

    UNKNOWN_VERB = "unknown_verb"
    NO_HYPOTHESIS = "no_hypothesis"
    NO_PLAN = "no_plan"
    NOTHING_TO_DO = "nothing_to_do"
    WRONG_EXECUTION = "wrong_execution"
    TAKEN_OVER = "taken_over"
    NO_STEP = "no_step"
    NOTHING_CHANGED = "nothing_changed"
    SHOW_AGAIN = "show_again"


@dataclass(frozen=True)
class RequestDemonstration:
    """The robot asks to be shown; ``restored``: the world was put back first."""

    reason: DemonstrationReason
    restored: bool = False
    name: ClassVar[str] = "request_demonstration"


@dataclass(frozen=True)
class ReportExecution:
    """What became of an execution: the steps done, and what stopped it if anything did."""

    done: tuple[Action, ...]
    failed: Action | None = None
    obstacle: str = ""
    name: ClassVar[str] = "report_execution"


@dataclass(frozen=True)
class ObserveStep:
    """The robot saw a demonstrated action; ``change`` is the whole change so far."""

    action: Action
    change: tuple[Literal, ...]
    name: ClassVar[str] = "observe_step"


@dataclass(frozen=True)
class RefuseStep:
    """The demonstrated action cannot be done now; ``reason`` says why in words."""

    action: Action
    reason: str
    name: ClassVar[str] = "refuse_step"


@dataclass(frozen=True)
class ReviseSteps:
    """The demonstration was edited: its steps as they now are, and their whole ``change``."""

    steps: tuple[Action, ...]
    change: tuple[Literal, ...]
    name: ClassVar[str] = "revise_steps"


@dataclass(frozen=True)
class RefuseRevision:
    """The demonstration stays as it is: step number ``step`` would not be possible any more."""

    step: int
    action: Action
    reason: str
    name: ClassVar[str] = "refuse_revision"


@dataclass(frozen=True)
class ReviseVerb:
    """What is known of a verb was corrected: ``left`` of ``before`` hypotheses are left."""

    verb: str
    literal: Literal
    wanted: bool
    before: int
    left: int
    name: ClassVar[str] = "revise_verb"


@dataclass(frozen=True)
class ReviseGoal:
    """The goal read back was wrong; the robot asks what to strike or to keep."""

    goal: Goal
    name: ClassVar[str] = "revise_goal"


@dataclass(frozen=True)
class Learned:
    """The robot keeps the verb: frame as (verb, number of noun phrases), its lifted goal."""

    verb: str
    arity: int
    hypothesis: str
    new_nodes: int
    name: ClassVar[str] = "learned"


@dataclass(frozen=True)
class CloseEpisode:
    """The episode is over; ``outcome`` is one of :class:`Outcome`."""

    outcome: Outcome
    name: ClassVar[str] = "close_episode"


class Outcome(Enum):
    """How an episode ended."""

    EXECUTED = "executed"
    LEARNED = "learned"
    UNJUDGED = "unjudged"
    ABANDONED = "abandoned"


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


@dataclass(frozen=True)
class Command:
    """What the robot should do, in English."""

    text: str
    name: ClassVar[str] = "command"


@dataclass(frozen=True)
class Yes:
    """Yes to the robot's question."""

    name: ClassVar[str] = "yes"


@dataclass(frozen=True)
class No:
    """No to the robot's question."""

    name: ClassVar[str] = "no"


@dataclass(frozen=True)
class Unsure:
    """The teacher does not know."""

    name: ClassVar[str] = "unsure"


@dataclass(frozen=True)
class Skip:
    """The teacher passes over the question, the demonstration or the judgement."""

    name: ClassVar[str] = "skip"


@dataclass(frozen=True)
class Say:
    """Free text; the robot reads it by what it waits for."""

    text: str
    name: ClassVar[str] = "say"


@dataclass(frozen=True)
class Point:
    """Pointing at an object."""

    object: str
    name: ClassVar[str] = "object"


@dataclass(frozen=True)
class Do:
    """One demonstrated action."""

    action: Action
    name: ClassVar[str] = "do"


@dataclass(frozen=True)
class Insert:
    """One more demonstrated action, which becomes step number ``at`` (from 1)."""

    at: int
    action: Action
    name: ClassVar[str] = "insert"


@dataclass(frozen=True)
class Remove:
    """The demonstrated steps from number ``first`` to number ``last`` were not meant."""

    first: int
    last: int
    name: ClassVar[str] = "remove"


@dataclass(frozen=True)
class Move:
    """The demonstrated step number ``at`` belongs at number ``to``."""

    at: int
    to: int
    name: ClassVar[str] = "move"


@dataclass(frozen=True)
class Done:
    """The demonstration is over."""

    name: ClassVar[str] = "done"


@dataclass(frozen=True)
class Good:
    """The execution, or the goal read back, is right."""

    name: ClassVar[str] = "good"


@dataclass(frozen=True)
class Bad:
    """The execution, or the goal read back, is wrong."""

    name: ClassVar[str] = "bad"


@dataclass(frozen=True)
class Stop:
    """Stop the execution after ``step`` of its steps (none given: at once)."""

    step: int = 0
    name: ClassVar[str] = "stop"


@dataclass(frozen=True)
class Strike:
    """The literal does not belong to the goal that was read back."""

    literal: Literal
    name: ClassVar[str] = "strike"


@dataclass(frozen=True)
class Keep:
    """The literal belongs to the goal that was read back."""

    literal: Literal
    name: ClassVar[str] = "keep"


@dataclass(frozen=True)
class RuleOut:
    """A fluent of a learned, lifted hypothesis is no part of what the verb frame asks for."""

    frame: str
    hypothesis: Goal
    literal: Literal
    name: ClassVar[str] = "rule_out"


@dataclass(frozen=True)
class Confirm:
    """A fluent of a learned, lifted hypothesis is part of what the verb frame asks for."""

    frame: str
    hypothesis: Goal
    literal: Literal
    name: ClassVar[str] = "confirm"


@dataclass(frozen=True)
class Show:
    """The teacher takes over and will demonstrate."""

    name: ClassVar[str] = "show"


@dataclass(frozen=True)
class GoToScene:
    """Go to another scene, found as it starts."""

    scene: str
    name: ClassVar[str] = "scene"


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

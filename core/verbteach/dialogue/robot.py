"""The robot: a dialogue that is fed the teacher's acts and answers each with a turn.

It never waits, reads no clock and opens no file. Its state is one immutable
value; going back to an earlier one is assigning it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any

from verbteach.dialogue import (
    acts,
    commands,
    demonstration,
    execution,
    judgement,
    learning,
    questions,
    reading_back,
    revising,
    shown_in_words,
)
from verbteach.dialogue.acts import DemonstrationReason, TeacherAct
from verbteach.dialogue.closing import await_command
from verbteach.dialogue.draft import Draft, Mind
from verbteach.dialogue.explanation import explain
from verbteach.dialogue.moves import Phase, check_teacher_act
from verbteach.dialogue.parameters import RobotParameters
from verbteach.dialogue.policy import LearningPolicy, Policy
from verbteach.dialogue.promise import Promise
from verbteach.dialogue.referring import check_object
from verbteach.dialogue.replies import offers_to_show
from verbteach.dialogue.setting import Setting, Settings
from verbteach.dialogue.state import RobotState
from verbteach.dialogue.turn import RobotTurn
from verbteach.dialogue.wording import word_turn
from verbteach.verbs.knowledge import VerbKnowledge


class Robot:
    """A robot in a scene, with what it has learned; start with :meth:`open`."""

    def __init__(
        self,
        settings: Settings,
        policy: Policy,
        parameters: RobotParameters | None = None,
        knowledge: VerbKnowledge | None = None,
        experience: Mapping[tuple[str, str], int] | None = None,
        promise: Promise | None = None,
    ) -> None:
        self.settings = settings
        self.policy = policy
        self.parameters = parameters or RobotParameters()
        self.promise = promise
        self._knowledge = knowledge or VerbKnowledge()
        self._experience = dict(experience or {})
        self._state: RobotState | None = None

    @property
    def state(self) -> RobotState:
        """Everything the robot carries; assign an earlier value to go back to it."""
        if self._state is None:
            raise RuntimeError("the robot is in no scene yet: call open")
        return self._state

    @state.setter
    def state(self, state: RobotState) -> None:
        self._state = state

    @property
    def turn(self) -> RobotTurn:
        """The last turn: what was said, and what the robot waits for."""
        return self.state.turn

    @property
    def setting(self) -> Setting:
        """Where the robot is."""
        return self.settings(self.state.scene)

    def open(self, scene_id: str) -> RobotTurn:
        """Begin in a scene, found as it starts. Raises ``UnknownSceneError``."""
        world = self.settings(scene_id).scene.initial
        empty = RobotTurn((), (), Phase.COMMAND)
        learning = self.policy if isinstance(self.policy, LearningPolicy) else None
        state = RobotState(
            scene_id, world, empty, self._knowledge, self._experience, policy=learning
        )
        return self._turn(state, await_command)

    def receive(self, act: TeacherAct) -> RobotTurn:
        """Take the teacher's act and answer it with a turn.

        Raises ``IllegalMoveError`` if the act does not fit what the robot waits
        for, ``UnknownSceneError`` and ``UnknownObjectError`` for names that are
        not there; the state is then as it was.
        """
        phase = self.turn.phase
        check_teacher_act(phase, act)
        if isinstance(act, acts.GoToScene):
            return self._go_to(act.scene)
        if isinstance(act, acts.Point):
            check_object(self.setting, act.object)
        return self._turn(self.state, lambda draft: _HANDLERS[phase](draft, act))

    def explain(self) -> tuple[str, ...]:
        """Why the robot's last turn asks or does what it does; changes nothing."""
        return explain(Draft(self._mind(self.state), self.state))

    def repeat(self) -> tuple[str, ...]:
        """The last turn's sentences; changes nothing."""
        return self.turn.texts

    def _go_to(self, scene_id: str) -> RobotTurn:
        world = self.settings(scene_id).scene.initial
        state = replace(
            self.state,
            scene=scene_id,
            world=world,
            spoken=(),
            referents=(),
            clauses=(),
            suggested="",
            heard="",
            offered=(),
        )
        return self._turn(state, await_command)

    def _turn(self, state: RobotState, make: Callable[[Draft], None]) -> RobotTurn:
        draft = Draft(self._mind(state), state)
        make(draft)
        self._state = _finished(draft)
        return self._state.turn

    def _mind(self, state: RobotState) -> Mind:
        return Mind(self.parameters, self.policy, self.settings(state.scene), self.promise)


def _finished(draft: Draft) -> RobotState:
    """The new state: experience counted, the turn worded."""
    experience = dict(draft.state.experience)
    for phrase, thing in draft.experience:
        experience[phrase, thing] = experience.get((phrase, thing), 0) + 1
    draft.remember(experience=experience)
    turn = RobotTurn(
        acts=tuple(draft.acts),
        texts=word_turn(draft),
        phase=draft.phase,
        reading=draft.reading,
        reward=draft.reward,
        trace=draft.trace,
        decisions=tuple(draft.decisions),
        learned=_learned(draft),
    )
    return replace(draft.state, turn=turn)


def _learned(draft: Draft) -> Mapping[str, Any] | None:
    if not (draft.learned or draft.experience or draft.revisions or draft.practice):
        return None
    revisions = [revision.to_json() for revision in draft.revisions]
    return {
        "spaces": [space.to_json() for space in draft.learned],
        "experience": [list(pair) for pair in draft.experience],
        **({"revisions": revisions} if revisions else {}),
        **({"policy": [dict(one) for one in draft.practice]} if draft.practice else {}),
    }


def _command(draft: Draft, act: TeacherAct) -> None:
    match act:
        case acts.Command(text=text):
            commands.hear(draft, text)
        case acts.RuleOut() | acts.Confirm():
            revising.revise(draft, act)


def _execution(draft: Draft, act: TeacherAct) -> None:
    if offers_to_show(act):
        demonstration.request(draft, DemonstrationReason.TAKEN_OVER)
    elif questions.settle(draft, questions.read_answer(draft, act)):
        execution.deliberate(draft)


def _learning(draft: Draft, act: TeacherAct) -> None:
    if offers_to_show(act):
        demonstration.request(draft, DemonstrationReason.SHOW_AGAIN)
    elif questions.settle(draft, questions.read_answer(draft, act)):
        learning.deliberate(draft)


def _demonstration(draft: Draft, act: TeacherAct) -> None:
    match act:
        case acts.Do(action=action):
            demonstration.observe(draft, action)
        case acts.Insert() | acts.Remove() | acts.Move():
            demonstration.edit(draft, act)
        case acts.Done():
            learning.sum_up(draft)
        case acts.Skip():
            learning.abandon(draft)
            commands.go_on(draft)
        case acts.Say(text=text):
            shown_in_words.hear(draft, text)


_HANDLERS: Mapping[Phase, Callable[[Draft, TeacherAct], None]] = {
    Phase.COMMAND: _command,
    Phase.EXECUTION: _execution,
    Phase.JUDGEMENT: judgement.hear,
    Phase.DEMONSTRATION: _demonstration,
    Phase.LEARNING: _learning,
    Phase.READ_BACK: reading_back.hear,
}

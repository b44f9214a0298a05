"""The robot: a dialogue that is fed the teacher's acts and answers each with a turn.

It never waits, reads no clock and opens no file. Its state is one immutable
value; going back to an earlier one is assigning it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import Any

from verbteach.dialogue import (
    acts,
    carrying_out,
    commands,
    demonstration,
    execution,
    learning,
    questions,
    revising,
    shown_in_words,
)
from verbteach.dialogue.acts import DemonstrationReason, Outcome, TeacherAct
from verbteach.dialogue.closing import await_command, close
from verbteach.dialogue.corrections import another_noun, another_reference, other_things
from verbteach.dialogue.draft import Draft, Mind
from verbteach.dialogue.explanation import explain
from verbteach.dialogue.moves import Phase, check_teacher_act
from verbteach.dialogue.parameters import RobotParameters
from verbteach.dialogue.policy import LearningPolicy, Policy
from verbteach.dialogue.promise import Promise
from verbteach.dialogue.setting import Setting, Settings
from verbteach.dialogue.speech import Speech
from verbteach.dialogue.state import RobotState
from verbteach.dialogue.turn import RobotTurn
from verbteach.dialogue.understanding import (
    check_object,
    read_verdict,
)
from verbteach.dialogue.wording import word_turn
from verbteach.language.corrections import read_correction
from verbteach.language.morphology import listing
from verbteach.language.refer import Candidates
from verbteach.language.small_talk import Talk, small_talk
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


def _offers_to_show(act: TeacherAct) -> bool:
    """Whether the teacher takes over, in a word or in words: "no, let me show you"."""
    if not isinstance(act, acts.Say):
        return isinstance(act, acts.Show)
    return Talk.SHOW in {small_talk(act.text), small_talk(read_verdict(act.text).rest)}


def _execution(draft: Draft, act: TeacherAct) -> None:
    if _offers_to_show(act):
        demonstration.request(draft, DemonstrationReason.TAKEN_OVER)
    elif questions.settle(draft, questions.read_answer(draft, act)):
        execution.deliberate(draft)


def _learning(draft: Draft, act: TeacherAct) -> None:
    if _offers_to_show(act):
        demonstration.request(draft, DemonstrationReason.SHOW_AGAIN)
    elif questions.settle(draft, questions.read_answer(draft, act)):
        learning.deliberate(draft)


def _judgement(draft: Draft, act: TeacherAct) -> None:
    match act:
        case acts.Good():
            carrying_out.approve(draft)
            commands.go_on(draft)
        case acts.Bad() | acts.Stop():
            carrying_out.disapprove(draft)
            demonstration.request(draft, DemonstrationReason.WRONG_EXECUTION)
        case acts.Show():
            demonstration.request(draft, DemonstrationReason.TAKEN_OVER)
        case acts.Skip():
            close(draft, Outcome.UNJUDGED)
            commands.go_on(draft)
        case acts.Say(text=text):
            _judgement_in_words(draft, text)


def _judgement_in_words(draft: Draft, text: str) -> None:
    reply = read_verdict(text)
    draft.reading = reply.label
    if _offers_to_show(acts.Say(text)):
        _judgement(draft, acts.Show())
    elif reply.reserved:
        _ask_again(draft, "Was it right just as I did it? Say yes or no first, and then the rest.")
    elif reply.label == "yes":
        commands.put_behind(draft, reply.rest)
        _judgement(draft, acts.Good())
    elif _corrected(draft, text):
        return
    elif reply.label == "no":
        _judgement(draft, acts.Bad())
    elif reply.label == "skip":
        _judgement(draft, acts.Skip())
    else:
        _ask_again(draft, "Say yes if it was right, no if it was not, or skip.")


def _ask_again(draft: Draft, problem: str) -> None:
    """Say what is unclear, and wait for the same."""
    draft.reading = ""
    draft.say(acts.AskAgain(problem))
    draft.wait(_waiting(draft), draft.state.turn.phase)


def _corrected(draft: Draft, text: str) -> bool:
    """Whether the words said what should have been meant.

    The robot starts over with it; where it could be several things, it asks which.
    """
    correction = read_correction(text)
    if correction is None:
        return False
    reference = another_reference(draft, correction)
    if reference is not None:
        return _with_other_words(draft, *reference)
    exchanges = other_things(draft, correction)
    if len(exchanges) > 1:
        _ask_which(draft, [exchange.now for exchange in exchanges])
        return True
    for exchange in exchanges:
        draft.reading = f"{exchange.was}: {exchange.now}"
        if execution.correct_goal(draft, exchange.goal):
            return True
    reference = another_noun(draft, correction)
    return reference is not None and _with_other_words(draft, *reference)


def _with_other_words(draft: Draft, phrase: str, things: Candidates) -> bool:
    draft.reading = f"{phrase}: {', '.join(thing for thing, _ in things)}"
    execution.correct_reference(draft, phrase, things)
    return True


def _ask_which(draft: Draft, things: Sequence[str]) -> None:
    """A correction that fits several things: which one, asked with the judgement still open."""
    name = Speech.of(draft.mind.setting, draft.state.world).thing
    named = listing([name(thing) for thing in dict.fromkeys(things)], "or")
    _ask_again(draft, f"Do you mean {named}? Say which one, or no if none of them.")


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


def _read_back(draft: Draft, act: TeacherAct) -> None:
    match act:
        case acts.Good():
            learning.accept(draft)
            commands.go_on(draft)
        case acts.Bad():
            learning.reject(draft)
        case acts.Strike(literal=literal):
            learning.strike(draft, literal)
        case acts.Keep(literal=literal):
            learning.keep(draft, literal)
        case acts.Show():
            demonstration.request(draft, DemonstrationReason.SHOW_AGAIN)
        case acts.Skip():
            learning.abandon(draft)
            commands.go_on(draft)
        case acts.Say(text=text):
            _read_back_in_words(draft, text)


def _read_back_in_words(draft: Draft, text: str) -> None:
    reply = read_verdict(text)
    draft.reading = reply.label
    if _offers_to_show(acts.Say(text)):
        _read_back(draft, acts.Show())
    elif reply.reserved:
        _ask_again(
            draft, "Is it right just as I said it? Say yes; or say no, and then what to change."
        )
    elif reply.label == "yes":
        commands.put_behind(draft, reply.rest)
        _read_back(draft, acts.Good())
    elif reply.label == "no":
        _read_back(draft, acts.Bad())
    elif reply.label == "skip":
        _read_back(draft, acts.Skip())
    else:
        problem = "Say yes if this is the goal, no if it is not, or skip. You can also strike parts"
        _ask_again(draft, f"{problem} of it, keep what I left out, or show me again.")


def _waiting(draft: Draft) -> acts.RobotAct:
    """The act that the teacher has not answered yet."""
    return draft.state.turn.waiting_act


_HANDLERS: Mapping[Phase, Callable[[Draft, TeacherAct], None]] = {
    Phase.COMMAND: _command,
    Phase.EXECUTION: _execution,
    Phase.JUDGEMENT: _judgement,
    Phase.DEMONSTRATION: _demonstration,
    Phase.LEARNING: _learning,
    Phase.READ_BACK: _read_back,
}

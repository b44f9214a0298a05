"""A simulated person: knows the lesson like the simulated teacher, and answers like a human.

Whether a question is passed over, not known or answered wrongly is drawn by
the person's habits. The draws depend on the seed and on where the session is,
so a session that was broken off goes on as if it had not been.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from verbteach.dialogue import acts
from verbteach.dialogue.acts import TeacherAct
from verbteach.dialogue.moves import Phase
from verbteach.dialogue.setting import Settings
from verbteach.dialogue.speech import Speech
from verbteach.dialogue.state import RobotState
from verbteach.dialogue.teacher import Teacher
from verbteach.dialogue.turn import RobotTurn
from verbteach_sessions.people.habits import Habits, Rates

_PHASES = tuple(Phase)


class HabitualTeacher:
    """``knowing`` gives the right acts, ``habits`` say what becomes of them; a ``Teacher``."""

    def __init__(self, knowing: Teacher, habits: Habits, settings: Settings, seed: int) -> None:
        self._knowing = knowing
        self._habits = habits
        self._settings = settings
        self._seed = seed

    def reply(self, turn: RobotTurn, state: RobotState) -> TeacherAct | None:
        """What this person says; ``None`` when there is no more to say."""
        right = self._knowing.reply(turn, state)
        rates = self._habits.rates.get(turn.waiting_act.name)
        if right is None or rates is None or not _first(turn, state):
            return right
        rng = np.random.default_rng([self._seed, *_place(turn, state)])
        return self._worded(self._said(right, rates, state, rng), rates, state, rng)

    def _said(
        self, right: TeacherAct, rates: Rates, state: RobotState, rng: np.random.Generator
    ) -> TeacherAct:
        passes, unsure, wrong = rng.random(3).tolist()
        asked = len(state.episode.asked) if state.episode else 0
        if passes < rates.passes(asked):
            return acts.Skip()
        judging = state.turn.phase in (Phase.JUDGEMENT, Phase.READ_BACK)
        if unsure < rates.unsure:
            return acts.Skip() if judging else acts.Unsure()
        return _slip(right, state, rng) if wrong < rates.error else right

    def _worded(
        self, act: TeacherAct, rates: Rates, state: RobotState, rng: np.random.Generator
    ) -> TeacherAct:
        if rng.random() >= rates.words:
            return act
        if isinstance(act, acts.Point):
            return acts.Say(self._description(act.object, state))
        text = self._habits.phrase(_ANSWERS.get(type(act), ""), rng)
        return acts.Say(text) if text else act

    def _description(self, thing: str, state: RobotState) -> str:
        return Speech.of(self._settings(state.scene), state.world).thing(thing)


def _first(turn: RobotTurn, state: RobotState) -> bool:
    """Whether this is the person's first word on it: a question put again gets the truth."""
    if any(isinstance(act, acts.AskAgain) for act in turn.acts):
        return False
    read_back = state.episode.read_back if state.episode else None
    return not (turn.phase is Phase.READ_BACK and read_back is not None and read_back.rejected)


def _place(turn: RobotTurn, state: RobotState) -> tuple[int, ...]:
    """Where the session is: two questions that are put at different points differ in it."""
    episode = state.episode
    if episode is None:
        return state.totals.episodes, _PHASES.index(turn.phase)
    shown = episode.demonstrated
    return (
        state.totals.episodes,
        _PHASES.index(turn.phase),
        state.totals.questions,
        len(episode.asked),
        len(episode.rejected),
        len(shown.actions) if shown else 0,
    )


def _slip(right: TeacherAct, state: RobotState, rng: np.random.Generator) -> TeacherAct:
    """The wrong answer: the opposite, or another of the objects in question."""
    if isinstance(right, acts.Point):
        others = _others(right.object, state)
        return acts.Point(others[int(rng.integers(len(others)))]) if others else right
    opposite = _OPPOSITES.get(type(right))
    return right if opposite is None else opposite


def _others(thing: str, state: RobotState) -> Sequence[str]:
    episode = state.episode
    question = episode.question if episode else None
    if episode is None or not isinstance(question, acts.NpGrdWhq):
        return ()
    return [other for other, _ in episode.grounding[question.np] if other != thing]


_OPPOSITES: dict[type[TeacherAct], TeacherAct] = {
    acts.Yes: acts.No(),
    acts.No: acts.Yes(),
    acts.Good: acts.Bad(),
    acts.Bad: acts.Good(),
}
_ANSWERS: dict[type[TeacherAct], str] = {
    acts.Yes: "yes",
    acts.Good: "yes",
    acts.No: "no",
    acts.Bad: "no",
    acts.Unsure: "unsure",
}

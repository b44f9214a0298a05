"""Teaching in plain lines within a study: hidden panels stay hidden, and tasks are told."""

from __future__ import annotations

from verbteach_sessions.script import ScriptAct
from verbteach_sessions.session import Session
from verbteach_sessions.session_acts import Quit
from verbteach_tui import plain_words
from verbteach_tui.plain_talk import MisfitError, Talk
from verbteach_tui.reading import without_slash
from verbteach_tui.study import words
from verbteach_tui.study.run import VIA, StudyRun

_PANELS_OF = {
    "look": frozenset({"scene"}),
    "seen": frozenset({"scene", "mind"}),
    "mind": frozenset({"mind"}),
    "verbs": frozenset({"verbs"}),
}
"""What the words of the plain mode tell of."""


class LessonTalk(Talk):
    """A conversation in one stretch. ``why`` says what ended it, and is empty while it goes on."""

    def __init__(self, run: StudyRun, session: Session) -> None:
        super().__init__(session)
        self._run, self.session = run, session
        self._told = ""
        self.why = ""

    def opening(self) -> list[str]:
        """The way to the first task, the task, and what the robot says."""
        return [*self._moved(None), *self._task(), *super().opening()]

    def again(self) -> list[str]:
        """The task and what the robot waits for, once more."""
        return [task_text(self._run, self.session), *self._robot(self.session.turn.texts)]

    def hear(self, line: str, via: str) -> list[str]:
        """As ``Talk.hear``; panels that the condition hides are not told."""
        if not _PANELS_OF.get(without_slash(line).lower(), frozenset()) <= self._run.panels:
            raise MisfitError("this is not shown here")
        return super().hear(line, via)

    def _help(self) -> list[str]:
        """As ever, without what the condition hides; and how to stop."""
        hidden = [word for word, panels in _PANELS_OF.items() if not panels <= self._run.panels]
        free = self._run.task(self.session) is None
        return [*plain_words.help_lines(self.snapshot, hidden, free), words.ENDING]

    def say(self, act: ScriptAct, raw: str, via: str) -> list[str]:
        """As ``Talk.say``, and what the study does after it."""
        if refusal := self._run.refusal(self.session, act):
            raise MisfitError(refusal)
        lines = super().say(act, raw, via)
        if isinstance(act, Quit):
            return []
        return [*lines, *self._after(act)]

    def _after(self, act: ScriptAct) -> list[str]:
        self.why = self._run.over(self.session)
        if self.why:
            super().say(Quit(), "", VIA)
            return [words.OVER[self.why]]
        return [*self._moved(act), *self._task()]

    def _moved(self, act: ScriptAct | None) -> list[str]:
        move = self._run.moves(self.session, act)
        return [] if move is None else super().say(move, "", VIA)

    def _task(self) -> list[str]:
        """The task, where it is another than was told last."""
        text = task_text(self._run, self.session)
        told, self._told = self._told, text
        return [text] if text and text != told else []


def task_text(run: StudyRun, session: Session) -> str:
    """The task in words with its place, or nothing where the participant chooses."""
    task, tasks = run.task(session), run.lessons.tasks_of(run.here.step.part)
    if task is None:
        return ""
    return words.headed(len(run.standing(session).right) + 1, len(tasks), task.text)

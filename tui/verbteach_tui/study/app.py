"""The full-screen app of a study: from the consent to the thanks, one screen after the other."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import ClassVar

from textual.message import Message
from textual.screen import Screen

from verbteach_sessions.study.steps import Kind
from verbteach_tui.app import VerbteachApp
from verbteach_tui.messages import SessionLeft, SessionOpened
from verbteach_tui.options import AppOptions, OpenNew
from verbteach_tui.screens.failure import FailureScreen
from verbteach_tui.screens.opening import OpeningScreen
from verbteach_tui.study import words
from verbteach_tui.study.leaving_screen import PAUSE, STOP
from verbteach_tui.study.questionnaire_screen import QuestionnaireScreen
from verbteach_tui.study.reading_screen import Choice, ReadingScreen
from verbteach_tui.study.run import StudyRun, is_practice, is_teaching

_NOT_KEPT = "Nothing has changed. Try again; if that does not help, tell whoever invited you."
CONSENT = (Choice("yes", "y", "I agree"), Choice("no", "n", "I do not agree"))
BEGIN = (Choice("begin", "enter", "Begin"),)
GO_ON = (Choice("begin", "enter", "Go on"),)
DONE = (Choice("leave", "enter", "Done"),)


class StudyApp(VerbteachApp):
    """Leads one participant. ``farewell`` is what to say once the screen is gone."""

    CSS_PATH = "../app.tcss"
    CSS: ClassVar[str] = (Path(__file__).parent / "study.tcss").read_text("utf-8")

    QUITTING = "{key} quits. You can come back later."

    class Moved(Message):
        """A worker has kept what was done; ``lead`` is what to say before the next step."""

        def __init__(self, lead: str = "") -> None:
            super().__init__()
            self.lead = lead

    class NotKept(Message):
        """A worker could not."""

        def __init__(self, error: Exception) -> None:
            super().__init__()
            self.error = error

    def __init__(self, options: AppOptions, run: StudyRun) -> None:
        super().__init__(options)
        self.run_through = run
        self.farewell: tuple[str, ...] = ()

    def begin(self) -> None:
        """At the beginning, or where the participant was."""
        self.show_step()

    # ---- the steps

    def show_step(self, lead: str = "") -> None:
        """Show what the participant is at; ``lead`` is said first."""
        run = self.run_through
        study = run.study
        if run.step is None:
            text = f"{study.consent}\n\n{words.ASK_CONSENT}"
            self._show(ReadingScreen(study.title, "Consent", text, CONSENT))
        elif is_teaching(run.step):
            choices = GO_ON if run.has_begun else BEGIN
            self._show(ReadingScreen(study.title, self._heading, self._intro(lead), choices))
        elif run.step.kind is Kind.INSTRUCTIONS:
            text = f"{words.CODE.format(code=run.code)}\n\n{study.instructions}"
            self._show(ReadingScreen(study.title, "Instructions", text))
        elif run.step.kind is Kind.QUESTIONNAIRE:
            self._show(QuestionnaireScreen(study.title, study.questionnaire))
        else:
            self._keep(self._thank)

    @property
    def _heading(self) -> str:
        run = self.run_through
        if is_practice(run.step):
            return "Practice"
        parts = len(run.here.study.by_id) if run.here.steps[-2].part > 1 else 1
        return f"Part {run.here.step.part} of {parts}" if parts > 1 else "Teaching"

    def _intro(self, lead: str) -> str:
        run = self.run_through
        back = words.WELCOME_BACK if run.has_begun else ""
        practice = words.PRACTICE if is_practice(run.step) else ""
        texts = (lead, back, practice, run.lessons.text, _HOW)
        return "\n\n".join(text for text in texts if text)

    def _thank(self) -> str:
        visit = self.run_through.here
        codes = (
            words.COMPLETION.format(code=visit.completion()),
            words.WITHDRAWAL.format(code=visit.code),
        )
        self.farewell = codes
        return "\n\n".join(text for text in (visit.study.thanks, *codes) if text)

    def _show(self, screen: Screen[None]) -> None:
        if len(self.screen_stack) > 1:
            self.switch_screen(screen)
        else:
            self.push_screen(screen)

    # ---- what the participant does

    def on_reading_screen_chosen(self, message: ReadingScreen.Chosen) -> None:
        """Consent, or on to the next."""
        run = self.run_through
        if message.word == "no":
            self.farewell = (words.REFUSED,)
            self.exit()
        elif message.word == "yes":
            self._keep(run.consent)
        elif message.word == "begin":
            self._show(OpeningScreen("the room"))
            self.open_in_worker(OpenNew(run.lessons.first_scene(run.here.step.part)))
        elif message.word == "leave":
            self.exit()
        else:
            self._keep(run.here.done)

    def on_questionnaire_screen_sent(self, message: QuestionnaireScreen.Sent) -> None:
        """Keep the answers."""
        self._keep(partial(self.run_through.answered, message.answers, message.seconds))

    def on_session_opened(self, message: SessionOpened) -> None:
        """Teach, in the room as the condition has it."""
        from verbteach_tui.study.lesson_screen import LessonScreen

        message.prevent_default()
        run = self.run_through
        room = LessonScreen(
            run, message.teaching, self.options.speed, self.load, is_practice(run.step)
        )
        self.enter(room)

    def on_session_left(self, message: SessionLeft) -> None:
        """The stretch is over, or the participant has left it."""
        from verbteach_tui.study.lesson_screen import LessonScreen

        message.prevent_default()
        room = self.screen
        why = room.why if isinstance(room, LessonScreen) else PAUSE

        def close() -> str:
            message.teaching.close()
            if why == STOP:
                self.run_through.here.stop()
                return words.STOPPED
            if why != PAUSE:
                self.run_through.finish(why)
            return words.OVER.get(why, "")

        if why == PAUSE:
            self.farewell = words.paused(self.run_through.code, self.run_through.way_back)
            self._keep(close, then=self.exit)
        else:
            self._keep(close)

    # ---- keeping it, away from the event loop

    def _keep(self, action: Callable[[], object], then: Callable[[], object] | None = None) -> None:
        self.run_worker(
            partial(self._kept, action, then), thread=True, exit_on_error=False, group="study"
        )

    def _kept(self, action: Callable[[], object], then: Callable[[], object] | None) -> None:
        try:
            said = action()
        except Exception as error:
            self.post_message(self.NotKept(error))
            return
        if then is not None:
            self.call_from_thread(then)
        else:
            self.post_message(self.Moved(said if isinstance(said, str) else ""))

    def on_study_app_moved(self, message: Moved) -> None:
        """On to the next step; the last one is shown with its text."""
        run = self.run_through
        if run.step is not None and run.step.kind is Kind.THANKS and self.farewell:
            self._show(ReadingScreen(run.study.title, "Thank you", message.lead, DONE))
        else:
            self.show_step(message.lead)

    def on_study_app_not_kept(self, message: NotKept) -> None:
        """Say why, and let the participant try again."""
        screen = self.screen
        if isinstance(screen, ReadingScreen | QuestionnaireScreen):
            screen.again()
        self.push_screen(FailureScreen("keeping what you did", message.error, _NOT_KEPT))


_HOW = "F1 says what you can do at any moment. F10 pauses, or stops taking part."

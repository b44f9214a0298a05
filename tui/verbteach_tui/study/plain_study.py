"""A whole study in plain lines: a line comes in, lines come out, from the consent to the thanks.

It is led as a session in plain lines is, from the keyboard, a pipe or a script.
"""

from __future__ import annotations

import time
from collections.abc import Callable

from verbteach_sessions.study.questionnaire import Question, Scale, read_rating
from verbteach_sessions.study.steps import Kind
from verbteach_tui.plain_talk import MisfitError
from verbteach_tui.reading import without_slash
from verbteach_tui.study import words
from verbteach_tui.study.lesson_talk import LessonTalk
from verbteach_tui.study.run import StudyRun
from verbteach_tui.views.visible import visible

_YES, _NO = ("yes", "y"), ("no", "n")
_NEXT = ("", "next", "n")
_SKIP = ("", "skip", "s")
_QUIT, _END = "quit", "end"
_GO_ON = (*_NO, "", "next", "go on", "stay")
"""Second thoughts after ``end``."""


class StudyTalk:
    """The conversation of one participant."""

    def __init__(self, run: StudyRun, clock: Callable[[], float] = time.monotonic):
        self._run, self._clock = run, clock
        self._lesson: LessonTalk | None = None
        self._answers: dict[str, int | str | None] = {}
        self._asked_at = 0.0
        self._ending = False
        self.ended = False

    def opening(self) -> list[str]:
        """What stands at the beginning."""
        return [visible(self._run.study.title), *self._entered()]

    def complete(self, text: str) -> list[str]:
        """What ``text`` may become."""
        return [] if self._lesson is None else self._lesson.complete(text)

    def hear(self, line: str, via: str) -> list[str]:
        """Take a line; answer with the lines to print. Raises ``MisfitError``."""
        word = without_slash(line).lower()
        if word == _END and self._run.visit is not None and self._kind is not Kind.THANKS:
            return self._end()
        asked, self._ending = self._ending, False
        if word == _QUIT:
            return self._paused()
        if asked and word in _YES:
            self._ending = True
            return [words.STOP_ASKED]
        if asked and word in _GO_ON:
            return [words.GOES_ON, *self._again()]
        return self._hear(line, via)

    def close(self) -> None:
        """Let go of the session, if one is open, and of the record."""
        if self._lesson is not None:
            self._lesson.session.close()
        self._run.close()

    # ---- by what is going on

    @property
    def _kind(self) -> Kind | None:
        return None if self._run.step is None else self._run.step.kind

    def _hear(self, line: str, via: str) -> list[str]:
        kind, word = self._kind, line.strip()
        if kind is None:
            return self._consent(word)
        if kind is Kind.INSTRUCTIONS:
            return self._read(word)
        if kind is Kind.QUESTIONNAIRE:
            return self._rated(word)
        if self._lesson is not None:
            return self._taught(self._lesson, line, via)
        return []

    def _again(self) -> list[str]:
        """What is waited for, once more."""
        if self._lesson is not None:
            return self._lesson.again()
        return self._question() if self._kind is Kind.QUESTIONNAIRE else [_TYPE_NEXT]

    def _entered(self) -> list[str]:
        """What a step begins with."""
        kind = self._kind
        if kind is None:
            return [*_lines(self._run.study.consent), f"{words.ASK_CONSENT} Type yes or no."]
        if kind is Kind.INSTRUCTIONS:
            return [*_lines(self._run.study.instructions), _TYPE_NEXT]
        if kind is Kind.QUESTIONNAIRE:
            self._answers, self._asked_at = {}, self._clock()
            return [words.TLX, *self._question()]
        return self._thanks() if kind is Kind.THANKS else self._lesson_begins()

    def _consent(self, word: str) -> list[str]:
        if word.lower() in _NO:
            self.ended = True
            return [words.REFUSED]
        if word.lower() not in _YES:
            raise MisfitError("type yes or no")
        self._run.consent()
        return [words.CODE.format(code=self._run.code), *self._entered()]

    def _read(self, word: str) -> list[str]:
        if word.lower() not in _NEXT:
            raise MisfitError("type next to go on, or quit to pause")
        self._run.here.done()
        return self._entered()

    def _lesson_begins(self) -> list[str]:
        back = [words.WELCOME_BACK] if self._run.has_begun else []
        practice = [words.PRACTICE] if self._kind is Kind.PRACTICE else []
        self._lesson = LessonTalk(self._run, self._run.open_session())
        how = "Type help for what you can say, quit to pause, end to stop taking part."
        repaired = [f"Note: {visible(text)}" for text in self._lesson.session.recovered]
        opening = self._lesson.opening()
        return [*back, *practice, *_lines(self._run.lessons.text), how, *repaired, *opening]

    def _taught(self, lesson: LessonTalk, line: str, via: str) -> list[str]:
        lines = lesson.hear(line, via)
        if not lesson.why:
            return lines
        self._leave_session()
        self._run.finish(lesson.why)
        return [*lines, *self._entered()]

    def _leave_session(self) -> None:
        if self._lesson is not None:
            self._lesson.session.close()
            self._lesson = None

    # ---- pausing and stopping

    def _paused(self) -> list[str]:
        self.ended = True
        if self._run.visit is None:
            return [words.REFUSED]
        self._quit()
        return [*words.paused(self._run.code, self._run.way_back)]

    def _quit(self) -> None:
        if self._lesson is not None and not self._lesson.ended:
            self._lesson.hear("quit", "typed")
        self._leave_session()

    def _end(self) -> list[str]:
        if not self._ending:
            self._ending = True
            return [words.STOP_ASKED]
        self._quit()
        self._run.here.stop()
        return [words.STOPPED, *self._entered()]

    # ---- the questionnaire and the end

    @property
    def _items(self) -> tuple[Scale | Question, ...]:
        asked = self._run.here.study.questionnaire
        return (*asked.scales, *asked.questions)

    def _question(self) -> list[str]:
        item = self._items[len(self._answers)]
        place = f"{len(self._answers) + 1} of {len(self._items)}"
        if isinstance(item, Scale):
            ends = f"0 is {item.low}, 100 is {item.high}"
            return [f"{place}. {item.title}. {item.text} A number from 0 to 100; {ends}. Or skip."]
        return [f"{place}. {visible(item.text)} In your own words, or skip."]

    def _rated(self, word: str) -> list[str]:
        item = self._items[len(self._answers)]
        self._answers[item.id] = None if word.lower() in _SKIP else _answer(item, word)
        if len(self._answers) < len(self._items):
            return self._question()
        self._run.answered(self._answers, self._clock() - self._asked_at)
        return self._entered()

    def _thanks(self) -> list[str]:
        self.ended = True
        visit = self._run.here
        return [
            *_lines(visit.study.thanks),
            words.COMPLETION.format(code=visit.completion()),
            words.WITHDRAWAL.format(code=visit.code),
        ]


_TYPE_NEXT = "Type next to go on."


def _answer(item: Scale | Question, word: str) -> int | str:
    if isinstance(item, Question):
        return word
    try:
        return read_rating(word)
    except ValueError as error:
        raise MisfitError(f"{error}, or skip") from error


def _lines(text: str) -> list[str]:
    return [visible(line) for line in text.splitlines() if line.strip()]

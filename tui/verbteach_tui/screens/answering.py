"""Answering the robot: single keys, words, typed lines, and what is picked from panels."""

from __future__ import annotations

from textual import events
from textual.widgets import Input

from verbteach.dialogue import acts
from verbteach.dialogue.moves import Phase
from verbteach_sessions.script import ScriptAct, parse_line, render
from verbteach_sessions.session_acts import Note
from verbteach_tui.keyguard import KeyGuard
from verbteach_tui.keys import word_of
from verbteach_tui.messages import ActPicked, LineTyped, PartToggled, StepChosen
from verbteach_tui.reading import lines_of
from verbteach_tui.screens.note import NoteScreen
from verbteach_tui.screens.speaking import SpeakingScreen
from verbteach_tui.teaching import Teaching
from verbteach_tui.typed_word import TypedWord
from verbteach_tui.widgets.command_input import CommandInput

_TYPING = "To answer in words, press Tab or / first."
_AHEAD = (Phase.COMMAND, Phase.DEMONSTRATION)
"""Where lines may be typed while the robot is still thinking about the last one."""
_STEERS = {Phase.JUDGEMENT: "ex"}
"""Letters that steer what is watched, and may come when it has just ended."""
_TELLING = 4.0  # seconds for which that stays in view


class AnsweringScreen(SpeakingScreen):
    """Turns what the person presses, types and picks into acts."""

    def __init__(self, teaching: Teaching) -> None:
        super().__init__(teaching)
        self.guard = KeyGuard()
        self._typed = ""
        self._ahead: list[str] = []
        self._told = float("-inf")
        self._word = TypedWord()
        self._due: ScriptAct | None = None
        self.keeps_line = self.dropped = False

    @property
    def typing(self) -> bool:
        """Whether the keys go into the line."""
        return isinstance(self.focused, Input)

    def on_key(self, event: events.Key) -> None:
        """A single key answers, unless it is part of a word being typed."""
        if self.typing:
            self._catch_up(event)
            return
        if event.key == "enter" and self.guard.ends(event.time):
            self._typed_elsewhere(event)
            return
        character = event.character
        if character is None or not event.is_printable:
            return
        own = character in getattr(self.focused, "OWN_KEYS", "")
        if self.guard.typing(character, event.time, repeats=own):
            self._typed_elsewhere(event)
            return
        self._word.forget()
        if own:
            return  # the widget in focus has that key for itself
        if self._answers(character):
            _consume(event)
            if self.guard.answers(event.time):
                self._say_key(character)
        elif character.isalpha() and character not in _STEERS.get(self.snapshot.phase, ""):
            _consume(event)  # no key: a line begins with it
            self.set_focus(self.query_one(CommandInput))
            self.query_one(CommandInput).insert_text_at_cursor(character)

    def _catch_up(self, event: events.Key) -> None:
        """A letter on its way elsewhere when the line got the focus comes after the one before."""
        if event.character is not None and event.is_printable:
            _consume(event)
            if not self.belongs_elsewhere(event):
                self.query_one(CommandInput).insert_text_at_cursor(event.character)

    def on_paste(self, event: events.Paste) -> None:
        """What is pasted where keys answer is meant for the line; nothing is said by it."""
        event.stop()
        line = self.query_one(CommandInput)
        line.focus()
        line.take_in(event.text)

    def _typed_elsewhere(self, event: events.Key) -> None:
        """Swallow a key that belongs to a word, or go on with it in the line.

        Say once a word where words go.
        """
        _consume(event)
        if event.character and event.is_printable and self._word.goes_beyond(event.character):
            self._into_the_line()
            return
        ended = event.key == "enter" or self.guard.swallowed == 2
        if ended and not self._word.text and event.time - self._told >= _TELLING:
            self._told = event.time
            self.notify(_TYPING, timeout=_TELLING)

    def _into_the_line(self) -> None:
        """A word is being typed: take back what its first letter said, and go on in the line."""
        text, self._due = self._word.end()
        line = self.query_one(CommandInput)
        self.set_focus(line)
        line.value = f"{line.value} {text}".lstrip()
        line.cursor_position = len(line.value)
        self.take_back()

    def belongs_elsewhere(self, event: events.Key) -> bool:
        """Whether a key that came to the line goes on with a word that began as an answer.

        The answer has led to the next command, whose line has the keys then. More
        than the answer's name is that next command already, unless the answer has
        dropped what was shown.
        """
        if not self._word.text or event.character is None or not event.is_printable:
            return False
        if not self.guard.goes_on(event.time):
            self._word.forget()
            return False
        if not self._word.goes_beyond(event.character):
            self.guard.typing(event.character, event.time)
            return True
        if self.dropped:
            self._into_the_line()
            return True
        self._word.forget()
        return False

    def nothing_said(self) -> None:
        """What was said last came to nothing: there is nothing of it to take back."""
        self._word.refused()
        self._due = None
        self.keeps_line = False

    def take_back(self) -> None:
        """Take back what the first letter of a word said, as soon as the robot has answered it.

        Until that is shown the line keeps the keys.
        """
        act = self._due
        if act is not None and not self.thinking:
            self._due = None
            self.say(act, render(act), "key")
        self.keeps_line = act is not None and self.thinking

    def _answers(self, character: str) -> bool:
        snapshot = self.snapshot
        return character in snapshot.choices or word_of(character, snapshot.phase) is not None

    def _say_key(self, character: str) -> None:
        thing = self.snapshot.choices.get(character)
        word = word_of(character, self.snapshot.phase) or ""
        if thing is not None:
            self.say(acts.Point(thing), character, "key")
        elif not self.thinking:
            self._word.begin(character, word)
            self._drop_from_line(character)
            self.say_word(word, character, "key")

    def _drop_from_line(self, character: str) -> None:
        """A key that was typed into the line before, and did nothing there, is said now."""
        line = self.query_one(CommandInput)
        if line.value == character:
            line.clear()

    def say_word(self, word: str, raw: str, via: str) -> None:
        """Say a word of the script; for a note, ask for its text first."""
        if word == Note.name:
            self.app.push_screen(NoteScreen(), self._note)
            return
        act = parse_line(word)
        if act is not None:
            self.say(act, raw, via)

    def _note(self, text: str | None) -> None:
        if text and text.strip():
            self.say(Note(text.strip()), text, "typed")

    def on_line_typed(self, message: LineTyped) -> None:
        """A line was typed; it leaves the input once it is on its way."""
        first, *more = lines_of(message.text, self.snapshot.phase)
        if self.thinking and self.snapshot.phase in _AHEAD:
            self._ahead += [first, *more]
            self.query_one(CommandInput).sent()
        elif self.say_line(first, "typed"):
            self._typed = first
            self._ahead += more
            self.query_one(CommandInput).sent()

    def say_what_was_typed_ahead(self, before: Phase) -> None:
        """Say the next line typed while the robot was thinking in the phase ``before``.

        Only where it still waits for the same, and took the last line: nobody answers a question
        that was not seen. Otherwise the lines go back into the input.
        """
        if not self._ahead:
            return
        same = self.snapshot.phase is before and not self.snapshot.problem
        if same and self.say_line(self._ahead[0], "typed"):
            self._typed = self._ahead.pop(0)
        else:
            self.give_back("")

    def give_back(self, raw: str) -> None:
        """Typed lines that came to nothing go back into the input."""
        back = [raw] if raw and raw == self._typed else []
        back, self._ahead = [*back, *self._ahead], []
        if back:
            self.query_one(CommandInput).give_back(", ".join(back))

    def on_step_chosen(self, message: StepChosen) -> None:
        """An action was picked from the lists."""
        act = self.meant(acts.Do(message.action))
        self.say(act, render(act), "picked")

    def on_act_picked(self, message: ActPicked) -> None:
        """An act was picked from a panel."""
        self.say(message.act, render(message.act), "picked")

    def on_part_toggled(self, message: PartToggled) -> None:
        """A part of the goal was struck or kept."""
        act = acts.Keep(message.literal) if message.keep else acts.Strike(message.literal)
        self.say(act, render(act), "picked")


def _consume(event: events.Key) -> None:
    event.stop()
    event.prevent_default()

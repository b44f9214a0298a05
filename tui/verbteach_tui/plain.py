"""The plain mode: the same session as append-only lines, for screen readers, pipes and scripts."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Iterable, Iterator
from contextlib import suppress
from shutil import get_terminal_size
from textwrap import wrap
from typing import TYPE_CHECKING, Protocol, TextIO

from verbteach_tui.views.visible import visible

if TYPE_CHECKING:
    from prompt_toolkit import PromptSession

    from verbteach_sessions.session import Session

DONE, WRONG = 0, 2
_COMMAND = "verbteach "
NOTE = "Note: type help for what you can say, look for what is in the room."


class Conversation(Protocol):
    """What can be led in lines: a session, or a study with sessions in it."""

    @property
    def ended(self) -> bool:
        """Whether the person has left."""
        ...

    def opening(self) -> list[str]:
        """What stands at the beginning."""
        ...

    def hear(self, line: str, via: str) -> list[str]:
        """Take a line; answer with the lines to print. Raises ``MisfitError``."""
        ...

    def complete(self, text: str) -> list[str]:
        """What ``text`` may become."""
        ...


def run_plain(session: Session, input: TextIO | None = None, output: TextIO | None = None) -> int:
    """Lead ``session`` through lines read from ``input`` until it ends or they do.

    Without ``input`` it reads the keyboard through prompt-toolkit where standard
    input is a terminal, and standard input line by line where it is not. Lines
    go to ``output`` (standard output). Answers 0, or 2 where a line from a file
    or pipe did not fit; at the keyboard such a line is explained and read again.
    The session is left open: the caller closes it and prints its summary.
    """
    from verbteach_tui.plain_talk import Talk

    return lead(Talk(session), input, output)


def lead(
    talk: Conversation,
    input: TextIO | None = None,
    output: TextIO | None = None,
    note: str = NOTE,
    patient: bool = False,
) -> int:
    """Lead any conversation as :func:`run_plain` leads a session; the exit status.

    ``note`` is said first to a person at the keyboard. ``patient``: a person may
    be at the other end of a pipe too, so that a line that does not fit ends
    nothing; it is reported all the same, and by the status in the end.
    """
    out = output or sys.stdout
    _print(out, talk.opening())
    if input is None and sys.stdin.isatty():
        return _at_the_keyboard(talk, out, note)
    return _from_lines(talk, out, input or _lenient(sys.stdin), patient)


def _from_lines(
    talk: Conversation, out: TextIO, lines: Iterable[str], patient: bool = False
) -> int:
    """Read lines to their end; one that does not fit is reported, and the first one ends it.

    Where it is ``patient`` it goes on, and leaves in the end as from the keyboard.
    """
    from verbteach_tui.plain_talk import MisfitError

    status = DONE
    for number, line in enumerate(lines, 1):
        text = line.strip()
        if not text or text.startswith("#"):
            continue
        _print(out, [f"You: {visible(text)}"])
        try:
            _print(out, talk.hear(line, "pipe"))
        except MisfitError as error:
            reason = f"verbteach: line {number}: '{visible(text[:80])}': {visible(str(error))}"
            print(reason, file=sys.stderr)
            status = WRONG
            if not patient:
                return status
            _print(out, [f"Note: {visible(str(error))}."])
        if talk.ended:
            return status
    if patient:
        _leave(talk, out)
    return status


def _leave(talk: Conversation, out: TextIO) -> None:
    """There is nothing more to read: the person has gone."""
    from verbteach_tui.plain_talk import MisfitError

    with suppress(MisfitError):
        _print(out, talk.hear("quit", "key"))


def _at_the_keyboard(talk: Conversation, out: TextIO, note: str) -> int:
    """Read the keyboard until the person leaves, by ``quit`` or Ctrl-D.

    The person's own short keys count here; a file or a pipe has the default ones.
    """
    from verbteach_tui.keymap import keys_file, read_keymap
    from verbteach_tui.keys import choose_keys
    from verbteach_tui.plain_talk import MisfitError

    choose_keys(read_keymap(keys_file()).said)
    _print(out, [note] if note else [])
    ask = _prompt(talk, out)
    while not talk.ended:
        try:
            _print(out, talk.hear(ask("You: "), "typed"))
        except MisfitError as error:
            _print(out, [f"Note: {visible(str(error))}."])
        except KeyboardInterrupt:
            _print(out, ["Note: type quit, or press Ctrl-D, to leave."])
        except EOFError:
            _leave(talk, out)
            break
    return DONE


def _prompt(talk: Conversation, out: TextIO) -> Callable[[str], str]:
    """A line editor with a history; Tab lists completions below the line, as in a shell."""
    from prompt_toolkit import PromptSession
    from prompt_toolkit.completion import Completer, Completion
    from prompt_toolkit.output import create_output
    from prompt_toolkit.shortcuts import CompleteStyle

    class Steps(Completer):
        def get_completions(self, document: object, complete_event: object) -> Iterator[Completion]:
            text: str = getattr(document, "text_before_cursor", "")
            for found in talk.complete(text):
                yield Completion(found, start_position=-len(text))

    # Asking the terminal where its cursor is would only make a screen reader speak.
    os.environ.setdefault("PROMPT_TOOLKIT_NO_CPR", "1")
    editor: PromptSession[str] = PromptSession(
        completer=Steps(),
        complete_while_typing=False,
        complete_style=CompleteStyle.READLINE_LIKE,
        output=create_output(stdout=out),
    )
    return editor.prompt


def _print(out: TextIO, lines: Iterable[str]) -> None:
    for line in lines:
        print(as_rows(line) if out.isatty() else line, file=out, flush=True)


def as_rows(line: str) -> str:
    """The line as a terminal's rows: it would break within words, and readers speak by the row.

    A command stays whole, or else it could not be copied.
    """
    if line.startswith(_COMMAND):
        return line
    width = max(get_terminal_size().columns - 1, 20)
    rows = wrap(line, width, break_long_words=False, break_on_hyphens=False)
    return "\n".join(rows)


def _lenient(stream: TextIO) -> TextIO:
    """Standard input that takes any bytes; what is no text comes out as a replacement sign."""
    reconfigure = getattr(stream, "reconfigure", None)
    if reconfigure is not None:
        reconfigure(errors="replace")
    return stream

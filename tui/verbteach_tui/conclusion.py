"""How a command ends: its exit status, and one line on standard error where the input was wrong.

Wrong input is told from a bug by the type of the error. This file knows every
such type of the rooms below, and imports them only once something went wrong.
"""

from __future__ import annotations

import sys

from verbteach_tui.standard_streams import discard_output
from verbteach_tui.views.visible import shortened

TYPE_CHECKING = False  # typing would take a tenth of what `--version` may take
if TYPE_CHECKING:
    from collections.abc import Callable

DONE = 0
CHECK_FAILED = 1
WRONG_USE = 2
BUG = 70  # EX_SOFTWARE of sysexits.h: neither the person's doing nor a failed check
INTERRUPTED = 130
UNREAD = 141  # what a shell says of a program that wrote into a pipe nobody reads


class WrongUseError(Exception):
    """What the person asked for cannot be; the message is the one line that says why."""


def concluded(command: Callable[[], int | None], name: str = "verbteach") -> int:
    """Run ``command`` and answer the exit status; say on standard error what was wrong, if so."""
    status = _status(command, name)
    if status == INTERRUPTED:
        _forget_the_interrupt()
    return status


def _forget_the_interrupt() -> None:
    """Let this process end with its status rather than by the signal.

    A Ctrl-C that lands in code compiled from text (a dataclass being made by an import) leaves
    a mark in the interpreter, handled or not, which then ends itself by SIGINT whatever status
    it was given. Running any text takes the mark away.
    """
    exec("")


def _status(command: Callable[[], int | None], name: str) -> int:
    try:
        status = command() or DONE
        _write_out()
        return status
    except KeyboardInterrupt:
        complain(name, "interrupted")
        return INTERRUPTED
    except BrokenPipeError:
        discard_output()
        return UNREAD
    except Exception as error:
        message = complaint(error)
        if message is not None:
            complain(name, message)
            return WRONG_USE
        import traceback  # which takes longer to import than `--version` may take as a whole

        traceback.print_exc()
        complain(name, "this is a bug in verbteach; please report the lines above")
        return BUG


def _write_out() -> None:
    """Write what is still held back, while the status can say that it cannot be written."""
    try:
        sys.stdout.flush()
    except BrokenPipeError:
        raise
    except OSError as error:
        discard_output()
        raise WrongUseError(f"standard output: {error.strerror}") from error


def complain(name: str, message: str) -> None:
    """Print ``message`` as one line on standard error, if anybody reads that."""
    try:
        print(f"{name}: {shortened(' '.join(message.split()))}", file=sys.stderr)
    except BrokenPipeError:
        return  # the status says it


def complaint(error: Exception) -> str | None:
    """The line that says what was wrong with the input; ``None`` where the error is a bug."""
    if isinstance(error, WrongUseError):
        return str(error)
    if isinstance(error, OSError):
        return _of_file(error)
    if isinstance(error, _wrong_input()):
        return str(error.args[0]) if isinstance(error, LookupError) and error.args else str(error)
    return None


def _of_file(error: OSError) -> str:
    what = error.strerror or type(error).__name__
    return f"{error.filename}: {what}" if error.filename is not None else what


def _wrong_input() -> tuple[type[Exception], ...]:
    from verbteach.dialogue.moves import IllegalMoveError
    from verbteach.dialogue.setting import UnknownObjectError, UnknownSceneError
    from verbteach.language.agreement import NoSecondReaderError
    from verbteach.world.fluents import FluentSyntaxError
    from verbteach_scenarios.errors import WorldFileError
    from verbteach_sessions.errors import SessionError

    return (
        FluentSyntaxError,
        IllegalMoveError,
        NoSecondReaderError,
        SessionError,
        UnknownObjectError,
        UnknownSceneError,
        WorldFileError,
    )

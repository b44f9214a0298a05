"""The plain mode: the same words and events in lines, from a pipe and from the keyboard."""

from __future__ import annotations

import io
import os
import pty
import select
import subprocess
import sys
import time
from contextlib import suppress
from pathlib import Path

import pytest

from tests.tui.commandline import LONGEST
from tests.tui.room import OPEN_THE_FRIDGE, SETTINGS
from tests.tui.strategies import NASTY
from verbteach.world.fluents import Fluent, Goal
from verbteach_sessions.header import Header
from verbteach_sessions.session import Session
from verbteach_tui.plain import run_plain
from verbteach_tui.plain_talk import MisfitError, Talk

LESSON = ("open the fridge", *OPEN_THE_FRIDGE, "done", "yes")


def begin(folder: Path, scene: str = "kitchen-1") -> Session:
    return Session.create(folder, Header.new(scene, interface="plain"), SETTINGS)


def talk(session: Session, *lines: str) -> tuple[int, list[str]]:
    """What comes of piping ``lines`` into ``session``: the status and the lines printed."""
    out = io.StringIO()
    status = run_plain(session, io.StringIO("".join(f"{line}\n" for line in lines)), out)
    return status, out.getvalue().splitlines()


def test_a_verb_is_taught_and_carried_out_elsewhere(tmp_path: Path) -> None:
    with begin(tmp_path) as session:
        status, printed = talk(session, *LESSON, "scene: kitchen-2", "open the fridge", "g")
        assert status == 0
        assert session.robot.state.totals.successes == 1
        assert Fluent("open", ("Fridge_1",)) in session.robot.state.world
    assert printed[0].startswith("Robot: I am in")
    assert "You: open the fridge" in printed
    assert 'Robot: I have learned "open".' in printed
    steps = printed.index("The robot does:")
    assert printed[steps + 1 : steps + 3] == ["1. go to the fridge", "2. open the fridge"]


def test_every_line_is_said_by_someone_or_is_a_choice(tmp_path: Path) -> None:
    with begin(tmp_path) as session:
        _, printed = talk(session, *LESSON, "undo", "redo", "flag", "why", "quit")
    speakers = ("Robot: ", "You: ", "Note: ", "The robot does:")
    assert all(line.startswith(speakers) or line[0].isdigit() for line in printed)
    assert all(line.isprintable() for line in printed)


def test_a_step_is_picked_by_numbers(tmp_path: Path) -> None:
    with begin(tmp_path) as session:
        _, listed = talk(session, "open the fridge", "steps")
        assert listed[-3:-1] == ["1. go to …", "2. wait"]
        assert listed[-1].startswith("And ")
        _, objects = talk(session, "steps", "1")
        number = next(line.split(".")[0] for line in objects if line.endswith(". fridge"))
        _, done = talk(session, "steps", "1", number)
        assert done[-1].startswith("Robot: I see: go to the fridge")


@pytest.mark.parametrize("said", ["fridge", "The fridge.", "Fridge_1"])
def test_what_is_offered_for_a_step_may_be_called_by_its_name(tmp_path: Path, said: str) -> None:
    with begin(tmp_path) as session:
        _, done = talk(session, "open the fridge", "steps", "1", said)
        assert done[-1].startswith("Robot: I see: go to the fridge")
        _, begun = talk(session, "steps", said)
        assert "I see:" not in begun[-1]


def test_parts_of_a_goal_are_struck_and_kept_by_numbers(tmp_path: Path) -> None:
    with begin(tmp_path) as session:
        _, printed = talk(session, *LESSON[:-1])
        goal = read_back_goal(session)
        kept = next(line for line in printed[::-1] if "must" in line and line[0].isdigit())
        number = kept.split(".")[0]
        _, struck = talk(session, number)
        assert any(line.startswith(f"{number}. need not") for line in struck)
        talk(session, number)
        assert read_back_goal(session) == goal


def read_back_goal(session: Session) -> Goal:
    episode = session.robot.state.episode
    assert episode is not None
    assert episode.read_back is not None
    return episode.read_back.goal


def test_looking_round_names_everything_and_leaves_no_record(tmp_path: Path) -> None:
    with begin(tmp_path) as session:
        before = session.content_hash
        _, printed = talk(session, "look", "mind", "verbs", "help")
        assert session.content_hash == before
    text = "\n".join(printed)
    assert "A family kitchen in the morning." in text
    assert "fridge (shut): in it milk carton (cold)" in text
    assert "The robot knows no verb yet." in text


def test_a_line_that_does_not_fit_ends_a_pipe_with_its_number(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    with begin(tmp_path) as session:
        status, printed = talk(session, "# a remark", "", "open the fridge", "good", "done")
        assert status == 2
        assert session.turn.phase.value == "demonstration", "what was said before is kept"
    assert "line 4: 'good'" in capsys.readouterr().err
    assert printed[-1] == "You: good"


@pytest.mark.parametrize("number", ["0", "99", "9" * 30])
def test_a_number_that_is_no_choice_is_explained(
    tmp_path: Path, number: str, capsys: pytest.CaptureFixture[str]
) -> None:
    with begin(tmp_path) as session:
        talk(session, *LESSON[:-1])
        status, _ = talk(session, number)
    assert status == 2
    assert "no part" in capsys.readouterr().err


def test_a_number_beyond_the_choices_is_explained_and_answers_nothing(tmp_path: Path) -> None:
    with begin(tmp_path) as session:
        conversation = Talk(session)
        conversation.hear("wash the mug", "typed")
        with pytest.raises(MisfitError, match="no choice 9"):
            conversation.hear("9", "typed")
        assert session.robot.state.totals.questions == 1


def test_help_says_how_to_begin_how_to_show_and_what_a_price_is(tmp_path: Path) -> None:
    with begin(tmp_path) as session:
        conversation = Talk(session)
        assert "it asks you to show it" in conversation.hear("Help", "typed")[0]
        conversation.hear("wash the mug", "typed")
        assert "price" in conversation.hear("help", "typed")[0]
        conversation.hear("skip", "typed")
        assert "in your own words" in conversation.hear("help", "typed")[0]


def test_what_belongs_to_showing_is_refused_elsewhere_in_plain_words(tmp_path: Path) -> None:
    with begin(tmp_path) as session:
        for word in ("steps", "shown"):
            with pytest.raises(MisfitError, match="only while you show"):
                Talk(session).hear(word, "typed")


def test_nasty_texts_print_as_themselves(tmp_path: Path) -> None:
    texts = [text for text in NASTY if text.strip() and "\n" not in text and "\r" not in text]
    with begin(tmp_path) as session:
        for text in texts:
            status, printed = talk(session, text)
            assert status == 0
            assert all(line.isprintable() for line in printed)
            if session.turn.phase.value != "command":
                talk(session, "skip")


def child(folder: Path) -> str:
    """A program that teaches in plain lines from its own standard input."""
    return f"""
from pathlib import Path
from verbteach_scenarios.settings import make_settings
from verbteach_sessions.header import Header
from verbteach_sessions.session import Session
from verbteach_tui.plain import run_plain
from verbteach_tui.plain_talk import MisfitError, Talk
settings = make_settings()
header = Header.new("kitchen-1", interface="plain")
with Session.create(Path({str(folder)!r}), header, settings) as session:
    status = run_plain(session)
    print("ended", session.ended, session.robot.state.knowledge.verbs)
raise SystemExit(status)
"""


def test_standard_input_may_hold_any_bytes(tmp_path: Path) -> None:
    ran = subprocess.run(
        [sys.executable, "-c", child(tmp_path)],
        input=b"open \xff\xfe the \x00 fridge\nskip\n",
        capture_output=True,
        timeout=LONGEST,
        check=False,
    )
    assert b"Robot:" in ran.stdout
    assert b"\xff" not in ran.stdout
    assert b"Traceback" not in ran.stderr


TYPED = (
    ("open the fridge", "show me an example?"),
    ("good", "the robot waits to be shown"),
    ("go to the fridge", "I see: go to the fridge"),
    ("open the fridge", "I see: open the fridge"),
    ("d", "Right?"),
    ("y", "What should I do next?"),
)


def test_at_the_keyboard_a_mistake_is_explained_and_ctrl_d_leaves(tmp_path: Path) -> None:
    ours, theirs = pty.openpty()
    process = subprocess.Popen(
        [sys.executable, "-c", child(tmp_path)],
        stdin=theirs,
        stdout=theirs,
        stderr=theirs,
        env={**os.environ, "TERM": "xterm", "COLUMNS": "100", "LINES": "40"},
        close_fds=True,
    )
    os.close(theirs)
    keyboard = Keyboard(ours)
    keyboard.expect("Note: type help")
    for line, answer in TYPED:
        keyboard.expect("You:")
        keyboard.type(f"{line}\r")
        keyboard.expect(answer)  # the line may be drawn again before, sign and all
    keyboard.expect("You:")
    keyboard.type("\x04")
    seen = keyboard.expect("ended")
    assert process.wait(timeout=LONGEST) == 0
    assert "Note: 'good' does not fit: the robot waits to be shown" in keyboard.seen
    assert 'I have learned "open"' in keyboard.seen
    assert "ended True ('open',)" in seen + keyboard.rest()


class Keyboard:
    """The person's side of a pseudo-terminal."""

    def __init__(self, descriptor: int) -> None:
        self._descriptor = descriptor
        self._unread = ""
        self.seen = ""

    def type(self, text: str) -> None:
        """Type ``text``."""
        os.write(self._descriptor, text.encode())

    def expect(self, text: str, seconds: float = LONGEST) -> str:
        """Read until ``text`` has come; answer with what came."""
        end = time.monotonic() + seconds
        while text not in self._unread:
            assert time.monotonic() < end, self.seen
            self._read()
        before, _, self._unread = self._unread.partition(text)
        return before + text

    def rest(self) -> str:
        """Read to the end."""
        with suppress(OSError):  # the other side has gone
            while "('open',)" not in self._unread:
                self._read()
        return self._unread

    def _read(self) -> None:
        ready, _, _ = select.select([self._descriptor], [], [], 1)
        if not ready:
            return
        got = os.read(self._descriptor, 65536).decode(errors="replace")
        self._unread += got
        self.seen += got


def test_steps_and_the_end_of_the_demonstration_may_be_one_line(tmp_path: Path) -> None:
    with begin(tmp_path) as session:
        talk = Talk(session)
        talk.hear("open the fridge", "typed")
        talk.hear("fly to the moon, done", "typed")
        assert session.turn.phase.value == "demonstration", "what went before was not understood"
        said = talk.hear("go to the fridge, open it, done", "typed")
        assert session.turn.phase.value == "read_back"
        assert "the fridge must be open" in "\n".join(said)

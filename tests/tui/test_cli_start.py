"""The way in: version, help, home without a terminal, wrong use, completion, bugs."""

from __future__ import annotations

import os
import shlex
import subprocess
import sys
from pathlib import Path
from unittest.mock import patch

import pytest

from tests.tui.commandline import assert_refused, here, process
from tests.tui.test_cli_contract import commands, options_of
from verbteach import __version__
from verbteach_tui.cli import COMPLETION_VARIABLE
from verbteach_tui.commands.examples import EXAMPLES
from verbteach_tui.conclusion import BUG, INTERRUPTED, UNREAD, concluded
from verbteach_tui.terminal import has_terminal


def test_version_alone_and_beside_other_words_say_the_same() -> None:
    assert here("--version").out == f"verbteach {__version__}\n"
    assert here("--version", "doctor").out == f"verbteach {__version__}\n"


def test_version_imports_nothing_that_costs_time() -> None:
    code = (
        "import sys; from verbteach_tui.cli import main; main(['--version']);"
        "print(sorted({m.split('.')[0] for m in sys.modules}))"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    for heavy in ("typer", "numpy", "textual", "rich", "prompt_toolkit", "pddl", "argparse"):
        assert f"'{heavy}'" not in done.stdout


def test_the_tree_of_commands_loads_nothing_heavy() -> None:
    code = (
        "import sys; from verbteach_tui.commands.tree import build; build();"
        "print(sorted({m.split('.')[0] for m in sys.modules}))"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    for heavy in ("numpy", "textual", "rich", "prompt_toolkit", "pddl", "joblib"):
        assert f"'{heavy}'" not in done.stdout


def test_without_a_terminal_home_says_how_to_go_on() -> None:
    assert_refused(here(), "terminal", "verbteach teach --plain")
    assert_refused(process(), "terminal", "verbteach teach --plain")


@pytest.mark.parametrize(("kind", "shown"), [("xterm", True), ("dumb", False), (None, False)])
def test_a_terminal_of_no_kind_shows_no_screen(
    kind: str | None, shown: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    ours, theirs = os.openpty()
    if kind is None:
        monkeypatch.delenv("TERM", raising=False)
    else:
        monkeypatch.setenv("TERM", kind)
    with os.fdopen(ours), os.fdopen(theirs) as terminal:
        monkeypatch.setattr("sys.stdin", terminal)
        monkeypatch.setattr("sys.stdout", terminal)
        assert has_terminal() == shown


@pytest.mark.parametrize("name", ["", *EXAMPLES])
def test_help_is_plain_text_with_examples(name: str) -> None:
    ran = here(*name.split()[1:], "--help")
    assert ran.status == 0
    assert "Examples:" in ran.out
    assert "\x1b" not in ran.out
    listed = [line for line in ran.out.splitlines() if line.startswith("  ")]
    assert not any(line.endswith("...") for line in listed), "a summary is cut short"


@pytest.mark.parametrize(
    ("line", "status", "out", "err"),
    [
        ("verbteach <&-", 2, "", "a terminal"),
        ("verbteach doctor --json >&-", 0, "", ""),
        ("verbteach scenes list --nothing 2>&-", 2, "", ""),
        ("(verbteach lessons list; echo $? >&2) | true", 0, "", f"{UNREAD}\n"),
        ('PYTHONIOENCODING=ascii verbteach parse "wash the caf\u00e9" --json', 0, "caf\\u00e9", ""),
    ],
)
def test_streams_may_be_closed_unread_or_of_an_old_encoding(
    line: str, status: int, out: str, err: str
) -> None:
    shell = f'verbteach() {{ "{sys.executable}" -m verbteach_tui "$@"; }}; {line}'
    done = subprocess.run(["sh", "-c", shell], capture_output=True, text=True, check=False)
    assert done.returncode == status
    assert "Traceback" not in done.stderr
    assert out in done.stdout
    assert err in done.stderr


def test_an_unknown_command_is_offered_a_near_one() -> None:
    assert_refused(here("doctr"), "doctr", "doctor", "--help")


def test_a_command_of_a_group_is_found_without_it() -> None:
    assert_refused(here("export", "x"), "Did you mean 'sessions export'?")
    assert_refused(here("check"), "'scenes check', 'lessons check'", "'study check'")
    assert "mean" not in here("sessions", "teach").err


def test_an_unknown_option_is_offered_a_near_one() -> None:
    assert_refused(here("doctor", "--jsn"), "--jsn", "--json", "verbteach doctor --help")


def test_what_the_person_typed_cannot_act_on_the_terminal() -> None:
    ran = here("\x1b[31mdoctor\nagain")
    assert_refused(ran)
    assert "\x1b" not in ran.err


@pytest.mark.parametrize(
    ("typed", "offered"),
    [
        ("verbteach doc", ["doctor"]),
        ("verbteach scenes s", ["show"]),
        ("verbteach scenes show living-room-", [f"living-room-{n}" for n in range(1, 7)]),
        ("verbteach teach --scene kitchen-4", ["kitchen-4"]),
        ("verbteach replay --ver", ["--verify"]),
    ],
)
def test_a_shell_gets_completions(typed: str, offered: list[str]) -> None:
    asked = {
        COMPLETION_VARIABLE: "complete_bash",
        "COMP_WORDS": typed,
        "COMP_CWORD": str(len(typed.split()) - 1),
    }
    done = subprocess.run(
        [sys.executable, "-m", "verbteach_tui"],
        capture_output=True,
        text=True,
        check=False,
        env={**os.environ, **asked},
    )
    assert done.stdout.split() == offered


def test_a_bug_shows_its_traceback_and_an_own_status() -> None:
    def broken() -> int:
        raise ZeroDivisionError("nothing to divide by")

    with patch("sys.stderr") as err:
        assert concluded(broken) == BUG
    said = "".join(call.args[0] for call in err.write.call_args_list)
    assert "nothing to divide by" in said
    assert "bug" in said


def test_an_interrupt_is_not_a_bug() -> None:
    def interrupted() -> int:
        raise KeyboardInterrupt

    assert concluded(interrupted) == INTERRUPTED


def test_an_interrupt_in_code_made_from_text_ends_by_its_status_too(tmp_path: Path) -> None:
    """The interpreter would end such a process by the signal; only as `python -m` does it show."""
    (tmp_path / "interrupted.py").write_text(
        "import signal, sys\n"
        "from verbteach_tui.conclusion import concluded\n"
        "raising = 'signal.raise_signal(signal.SIGINT)'\n"
        "sys.exit(concluded(lambda: exec(raising, {'signal': signal})))\n",
        encoding="utf-8",
    )
    done = subprocess.run([sys.executable, "-m", "interrupted"], cwd=tmp_path, check=False)
    assert done.returncode == INTERRUPTED


@pytest.mark.parametrize("name", EXAMPLES)
def test_examples_name_commands_and_options_that_there_are(name: str) -> None:
    groups = {path.rpartition(" ")[0] for path in EXAMPLES}
    there = {f"verbteach {path}": options_of(command) for path, command in commands()}
    there["verbteach"] = set()
    for line in EXAMPLES[name]:
        words = shlex.split(line)
        command = max((path for path in there if line.startswith(path)), key=len)
        assert command.startswith(name) or name in groups
        used = {word for word in words if word.startswith("--")}
        assert used <= there[command], line

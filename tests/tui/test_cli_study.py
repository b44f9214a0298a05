"""`verbteach study` and `verbteach serve`, without a server."""

from __future__ import annotations

import csv
import io
import stat
from pathlib import Path

import pytest

from tests.study.files import SMALL
from tests.tui.commandline import assert_refused, here
from tests.tui.study.led import WHOLE, study_file
from verbteach_tui.commands.serve import is_local
from verbteach_tui.web.tokens import (
    Door,
    UnknownTokenError,
    UsedTokenError,
    read_tokens,
)
from verbteach_tui.web.visits import Visits


def test_a_new_study_fits_and_is_never_written_over(tmp_path: Path) -> None:
    made = here("study", "new", tmp_path / "mine", "--json").document["file"]
    checked = here("study", "check", made, "--json").document
    assert checked["valid"]
    assert checked["study"]["conditions"] == ["showing", "asking"]
    assert Path(made).read_text().count("#") > 20
    assert_refused(here("study", "new", tmp_path / "mine"), "study.toml", "there already")


def test_a_study_that_does_not_fit_fails_the_check_with_lines(tmp_path: Path) -> None:
    file = study_file(tmp_path, SMALL.replace('"she16"', '"x"').replace("seed = 7", "seeds = 7"))
    ran = here("study", "check", file)
    assert ran.status == 1
    assert [line.split(":")[1] for line in ran.out.splitlines()] == ["5", "26"]
    document = here("study", "check", file, "--json").document
    assert not document["valid"]
    assert [problem["line"] for problem in document["problems"]] == [5, 26]
    assert_refused(here("study", "check", tmp_path / "none.toml"), "No such file")
    assert_refused(here("teach", "--study", file), f"{file}:5", "study check")


def test_noise_of_a_kind_that_is_nowhere_is_found_before_anybody_comes(tmp_path: Path) -> None:
    noise = 'policy = "she16"\nnoise = "0.2,onn=perfect"'
    file = study_file(tmp_path, SMALL.replace('policy = "she16"', noise))
    (problem,) = here("study", "check", file, "--json").document["problems"]
    assert problem["line"] == 27
    assert "'onn'" in problem["message"]
    assert_refused(here("teach", "--study", file), f"{file}:27", "onn")
    file.write_text(file.read_text().replace("onn=", "on="))
    assert here("study", "check", file).status == 0


def test_a_participant_by_the_command_line_status_and_answers(tmp_path: Path) -> None:
    file, records = study_file(tmp_path), tmp_path / "records"
    words = ("--study", file, "--sessions", records, "--participant", "pppp")
    ran = here("teach", *words, typed=WHOLE)
    assert ran.status == 0, ran
    assert "completion code" in ran.out
    document = here("study", "status", file, "--sessions", records, "--json").document
    (row,) = document["participants"]
    assert (row["participant"], row["finished"], row["slot"]) == ("pppp", True, 0)
    assert sum(one["given"] for one in document["balance"]) == 1
    shown = here("study", "status", file, "--sessions", records).out
    assert "finished" in shown
    table = list(csv.DictReader(io.StringIO(here("study", "answers", "--sessions", records).out)))
    assert [one["step"] for one in table] == ["practice", "lessons"]
    assert table[1]["answer_effort"] == "100"
    assert table[1]["answer_temporal_demand"] == ""
    assert table[1]["why"] == "tasks"
    written = tmp_path / "answers.csv"
    both = here("study", "answers", "--sessions", records, "--out", written, "--json").document
    assert len(both["rows"]) == len(written.read_text("utf-8").splitlines()) - 1
    assert here("sessions", "validate", records / "pppp").status == 0


def test_a_line_that_does_not_fit_ends_no_study(tmp_path: Path) -> None:
    said = "maybe\nyes\nnext\nopen the fridge\nobject:\nend\nobject:\nlook\n"
    words = ("--study", study_file(tmp_path), "--sessions", tmp_path / "r", "--participant", "p1")
    ran = here("teach", *words, typed=said)
    assert ran.status == 2
    assert "Note: type yes or no." in ran.out
    named = [line.split(":")[1].strip() for line in ran.err.splitlines()]
    assert named == ["line 1", "line 5", "line 7"]
    assert f"--participant p1 --sessions {tmp_path / 'r'}" in ran.out.splitlines()[-1]
    assert here("sessions", "validate", tmp_path / "r" / "p1").status == 0


def test_a_formula_in_an_answer_is_a_text_in_the_table(tmp_path: Path) -> None:
    said = WHOLE.replace("nothing more", "=1+1")
    words = ("--study", study_file(tmp_path), "--sessions", tmp_path / "r", "--participant", "p1")
    assert here("teach", *words, typed=said).status == 0
    assert "'=1+1" in here("study", "answers", "--sessions", tmp_path / "r").out


@pytest.mark.parametrize(
    "words", [("--scene", "kitchen-1"), ("--policy", "rl"), ("--seed", "1"), ("--teacher", "-")]
)
def test_what_the_study_says_cannot_be_said_beside_it(tmp_path: Path, words: list[str]) -> None:
    assert_refused(here("teach", "--study", study_file(tmp_path), *words), words[0], "study")


# ---- the door


def test_tokens_are_random_private_and_read_back(tmp_path: Path) -> None:
    file = tmp_path / "tokens.txt"
    assert here("study", "tokens", file, "--count", "5", "--json").document["tokens"] == 5
    assert len(read_tokens(file)) == 5
    assert stat.S_IMODE(file.stat().st_mode) == 0o600
    assert_refused(here("study", "tokens", file), "there already")


def test_a_token_lets_one_browser_in_and_that_one_again() -> None:
    door = Door(Path("nowhere"), frozenset({"a-token-1", "b-token-2"}))
    first = door.enter("a-token-1", "")
    assert door.enter("a-token-1", first.secret).code == first.code
    assert door.enter("", first.secret).code == first.code
    with pytest.raises(UsedTokenError):
        door.enter("a-token-1", "")
    second = door.enter("b-token-2", "")
    assert second.code != first.code
    with pytest.raises(UsedTokenError):
        door.enter("b-token-2", first.secret)
    for token in ("", "a-token-", "a-token-1 ", "é" * 9, "x" * 5000):
        with pytest.raises(UnknownTokenError):
            door.enter(token, "no-such-secret")


def test_who_has_been_here_is_known_after_the_server_was_started_anew(tmp_path: Path) -> None:
    tokens = frozenset({"a-token-1"})
    first = Door(tmp_path, tokens).enter("a-token-1", "")
    (tmp_path / first.code).mkdir()
    first.ticket.write(tmp_path / first.code)
    again = Door(tmp_path, tokens)
    assert again.enter("", first.secret).code == first.code
    with pytest.raises(UsedTokenError):
        again.enter("a-token-1", "")
    kept = "".join(path.read_text() for path in (tmp_path / first.code).iterdir())
    assert "a-token-1" not in kept
    assert first.secret not in kept


def test_without_tokens_everybody_is_somebody_else() -> None:
    door = Door(Path("nowhere"))
    first, second = door.enter("", ""), door.enter("", "")
    assert first.code != second.code
    assert door.enter("", second.secret).code == second.code


def test_a_visitor_gets_a_folder_of_their_own_and_a_study_none_before_consent(
    tmp_path: Path,
) -> None:
    visitor = Door(tmp_path).enter("", "")
    command = Visits(tmp_path / "a b", tmp_path / "study; rm.toml").command(visitor)
    assert not (tmp_path / "a b").exists()
    assert "'" in command
    plain = Visits(tmp_path / "records").command(visitor)
    assert str(tmp_path / "records" / visitor.code) in plain
    assert (tmp_path / "records" / visitor.code).is_dir()


def test_serving_to_others_needs_tokens(tmp_path: Path) -> None:
    assert_refused(here("serve", "--host", "0.0.0.0"), "--tokens")
    empty = tmp_path / "tokens.txt"
    empty.write_text("# none yet\n")
    assert_refused(here("serve", "--tokens", empty), "no token")
    empty.write_text("short\n")
    assert_refused(here("serve", "--tokens", empty), f"{empty}:1")
    assert_refused(here("serve", "--study", tmp_path / "none.toml"), "No such file")
    assert_refused(here("serve", "--sessions", empty / "below"), "cannot be kept there")
    assert_refused(here("serve", "--scenes", tmp_path / "none"), "none")
    assert [
        is_local(h) for h in ("127.0.0.1", "::1", "localhost", "192.168.0.1", "example.org")
    ] == [*(True, True, True, False, False)]


def test_who_pauses_is_told_how_to_come_back_to_the_same_records(tmp_path: Path) -> None:
    file, records = study_file(tmp_path), tmp_path / "my records"
    words = ("--study", file, "--sessions", records, "--participant", "pppp")
    ran = here("teach", *words, typed="yes\nquit\n")
    assert f"--participant pppp --sessions '{records}'" in ran.out

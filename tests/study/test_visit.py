"""A participant's way: nothing before consent, one place each, and back to where it was left."""

from __future__ import annotations

import multiprocessing
import stat
from collections import Counter
from datetime import UTC, datetime, timedelta
from pathlib import Path

import pytest

from tests.study.files import SCENES, SMALL, study
from verbteach_sessions.errors import DamagedLogError, SessionInUseError, UnsafeNameError
from verbteach_sessions.study.counterbalance import order_of, orders
from verbteach_sessions.study.enrolment import has_enrolled
from verbteach_sessions.study.errors import VisitError
from verbteach_sessions.study.progress import VISIT_NAME
from verbteach_sessions.study.status import status_of
from verbteach_sessions.study.steps import Kind
from verbteach_sessions.study.visit import Visit

NOW = datetime(2030, 1, 2, 3, 4, 5, tzinfo=UTC)


def enter(folder: Path, code: str = "aaaa", text: str = SMALL) -> Visit:
    return Visit.enter(folder, study(text), text.encode(), code, "plain", lambda: NOW)


def back(folder: Path, code: str = "aaaa") -> Visit:
    return Visit.come_back(folder, "small", code, "app", SCENES, lambda: NOW)


def test_the_steps_come_in_order_and_the_last_one_stays(tmp_path: Path) -> None:
    with enter(tmp_path) as visit:
        seen = []
        while visit.step.kind is not Kind.THANKS:
            seen.append(visit.step.kind.value)
            visit.done()
        assert seen == ["instructions", "practice", "lessons", "questionnaire"]
        visit.done()
        assert visit.step.kind is Kind.THANKS


def test_who_comes_back_is_where_they_were(tmp_path: Path) -> None:
    with enter(tmp_path) as visit:
        visit.done()
        visit.began("20300102-030405-abcdefgh")
        before = (visit.step, visit.session, visit.slot, visit.seed, visit.header())
    with back(tmp_path) as again:
        assert (again.step, again.session, again.slot, again.seed, again.header()) == before
        again.done("tasks")
        assert again.step.kind is Kind.LESSONS
        assert again.session is None


def test_the_record_says_what_was_consented_to(tmp_path: Path) -> None:
    with enter(tmp_path) as visit:
        visit.done()
        header = visit.header()
    assert header["consent"] == {"answer": "yes", "text": study().consent_hash}
    assert header["condition"]["panels"] in (["scene"], ["scene", "mind", "verbs"])
    assert header["step"] == "practice"


def test_the_study_stays_as_it_was_for_those_who_have_begun(tmp_path: Path) -> None:
    enter(tmp_path).close()
    changed = SMALL.replace('instructions = "Teach."', "")
    with enter(tmp_path, "bbbb", changed) as other:
        assert other.step.kind is Kind.PRACTICE
    with back(tmp_path) as again:
        assert again.step.kind is Kind.INSTRUCTIONS


def test_one_participant_is_in_one_place_at_a_time(tmp_path: Path) -> None:
    with enter(tmp_path), pytest.raises(SessionInUseError):
        back(tmp_path)
    back(tmp_path).close()


def test_a_code_cannot_be_used_twice_and_cannot_leave_the_folder(tmp_path: Path) -> None:
    enter(tmp_path).close()
    with pytest.raises(VisitError):
        enter(tmp_path)
    for code in ("../x", "a/b", "", ".", "a b", "x" * 65):
        with pytest.raises(UnsafeNameError):
            enter(tmp_path, code)
    with pytest.raises(VisitError):
        back(tmp_path, "nobody")
    assert not has_enrolled(tmp_path, "nobody")


def test_what_is_kept_is_private(tmp_path: Path) -> None:
    enter(tmp_path).close()
    for path in (tmp_path / "aaaa" / VISIT_NAME, *tmp_path.glob("study-*.toml")):
        assert stat.S_IMODE(path.stat().st_mode) == 0o600
    assert stat.S_IMODE((tmp_path / "aaaa").stat().st_mode) == 0o700


def test_a_changed_record_of_a_visit_is_found(tmp_path: Path) -> None:
    enter(tmp_path).close()
    path = tmp_path / "aaaa" / VISIT_NAME
    path.write_bytes(path.read_bytes().replace(b'"slot":0', b'"slot":1'))
    with pytest.raises(DamagedLogError):
        back(tmp_path)
    with pytest.raises(VisitError):
        enter(tmp_path, "bbbb")


def test_who_withdraws_makes_room_for_another(tmp_path: Path) -> None:
    for code in ("aaaa", "bbbb", "cccc"):
        enter(tmp_path, code).close()
    for path in (tmp_path / "bbbb").iterdir():
        path.unlink()
    (tmp_path / "bbbb").rmdir()
    with enter(tmp_path, "dddd") as visit:
        assert visit.slot == 1


def test_stopping_goes_to_what_is_asked_at_the_end(tmp_path: Path) -> None:
    with enter(tmp_path) as visit:
        visit.stop()
        assert visit.step.kind is Kind.THANKS  # nothing was taught, so nothing is asked
    with enter(tmp_path, "bbbb") as visit:
        visit.done()
        visit.done()
        visit.began("20300102-030405-abcdefgh")
        visit.stop()
        assert visit.step.kind is Kind.QUESTIONNAIRE


def test_stopping_in_the_first_part_asks_about_that_part_only(tmp_path: Path) -> None:
    text = SMALL.replace("[study]", '[study]\ndesign = "within"') + '\nwhen = "each"\n'
    with enter(tmp_path, text=text) as visit:
        visit.done()
        visit.done()
        visit.began("20300102-030405-abcdefgh")
        visit.stop()
        assert (visit.step.kind, visit.step.part) == (Kind.QUESTIONNAIRE, 1)
        visit.done()
        assert visit.step.kind is Kind.THANKS


def test_the_completion_code_is_drawn_once(tmp_path: Path) -> None:
    with enter(tmp_path) as visit:
        with pytest.raises(VisitError):
            visit.completion()
        visit.stop()
        code = visit.completion()
        assert code == visit.completion() != visit.code
    with back(tmp_path) as again:
        assert again.completion() == code


def _come(folder: str, code: str) -> None:
    enter(Path(folder), code).close()


def test_participants_who_come_at_once_never_share_a_place(tmp_path: Path) -> None:
    context = multiprocessing.get_context("fork")
    codes = [f"p{number}" for number in range(8)]
    several = [context.Process(target=_come, args=(str(tmp_path), code)) for code in codes]
    for one in several:
        one.start()
    for one in several:
        one.join(60)
        assert one.exitcode == 0
    status = status_of(study(), tmp_path)
    assert [row.slot for row in status.rows] == list(range(8))
    assert all(row.order == order_of(study(), row.slot or 0) for row in status.rows)
    assert {one.given for one in status.balance} == {4}


def test_status_says_when_something_was_done_last_whatever_it_was(tmp_path: Path) -> None:
    times = iter([NOW, NOW + timedelta(minutes=2), NOW + timedelta(minutes=31)])
    raw = SMALL.encode()
    with Visit.enter(tmp_path, study(), raw, "aaaa", "plain", lambda: next(times)) as visit:
        visit.done()
        visit.done()
    (row,) = status_of(study(), tmp_path).rows
    assert row.seen == "2030-01-02T03:35:05+00:00"


def test_status_says_who_is_where(tmp_path: Path) -> None:
    with enter(tmp_path) as visit:
        visit.stop()
        visit.completion()
    second = enter(tmp_path, "bbbb")
    second.done()
    status = status_of(study(), tmp_path)
    first_row, second_row = status.rows
    assert (first_row.finished, first_row.stopped, first_row.here) == (True, True, False)
    assert (second_row.finished, second_row.here, second_row.done) == (False, True, 1)
    assert second_row.at == f"practice {second_row.order[0]}"
    second.close()
    assert status.to_json()["finished"] == 1
    assert Counter(order for order in orders(study())) == Counter(b.order for b in status.balance)
    (tmp_path / "bbbb" / VISIT_NAME).write_text("nonsense\n")
    assert any(row.problem for row in status_of(study(), tmp_path).rows)

"""The datasheet and the release check: filled in, kept up to date, and each reason fires."""

from __future__ import annotations

import json
import shutil
from dataclasses import replace
from pathlib import Path

import pytest

from tests.sessions.corpora import ANNA, BEN
from tests.sessions.records import forge
from tests.sessions.rooms import settings
from verbteach_sessions.corpus.datasheet import (
    SECTIONS,
    TO_DO,
    datasheet,
    figures_in,
    left_to_do,
    written_in,
)
from verbteach_sessions.corpus.describing import describe
from verbteach_sessions.corpus.findings import scan
from verbteach_sessions.corpus.personal import Scanner
from verbteach_sessions.corpus.redactions import Redactions
from verbteach_sessions.corpus.release import REASONS, Corpus, Release, check_release
from verbteach_sessions.corpus.withdrawal import WITHDRAWN_NAME
from verbteach_sessions.exports.alias import alias

ASKED = [item.title for items in SECTIONS.values() for item in items if item.ask]


def answered(text: str) -> str:
    """A datasheet in which a person has answered everything."""
    lines = ["We did." if TO_DO in line else line for line in text.splitlines()]
    return "\n".join(lines) + "\n"


def fresh(paths: tuple[Path, ...]) -> str:
    return datasheet(describe(paths), {})


@pytest.fixture
def ready(mine: tuple[Path, ...], tmp_path: Path) -> Corpus:
    """A corpus against which nothing speaks."""
    log = Redactions.of(mine[0].parent)
    log.decide(finding.decision("redact") for finding in scan(mine[0], Scanner(), log))
    sheet = tmp_path / "DATASHEET.md"
    sheet.write_text(answered(fresh(mine)), "utf-8")
    splits = {"train": [alias(mine[0].name)], "validation": [alias(mine[1].name)]}
    path = tmp_path / "splits.json"
    path.write_text(json.dumps({**splits, "test": [alias(mine[2].name)]}), "utf-8")
    return Corpus(mine, sheet, path)


def rules(release: Release) -> set[str]:
    return {problem.rule for problem in release.problems}


def test_a_new_datasheet_asks_people_and_tells_what_the_records_tell(
    mine: tuple[Path, ...],
) -> None:
    text = fresh(mine)
    assert list(left_to_do(text)) == ASKED
    assert text.count(TO_DO) == len(ASKED)
    assert "- sessions: 3 (taught by: 2 human, 1 simulated)" in text
    assert "simulated teachers are programs, not people" in text
    assert "boil" in text
    assert "overlap by" in text


def test_what_people_wrote_stays_and_figures_follow(mine: tuple[Path, ...]) -> None:
    text = fresh(mine[:1]).replace(
        f"**{TO_DO}**: under which licence",
        "CC BY 4.0, ### not a heading\n\n- held by us, not under",
    )
    again = datasheet(describe(mine), written_in(text))
    assert "CC BY 4.0" in again
    assert "- held by us" in again
    assert "Licence" not in left_to_do(again)
    assert "- sessions: 3 " in again
    assert "- sessions: 1 " not in again
    assert datasheet(describe(mine), written_in(again)) == again


def test_a_datasheet_that_lost_a_heading_is_not_done(mine: tuple[Path, ...]) -> None:
    text = answered(fresh(mine))
    assert left_to_do(text) == ()
    assert left_to_do(text.replace("### Licence", "### Other")) == ("Licence",)
    assert left_to_do(text.replace("# Datasheet", f"# Datasheet {TO_DO}")) == ("the beginning",)
    emptied = text.replace("### Ethics\n\nWe did.", "### Ethics\n")
    assert left_to_do(emptied) == ("Ethics",)


def test_figures_are_what_stands_between_the_marks(mine: tuple[Path, ...]) -> None:
    text = fresh(mine)
    assert figures_in(text) == figures_in(answered(text))
    assert figures_in(text) != figures_in(fresh(mine[:2]))


def test_nothing_speaks_against_a_corpus_in_order(ready: Corpus) -> None:
    release = check_release(ready, settings)
    assert release.problems == ()
    assert release.ready
    # Two people taught outside a study: to be weighed, not forbidden.
    assert [one.rule for one in release.warnings] == ["consent", "consent"]


def test_the_datasheet_stops_it(ready: Corpus) -> None:
    sheet = ready.datasheet
    text = sheet.read_text("utf-8")
    for spoiled in (
        text.replace("We did.", f"{TO_DO}", 1),
        text.replace("sessions: 3", "sessions: 4"),
    ):
        sheet.write_text(spoiled, "utf-8")
        assert rules(check_release(ready, settings)) == {"datasheet"}
    sheet.unlink()
    assert rules(check_release(ready, settings)) == {"datasheet"}


def test_personal_data_stops_it(ready: Corpus) -> None:
    named = replace(ready, names=("kettle",))
    release = check_release(named, settings)
    assert rules(release) == {"personal"}
    assert any("kettle" in problem.message for problem in release.problems)


def test_a_withdrawn_person_stops_it(ready: Corpus) -> None:
    path = ready.sessions[0].parent / WITHDRAWN_NAME
    path.write_text(json.dumps({"participant": ANNA, "at": ""}) + "\n", "utf-8")
    assert rules(check_release(ready, settings)) == {"withdrawn"}


def test_a_study_without_consent_stops_it(ready: Corpus) -> None:
    study = {"id": "s", "consent": {"answer": "yes", "text": "0" * 64}}
    path = ready.sessions[2]
    forge(path, lambda events: events[0]["data"].update(study=study))
    ready.datasheet.write_text(answered(fresh(tuple(ready.sessions))), "utf-8")
    assert check_release(ready, settings).ready
    forge(path, lambda events: events[0]["data"].update(study={"id": "s"}))
    ready.datasheet.write_text(answered(fresh(tuple(ready.sessions))), "utf-8")
    assert rules(check_release(ready, settings)) == {"consent"}


def test_a_record_that_is_not_valid_stops_it(ready: Corpus) -> None:
    log = ready.sessions[1] / "events.jsonl"
    log.write_bytes(log.read_bytes().replace(b"boil", b"bowl", 1))
    release = check_release(ready, settings)
    # It cannot be read any more, so the figures of the datasheet are not right either.
    assert rules(release) == {"valid", "datasheet"}
    assert release.problems[0].session == ready.sessions[1].name


def test_parts_that_share_a_person_stop_it(ready: Corpus) -> None:
    forge(ready.sessions[2], lambda events: events[0]["data"].update(participant=BEN))
    ready.datasheet.write_text(answered(fresh(tuple(ready.sessions))), "utf-8")
    release = check_release(ready, settings)
    assert rules(release) == {"splits"}
    assert "belong together" in release.problems[0].message
    assert check_release(replace(ready, splits=None), settings).ready


def test_a_session_in_no_part_stops_it(ready: Corpus, tmp_path: Path) -> None:
    name = "20260101-120000-zzzzzzzz"
    copy = Path(shutil.copytree(ready.sessions[2], tmp_path / "more" / name))
    forge(copy, lambda events: events[0]["data"].update(id=name))
    found = check_release(replace(ready, sessions=(*ready.sessions, copy)), settings)
    assert "splits" in rules(found)


def test_every_reason_is_documented() -> None:
    text = (Path(__file__).parents[3] / "docs" / "datasheet.md").read_text("utf-8")
    for name, why in REASONS.items():
        assert f"| `{name}` | {why} |" in text

"""A person's withdrawal: everything of theirs goes, nothing of others, and copies are listed."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import pytest

from tests.sessions.corpora import ANNA, BEN, MAIL
from tests.sessions.rooms import begin, resumed
from verbteach_sessions.corpus.findings import scan
from verbteach_sessions.corpus.folder import corpus_of, sessions_at
from verbteach_sessions.corpus.personal import Scanner
from verbteach_sessions.corpus.redactions import REDACTIONS_NAME, Decision, Redactions
from verbteach_sessions.corpus.withdrawal import carry_out, find, withdrawn
from verbteach_sessions.errors import NotASessionError, SessionInUseError, UnsafeNameError
from verbteach_sessions.exports.exporting import Request, export
from verbteach_sessions.learned import source_from
from verbteach_sessions.study.progress import VISIT_NAME


def test_finding_changes_nothing(mine: tuple[Path, ...]) -> None:
    found = find(mine[0].parent, ANNA)
    assert found.sessions == (mine[0],)
    assert found.exports == ()
    assert found.others == ()
    assert all(path.exists() for path in mine)


def test_a_withdrawal_deletes_and_lists(mine: tuple[Path, ...], tmp_path: Path) -> None:
    folder = mine[0].parent
    log = Redactions.of(folder)
    log.decide(finding.decision("redact") for finding in scan(mine[0], Scanner(), log))
    log.decide([Decision(mine[1].name, "name", "Ben", "redact")])
    export(Request(mine, "csv", tmp_path / "out"))
    found = find(folder, ANNA)
    assert [one.out for one in found.exports] == [str(tmp_path / "out")]
    carry_out(found)
    left = sorted(path.name for path in folder.iterdir() if path.is_dir())
    assert left == sorted(path.name for path in mine[1:])
    assert withdrawn(folder) == {ANNA}
    kept = (folder / REDACTIONS_NAME).read_text("utf-8")
    assert MAIL not in kept
    assert "Ben" in kept
    # The register still tells where the copies are.
    assert find(folder, ANNA).exports == found.exports
    assert find(folder, ANNA).sessions == ()


def test_sessions_that_go_on_from_it_are_named_and_stay(mine: tuple[Path, ...]) -> None:
    folder = mine[0].parent
    with begin(folder, source=source_from(mine[0]), participant=BEN) as session:
        path = session.path
    found = find(folder, ANNA)
    assert found.others == (path,)
    carry_out(found)
    assert path.exists()


def test_an_open_session_stops_it_before_anything_is_deleted(mine: tuple[Path, ...]) -> None:
    with begin(mine[0].parent, participant=ANNA) as session:
        found = find(mine[0].parent, ANNA)
        assert len(found.sessions) == 2
        with pytest.raises(SessionInUseError):
            carry_out(found)
        assert all(path.exists() for path in found.sessions)
        assert session.path.exists()


def test_an_interrupted_deletion_can_be_finished(mine: tuple[Path, ...]) -> None:
    (mine[0] / "events.jsonl").unlink()  # as far as it came
    found = find(mine[0].parent, ANNA)
    assert found.sessions == (mine[0],)
    carry_out(found)
    assert not mine[0].exists()


def test_links_are_not_followed(mine: tuple[Path, ...], tmp_path: Path) -> None:
    elsewhere = Path(shutil.move(mine[0], tmp_path / "elsewhere"))
    mine[0].symlink_to(elsewhere)
    (mine[1] / "link").symlink_to(elsewhere)
    with pytest.raises(NotASessionError):
        find(mine[1].parent, ANNA)
    carry_out(find(mine[1].parent, BEN))
    assert (elsewhere / "events.jsonl").exists()


@pytest.mark.parametrize("code", ["../out", "", "a/b", ".", "x" * 65])
def test_a_code_cannot_leave_the_folder(mine: tuple[Path, ...], code: str) -> None:
    with pytest.raises(UnsafeNameError):
        find(mine[0].parent, code)


def test_nobody_of_that_code(mine: tuple[Path, ...], tmp_path: Path) -> None:
    with pytest.raises(NotASessionError, match="nobody23"):
        find(mine[0].parent, "nobody23")
    with pytest.raises(NotASessionError, match="no such folder"):
        find(tmp_path / "none", ANNA)


def test_in_a_study_the_persons_folder_goes_as_well(mine: tuple[Path, ...], tmp_path: Path) -> None:
    study = tmp_path / "study"
    for code, path in ((ANNA, mine[0]), (BEN, mine[1])):
        home = study / code
        home.mkdir(parents=True)
        (home / VISIT_NAME).write_text("{}\n", "utf-8")
        shutil.copytree(path, home / path.name)
    paths = sessions_at([study])
    assert [path.parent.name for path in paths] == sorted([ANNA, BEN])
    assert {corpus_of(path) for path in paths} == {study}
    export(Request(paths, "csv", tmp_path / "out"))
    found = find(study, ANNA)
    assert found.home == study / ANNA
    assert len(found.exports) == 1
    carry_out(found)
    assert sorted(path.name for path in study.iterdir() if path.is_dir()) == [BEN]


def test_a_session_of_theirs_can_no_longer_be_resumed(mine: tuple[Path, ...]) -> None:
    resumed(mine[0]).close()
    carry_out(find(mine[0].parent, ANNA))
    with pytest.raises(NotASessionError):
        resumed(mine[0])


def test_the_document_is_plain(mine: tuple[Path, ...], tmp_path: Path) -> None:
    export(Request(mine, "csv", tmp_path / "out"))
    document = json.loads(json.dumps(find(mine[0].parent, ANNA).to_json()))
    assert set(document) == {"participant", "sessions", "exports", "others"}
    assert set(document["exports"][0]) == {"at", "format", "out", "sessions", "participants"}

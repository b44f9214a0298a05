"""Exports as a whole: complete or not there, nothing replaced by accident, people registered."""

from __future__ import annotations

import importlib.util
import json
import shutil
from pathlib import Path
from zipfile import ZipFile

import pytest

from tests.sessions.corpora import ANNA, BEN, BY_ANNA, MAIL
from tests.sessions.records import first, forge, read_events
from tests.sessions.rooms import recorded, settings
from verbteach_sessions.corpus.findings import scan
from verbteach_sessions.corpus.personal import Scanner
from verbteach_sessions.corpus.redactions import Redactions
from verbteach_sessions.corpus.register import REGISTER_NAME, exports_of
from verbteach_sessions.errors import LogError, StorageError
from verbteach_sessions.exports import csv_table
from verbteach_sessions.exports.alias import alias
from verbteach_sessions.exports.errors import (
    ExportError,
    MissingExtraError,
    NothingToExportError,
)
from verbteach_sessions.exports.exporting import Request, export
from verbteach_sessions.exports.folder import MANIFEST, OutputExistsError
from verbteach_sessions.exports.formats import FORMATS
from verbteach_tui.views.sight import make_depict

PLAIN = [name for name, one in FORMATS.items() if not one.packages]


@pytest.fixture
def mine(corpus: tuple[Path, ...], tmp_path: Path) -> tuple[Path, ...]:
    """The corpus in a folder of its own, to be written beside."""
    return tuple(Path(shutil.copytree(p, tmp_path / "sessions" / p.name)) for p in corpus)


def everything(folder: Path) -> str:
    """All bytes of an export as text, those in archives too."""
    parts = []
    for path in sorted(folder.rglob("*")):
        if path.suffix == ".zip":
            with ZipFile(path) as archive:
                parts += [archive.read(name).decode() for name in archive.namelist()]
        elif path.is_file():
            parts.append(path.read_bytes().decode("utf-8", "replace"))
    return "\n".join(parts)


@pytest.mark.parametrize("name", PLAIN)
def test_no_format_tells_a_time_of_day_or_what_was_redacted(
    mine: tuple[Path, ...], tmp_path: Path, name: str
) -> None:
    log = Redactions.of(mine[0].parent)
    found = list(scan(mine[0], Scanner(), log))
    assert MAIL in [finding.text for finding in found]
    log.decide(finding.decision("redact") for finding in found)
    request = Request(mine, name, tmp_path / "out", settings=settings, depict=make_depict())
    made = export(request)
    text = everything(tmp_path / "out")
    created = read_events(mine[0])[0]["data"]["created"]
    for secret in (created[:10], mine[0].name[:15], str(tmp_path), *(f.text for f in found)):
        assert secret not in text
    assert made.redacted
    assert made.participants == (ANNA, BEN)
    assert "redactions" not in " ".join(made.files)


@pytest.mark.parametrize("name", PLAIN)
def test_an_export_is_the_same_bytes_again(
    mine: tuple[Path, ...], tmp_path: Path, name: str
) -> None:
    for place in ("one", "two"):
        export(Request(mine, name, tmp_path / place, settings=settings, depict=make_depict()))
    ours, theirs = tmp_path / "one", tmp_path / "two"
    files = [path.relative_to(ours) for path in sorted(ours.rglob("*")) if path.is_file()]
    assert MANIFEST in [path.name for path in files]
    for path in files:
        assert (ours / path).read_bytes() == (theirs / path).read_bytes()


def test_what_is_there_is_refused_and_only_an_export_is_replaced(
    mine: tuple[Path, ...], tmp_path: Path
) -> None:
    out = tmp_path / "out"
    out.mkdir()
    export(Request(mine[:1], "csv", out))  # an empty folder is free to take
    with pytest.raises(OutputExistsError, match="--force"):
        export(Request(mine, "csv", out))
    (out / "left.txt").write_text("of the earlier export", "utf-8")
    export(Request(mine, "csv", out, force=True))
    assert sorted(path.name for path in out.iterdir()) == [MANIFEST, "sessions.csv", "turns.csv"]
    home = tmp_path / "home"
    home.mkdir()
    (home / "thesis.txt").write_text("precious", "utf-8")
    with pytest.raises(OutputExistsError, match=r"no export\.json"):
        export(Request(mine, "csv", home, force=True))
    assert [path.name for path in home.iterdir()] == ["thesis.txt"]
    with pytest.raises(OutputExistsError):
        export(Request(mine, "csv", home / "thesis.txt", force=True))


def test_a_damaged_session_leaves_no_export(mine: tuple[Path, ...], tmp_path: Path) -> None:
    log = mine[1] / "events.jsonl"
    log.write_bytes(log.read_bytes().replace(b"boil", b"bowl", 1))
    with pytest.raises(LogError):
        export(Request(mine, "jsonl", tmp_path / "out"))
    assert not (tmp_path / "out").exists()
    assert [path.name for path in tmp_path.iterdir()] == ["sessions"]
    assert not (mine[0].parent / REGISTER_NAME).exists()


def test_whole_sessions_can_go_without_the_damaged(mine: tuple[Path, ...], tmp_path: Path) -> None:
    whole = export(Request((mine[0], mine[2]), "csv", tmp_path / "whole"))
    log = mine[1] / "events.jsonl"
    log.write_bytes(log.read_bytes().replace(b"boil", b"bowl", 1))
    heard: list[int] = []
    made = export(Request(mine, "csv", tmp_path / "out", skip_damaged=True), heard.append)
    assert heard == [1, 2, 3]
    assert (made.sessions, made.participants) == (whole.sessions, (ANNA,))
    assert [one.session for one in made.left_out] == [mine[1].name]
    assert "line" in made.left_out[0].reason
    for name in ("turns.csv", "sessions.csv"):
        ours, theirs = (tmp_path / one / name for one in ("out", "whole"))
        assert ours.read_bytes() == theirs.read_bytes()
    manifest = json.loads((tmp_path / "out" / MANIFEST).read_text("utf-8"))
    assert manifest["left_out"] == [alias(mine[1].name)]
    assert exports_of(mine[0].parent, BEN) == ()
    assert len(exports_of(mine[0].parent, ANNA)) == 2
    with pytest.raises(NothingToExportError, match="none of 1"):
        export(Request(mine[1:2], "csv", tmp_path / "none", skip_damaged=True))
    assert not (tmp_path / "none").exists()


def test_a_failing_disk_leaves_the_earlier_export(
    mine: tuple[Path, ...], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    out = tmp_path / "out"
    export(Request(mine, "csv", out))
    before = everything(out)

    def fail(*_: object) -> None:
        raise OSError(28, "No space left on device", str(out / "turns.csv"))

    monkeypatch.setattr(csv_table, "turn_rows", fail)
    with pytest.raises(StorageError, match="disk is full"):
        export(Request(mine, "csv", out, force=True))
    assert everything(out) == before
    assert sorted(path.name for path in tmp_path.iterdir()) == ["out", "sessions"]


def test_exports_of_people_are_registered(mine: tuple[Path, ...], tmp_path: Path) -> None:
    export(Request(mine, "csv", tmp_path / "all"))
    export(Request(mine[1:], "markdown", tmp_path / "ben"))
    export(Request(mine[2:], "svg", tmp_path / "program"))
    folder = mine[0].parent
    register = folder / REGISTER_NAME
    assert [one.format for one in exports_of(folder, ANNA)] == ["csv"]
    assert [one.format for one in exports_of(folder, BEN)] == ["csv", "markdown"]
    assert exports_of(folder, ANNA)[0].sessions == tuple(sorted(p.name for p in mine[:2]))
    assert register.stat().st_mode & 0o777 == 0o600
    assert len(register.read_text("ascii").splitlines()) == 2


def test_without_a_place_to_register_there_is_no_export(
    mine: tuple[Path, ...], tmp_path: Path
) -> None:
    (mine[0].parent / REGISTER_NAME).mkdir()
    with pytest.raises(StorageError):
        export(Request(mine, "csv", tmp_path / "out"))
    assert not (tmp_path / "out").exists()


def test_one_session_twice_is_refused(mine: tuple[Path, ...], tmp_path: Path) -> None:
    copy = Path(shutil.copytree(mine[0], tmp_path / "copy" / mine[0].name))
    with pytest.raises(ExportError, match="same session"):
        export(Request((*mine, copy), "csv", tmp_path / "out"))


@pytest.mark.parametrize("name", ["parquet", "minari"])
def test_a_missing_extra_is_one_line_with_the_command(
    mine: tuple[Path, ...], tmp_path: Path, name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("verbteach_sessions.exports.formats.find_spec", lambda package: None)
    with pytest.raises(MissingExtraError) as caught:
        export(Request(mine, name, tmp_path / "out"))
    assert f"pip install 'verbteach[{name}]'" in str(caught.value)
    assert "\n" not in str(caught.value)
    assert not (tmp_path / "out").exists()


def test_minari_needs_choices(tmp_path: Path) -> None:
    if importlib.util.find_spec("minari") is None:
        pytest.skip("minari is not installed here")
    path = recorded(tmp_path / "sessions", "scene: kitchen-3\n")
    with pytest.raises(NothingToExportError):
        export(Request((path,), "minari", tmp_path / "out"))


def test_splits_are_taken_up(mine: tuple[Path, ...], tmp_path: Path) -> None:
    from verbteach_sessions.exports.alias import alias

    splits = {alias(mine[0].name): "test"}
    made = export(Request(mine, "jsonl", tmp_path / "out", splits=splits))
    assert "data/sessions-test.jsonl" in made.files
    row = json.loads((tmp_path / "out" / "data" / "sessions-test.jsonl").read_text("utf-8"))
    assert row["participant"] == ANNA


@pytest.mark.parametrize("name", PLAIN)
def test_hostile_values_are_exported_as_they_are(tmp_path: Path, name: str) -> None:
    path = recorded(tmp_path / "sessions", BY_ANNA)

    def change(events: list[dict[str, object]]) -> None:
        header = events[0]["data"]
        assert isinstance(header, dict)
        header.update(study={"consent": [[[]]], "id": {"a": "\ud800"}})
        header["parameters"]["rewards"] = {"prices": {"np_grd_ynq": "free", "x": [1]}}
        robot = first(events, "robot", 1)["data"]
        robot.update(acts=[{"act": 5, "np": {"deep": [None]}}], texts=["\ud800", "</script>"])

    forge(path, change)
    request = Request((path,), name, tmp_path / "out", settings=settings, depict=make_depict())
    assert export(request).sessions == 1


# A teacher's act is read together with the reply to it.
@pytest.mark.parametrize(("event", "field", "line"), [(0, "seed", 1), (2, "answered_at", 4)])
def test_a_number_that_no_column_holds_is_refused(
    tmp_path: Path, event: int, field: str, line: int
) -> None:
    path = recorded(tmp_path / "sessions", BY_ANNA)
    forge(path, lambda events: events[event]["data"].update({field: 10**40}))
    with pytest.raises(LogError, match=f"line {line}: .*too large"):
        export(Request((path,), "jsonl", tmp_path / "out"))
    assert not (tmp_path / "out").exists()

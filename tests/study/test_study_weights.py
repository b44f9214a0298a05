"""Two trained policies compared with people: each condition's weights are hashed and kept."""

from __future__ import annotations

import json
from datetime import UTC, datetime
from hashlib import sha256
from pathlib import Path

import pytest

from tests.study.files import SCENES, SMALL
from verbteach_scenarios.weights import STARTING
from verbteach_sessions.study.errors import StudyFileError
from verbteach_sessions.study.status import status_of
from verbteach_sessions.study.study_file import read_study
from verbteach_sessions.study.visit import Visit
from verbteach_sessions.study.weights_beside import copy_of_weights

NOW = datetime(2030, 1, 2, 3, 4, 5, tzinfo=UTC)
ASKING = SMALL[SMALL.index("[[condition]]") : SMALL.index("[questionnaire]")]
TWO = SMALL.replace(
    ASKING,
    """
[[condition]]
id = "first"
policy = "rl"
weights = "policies/first.json"
freeze = true

[[condition]]
id = "second"
policy = "rl"
weights = "policies/second.json"

""",
)


def written(folder: Path, text: str = TWO) -> Path:
    """The study's file with two files of weights beside it."""
    policies = folder / "policies"
    policies.mkdir()
    raw = STARTING.read_text("utf-8")
    for name in ("first", "second"):
        changed = {**json.loads(raw), "training": {"source": name}}
        (policies / f"{name}.json").write_text(json.dumps(changed), "utf-8")
    file = folder / "study.toml"
    file.write_text(text, "utf-8")
    return file


def enter(file: Path, records: Path, code: str = "aaaa") -> Visit:
    return Visit.enter(
        records, read_study(file, SCENES), file.read_bytes(), code, "plain", lambda: NOW
    )


def come_back(records: Path, code: str = "aaaa") -> Visit:
    return Visit.come_back(records, "small", code, "plain", SCENES, lambda: NOW)


def test_a_condition_knows_its_weights_by_their_hash(tmp_path: Path) -> None:
    study = read_study(written(tmp_path), SCENES)
    for condition in study.conditions:
        raw = (tmp_path / condition.weights).read_bytes()
        assert condition.weights_hash == sha256(raw).hexdigest()
        assert study.attached[condition.weights_hash] == raw
    assert [one.freeze for one in study.conditions] == [True, False]
    assert study.conditions[0].to_json()["weights_hash"] == study.conditions[0].weights_hash


def test_a_condition_without_weights_is_kept_as_before(tmp_path: Path) -> None:
    (tmp_path / "study.toml").write_text(SMALL, "utf-8")
    shape = read_study(tmp_path / "study.toml", SCENES).conditions[0].to_json()
    assert set(shape) == {"id", "policy", "noise", "noise_reading", "panels"}


def test_who_has_begun_goes_on_with_the_weights_there_were(tmp_path: Path) -> None:
    file, records = written(tmp_path), tmp_path / "records"
    with enter(file, records) as visit:
        visit.done()
        before = visit.header()
        assert len(before["condition"]["weights_hash"]) == 64
    for policy in (tmp_path / "policies").iterdir():
        policy.unlink()
    with come_back(records) as again:
        assert again.header() == before
        named = again.condition.weights_hash
    assert sha256(copy_of_weights(records, named).read_bytes()).hexdigest() == named


def test_who_comes_after_a_change_is_told_apart(tmp_path: Path) -> None:
    file, records = written(tmp_path), tmp_path / "records"
    enter(file, records, "aaaa").close()
    second = tmp_path / "policies" / "second.json"
    second.write_text(second.read_text("utf-8") + "\n", "utf-8")
    enter(file, records, "bbbb").close()
    changed = {
        row.participant: row.changed for row in status_of(read_study(file, SCENES), records).rows
    }
    assert changed == {"aaaa": True, "bbbb": False}


def test_a_copy_that_was_meddled_with_is_refused(tmp_path: Path) -> None:
    file, records = written(tmp_path), tmp_path / "records"
    enter(file, records).close()
    for copy in records.glob("weights-*.json"):
        copy.write_text(copy.read_text("utf-8") + "\n", "utf-8")
    with pytest.raises(StudyFileError, match="changed after somebody began"):
        come_back(records)


@pytest.mark.parametrize(
    ("old", "new", "problem"),
    [
        ("policies/first.json", "policies/none.json", "No such file"),
        ("policies/first.json", "study.toml", "no JSON"),
        ('policy = "rl"\nweights', 'policy = "manual"\nweights', "for the policy 'rl' alone"),
        ("freeze = true", 'freeze = "yes"', "must be true or false"),
    ],
)
def test_what_does_not_fit_is_said_with_its_line(
    tmp_path: Path, old: str, new: str, problem: str
) -> None:
    file = written(tmp_path, TWO.replace(old, new, 1))
    with pytest.raises(StudyFileError, match=problem) as raised:
        read_study(file, SCENES)
    line = file.read_text("utf-8").splitlines()[raised.value.problems[0].line - 1]
    assert line.startswith(("weights", "freeze"))

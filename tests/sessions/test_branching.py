"""A branch holds what its parent held up to an event, and goes its own way from there."""

from __future__ import annotations

from pathlib import Path
from tempfile import TemporaryDirectory

import pytest
from hypothesis import given
from hypothesis import settings as hypothesis_settings
from hypothesis import strategies as st

from tests.sessions.records import raw_lines, read_events
from tests.sessions.rooms import BOIL, babble, begin, recorded, resumed, say, settings
from tests.sessions.test_crash import files_no_larger_than
from verbteach_sessions.branching import BranchError, branch
from verbteach_sessions.errors import DamagedLogError, StorageError
from verbteach_sessions.eventlog import LOG_NAME
from verbteach_sessions.lines import GENESIS, digest
from verbteach_sessions.replay import replay, verify
from verbteach_sessions.validate import validate

OWN = {"id", "created", "parent"}


@hypothesis_settings(max_examples=8, deadline=None)
@given(st.integers(0, 2**32 - 1), st.floats(0, 1))
def test_a_branch_replays_as_the_prefix_it_is(seed: int, share: float) -> None:
    with TemporaryDirectory() as folder:
        with begin(Path(folder)) as session:
            say(session, BOIL)
            path = babble(session, seed, 15).path
        lines = raw_lines(path)
        at = 1 + int(share * (len(lines) - 2))
        made = branch(path, Path(folder), at)
        assert raw_lines(path) == lines, "the parent stays as it was"
        seq = made.parent.seq
        prefix, whole = verify(path, settings, to=seq), verify(made.path, settings)
        assert whole.verified
        assert whole.content_hash == prefix.content_hash == made.content_hash
        ours = [frame.state for frame in replay(made.path, settings)]
        assert ours == [frame.state for frame in replay(path, settings, to=seq)]
        assert validate(made.path, settings).to_json() == {
            "valid": True,
            "problems": [],
            "warnings": [],
        }
        shared = read_events(path)[1 : seq + 1]
        kept = read_events(made.path)[1:]
        assert [(e["type"], e["at"], e["data"]) for e in kept] == [
            (e["type"], e["at"], e["data"]) for e in shared
        ]
        assert seq <= at < seq + 3, "at most an act and what was learned were left out"


def test_the_header_names_the_parent_and_its_line(tmp_path: Path) -> None:
    path = recorded(tmp_path, BOIL, participant="p1", study={"condition": "a"})
    made = branch(path, tmp_path, 7)
    old, new = read_events(path)[0]["data"], read_events(made.path)[0]["data"]
    assert {name for name in new if new[name] != old[name]} <= OWN
    assert new["participant"] == "p1", "whose words they are is not forgotten"
    assert new["id"] == made.path.name != old["id"]
    assert new["parent"] == {
        "id": old["id"],
        "seq": 7,
        "hash": digest(raw_lines(path)[7]),
    }
    assert old["parent"] is None
    assert raw_lines(made.path)[0].count(GENESIS.encode()) == 1


def test_both_histories_go_on(tmp_path: Path) -> None:
    path = recorded(tmp_path, BOIL)
    made = branch(path, tmp_path, 12)
    with resumed(made.path) as own:
        say(own, "undo\ndo: moveto Mug_1\ndone\n")
        assert own.robot.state.knowledge.verbs == ()
        again = branch(own.path, tmp_path)
    with resumed(path) as parent:
        say(parent, "scene: kitchen-3\ncommand: boil the water\n")
        assert parent.turn.phase.value == "judgement"
    assert verify(made.path, settings).verified
    assert read_events(again.path)[0]["data"]["parent"]["id"] == made.path.name


def test_without_an_event_the_branch_holds_all(tmp_path: Path) -> None:
    path = recorded(tmp_path, BOIL + "quit\n")
    made = branch(path, tmp_path)
    assert len(raw_lines(made.path)) == len(raw_lines(path))
    with resumed(made.path) as session:
        assert session.robot.state.knowledge.verbs == ("boil",)


@pytest.mark.parametrize("at", [0, 999])
def test_there_is_no_branch_where_nothing_stood(tmp_path: Path, at: int) -> None:
    path = recorded(tmp_path, BOIL)
    with pytest.raises(BranchError):
        branch(path, tmp_path, at)
    assert list(tmp_path.iterdir()) == [path]


def test_a_branch_that_cannot_be_made_leaves_nothing(tmp_path: Path) -> None:
    path = recorded(tmp_path, BOIL)
    with files_no_larger_than(6000), pytest.raises(StorageError):
        branch(path, tmp_path)
    whole = (path / LOG_NAME).read_bytes()
    (path / LOG_NAME).write_bytes(whole[:4000] + b"!" + whole[4001:])
    with pytest.raises(DamagedLogError):
        branch(path, tmp_path)
    assert list(tmp_path.iterdir()) == [path]

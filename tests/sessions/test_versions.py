"""Records of every version of the format can be read, checked and gone on with."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from tests.sessions.records import raw_lines, read_events
from tests.sessions.rooms import resumed, say
from verbteach.dialogue.setting import Setting, UnknownSceneError
from verbteach_sessions.branching import branch
from verbteach_sessions.catalogue import entry
from verbteach_sessions.content import ContentHash
from verbteach_sessions.eventlog import LogReader
from verbteach_sessions.events import EVENT_TYPES
from verbteach_sessions.learned import knowledge_from
from verbteach_sessions.recomputing import check_fields
from verbteach_sessions.upcasting import STEPS, VERSION, upcast
from verbteach_sessions.validate import validate

FIXTURES = Path(__file__).parent / "fixtures"
NAME = "20260101-120000-abcdefgh"
# Written down when the fixture was: reading an old record never gives anything else.
CONTENT = {
    1: "27c7efcc1249c4cddc7db1f11af9b15af4a4fa2c1a3a2578dd54a766a374efd3",
    2: "838466d8db69edac1b50654f2647850398668611432fe3a68b16fbd70fbb2eda",
}


def nowhere(scene: str) -> Setting:
    """No scene at all: reading needs none."""
    raise UnknownSceneError(f"there is no scene {scene!r}")


@pytest.fixture(params=sorted({*STEPS, VERSION}))
def version(request: pytest.FixtureRequest) -> int:
    made: int = request.param
    return made


@pytest.fixture
def path(version: int, tmp_path: Path) -> Path:
    """A record of that version, in a folder of its own."""
    return Path(shutil.copytree(FIXTURES / f"version-{version}" / NAME, tmp_path / NAME))


def test_there_is_a_step_from_every_version_to_the_next() -> None:
    assert sorted(STEPS) == list(range(1, VERSION))


def test_it_is_what_it_says_it_is(path: Path, version: int) -> None:
    assert {event["v"] for event in read_events(path)} == {version}


def test_its_events_are_read_as_those_of_today(path: Path, version: int) -> None:
    content = ContentHash()
    for event in LogReader(path, strict=True):
        check_fields(event)
        content.add(event)
    assert content.hexdigest == CONTENT[version]
    knowledge, experience = knowledge_from(path)
    assert knowledge.verbs == ("boil",)
    assert experience


def test_it_breaks_no_rule_that_can_be_asked_without_its_rooms(path: Path) -> None:
    validation = validate(path, nowhere)
    assert [one.rule for one in validation.problems] == ["replay"]
    assert validation.warnings == ()
    assert entry(path).verbs_learned == ("boil",)
    assert entry(path).problem == ""


def test_it_goes_on_in_the_version_of_today(path: Path, version: int) -> None:
    lines = raw_lines(path)
    with resumed(path) as session:
        say(session, "note: later\n")
        assert session.robot.state.knowledge.verbs == ("boil",)
        assert session.header.parent is None
    assert raw_lines(path)[: len(lines)] == lines, "not a byte of what was is changed"
    assert {event["v"] for event in read_events(path)} == {version, VERSION}
    with resumed(path) as again:
        assert again.recovered == ()
    made = branch(path, path.parent / "branches", 3)
    assert {event["v"] for event in read_events(made.path)} == {VERSION}
    assert made.parent.id == NAME


def test_a_step_leaves_other_events_as_they_are() -> None:
    for kind in EVENT_TYPES:
        data = {"some": "thing"}
        assert (upcast(1, kind, data) == data) == (kind != "header")

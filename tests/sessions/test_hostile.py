"""Records from strangers: whatever they hold, they are refused with a reason, or read."""

from __future__ import annotations

import copy
import json
import os
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tests.sessions.records import raw_lines, read_events, write_events
from tests.sessions.rooms import TAUGHT, begin, recorded, resumed, say, settings
from verbteach.dialogue.setting import Setting, UnknownSceneError
from verbteach_sessions.branching import branch
from verbteach_sessions.catalogue import entry, list_sessions
from verbteach_sessions.counterfactual import counterfactual
from verbteach_sessions.errors import LogError, NotASessionError, SessionError
from verbteach_sessions.eventlog import LOG_NAME, LogReader
from verbteach_sessions.learned import source_from
from verbteach_sessions.lines import GENESIS, MAX_LINE, digest
from verbteach_sessions.replay import verify
from verbteach_sessions.upcasting import VERSION
from verbteach_sessions.validate import validate

SCRIPT = TAUGHT + "good\nnote: so\nundo\nredo\nquit\n"
REFUSALS = (SessionError, ValueError, UnknownSceneError)

ODD: tuple[Any, ...] = (
    None, True, -1, 10**30, 1.5, -0.5, "", "../../etc/passwd", "\x1b[2J", "kitchen-1",
    [], {}, [[]], {"act": "yes"}, ["a", 1], {"": None}, [None, [True]],
)  # fmt: skip
GONE = object()


@pytest.fixture(scope="module")
def honest(tmp_path_factory: pytest.TempPathFactory) -> list[dict[str, Any]]:
    return read_events(recorded(tmp_path_factory.mktemp("honest"), SCRIPT))


def places(value: Any, path: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
    """The paths of all values inside a value."""
    items = value.items() if isinstance(value, dict) else enumerate(value)
    for name, inner in items:
        yield (*path, name)
        if isinstance(inner, dict | list):
            yield from places(inner, (*path, name))


def spoiled(honest: list[dict[str, Any]], rng: np.random.Generator) -> list[dict[str, Any]]:
    """The events with an odd value in some place, or with nothing there any more."""
    events: Any = copy.deepcopy(honest)
    inside = [place for place in places(events) if place[1:2] == ("data",) and len(place) > 2]
    place = inside[int(rng.integers(len(inside)))]
    value = (*ODD, GONE)[int(rng.integers(len(ODD) + 1))]
    holder = events
    for name in place[:-1]:
        holder = holder[name]
    if value is GONE:
        del holder[place[-1]]
    else:
        holder[place[-1]] = value
    found: list[dict[str, Any]] = events
    return found


@pytest.mark.parametrize("seed", range(3))
def test_any_value_in_any_place_is_refused_or_read(
    honest: list[dict[str, Any]], tmp_path: Path, seed: int
) -> None:
    """Hashes and numbers hold, so that nothing but the value itself can be at fault."""
    rng = np.random.default_rng(seed)
    path = tmp_path / "sessions" / "session"
    path.mkdir(parents=True)
    for _ in range(60):
        write_events(path, spoiled(honest, rng))
        validate(path, nowhere)
        refused_or_done(source_from, path)
        refused_or_done(lambda path: branch(path, tmp_path / "branches"), path)
        entry(path)


@pytest.mark.parametrize("seed", range(3, 6))
def test_any_value_in_any_place_is_recomputed_or_refused(
    honest: list[dict[str, Any]], tmp_path: Path, seed: int
) -> None:
    rng = np.random.default_rng(seed)
    path = tmp_path / "session"
    path.mkdir()
    for _ in range(8):
        write_events(path, spoiled(honest, rng))
        refused_or_done(lambda path: verify(path, settings), path)
        refused_or_done(lambda path: counterfactual(path, settings, "split"), path)
        refused_or_done(lambda path: resumed(path).close(), path)
        assert list(tmp_path.iterdir()) == [path], "nothing was written beside it"


def nowhere(scene: str) -> Setting:
    """No scene at all, so that nothing is recomputed."""
    raise UnknownSceneError(f"there is no scene {scene!r}"[:80])


def refused_or_done(read: Callable[[Path], object], path: Path) -> None:
    refusal = ""
    try:
        read(path)
    except REFUSALS as error:
        refusal = str(error)
    assert "\n" not in refusal
    assert len(refusal) < 2000


def sealed(body: str) -> bytes:
    """A line whose own hash holds."""
    return (body[:-1] + f',"hash":"{digest(body.encode())}"}}\n').encode()


def lined(data: str, *, seq: str = "0", at: str = "0", kind: str = '"note"') -> bytes:
    head = f'{{"v":{VERSION},"seq":{seq},"type":{kind},"at":{at},'
    return sealed(f'{head}"data":{data},"prev":"{GENESIS}"}}')


HOSTILE: dict[str, bytes] = {
    "infinite": lined('{"text":1e999}'),
    "negative infinite": lined('{"text":-1E+999}'),
    "not a number": lined('{"text":NaN}'),
    "infinity": lined("{}", at="Infinity"),
    "endless integer": lined('{"text":' + "9" * 5000 + "}"),
    "huge time": lined("{}", at="9" * 400),
    "deep lists": lined('{"text":' + "[" * 100_000 + "]" * 100_000 + "}"),
    "deep objects": lined('{"text":' + '{"a":' * 50_000 + "1" + "}" * 50_000 + "}"),
    "no object": sealed('["v",1]'),
    "data is a list": lined("[]"),
    "seq is true": lined("{}", seq="true"),
    "seq is text": lined("{}", seq='"0"'),
    "type is null": lined("{}", kind="null"),
    "version is text": lined("{}").replace(b'{"v":2', b'{"v":"2"', 1),
    "no UTF-8": b'{"v":2,"\xff\xfe":1}\n',
    "zeros": b"\0" * 5000 + b"\n",
    "an endless line": b'{"v":2,"a":"' + b"x" * (MAX_LINE + 10),
    "a program": b"\x7fELF" + bytes(range(256)) * 40,
}


@pytest.mark.parametrize("name", HOSTILE)
def test_a_hostile_line_is_refused_in_one_line(tmp_path: Path, name: str) -> None:
    (tmp_path / LOG_NAME).write_bytes(HOSTILE[name])
    with pytest.raises((LogError, NotASessionError)) as refused:
        list(LogReader(tmp_path))
    assert "\n" not in str(refused.value)
    assert len(str(refused.value)) < 600
    validation = validate(tmp_path, settings)
    assert not validation.valid
    assert entry(tmp_path).problem
    with pytest.raises(SessionError):
        resumed(tmp_path)


def test_a_member_that_is_there_twice_is_a_problem(tmp_path: Path) -> None:
    path = recorded(tmp_path, "note: one\n")
    lines = raw_lines(path)
    body = lines[-1].decode().replace('"text":"one"', '"text":"two","text":"one"')
    (path / LOG_NAME).write_bytes(
        b"".join([*lines[:-1], sealed(body[: body.rindex(',"hash"')] + "}")])
    )
    assert list(LogReader(path))[-1].data["text"] == "one"
    (problem,) = validate(path, settings).problems
    assert problem.rule == "file"
    assert "'text'" in problem.message


def test_links_and_devices_are_no_records(tmp_path: Path) -> None:
    path = recorded(tmp_path, "")
    other = tmp_path / "other"
    other.mkdir()
    for target in (path / LOG_NAME, Path("/dev/zero"), Path("/nowhere")):
        (other / LOG_NAME).symlink_to(target)
        with pytest.raises(NotASessionError):
            list(LogReader(other))
        with pytest.raises(SessionError):
            resumed(other)
        assert not validate(other, settings).valid
        (other / LOG_NAME).unlink()
    os.mkfifo(other / LOG_NAME)
    with pytest.raises(NotASessionError):
        list(LogReader(other))


NAMES = ("../up", "/etc/passwd", "a/b", "..", "", "x" * 65, "CON\n", "naïve", "a\0b")


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("field", ["id", "participant", "parent", "source"])
def test_no_name_leads_out_of_its_folder(tmp_path: Path, field: str, name: str) -> None:
    path = recorded(tmp_path, "")
    events = read_events(path)
    values: dict[str, Any] = {
        "parent": {"id": name, "seq": 1, "hash": GENESIS},
        "source": {"id": name, "content_hash": GENESIS},
    }
    events[0]["data"][field] = values.get(field, name)
    write_events(path, events)
    (problem,) = validate(path, settings).problems
    assert problem.rule == "header"
    with pytest.raises(SessionError):
        resumed(path)


def test_what_a_session_keeps_is_its_owners_alone(tmp_path: Path) -> None:
    old = os.umask(0)
    try:
        with begin(tmp_path / "sessions") as session:
            say(session, "note: private\n")
        made = branch(session.path, tmp_path / "branches").path
    finally:
        os.umask(old)
    for path in (session.path, made):
        assert path.stat().st_mode & 0o777 == 0o700
        assert path.parent.stat().st_mode & 0o777 == 0o700
        files = list(path.iterdir())
        assert files
        assert {file.stat().st_mode & 0o777 for file in files} == {0o600}


@pytest.mark.slow
def test_a_folder_of_a_hundred_thousand_files_is_listed(tmp_path: Path) -> None:
    path = recorded(tmp_path, "")
    for number in range(100_000):
        os.close(os.open(tmp_path / f"file-{number}", os.O_CREAT | os.O_WRONLY))
    (found,) = list_sessions(tmp_path)
    assert found.path == path


BOUNDED = """
import resource, sys
from pathlib import Path
from verbteach_sessions.validate import validate
from verbteach_sessions.catalogue import entry
from tests.sessions.rooms import settings
settings("kitchen-1")
before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
found = validate(Path(sys.argv[1]), settings)
assert not found.valid
assert entry(Path(sys.argv[1])).problem
print(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before)
"""


@pytest.mark.slow
@pytest.mark.parametrize("shape", ["one line", "many lists", "many lines"])
def test_a_huge_record_takes_bounded_memory(tmp_path: Path, shape: str) -> None:
    block = {
        "one line": b"x" * 1024,
        "many lists": b'{"v":2,"a":[' + b"[]," * (MAX_LINE // 3 - 10) + b"0]}\n",
        "many lines": lined("{}") * 64,
    }[shape]
    with (tmp_path / LOG_NAME).open("wb") as file:
        while file.tell() < 200 * 1024 * 1024:
            file.write(block)
    ran = subprocess.run(
        [sys.executable, "-c", BOUNDED, str(tmp_path)], capture_output=True, text=True, check=True
    )
    assert int(ran.stdout) < 300 * 1024, "kilobytes beyond what the programs need"


def test_a_record_of_wrong_types_all_over_is_refused(tmp_path: Path) -> None:
    values: tuple[Any, ...] = (None, 1, "text", [], {}, True, [[]], {"data": {}})
    for value in values:
        (tmp_path / LOG_NAME).write_bytes(lined(json.dumps(value), kind='"header"'))
        assert not validate(tmp_path, settings).valid
        with pytest.raises(SessionError):
            resumed(tmp_path)

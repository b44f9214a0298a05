"""Each rule of a sound record fires when a record breaks it, and only then."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from tests.sessions.records import first, forge, raw_lines, read_events
from tests.sessions.rooms import TAUGHT, babble, begin, recorded, say, settings
from verbteach.dialogue.setting import Setting, UnknownSceneError
from verbteach_sessions.eventlog import LOG_NAME
from verbteach_sessions.header_file import HEADER_NAME
from verbteach_sessions.validate import CAUTIONS, RULES, validate

Events = list[dict[str, Any]]
Change = Callable[[Events], object]

SCRIPT = TAUGHT + "good\ncommand: wash the glorp\nunsure\nskip\nundo\nredo\nnote: so\nquit\n"


@pytest.fixture(scope="module")
def original(tmp_path_factory: pytest.TempPathFactory) -> dict[str, bytes]:
    path = recorded(tmp_path_factory.mktemp("once"), SCRIPT)
    return {name: (path / name).read_bytes() for name in (LOG_NAME, HEADER_NAME)}


@pytest.fixture
def path(original: dict[str, bytes], tmp_path: Path) -> Path:
    for name, content in original.items():
        (tmp_path / name).write_bytes(content)
    return tmp_path


def test_a_sound_record_is_valid_without_a_warning(path: Path) -> None:
    before = {one.name: one.read_bytes() for one in path.iterdir()}
    validation = validate(path, settings)
    assert validation.to_json() == {"valid": True, "problems": [], "warnings": []}
    assert {one.name: one.read_bytes() for one in path.iterdir()} == before


@pytest.mark.parametrize("seed", range(6))
def test_whatever_was_said_the_record_is_valid(tmp_path: Path, seed: int) -> None:
    with begin(tmp_path) as session:
        say(session, TAUGHT)
        babble(session, seed, 30)
    assert validate(session.path, settings).to_json() == {
        "valid": True,
        "problems": [],
        "warnings": [],
    }


def robots(events: Events) -> Events:
    return [event["data"] for event in events if event["type"] == "robot"]


def deciding(events: Events) -> dict[str, Any]:
    return next(data for data in robots(events) if data["decisions"])


def believing(events: Events) -> dict[str, Any]:
    return next(data for data in robots(events) if data["beliefs"] and data["beliefs"]["goals"])


def deep(levels: int) -> Any:
    value: Any = 0
    for _ in range(levels):
        value = [value]
    return value


MUTATIONS: list[tuple[str, Change]] = [
    ("schema", lambda e: e[4].__setitem__("type", "whisper")),
    ("schema", lambda e: e[3]["data"].__delitem__("acts")),
    ("schema", lambda e: e[3]["data"].__setitem__("extra", 1)),
    ("schema", lambda e: e[3]["data"].__setitem__("reward", "ten")),
    ("schema", lambda e: e[3]["data"].__setitem__("reward", True)),
    ("schema", lambda e: e[2]["data"].__setitem__("act", "yes")),
    ("schema", lambda e: e[2]["data"]["act"].__setitem__("text", deep(40))),
    ("schema", lambda e: deciding(e)["decisions"][0]["candidates"][0]["features"].update(x="1")),
    ("schema", lambda e: first(e, "learned")["data"]["record"]["experience"].append(["one"])),
    ("header", lambda e: e[0]["data"]["policy"].__setitem__("name", "psychic")),
    ("header", lambda e: e[0]["data"].__setitem__("id", "..")),
    ("header", lambda e: e[0]["data"]["parameters"].__setitem__("question_cap", "many")),
    ("order", lambda e: e.pop(3)),
    ("order", lambda e: e.insert(3, e[2])),
    ("order", lambda e: e.insert(1, e[0])),
    ("order", lambda e: e.append(e[-2])),
    ("order", lambda e: e[4]["data"].__setitem__("reply_to", 1)),
    ("order", lambda e: first(e, "undo")["data"].__setitem__("to", 2)),
    ("order", lambda e: first(e, "redo")["data"].__setitem__("to", 1)),
    ("order", lambda e: e.insert(2, first(e, "redo"))),
    ("moves", lambda e: e[2]["data"].__setitem__("act", {"act": "done"})),
    ("moves", lambda e: e[2]["data"].__setitem__("act", {"act": "shrug"})),
    ("moves", lambda e: e[3]["data"].__setitem__("phase", "read_back")),
    ("moves", lambda e: e[3]["data"].__setitem__("phase", "siesta")),
    ("moves", lambda e: e[3]["data"]["acts"].__setitem__(-1, {"act": "await_command"})),
    ("moves", lambda e: e[3]["data"]["acts"].__setitem__(-1, {"act": "hum"})),
    ("moves", lambda e: e[3]["data"]["texts"].append("And another thing.")),
    ("rewards", lambda e: robots(e)[3].__setitem__("reward", 1.0)),
    ("rewards", lambda e: robots(e)[0].__setitem__("reward", -2.0)),
    ("rewards", lambda e: robots(e)[5]["after"]["totals"].__setitem__("reward", 3.0)),
    ("beliefs", lambda e: believing(e)["beliefs"]["goals"][0].__setitem__("share", 0.3)),
    ("beliefs", lambda e: believing(e)["beliefs"]["goals"][0].__setitem__("share", -1)),
    (
        "beliefs",
        lambda e: believing(e)["beliefs"]["grounding"][0]["objects"].append(["Mug_1", 0.5]),
    ),
    ("beliefs", lambda e: believing(e)["beliefs"]["uncertain"].append(["(hot Water)", 1.5])),
    ("decisions", lambda e: deciding(e)["decisions"][0].__setitem__("chosen", 99)),
    ("decisions", lambda e: deciding(e)["decisions"][0].__setitem__("chosen", -1)),
    ("decisions", lambda e: deciding(e)["decisions"][0].__setitem__("propensity", 0)),
    ("times", lambda e: e[5].__setitem__("at", 0.001)),
    ("undo", lambda e: first(e, "undo")["data"]["after"].__setitem__("scene", "kitchen-9")),
    ("undo", lambda e: first(e, "redo")["data"]["after"]["totals"].__setitem__("episodes", 0)),
    ("replay", lambda e: e[3]["data"]["texts"].__setitem__(0, "Of course.")),
    ("replay", lambda e: e[3]["data"]["after"].__setitem__("digest", "0" * 64)),
    ("replay", lambda e: first(e, "learned")["data"]["record"]["spaces"].pop()),
    ("replay", lambda e: e[0]["data"].__setitem__("scene", "kitchen-2")),
    ("replay", lambda e: e[0]["data"].__setitem__("scene", "the-moon")),
]


@pytest.mark.parametrize(("rule", "change"), MUTATIONS)
def test_a_mutation_breaks_its_rule(path: Path, rule: str, change: Change) -> None:
    before = read_events(path)
    forge(path, change)
    validation = validate(path, settings)
    assert not validation.valid
    assert {one.rule for one in validation.problems} == {rule}
    assert all(one.message for one in validation.problems)
    pairs = zip(before, read_events(path), strict=False)
    place = next((n for n, (a, b) in enumerate(pairs) if a != b), len(before))
    named = validation.problems[0].seq
    assert named is None or place <= named <= place + 2
    assert json.loads(json.dumps(validation.to_json()))["valid"] is False


def changed(path: Path) -> None:
    lines = raw_lines(path)
    lines[6] = lines[6].replace(b"0", b"1", 1)
    (path / LOG_NAME).write_bytes(b"".join(lines))


def lost(path: Path) -> None:
    (path / LOG_NAME).write_bytes(
        b"".join(line for n, line in enumerate(raw_lines(path)) if n != 6)
    )


def swapped(path: Path) -> None:
    lines = raw_lines(path)
    (path / LOG_NAME).write_bytes(b"".join([*lines[:6], lines[7], lines[6], *lines[8:]]))


def newer(path: Path) -> None:
    lines = raw_lines(path)
    (path / LOG_NAME).write_bytes(b"".join([*lines[:6], b'{"v":3}\n']))


def emptied(path: Path) -> None:
    (path / LOG_NAME).write_bytes(b"")


def removed(path: Path) -> None:
    (path / LOG_NAME).unlink()


@pytest.mark.parametrize(
    ("rule", "damage", "seq"),
    [
        ("hash", changed, 6),
        ("hash", lost, 6),
        ("hash", swapped, 6),
        ("file", newer, 6),
        ("file", emptied, None),
        ("file", removed, None),
    ],
)
def test_a_damaged_file_breaks_its_rule(
    path: Path, rule: str, damage: Callable[[Path], None], seq: int | None
) -> None:
    damage(path)
    (problem,) = validate(path, settings).problems
    assert (problem.rule, problem.seq) == (rule, seq)


PERSONAL: list[tuple[str, Change]] = [
    ("e-mail", lambda e: first(e, "note")["data"].__setitem__("text", "write to ann@example.org")),
    ("name", lambda e: first(e, "note")["data"].__setitem__("raw", "note: my name is Ann Lee")),
    ("telephone", lambda e: e[2]["data"].__setitem__("raw", "call +49 30 901820 then")),
]


@pytest.mark.parametrize(("kind", "change"), PERSONAL)
def test_what_looks_personal_is_a_warning_that_does_not_repeat_it(
    path: Path, kind: str, change: Change
) -> None:
    forge(path, change)
    validation = validate(path, settings)
    assert validation.valid
    (warning,) = validation.warnings
    assert warning.rule == "personal"
    assert kind in warning.message
    assert "ann" not in warning.message.casefold()


def test_every_caution_is_tested() -> None:
    assert set(CAUTIONS) == {"torn", "header-file", "personal"}


def test_every_rule_has_a_mutation() -> None:
    # A broken promise needs a session that made one: see test_promise.
    assert set(RULES) == {rule for rule, _ in MUTATIONS} | {"hash", "file", "promise"}


def test_a_torn_last_line_is_a_warning(path: Path) -> None:
    with (path / LOG_NAME).open("ab") as file:
        file.write(b'{"v":1')
    validation = validate(path, settings)
    assert validation.valid
    assert [one.rule for one in validation.warnings] == ["torn"]


def test_a_header_file_that_says_otherwise_is_a_warning(path: Path) -> None:
    (path / HEADER_NAME).write_text("{}")
    validation = validate(path, settings)
    assert validation.valid
    assert [one.rule for one in validation.warnings] == ["header-file"]


def test_a_record_from_scenes_that_are_not_here_cannot_be_replayed(path: Path) -> None:
    def nowhere(scene: str) -> Setting:
        raise UnknownSceneError(f"there is no scene {scene!r}")

    (problem,) = validate(path, nowhere).problems
    assert problem.rule == "replay"
    assert "kitchen-1" in problem.message

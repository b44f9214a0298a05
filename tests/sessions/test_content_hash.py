"""One script has one content hash, however it was said; another has another."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.sessions.rooms import TAUGHT, Clock, begin, say, settings
from verbteach.dialogue.parameters import RobotParameters
from verbteach_sessions.header import Header
from verbteach_sessions.method import Method
from verbteach_sessions.session import Session

SAID = TAUGHT + "why\ngood\nnote: fine\nundo\nredo\n"


def test_one_script_has_one_content_hash_in_every_interface(tmp_path: Path) -> None:
    hashes: set[str] = set()
    for interface, via in (("app", "key"), ("plain", "typed"), ("script", "script")):
        header = Header.new("kitchen-1", interface=interface, terminal=(80, len(via)))
        clock = Clock(start=float(len(hashes)))
        with Session.create(tmp_path, header, settings, clock=clock) as session:
            say(session, SAID)
            hashes.add(session.content_hash)
    assert len(hashes) == 1


@pytest.mark.parametrize(
    "other",
    [SAID + "flag\n", SAID.replace("fine", "fin"), SAID.replace("good\nnote", "bad\nnote")],
)
def test_another_script_has_another_content_hash(tmp_path: Path, other: str) -> None:
    with begin(tmp_path) as one, begin(tmp_path) as two:
        assert say(one, SAID).content_hash != say(two, other).content_hash


def test_another_seed_has_another_content_hash(tmp_path: Path) -> None:
    seeded = Method(parameters=RobotParameters(seed=1))
    with begin(tmp_path) as one, begin(tmp_path, method=seeded) as two:
        assert one.content_hash != two.content_hash

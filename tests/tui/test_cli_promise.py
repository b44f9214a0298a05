"""`teach --promise`: what is promised stands in the record and in view, or is refused in a line."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from tests.sessions.rooms import BOIL
from tests.tui.commandline import assert_refused, here
from verbteach_scenarios.weights import save_weights, starting_weights

SHOWN = BOIL.removesuffix("good\n")


def header(session: str) -> dict[str, Any]:
    read: dict[str, Any] = json.loads((Path(session) / "header.json").read_text("utf-8"))
    return read


def test_a_promise_is_recorded_told_and_verified(tmp_path: Path) -> None:
    words = ("--promise", 0.7, "--policy", "rl", "--sessions", tmp_path)
    ran = here("teach", "--plain", *words, typed=SHOWN + "skip\nskip\nskip\n")
    told = "acts when at least "
    assert f"Note: The robot {told}" in ran.out
    assert "promised 70%, calibrated on" in ran.out
    (session,) = [path for path in tmp_path.iterdir() if path.is_dir()]
    promise = header(str(session))["promise"]
    supported = starting_weights().calibrations
    assert supported is not None
    expected = supported.promise(0.7, "rl", "perfect", "literal")
    assert promise["sure"] == expected.sure
    assert promise["lessons"] == expected.lessons
    assert here("replay", session, "--verify", "--json").document["verified"] is True


def test_what_cannot_be_promised_is_refused_in_a_line(tmp_path: Path) -> None:
    base = ("teach", "--plain", "--sessions", tmp_path)
    assert_refused(here(*base, "--promise", 0.99, "--policy", "rl"), "99%", "cannot be promised")
    assert_refused(here(*base, "--promise", 1.5), "between 0 and 1")
    assert_refused(here(*base, "--promise", 0.6, "--policy", "she16"), "she16", "calibrated")
    assert_refused(
        here(*base, "--promise", 0.6, "--policy", "rl", "--noise", "std5"), "std5", "calibrated"
    )
    bare = tmp_path / "bare.json"
    save_weights(bare, type(w := starting_weights())(**{**vars(w), "calibrations": None}))
    assert_refused(here(*base, "--promise", 0.6, "--weights", bare), "not calibrated", "train")
    assert_refused(here(*base, "--promise", 0.6, "--resume", tmp_path), "--promise")

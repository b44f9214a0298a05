"""The true world at every turn, followed without a learner, is the one that recomputing gives."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from tests.sessions.rooms import BOIL, babble, begin, recorded, say, settings
from verbteach.dialogue.setting import Setting, UnknownSceneError
from verbteach_sessions.exports.reading import read_dialogue
from verbteach_sessions.exports.worlds import follow
from verbteach_sessions.replay import replay

EDITED = """\
command: fetch the kettle
do: moveto Mug_1
do: moveto Kettle_1
do: grasp Kettle_1
remove: 1
done
good
"""


@pytest.mark.parametrize("seed", [1, 4])
def test_every_world_of_a_session_is_followed(tmp_path: Path, seed: int) -> None:
    with begin(tmp_path) as session:
        path = babble(session, seed, 60).path
    worlds = follow(read_dialogue(path), settings)
    states = [frame.state for frame in replay(path, settings) if frame.event.type == "robot"]
    turns = [turn for turn in read_dialogue(path).turns if turn.kind == "robot"]
    for turn, state in zip(turns, states, strict=True):
        assert state is not None
        assert worlds[turn.world][1] == state.world
        assert worlds[turn.world][0].id == turn.scene


def test_an_execution_and_another_scene_are_followed(tmp_path: Path) -> None:
    path = recorded(tmp_path, BOIL + "scene: kitchen-3\ncommand: boil the water\nbad\n")
    dialogue = read_dialogue(path)
    worlds = follow(dialogue, settings)
    assert all(turn.world in worlds for turn in dialogue.turns)


def test_a_demonstration_that_was_edited_is_followed(tmp_path: Path) -> None:
    with begin(tmp_path) as session:
        path = say(session, EDITED).path
    dialogue = read_dialogue(path)
    assert "revise_steps" in [name for turn in dialogue.turns for name in turn.act_names]
    assert all(turn.world in follow(dialogue, settings) for turn in dialogue.turns)


def test_a_world_that_does_not_fit_its_hash_is_left_out(tmp_path: Path) -> None:
    dialogue = read_dialogue(recorded(tmp_path, BOIL))
    wrong = tuple(
        replace(turn, world=turn.world if turn.number < 3 else f"{turn.number:064d}")
        for turn in dialogue.turns
    )
    worlds = follow(replace(dialogue, turns=wrong), settings)
    assert wrong[0].world in worlds
    assert not [turn.world for turn in wrong[3:] if turn.world in worlds]


def test_without_its_scene_nothing_is_followed(tmp_path: Path) -> None:
    def nowhere(scene: str) -> Setting:
        raise UnknownSceneError(scene)

    assert follow(read_dialogue(recorded(tmp_path, BOIL)), nowhere) == {}

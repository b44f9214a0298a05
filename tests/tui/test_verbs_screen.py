"""The hypothesis graph: a condition is struck out or confirmed there, as any other event."""

from __future__ import annotations

from pathlib import Path

from tests.tui.room import BOIL_THE_WATER, NARROW, SETTINGS, Room, room, said
from verbteach.verbs.space import FrameKey
from verbteach_sessions.replay import verify
from verbteach_tui.options import OpenSession
from verbteach_tui.past import Past
from verbteach_tui.screens.verbs import VerbsScreen
from verbteach_tui.views.rows import plain
from verbteach_tui.widgets.hypothesis_view import HypothesisView
from verbteach_tui.widgets.node_view import NodeView

FRAME = FrameKey("boil", 1)


def hypotheses(here: Room) -> set[str]:
    nodes = here.teach.snapshot.knowledge.frames[FRAME].nodes
    return {" ".join(map(str, node)) for node in nodes}


def node(here: Room) -> str:
    rows = here.app.screen.query_one(NodeView).rows
    return " ".join(" ".join(plain(row) for row in rows).split())


async def test_a_condition_is_struck_out_by_key_and_the_graph_follows(tmp_path: Path) -> None:
    path = said(tmp_path, *BOIL_THE_WATER)
    async with room(tmp_path, OpenSession(path)) as here:
        before = hypotheses(here)
        await here.key("f5")
        assert "X is hot" in node(here)
        on = next(i for i, text in enumerate(conditions(here)) if "is on a burner" in text)
        await here.key("tab", *["down"] * on, "x")
        assert "is on a burner" not in node(here)
        assert isinstance(here.app.screen, VerbsScreen)
        assert len(hypotheses(here)) < len(before)
        await here.key("escape")
        assert "boil X need not mean that a cookware is on a burner" in here.dialogue
        await here.key("ctrl+z")
        assert hypotheses(here) == before
    assert verify(path, SETTINGS).verified
    assert [event.type for event in Past.open(path, SETTINGS)._events][-3:] == [
        "learned",
        "robot",
        "undo",
    ]


def conditions(here: Room) -> tuple[str, ...]:
    view = here.app.screen.query_one(HypothesisView)
    return view._graph.nodes[view.chosen].conditions


async def test_a_condition_is_confirmed_by_mouse_and_key(tmp_path: Path) -> None:
    path = said(tmp_path, *BOIL_THE_WATER)
    async with room(tmp_path, OpenSession(path), size=NARROW) as here:
        await here.key("f5")
        view = here.app.screen.query_one(HypothesisView)
        view.choose("A")
        await here.settle()
        index = next(i for i, text in enumerate(conditions(here)) if text.endswith("burner is on"))
        panel = here.app.screen.query_one(NodeView)
        panel.reveal(index + 2)
        await here.pilot.pause()
        await here.click_target(panel, f"condition:{index}")
        await here.key("c")
        assert all("(is-on " in one for one in hypotheses(here))


async def test_in_the_middle_of_a_command_nothing_is_corrected(tmp_path: Path) -> None:
    path = said(tmp_path, *BOIL_THE_WATER, "command: wash the mug")
    async with room(tmp_path, OpenSession(path)) as here:
        before = hypotheses(here)
        await here.key("f5", "x")
        assert hypotheses(here) == before
        told = [str(one.message) for one in here.app._notifications]
        assert any("Finish this command first" in text for text in told)

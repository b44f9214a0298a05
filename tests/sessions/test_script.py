from __future__ import annotations

from typing import get_args

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from tests.sessions.acts import script_acts
from verbteach.dialogue import acts
from verbteach.dialogue.acts import TeacherAct
from verbteach.world.fluents import Fluent, Literal
from verbteach.world.plan import Action
from verbteach_sessions import session_acts
from verbteach_sessions.script import (
    PREFIXES,
    WORDS,
    LineSyntaxError,
    ScriptAct,
    parse_line,
    render,
    spoken,
)
from verbteach_sessions.session_acts import SessionAct

HOT = Fluent("hot", ("Water_1",))
LIFTED_HOT = Literal(Fluent("hot", ("?0",)))
LIFTED_OFF = Literal(Fluent("on", ("?0", "<a>0")), positive=False)


@pytest.mark.parametrize(
    ("line", "act"),
    [
        ("command: boil the water", acts.Command("boil the water")),
        ("yes", acts.Yes()),
        ("no", acts.No()),
        ("unsure", acts.Unsure()),
        ("skip", acts.Skip()),
        ("nope, the red one", acts.Say("nope, the red one")),
        ("object: Kettle_1", acts.Point("Kettle_1")),
        ("do: moveto Kettle_1", acts.Do(Action("moveto", ("Kettle_1",)))),
        ("do: (moveto Kettle_1)", acts.Do(Action("moveto", ("Kettle_1",)))),
        ("insert: 2 moveto Kettle_1", acts.Insert(2, Action("moveto", ("Kettle_1",)))),
        ("remove: 3", acts.Remove(3, 3)),
        ("remove: 3-5  # all that", acts.Remove(3, 5)),
        ("move: 3 1", acts.Move(3, 1)),
        (
            "rule_out: boil/1 (not (on ?0 <a>0)) of (hot ?0) (not (on ?0 <a>0))",
            acts.RuleOut("boil/1", frozenset({LIFTED_HOT, LIFTED_OFF}), LIFTED_OFF),
        ),
        (
            "confirm: boil/1 (hot ?0) of (hot ?0)",
            acts.Confirm("boil/1", frozenset({LIFTED_HOT}), LIFTED_HOT),
        ),
        ("undo: 4", session_acts.Undo(4)),
        ("redo: 2", session_acts.Redo(2)),
        ("done", acts.Done()),
        ("good", acts.Good()),
        ("bad", acts.Bad()),
        ("stop", acts.Stop()),
        ("stop: 3", acts.Stop(3)),
        ("strike: (hot Water_1)", acts.Strike(Literal(HOT))),
        ("strike: (not (hot Water_1))", acts.Strike(Literal(HOT, positive=False))),
        ("keep: hot Water_1", acts.Keep(Literal(HOT))),
        ("show", acts.Show()),
        ("scene: kitchen-2", acts.GoToScene("kitchen-2")),
        ("why", session_acts.Why()),
        ("repeat", session_acts.Repeat()),
        ("undo", session_acts.Undo()),
        ("redo", session_acts.Redo()),
        ("flag", session_acts.Flag()),
        ("note: see #3 # and #4", session_acts.Note("see #3 # and #4")),
        ("quit", session_acts.Quit()),
        ("", None),
        ("   \t", None),
        ("# a remark", None),
        ("  # a remark", None),
        ("yes   # it is", acts.Yes()),
        ("do: grasp Mug_1  # the red one", acts.Do(Action("grasp", ("Mug_1",)))),
        ("it is #2", acts.Say("it is #2")),
        ("say: yes", acts.Say("yes")),
        ("time: now", acts.Say("time: now")),
        ("Yes", acts.Say("Yes")),
        ("  good \r\n", acts.Good()),
    ],
)
def test_a_line_is_read(line: str, act: ScriptAct | None) -> None:
    assert parse_line(line) == act


@pytest.mark.parametrize(
    "line",
    [
        *("object:", "object: two words", "do:", "stop: now", "stop: -1", "strike: ((", "scene:"),
        *("insert: 2", "insert: x moveto A", "remove: 1-x", "remove: ", "move: 3", "move: 3 a b"),
        *("undo: 0", "redo: some", "rule_out: boil/1 (hot ?0)", "confirm: boil/1 (hot ?0) of hot"),
        "rule_out: boil/1 (hot ?0) of ((hot ?0)",
    ],
)
def test_a_term_that_is_none_is_refused_with_the_line(line: str) -> None:
    with pytest.raises(LineSyntaxError, match=line.split(":", maxsplit=1)[0]):
        parse_line(line)


@given(script_acts)
def test_a_rendered_act_is_read_as_itself(act: ScriptAct) -> None:
    try:
        line = render(act)
    except ValueError:
        # Only prose can be what no line holds: line breaks, or spaces around it.
        text = getattr(act, "text", None)
        assert text is not None
        assert text != text.strip() or len(text.splitlines()) != 1 or not text
        return
    assert parse_line(line) == act
    assert "\n" not in line


@given(st.text())
def test_every_line_is_an_act_or_nothing_or_refused(line: str) -> None:
    assume("\n" not in line)
    try:
        act = parse_line(line)
    except LineSyntaxError:
        return
    assert (act is None) == (not line.strip() or line.strip().startswith("#"))


def test_every_act_has_a_word_or_a_prefix() -> None:
    names = {kind.name for kind in (*get_args(TeacherAct), *get_args(SessionAct))}
    assert names == {*WORDS, *PREFIXES}


def test_what_was_said_reads_without_its_prefix() -> None:
    assert spoken(acts.Command("boil the water")) == "boil the water"
    assert spoken(acts.Do(Action("grasp", ("Mug_1",)))) == "grasp Mug_1"
    assert spoken(acts.Yes()) == "yes"
    assert spoken(acts.Say("command: it")) == "command: it"

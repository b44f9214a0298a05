"""Situations of a dialogue, and what comes of a line that somebody types in one of them."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

from verbteach.dialogue import acts
from verbteach.dialogue.moves import Phase
from verbteach_scenarios.settings import make_settings
from verbteach_sessions.header import Header
from verbteach_sessions.method import Method
from verbteach_sessions.script import ScriptAct
from verbteach_sessions.session import Session
from verbteach_sessions.session_acts import SessionAct, Undo
from verbteach_tui.plain_talk import MisfitError, Talk

SETTINGS = make_settings()
TABLE = Path(__file__).parent / "data" / "utterances.tsv"

_BOIL = (
    "boil the water",
    *("moveto Kettle_1", "grasp Kettle_1", "moveto Burner_1", "set-on Kettle_1 Burner_1"),
    *("moveto StoveKnob_1", "turn StoveKnob_1", "done"),
)
_BOIL_MILK = (
    *("yes", "yes", "scene: kitchen-2", "boil the water", "skip"),
    "boil the milk in the pot",
)
_OPEN = ("open the fridge", "moveto Fridge_1", "open Fridge_1", "done", "yes")
_TAKE = ("take the blue mug", "moveto Mug_2", "grasp Mug_2", "done", "yes")


class Situation(NamedTuple):
    """A scene, a question policy, and what was said so far."""

    scene: str
    said: tuple[str, ...] = ()
    policy: str = "she16"


SITUATIONS = {
    "start": Situation("kitchen-1"),
    "living room": Situation("living-room-1"),
    "taught": Situation("kitchen-1", _TAKE),
    "offered": Situation("kitchen-1", ("boli the water",)),
    "which": Situation("kitchen-1", ("take the mug",)),
    "whether": Situation("kitchen-1", ("boil the watr",)),
    "absent": Situation("kitchen-1", ("take the banjo",)),
    "should": Situation("kitchen-1", _BOIL, "manual"),
    "goal": Situation("kitchen-1", (*_BOIL, *_BOIL_MILK), "manual"),
    "showing": Situation("kitchen-1", ("take the blue mug", "go to the blue mug")),
    "read back": Situation("kitchen-1", _BOIL),
    "opened": Situation("kitchen-1", (*_OPEN, "scene: kitchen-2", "open the fridge")),
    "taken": Situation("kitchen-1", (*_TAKE, "scene: kitchen-1", "take the blue mug")),
    "boiled": Situation("kitchen-1", (*_BOIL, "yes", "scene: kitchen-3", "boil the water")),
}


class Row(NamedTuple):
    """A line of the table: what is to come of ``said`` in a situation."""

    situation: str
    said: str
    outcome: str


def rows() -> list[Row]:
    """The table."""
    lines = TABLE.read_text("utf-8").splitlines()[1:]
    return [Row(*line.split("\t")) for line in lines]


class Situated:
    """A session in a situation, to which one line after the other may be said."""

    def __init__(self, situation: Situation, folder: Path) -> None:
        header = Header.new(situation.scene, method=Method.named(situation.policy))
        self._session = Session.create(folder, header, SETTINGS)
        self._talk = Talk(self._session)
        for line in situation.said:
            self._talk.hear(line, "pipe")
        self._before = self._session.robot.state

    @property
    def phase(self) -> Phase:
        """What the robot waits for here."""
        return self._before.turn.phase

    def outcome(self, said: str) -> str:
        """What comes of the line, in a few words; everything is then as it was before."""
        act = self._talk.snapshot.reader.read(said)
        if isinstance(act, SessionAct):
            return act.name
        try:
            self._talk.hear(said, "pipe")
        except MisfitError as error:
            return f"? {error}"
        state = self._session.robot.state
        told = _told(self._session, act)
        if state is not self._before:
            self._talk.say(Undo(), "undo", "pipe")
        assert self._session.robot.state.digest == self._before.digest
        return told


def _told(session: Session, act: ScriptAct | None) -> str:
    """The robot's complaint after a question mark; else what it waits for and what it read."""
    turn = session.turn
    for one in turn.acts:
        if isinstance(one, acts.AskAgain | acts.AskRephrase):
            return f"? {one.reason}"
    return f"{turn.phase.value}: {turn.reading or (act.name if act else '')}"

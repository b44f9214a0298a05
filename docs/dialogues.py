"""Writes dialogues.md: the four dialogues of She & Chai (2017), Table 1, as they happen here.

Each is held in a session of its own by a simulated teacher who has a lesson in
mind, after the lessons that the robot was taught before. `python
docs/dialogues.py` rewrites the page; `--check` only says whether it is current.
"""

from __future__ import annotations

import sys
import tempfile
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from verbteach.dialogue import acts
from verbteach.dialogue.lesson import Lesson
from verbteach.dialogue.setting import Settings
from verbteach.dialogue.simulated import SimulatedTeacher
from verbteach.world.fluents import Fluent, Literal
from verbteach.world.plan import Action
from verbteach_scenarios.settings import make_settings
from verbteach_sessions.driving import drive
from verbteach_sessions.header import Header
from verbteach_sessions.method import Method, starting_policy
from verbteach_sessions.session import Session
from verbteach_sessions.transcript import TEACHER, Line

PAGE = Path(__file__).resolve().parent / "dialogues.md"

_ON_THE_STOVE = ("set-on Kettle_1 Burner_1", "moveto StoveKnob_1", "turn StoveKnob_1")
_BOIL = ("moveto Kettle_1", "grasp Kettle_1", "moveto Burner_1", *_ON_THE_STOVE)
_ASIDE = ("moveto Kettle_1", "grasp Kettle_1", "moveto Table_1", "put-on Kettle_1 Table_1")
_HOT = Literal(Fluent("hot", ("Water",)))


@dataclass(frozen=True)
class Dialogue:
    """One of the table's: what was taught before, and the lesson that is shown."""

    title: str
    paper: tuple[str, ...]
    policy: str
    lesson: Lesson
    before: tuple[Lesson, ...] = ()


def _boil(name: str, *after: str) -> Lesson:
    steps = tuple(Action.parse(step) for step in (*_BOIL, *after))
    meant = {"the water": ("Water",)}
    return Lesson(name, "kitchen-1", "boil the water", "boil", meant, steps, frozenset({_HOT}))


def _boil_in(thing: str, called: str, place: str, fetched: Sequence[str], *after: str) -> Lesson:
    """Boiling water in a pot of kitchen-5, which ends up in a place."""
    tap = ("moveto Tap_1", "turn-on Tap_1")
    filled = ("moveto Sink_1", f"drop-in {thing} Sink_1", f"grasp {thing}")
    heated = ("moveto StoveKnob_1", "turn StoveKnob_1", "moveto Burner_1")
    steps = (*tap, *fetched, *filled, *heated, f"set-on {thing} Burner_1", *after)
    goal = frozenset(
        {_HOT, Literal(Fluent("has", (thing, "Water"))), Literal(Fluent("on", (thing, place)))}
    )
    return Lesson(
        f"{thing} {place}",
        "kitchen-5",
        f"boil the water in {called}",
        "boil",
        {"the water": ("Water",), called: (thing,)},
        tuple(Action.parse(step) for step in steps),
        goal,
    )


def _saucepan(place: str, *after: str) -> Lesson:
    return _boil_in("Pot_1", "the saucepan", place, ("moveto Pot_1", "grasp Pot_1"), *after)


_RACK = ("grasp Pot_1", "moveto Rack_1", "put-on Pot_1 Rack_1")
_FROM_CUPBOARD = ("moveto Cupboard_1", "open Cupboard_1", "take-out Pot_2 Cupboard_1")


def dialogues() -> tuple[Dialogue, ...]:
    """The four, in the table's order."""
    return (
        Dialogue(
            "Only demonstration: an execution",
            (
                "H1: Boil the water.",
                "R1: (selects a hypothesis and executes the action accordingly)",
                "H2: (gives true/false feedback on whether the execution is correct)",
            ),
            "she16",
            _boil("again"),
            (_boil("shown"),),
        ),
        Dialogue(
            "Only demonstration: learning",
            (
                "H3: Boil the water.",
                "R3: I don't know how to boil, could you show me an example?",
                "H4: (shows how, step by step)",
                "R4: (accepts, and induces a hypothesis)",
            ),
            "she16",
            _boil("shown"),
        ),
        Dialogue(
            "Interactive learning: an execution",
            (
                "H1: Boil the water.",
                "R1: I see a silver object on the table, is that a pot?",
                "H2: Yes.",
                "R2: Should I leave the pot on the stove after boil?",
                "H3: Yes.",
                "R3: Ok. (selects a hypothesis to execute)",
                "H4: Thank you.",
            ),
            "manual",
            _boil_in("Pot_2", "the pot", "Burner_1", _FROM_CUPBOARD),
            (_saucepan("Rack_1", *_RACK), _saucepan("Burner_1")),
        ),
        Dialogue(
            "Interactive learning: learning",
            (
                "H5: Boil the water.",
                "R5: I don't know how to boil, could you show me an example?",
                "H6: Ok. (demonstrates the task, at the end puts the pot on a heat pad)",
                "R6: So after boiling something, should I put it on a heat pad?",
                "H7: No, you don't have to.",
                "R7: I see. (induces a goal state hypothesis)",
            ),
            "rl",
            _boil("set aside", *_ASIDE),
        ),
    )


def played(dialogue: Dialogue, folder: Path) -> Session:
    """The session in which the dialogue was held; its last command is the one to show."""
    ready = settings()
    header = Header.new(dialogue.lesson.scene, _method(dialogue.policy), teacher="simulated")
    session = Session.create(folder, header, ready)
    lessons = (*dialogue.before, dialogue.lesson)
    for number, lesson in enumerate(lessons, start=1):
        drive(session, _shown_by_hand(session, lesson, ready, number < len(lessons)))
    return session


def _shown_by_hand(
    session: Session, lesson: Lesson, ready: Settings, show: bool
) -> SimulatedTeacher:
    """A teacher of one lesson; earlier lessons are shown, whatever the robot would do."""
    teacher = SimulatedTeacher([lesson], ready)
    if show:
        while not isinstance(
            said := teacher.reply(session.turn, session.robot.state), acts.Command
        ):
            session.perform(said or acts.Skip(), via="simulated")
        session.perform(said, via="simulated")
        if not isinstance(session.turn.waiting_act, acts.RequestDemonstration):
            session.perform(acts.Show(), via="simulated")
    return teacher


@cache
def settings() -> Settings:
    """The bundled scenes, each made ready once."""
    return make_settings()


def _method(policy: str) -> Method:
    """Learned weights are held, so that the page does not hang on the earlier lessons."""
    return Method(starting_policy(frozen=True)) if policy == "rl" else Method.named(policy)


def shown(session: Session) -> Sequence[Line]:
    """The lines from the last command on."""
    lines = session.transcript()
    first = max(i for i, line in enumerate(lines) if line.kind == acts.Command.name)
    return lines[first:]


def held(folder: Path) -> tuple[tuple[Dialogue, tuple[Line, ...]], ...]:
    """The four dialogues with what was said in them; their sessions are kept in ``folder``."""
    found = []
    for dialogue in dialogues():
        with played(dialogue, folder) as session:
            found.append((dialogue, tuple(shown(session))))
    return tuple(found)


def page(four: Sequence[tuple[Dialogue, Sequence[Line]]]) -> str:
    """The whole page."""
    parts = [_HEAD]
    for number, (dialogue, said) in enumerate(four, start=1):
        lines = "\n".join(_told(said))
        paper = "\n".join(dialogue.paper)
        parts.append(
            f"## {number}. {dialogue.title}\n\nIn the paper:\n\n```\n{paper}\n```\n\n"
            f"Here (`--policy {dialogue.policy}`{_taught(dialogue)}):\n\n```\n{lines}\n```\n"
        )
    return "\n".join(parts)


def _taught(dialogue: Dialogue) -> str:
    count = len(dialogue.before)
    return f", after {count} lesson{'s' * (count != 1)}" if count else ""


def _told(lines: Sequence[Line]) -> Iterator[str]:
    """The lines as the page has them; a demonstration's steps stand in one line."""
    steps: list[str] = []
    for line in lines:
        if line.kind in (acts.Do.name, acts.ObserveStep.name):
            steps += [line.text] if line.speaker == TEACHER else []
            continue
        if steps:
            yield f"H: ({'; '.join(steps)})"
            steps = []
        if line.kind != acts.AwaitCommand.name:
            yield f"{'H' if line.speaker == TEACHER else 'R'}: {line.text}"


_HEAD = """# The four dialogues of the paper's Table 1

She & Chai (2017) show in Table 1 how learning from demonstration alone differs
from learning that asks. These are the same four dialogues as they happen here:
a simulated teacher with a lesson in mind answers, and nothing the robot says is
written in advance. `python docs/dialogues.py` holds them again and writes this page.
"""


def main(arguments: Sequence[str]) -> int:
    """Write the page, or with `--check` say whether it is current."""
    with tempfile.TemporaryDirectory() as folder:
        text = page(held(Path(folder)))
    if "--check" in arguments:
        current = PAGE.is_file() and PAGE.read_text("utf-8") == text
        print("current" if current else "stale: run python docs/dialogues.py")
        return 0 if current else 1
    PAGE.write_text(text, "utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

"""Acts, their arguments and the dialogue's state, in the words of ConvLab-3's unified format."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple

from verbteach.dialogue.codec import ROBOT_ACTS, TEACHER_ACTS
from verbteach.dialogue.moves import Phase
from verbteach_sessions.exports.dialogue import TEACHER, Turn

DOMAIN = "household"

# What an act's field is called as a slot, and what that means. All others are told by their acts.
_SLOTS: Mapping[str, str] = {
    "command": "what the robot should do, in English",
    "text": "what was said freely",
    "scene": "the scene that the robot is in or goes to",
    "phase": "what the robot waits for",
    "object": "an object's id",
    "np": "a noun phrase of the command",
    "fluent": "a fluent",
    "literal": "a fluent that should hold, or should not",
    "goal": "a literal of a goal",
    "action": "an action of the domain, with its objects",
    "plan": "an action of a plan",
    "done": "an action that was done",
    "failed": "an action that could not be done",
    "change": "a literal that became true",
    "pairs": "a noun phrase and the object it may mean",
    "verb": "a verb",
    "hypothesis": "a goal hypothesis",
    "outcome": "how an episode ended",
    "clause": "a clause of the command",
    "steps": "an action of a demonstration",
    "frame": "a verb frame",
    "step": "the step after which an execution stops",
}
_CATEGORICAL: Mapping[str, tuple[str, ...]] = {"phase": tuple(phase.value for phase in Phase)}
_STATE = ("scene", "command", "phase")


class _Kind(NamedTuple):
    """A dialogue act without its value: the ontology lists these."""

    part: str
    intent: str
    slot: str


class Acts:
    """Turns' acts in the format's words; remembers which there are, and who uses them."""

    def __init__(self) -> None:
        self.users: dict[_Kind, set[str]] = {}

    def of(self, turn: Turn) -> dict[str, list[dict[str, Any]]]:
        """The turn's ``dialogue_acts``."""
        made: dict[str, list[dict[str, Any]]] = {
            "categorical": [],
            "non-categorical": [],
            "binary": [],
        }
        for act in turn.acts:
            name = str(act.get("act"))
            values = list(_values(name, act))
            for slot, value in values:
                self._note("non-categorical", name, slot, turn)
                told = {"intent": name, "domain": DOMAIN, "slot": slot, "value": value}
                made["non-categorical"].append({**told, **_span(turn.text, value)})
            if not values:
                self._note("binary", name, "", turn)
                made["binary"].append({"intent": name, "domain": DOMAIN, "slot": ""})
        return made

    def _note(self, part: str, intent: str, slot: str, turn: Turn) -> None:
        self.users.setdefault(_Kind(part, intent, slot), set()).add(turn.speaker)


def state(turn: Turn) -> dict[str, Any]:
    """The state on a teacher's turn: where the robot is, what it was told, what it waits for."""
    command = turn.text if turn.act_names == ("command",) else ""
    return {DOMAIN: {"scene": turn.scene, "command": command, "phase": turn.phase}}


def ontology(acts: Acts) -> dict[str, Any]:
    """The ontology of the acts seen."""
    parts: dict[str, list[str]] = {"categorical": [], "non-categorical": [], "binary": []}
    for kind in sorted(acts.users):
        users = acts.users[kind]
        told = {
            "user": TEACHER in users,
            "system": bool(users - {TEACHER}),
            "intent": kind.intent,
            "domain": DOMAIN,
            "slot": kind.slot,
        }
        parts[kind.part].append(str(told))
    return {
        "domains": {
            DOMAIN: {
                "description": "a household robot that learns verbs from its teacher",
                "slots": {name: _slot(name) for name in _SLOTS},
            }
        },
        "intents": {name: {"description": about} for name, about in _intents()},
        "dialogue_acts": parts,
        "state": {DOMAIN: dict.fromkeys(_STATE, "")},
    }


def _slot(name: str) -> dict[str, Any]:
    values = _CATEGORICAL.get(name, ())
    return {
        "description": _SLOTS[name],
        "is_categorical": bool(values),
        "possible_values": list(values),
    }


def _intents() -> Iterator[tuple[str, str]]:
    """Every act's name, with the first line that its class says of it."""
    for name, kind in {**TEACHER_ACTS, **ROBOT_ACTS}.items():
        yield name, (kind.__doc__ or name).splitlines()[0]


def _values(name: str, act: Mapping[str, Any]) -> Iterator[tuple[str, str]]:
    for field, value in act.items():
        slot = "command" if (name, field) == ("command", "text") else field
        if slot not in _SLOTS or field == "act":
            continue
        for item in value if isinstance(value, list) else [value]:
            text = " = ".join(map(str, item)) if isinstance(item, list) else str(item)
            if item is not None and text:
                yield slot, text


def _span(utterance: str, value: str) -> dict[str, int]:
    start = utterance.find(value)
    return {} if start < 0 else {"start": start, "end": start + len(value)}

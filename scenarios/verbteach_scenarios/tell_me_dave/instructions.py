"""The corpus's instructions and the domain's actions, each turned into the other.

| instruction | action |
|---|---|
| ``keep x On z`` | ``keep-on x z``; ``In``, ``Inside``, ``Near`` likewise |
| ``pour x``, ``pour x y`` | ``pour x``, ``pour-into x y`` |
| ``add IceCreamScoop y``, ``add x y`` | ``add-scoop IceCreamScoop y``, ``add x y`` |
| ``turn d``; ``open``, ``close``, ``press`` likewise | ``turn d h``, done near its host ``h`` |
| ``press d`` of a thing held, and likewise | ``press-held d h``, done with ``h`` in hand |
| all others | the same words |

The added argument is a function of the named object, so that two actions are
equal exactly when their instructions are. An instruction outside the table
becomes an action of the same words, which no task knows.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from verbteach.world.plan import Action
from verbteach_scenarios.tell_me_dave.fittings import SCOOPFUL, Marks, hosts, kind

_KEEP = {"On": "keep-on", "In": "keep-in", "Inside": "keep-inside", "Near": "keep-near"}
_RELATION = {name: relation for relation, name in _KEEP.items()}
_WORKED = frozenset({"turn", "open", "close", "press"})
_HELD = "-held"
_INTO = "pour-into"
_SCOOP = "add-scoop"


@dataclass(frozen=True)
class Instructions:
    """Reads instructions in a room; ``at`` maps each part to its host, ``held`` are graspable."""

    at: dict[str, str]
    held: frozenset[str]

    @classmethod
    def among(cls, objects: Marks) -> Instructions:
        """Read instructions about these objects."""
        graspable = frozenset(o for o, marks in objects.items() if "IsGraspable" in marks)
        return cls(hosts(objects), graspable)

    def action(self, words: Sequence[str]) -> Action:
        """Return the domain's action for an instruction's words; there must be one at least."""
        name, *args = words
        if name == "keep" and len(args) == 3 and args[1] in _KEEP:
            return Action(_KEEP[args[1]], (args[0], args[2]))
        if name == "pour" and len(args) == 2:
            return Action(_INTO, tuple(args))
        if name == "add" and len(args) == 2 and kind(args[0]).endswith(SCOOPFUL):
            return Action(_SCOOP, tuple(args))
        if name in _WORKED and len(args) == 1:
            return self._worked(name, args[0])
        return Action(name, tuple(args))

    def _worked(self, name: str, device: str) -> Action:
        host = device if device in self.held else self.at.get(device, device)
        return Action(name + _HELD if host in self.held else name, (device, host))


def instruction(action: Action) -> str:
    """Return the corpus's words for an action: ``keep Mug_1 On Sink``."""
    name, args = action
    if name in _RELATION and len(args) == 2:
        return f"keep {args[0]} {_RELATION[name]} {args[1]}"
    base = name.removesuffix(_HELD)
    if base in _WORKED and len(args) == 2:
        return f"{base} {args[0]}"
    word = {_INTO: "pour", _SCOOP: "add"}.get(name, name)
    return " ".join((word, *args))

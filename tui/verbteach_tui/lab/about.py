"""What the lab's settings mean, for whoever stands on one of them."""

from __future__ import annotations

from collections.abc import Mapping

LAB = (
    "Train: the robot holds dialogues with simulated people about the bundled lessons and learns "
    "which question is worth its price. The mean return of its dialogues is drawn as it learns, "
    "and its weights are saved for teaching.",
    "Compare: policies are taught the same verbs, each asking in its own way, and are then tested "
    "in rooms that they have not seen.",
)
"""What can be done here, a paragraph each."""

FIGURES = (
    "SJI: how much of the wanted change came about; IED: how near the plan is to the "
    "demonstration; both 0 to 1, where it fits with the 95 % interval. Right: the share of "
    "commands carried out exactly. Asked: questions for a lesson and for a command."
)
"""The columns of the table of policies."""

SETTINGS: Mapping[str, str] = {
    "Do": "train the robot's asking, or compare ways of asking.",
    "Noise": (
        "how unreliable the robot's eyes are: perfect sees everything as it is, std3 and std5 are "
        "ever less sure of it, uniform is not to be relied on at all."
    ),
    "Dialogues": (
        "how many dialogues each phase learns from, the one after a demonstration and the one "
        "before the robot acts. More take longer and teach more surely."
    ),
    "Seed": "draws lessons and noise. The same seed gives the same figures.",
    "Tested in": "nothing is learned from these rooms; there the verbs are carried out.",
    "silent": "asks nothing.",
    "random": "asks whatever it may, by chance.",
    "split": "asks what is most in doubt about the goal, up to a cap.",
    "manual": "asks by a fixed rule: objects first, then the room, then the goal.",
    "rl": "has learned what to ask, as training teaches it.",
}
"""What each setting means, by its name; it goes on from "the name:"."""

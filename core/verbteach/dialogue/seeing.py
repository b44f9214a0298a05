"""What the robot makes of the true world: a look through its noise model."""

from __future__ import annotations

import numpy as np

from verbteach.dialogue.draft import Draft
from verbteach.dialogue.worth import PLACED
from verbteach.perception.belief import Belief
from verbteach.perception.noise import perceive
from verbteach.world.fluents import State

_LOOKS = ("before", "after")


def perceived(draft: Draft, world: State, look: str) -> Belief:
    """Look ``before`` the command or ``after`` the demonstration; each look draws anew.

    What never changes in a scene is known, not seen, and so is what the robot
    keeps in mind for itself.
    """
    parameters = draft.mind.parameters
    if parameters.noise.exact:
        return Belief.certain(world, (PLACED,))
    task = draft.mind.setting.task
    known = task.domain.static | draft.mind.setting.lexicon.unspoken
    noise = parameters.noise.with_spreads(dict.fromkeys(sorted(known), 0.0))
    number = draft.state.totals.episodes
    rng = np.random.default_rng([parameters.seed, number, _LOOKS.index(look), 0xE7E5])
    return perceive(world, task.fluents, noise, rng, (PLACED,))

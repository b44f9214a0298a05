"""The policies that a log can be asked about, as the probabilities that they give the acts."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from verbteach.dialogue.decision import Candidate
from verbteach.policy.asking_policy import AskingPolicy
from verbteach.policy.fixed_rules import ManualPolicy, RandomPolicy, SilentPolicy, SplitPolicy
from verbteach.policy.linear import LinearPolicy
from verbteach.policy.weights_file import PolicyWeights
from verbteach_sessions.errors import SessionError
from verbteach_sessions.people.logs import Chances

Floats = NDArray[np.float64]

RULES: Mapping[str, Callable[[], AskingPolicy]] = {
    "manual": ManualPolicy,
    "random": RandomPolicy,
    "split": SplitPolicy,
    "silent": SilentPolicy,
}
TARGETS: tuple[str, ...] = ("rl", *RULES)


class UnknownTargetError(SessionError):
    """No policy of this name can be evaluated on a log; the message lists those that can."""


def target(name: str, weights: PolicyWeights, epsilon: float = 0.0) -> Chances:
    """The policy called ``name``; ``rl`` acts on ``weights`` as they are.

    With probability ``epsilon`` it takes any act, so that it can be evaluated
    nearer to what was logged. Raises :class:`UnknownTargetError`.
    """
    if name != "rl" and name not in RULES:
        raise UnknownTargetError(f"no policy {name!r} to evaluate; there are {', '.join(TARGETS)}")
    phases: Mapping[str, AskingPolicy] = (
        {"execution": LinearPolicy(weights.execution), "learning": LinearPolicy(weights.learning)}
        if name == "rl"
        else dict.fromkeys(("execution", "learning"), RULES[name]())
    )

    def chances(phase: str, candidates: Sequence[Candidate]) -> Floats:
        even = np.full(len(candidates), 1.0 / len(candidates))
        chosen = even if name == "random" else _taken(phases[phase], candidates)
        return (1.0 - epsilon) * chosen + epsilon * even

    return chances


def _taken(policy: AskingPolicy, candidates: Sequence[Candidate]) -> Floats:
    """All of it on the act that is taken: these policies draw nothing as they stand."""
    found = np.zeros(len(candidates))
    found[policy.choose(None, candidates, np.random.default_rng(0)).chosen] = 1.0
    return found

"""The method under which a session runs: policy and parameters, as the header keeps them."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

from verbteach.dialogue.parameters import RobotParameters
from verbteach.dialogue.policy import Policy
from verbteach.dialogue.robot import Robot
from verbteach.dialogue.setting import Settings
from verbteach.perception.noise import NoiseModel
from verbteach.policy.demonstration_only import DemonstrationOnlyPolicy
from verbteach.policy.fixed_rules import ManualPolicy, RandomPolicy, SplitPolicy
from verbteach.verbs.knowledge import VerbKnowledge
from verbteach_sessions.errors import SessionError
from verbteach_sessions.plain_values import ParameterError, from_plain, to_plain

POLICIES: Mapping[str, type[Policy]] = {
    kind.name: kind for kind in (DemonstrationOnlyPolicy, ManualPolicy, SplitPolicy, RandomPolicy)
}


class UnknownPolicyError(SessionError):
    """No question policy has this name; the message lists those that there are."""


@dataclass(frozen=True)
class Method:
    """A question policy and the robot's parameters, the seed and the noise model among them."""

    policy: Policy = field(default_factory=DemonstrationOnlyPolicy)
    parameters: RobotParameters = field(default_factory=RobotParameters)

    @classmethod
    def named(cls, policy: str, parameters: RobotParameters | None = None) -> Method:
        """The method with a policy of this name. Raises :class:`UnknownPolicyError`."""
        return cls(_kind(policy)(), parameters or RobotParameters())

    def to_json(self) -> dict[str, Any]:
        """Plain JSON: ``policy``, ``seed``, ``noise`` and the other ``parameters``."""
        rest = to_plain(self.parameters)
        seed, noise = rest.pop("seed"), rest.pop("noise")
        return {"policy": to_plain(self.policy), "seed": seed, "noise": noise, "parameters": rest}

    @classmethod
    def from_json(cls, data: Mapping[str, Any]) -> Method:
        """Read what :meth:`to_json` wrote. Raises ``ParameterError``, ``UnknownPolicyError``."""
        policy = data["policy"]
        if not isinstance(policy, dict) or not isinstance(policy.get("name"), str):
            raise ParameterError("policy: a name is missing")
        parts = {"seed": data["seed"], "noise": data["noise"]}
        return cls(
            from_plain(_kind(policy["name"]), policy, "policy"),
            from_plain(RobotParameters, {**data["parameters"], **parts}),
        )

    def robot(self, settings: Settings, records: Sequence[Mapping[str, Any]] = ()) -> Robot:
        """A robot that has learned what the ``learned`` records say; it is in no scene yet."""
        knowledge, experience = knowledge_of(records)
        return Robot(settings, self.policy, self.parameters, knowledge, experience)

    def with_noise(self, noise: NoiseModel) -> Method:
        """The same method with other eyes."""
        return replace(self, parameters=replace(self.parameters, noise=noise))


def knowledge_of(
    records: Sequence[Mapping[str, Any]],
) -> tuple[VerbKnowledge, dict[tuple[str, str], int]]:
    """What the records teach: the verbs, and how often a phrase meant an object.

    The records are of their shape. Raises ``ValueError`` where a space is none.
    """
    spaces = [space for record in records for space in record["spaces"]]
    pairs = [(phrase, thing) for record in records for phrase, thing in record["experience"]]
    return VerbKnowledge.from_json({"spaces": spaces}), dict(Counter(pairs))


def _kind(policy: str) -> type[Policy]:
    if policy not in POLICIES:
        raise UnknownPolicyError(f"no policy {policy!r}; there are {', '.join(POLICIES)}")
    return POLICIES[policy]

"""The method under which a session runs: policy and parameters, as the header keeps them."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cache
from typing import Any

from verbteach.dialogue.parameters import RobotParameters
from verbteach.dialogue.policy import Policy
from verbteach.dialogue.promise import Promise
from verbteach.dialogue.robot import Robot
from verbteach.dialogue.setting import Setting, Settings
from verbteach.language.agreement import NoSecondReaderError
from verbteach.perception.noise import NoiseModel
from verbteach.policy.demonstration_only import DemonstrationOnlyPolicy
from verbteach.policy.fixed_rules import ManualPolicy, RandomPolicy, SplitPolicy
from verbteach.policy.learned_policy import LearnedPolicy
from verbteach.policy.weights_file import PolicyWeights
from verbteach.verbs.knowledge import VerbKnowledge
from verbteach.verbs.revision import Revision, revised
from verbteach_scenarios.weights import starting_weights
from verbteach_sessions.errors import SessionError
from verbteach_sessions.plain_values import ParameterError, from_plain, to_plain

_RULES: Mapping[str, type[Policy]] = {
    kind.name: kind for kind in (DemonstrationOnlyPolicy, ManualPolicy, SplitPolicy, RandomPolicy)
}


def starting_policy(weights: PolicyWeights | None = None, *, frozen: bool = False) -> LearnedPolicy:
    """The learned policy with these weights, else with those that come with the robot."""
    return LearnedPolicy.beginning(weights or starting_weights(), frozen=frozen)


POLICIES: Mapping[str, Callable[[], Policy]] = {LearnedPolicy.name: starting_policy, **_RULES}
"""The question policies by name, each as it is without any choice of its own."""


class UnknownPolicyError(SessionError):
    """No question policy has this name; the message lists those that there are."""


@dataclass(frozen=True)
class Method:
    """A question policy and the robot's parameters, the seed and the noise model among them.

    ``second_opinion``: the robot asks before it acts on a command that a second
    reader reads differently. With a ``promise`` it carries out only what it is
    sure enough of.
    """

    policy: Policy = field(default_factory=DemonstrationOnlyPolicy)
    parameters: RobotParameters = field(default_factory=RobotParameters)
    second_opinion: bool = False
    promise: Promise | None = None

    @classmethod
    def named(cls, policy: str, parameters: RobotParameters | None = None) -> Method:
        """The method with a policy of this name. Raises :class:`UnknownPolicyError`."""
        if policy not in POLICIES:
            raise UnknownPolicyError(f"no policy {policy!r}; there are {', '.join(POLICIES)}")
        return cls(POLICIES[policy](), parameters or RobotParameters())

    def to_json(self) -> dict[str, Any]:
        """Plain JSON: ``policy``, ``seed``, ``noise`` and the other ``parameters``.

        ``second_opinion`` and ``promise`` only where there is one, so that what
        was recorded without has the content hash it always had.
        """
        rest = to_plain(self.parameters)
        seed, noise = rest.pop("seed"), rest.pop("noise")
        more = {"second_opinion": True} if self.second_opinion else {}
        if self.promise is not None:
            more["promise"] = to_plain(self.promise)
        policy = to_plain(self.policy)
        return {"policy": policy, "seed": seed, "noise": noise, "parameters": rest, **more}

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
            from_plain(bool, data.get("second_opinion", False), "second_opinion"),
            from_plain(Promise | None, data.get("promise"), "promise"),
        )

    def settings(self, settings: Settings) -> Settings:
        """The settings as this method has them: with a second reader or without.

        Where one is wanted and a scene comes without, that raises ``NoSecondReaderError``.
        """
        return _needing_reader(settings) if self.second_opinion else _without_reader(settings)

    def robot(self, settings: Settings, records: Sequence[Mapping[str, Any]] = ()) -> Robot:
        """A robot that has learned what the ``learned`` records say; it is in no scene yet."""
        knowledge, experience = knowledge_of(records)
        here = self.settings(settings)
        policy = practised(self.policy, records)
        return Robot(here, policy, self.parameters, knowledge, experience, self.promise)

    def with_noise(self, noise: NoiseModel) -> Method:
        """The same method with other eyes."""
        return replace(self, parameters=replace(self.parameters, noise=noise))


def practised(policy: Policy, records: Sequence[Mapping[str, Any]]) -> Policy:
    """The policy after what the records say it learned. Raises ``ValueError`` on a wrong one."""
    if not isinstance(policy, LearnedPolicy):
        return policy
    for record in records:
        for step in record.get("policy", ()):
            policy = policy.after(step)
    return policy


def knowledge_of(
    records: Sequence[Mapping[str, Any]],
) -> tuple[VerbKnowledge, dict[tuple[str, str], int]]:
    """What the records teach: the verbs, and how often a phrase meant an object.

    The records are of their shape. Raises ``ValueError`` where a space
    or a revision is none.
    """
    knowledge, spaces = VerbKnowledge(), list[Any]()
    for record in records:
        spaces += record["spaces"]
        for revision in record.get("revisions", ()):
            knowledge, spaces = _with_spaces(knowledge, spaces), []
            knowledge = revised(knowledge, Revision.from_json(revision))
    pairs = [(phrase, thing) for record in records for phrase, thing in record["experience"]]
    return _with_spaces(knowledge, spaces), dict(Counter(pairs))


def _with_spaces(knowledge: VerbKnowledge, spaces: Sequence[Any]) -> VerbKnowledge:
    if not spaces:
        return knowledge
    more = VerbKnowledge.from_json({"spaces": list(spaces)})
    return VerbKnowledge.merged((*knowledge.spaces, *more.spaces))


def _needing_reader(settings: Settings) -> Settings:
    def setting(scene_id: str) -> Setting:
        found = settings(scene_id)
        if found.second is None:
            raise NoSecondReaderError(
                "the session is held with a second opinion, and there is none here:"
                " install the extra verbteach[nlp]"
            )
        return found

    return setting


def _without_reader(settings: Settings) -> Settings:
    @cache
    def setting(scene_id: str) -> Setting:
        found = settings(scene_id)
        return found if found.second is None else replace(found, second=None)

    return setting


def _kind(policy: str) -> type[Policy]:
    kinds: Mapping[str, type[Policy]] = {LearnedPolicy.name: LearnedPolicy, **_RULES}
    if policy not in kinds:
        raise UnknownPolicyError(f"no policy {policy!r}; there are {', '.join(kinds)}")
    return kinds[policy]

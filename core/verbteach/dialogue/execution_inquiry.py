"""The execution phase as a decision process: <l, e, KB, Grd, Goal>, its acts and their features.

She & Chai (2017), section 4.3, acts 1 to 5 of Table 2. A grounding answer or
one about the environment changes the goal belief at once.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from functools import cached_property, lru_cache, partial
from itertools import islice

import numpy as np

from verbteach.dialogue.acts import (
    DemonstrationReason,
    EnvPredYnq,
    GoalPredYnq,
    NpGrdWhq,
    NpGrdYnq,
    RequestDemonstration,
    RobotAct,
    SelectHypo,
)
from verbteach.dialogue.decision import Candidate
from verbteach.dialogue.grounding import GroundingBelief
from verbteach.dialogue.inquiry import (
    InquiryParameters,
    Label,
    Reply,
    candidates,
    doubt,
    grounding_questions,
    joint_chances,
    settle,
)
from verbteach.dialogue.late_features import LateFeatures
from verbteach.perception.belief import Belief
from verbteach.verbs.pool import GoalPool, PoolSource
from verbteach.world.fluents import Goal, Literal, State
from verbteach.world.reliance import Foresight, nothing_foreseen


@dataclass(frozen=True)
class ExecutionInquiry:
    """One command between its request and the choice of a goal.

    ``prior`` is the grounding as answered so far; ``grounding`` adds what the
    goal belief makes of it. ``static`` are the facts that are not perceived;
    ``believed`` is what the robot takes for true: plans start there.
    ``foresight`` says what pursuing a goal takes for granted.
    """

    source: PoolSource
    static: State
    believed: State
    belief: Belief
    prior: GroundingBelief
    pool: GoalPool
    parameters: InquiryParameters = field(default_factory=InquiryParameters)
    foresight: Foresight = nothing_foreseen
    asked: tuple[RobotAct, ...] = ()

    @classmethod
    def begin(
        cls,
        source: PoolSource,
        static: State,
        belief: Belief,
        grounding: GroundingBelief,
        parameters: InquiryParameters | None = None,
        foresight: Foresight = nothing_foreseen,
    ) -> ExecutionInquiry:
        """Take a command in."""
        chances = joint_chances(grounding, source.analogies.groundings)
        believed = _state(static, belief.believed())
        pool = source.pool(believed, chances)
        chosen = parameters or InquiryParameters()
        return cls(source, static, believed, belief, grounding, pool, chosen, foresight)

    @cached_property
    def grounding(self) -> GroundingBelief:
        """*Grd*: the marginals of the joint groundings, given all that is known."""
        if self.pool.empty:
            return self.prior
        weights: dict[str, dict[str, float]] = {}
        for phrase, meant in zip(self.prior.names, self.source.analogies.meant, strict=True):
            chances = np.bincount(meant.number, self.pool.referents).tolist()
            own = weights.setdefault(phrase, {})
            for thing, chance in zip(meant.things, chances, strict=True):
                own[thing] = own.get(thing, 0.0) + chance
        kept = GroundingBelief.of(weights)
        return GroundingBelief(kept.phrases, self.prior.settled)

    @cached_property
    def best(self) -> Goal:
        """The goal with the highest expected Jaccard index; empty where nothing is known."""
        goals = self.pool.goals(1)
        return goals[0][0] if goals else frozenset()

    def candidates(self) -> tuple[Candidate, ...]:
        """The acts to choose from, questions first; never none."""
        return self._candidates

    @cached_property
    def _candidates(self) -> tuple[Candidate, ...]:
        if self.pool.empty or not self.best:
            shown = RequestDemonstration(DemonstrationReason.NO_HYPOTHESIS)
            return (Candidate(shown, {"request_demonstration": 1.0}),)
        found: list[Candidate] = []
        if len(self.asked) < self.parameters.cap:
            asking = self._asking()
            found = [*candidates(self._questions(), asking), *self._goal_questions(asking)]
        return (*found, self._selection())

    def after(self, act: RobotAct, reply: Reply) -> ExecutionInquiry:
        """The state after a reply; an unsure one only uses the question up."""
        asked = (*self.asked, act)
        if reply.label is Label.UNSURE:
            return replace(self, asked=asked)
        match act:
            case NpGrdWhq() | NpGrdYnq():
                prior = settle(self.prior, act, reply, self.parameters.trust)
                chances = joint_chances(prior, self.pool.groundings)
                return replace(self, prior=prior, pool=self.pool.regrounded(chances), asked=asked)
            case GoalPredYnq(literal=literal):
                number = self.pool.numbers[literal]
                pool = self.pool.answered(number, reply.label is Label.YES)
                return replace(self, pool=pool, asked=asked)
            case EnvPredYnq(fluent=fluent):
                yes = reply.label is Label.YES
                belief = self.belief.answered(fluent, yes, self.parameters.trust)
                return replace(self.believing(belief), asked=asked)
        raise TypeError(f"{act!r} is no question of this phase")

    def believing(self, belief: Belief) -> ExecutionInquiry:
        """The state with another belief about the room, and the answers so far."""
        believed = _state(self.static, belief.believed())
        pool = self.source.pool(believed, self.pool.chances)
        number = pool.numbers
        for old, answer in self.pool.answers:
            if self.pool.literals[old] in number:
                pool = pool.answered(number[self.pool.literals[old]], answer)
        return replace(self, believed=believed, belief=belief, pool=pool)

    def _questions(self) -> Iterator[tuple[RobotAct, dict[str, float]]]:
        for act, features in grounding_questions(
            self.grounding, self.asked, self.parameters.object_questions
        ):
            gain = self._grounding_gain(act)
            if gain >= self.parameters.object_gain:
                yield act, {**features, "ask.gain": gain}
        yield from self._environment_questions()

    def _grounding_gain(self, act: RobotAct) -> float:
        if not isinstance(act, NpGrdYnq | NpGrdWhq):
            return 0.0
        meant = self.source.analogies.meant[self.prior.names.index(act.np)]
        if isinstance(act, NpGrdWhq):
            return self.pool.grounding_gain(meant.number, len(meant.things))
        other = meant.number != meant.things.index(act.object)
        return self.pool.grounding_gain(other.astype(np.int64), 2)

    def _environment_questions(self) -> Iterator[tuple[RobotAct, dict[str, float]]]:
        """Doubtful fluents that the plan to the best goal takes for granted.

        Without a plan, which doubt may be the reason of: those about the
        things that what is meant probably speaks of.
        """
        unsure = self.belief.doubtful(self.parameters.environment_doubt)
        hinges = self.foresight(self.believed, self.best) if unsure else frozenset()
        wanted = self._relevance() if hinges or hinges is None else {}
        found = []
        for fluent, confidence in unsure:
            if hinges is not None and fluent not in hinges:
                continue
            relevance = max((wanted.get(word, 0.0) for word in fluent.args), default=0.0)
            matters = relevance > 0.0 or hinges is not None
            if matters and EnvPredYnq(fluent) not in self.asked:
                found.append((-doubt(confidence) * relevance, fluent, confidence, relevance))
        for _, fluent, confidence, relevance in sorted(found)[
            : self.parameters.environment_questions
        ]:
            yield (
                EnvPredYnq(fluent),
                {
                    "env_pred_ynq": 1.0,
                    "env_pred_ynq.doubt": doubt(confidence),
                    "env_pred_ynq.unbelieved": float(confidence <= 0.5),
                    "env_pred_ynq.relevance": relevance,
                },
            )

    def _relevance(self) -> dict[str, float]:
        """How likely what is meant speaks of a thing: its likeliest literal's probability."""
        things = self.source.analogies.surroundings.affordances
        chances = self.pool.marginals
        wanted: dict[str, float] = {}
        for number in (chances > 0.2).nonzero()[0].tolist():
            chance = float(chances[number])
            for word in self.pool.literals[number].fluent.args:
                if word in things:
                    wanted[word] = max(wanted.get(word, 0.0), chance)
        return wanted

    def _goal_questions(self, asking: dict[str, float]) -> Iterator[Candidate]:
        open_ones = self._open_literals()
        gains = _Gains(self.pool, tuple(open_ones))
        for place, chance in enumerate(self.pool.yes_chances(open_ones)):
            features = {
                "goal_pred_ynq": 1.0,
                "goal_pred_ynq.probability": chance,
                "goal_pred_ynq.doubt": doubt(chance),
                **asking,
            }
            late = LateFeatures(features, partial(gains.of, place))
            yield Candidate(GoalPredYnq(self.pool.literals[open_ones[place]]), late)

    def _open_literals(self) -> list[int]:
        """The numbers of the most doubtful literals that nothing was asked about."""
        least = self.pool.doubts
        done = {number for number, _ in self.pool.answers}
        asked = {act.literal for act in self.asked if isinstance(act, GoalPredYnq)}
        doubtful = int(np.count_nonzero(least > self.parameters.doubt))
        order = (-least).argsort(kind="stable")[:doubtful].tolist()
        literals = self.pool.literals
        left = (n for n in order if n not in done and literals[n] not in asked)
        return list(islice(left, self.parameters.goal_questions))

    def _asking(self) -> dict[str, float]:
        value, certainty = self.pool.decision.value, self.pool.certainty
        return {
            "ask.value": value,
            "ask.certainty": certainty,
            "ask.spread": self._spread,
            "ask.asked": len(self.asked) / 10.0,
        }

    @cached_property
    def _spread(self) -> float:
        """How many literals are in doubt, growing ever more slowly."""
        return float(np.log1p(self.pool.doubts.sum()))

    def _selection(self) -> Candidate:
        value = self.pool.decision.value
        held = math.prod(self._holding(literal) for literal in sorted(self.best))
        features = {
            "select_hypo": 1.0,
            "select_hypo.value": value,
            "select_hypo.value_squared": value * value,
            "select_hypo.certainty": self.pool.certainty,
            "select_hypo.unsatisfied": 1.0 - held,
            "select_hypo.similarity": self.source.nearest,
            "select_hypo.spread": self._spread,
            "select_hypo.asked": len(self.asked) / 10.0,
        }
        return Candidate(SelectHypo(self.best, "expected", ()), features)

    def _holding(self, literal: Literal) -> float:
        confidence = self.belief[literal.fluent]
        return confidence if literal.positive else 1.0 - confidence


@dataclass(frozen=True)
class _Gains:
    """What asking about some of a pool's literals is worth, worked out for all of them at once.

    It does not hold the inquiry, which holds its candidates.
    """

    pool: GoalPool
    literals: tuple[int, ...]

    @cached_property
    def _values(self) -> list[float]:
        values: list[float] = self.pool.literal_gains(self.literals).tolist()
        return values

    def of(self, place: int) -> dict[str, float]:
        """The feature of the literal at that place."""
        return {"ask.gain": self._values[place]}


@lru_cache(maxsize=512)
def _state(static: State, believed: State) -> State:
    """All that is taken for true: the same object each time, whose hash is then known."""
    return static | believed


FEATURES: dict[str, str] = {
    "np_grd_whq": "asks which object a noun phrase is",
    "np_grd_whq.entropy": "entropy of the phrase's candidates, in nats (Table 3)",
    "np_grd_whq.many": "the phrase has more than 4 candidates (Table 3)",
    "np_grd_ynq": "asks whether a noun phrase is an object",
    "np_grd_ynq.probability": "probability that it is (Table 3)",
    "env_pred_ynq": "asks whether a fluent holds",
    "env_pred_ynq.doubt": "1 at confidence one half, 0 at 0 and 1",
    "env_pred_ynq.unbelieved": "the confidence is not above one half",
    "env_pred_ynq.relevance": "how likely what is meant speaks of one of the fluent's things",
    "goal_pred_ynq": "asks whether a literal should hold",
    "goal_pred_ynq.probability": "probability of a yes",
    "goal_pred_ynq.doubt": "1 where yes and no are equally likely",
    "ask.gain": "how much the answer raises the expected Jaccard index of the best goal",
    "ask.value": "expected Jaccard index of the best goal now, for any question",
    "ask.certainty": "probability that the best goal is exactly right, for any question",
    "ask.spread": "log(1 + expected number of literals judged wrongly), for any question",
    "ask.asked": "questions asked so far / 10, for any question",
    "select_hypo": "executes the best goal",
    "select_hypo.value": "its expected Jaccard index",
    "select_hypo.value_squared": "the square of that",
    "select_hypo.certainty": "probability that it is exactly right",
    "select_hypo.unsatisfied": "probability that it does not hold already (Table 3)",
    "select_hypo.similarity": "likeness of the noun phrases to the nearest demonstration (Table 3)",
    "select_hypo.spread": "log(1 + expected number of literals judged wrongly)",
    "select_hypo.asked": "questions asked so far / 10",
    "request_demonstration": "asks to be shown, where nothing is known",
}
"""The execution phase's features by name; each is 0 where it does not apply."""

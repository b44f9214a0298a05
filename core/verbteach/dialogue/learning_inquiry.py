"""The learning phase as a decision process: <l, e_start, e_end, Grd>, its acts and their features.

She & Chai (2017), section 4.3, acts 1, 2 and 6 to 8 of Table 2, and
``goal_relevant_ynq`` where it is switched on.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property

from verbteach.dialogue.acts import (
    BulkNpGrdYnq,
    GoalRelevantYnq,
    IncludeFluent,
    NpGrdWhq,
    NpGrdYnq,
    PredChangeYnq,
    RequestDemonstration,
    RobotAct,
)
from verbteach.dialogue.acts import DemonstrationReason as Reason
from verbteach.dialogue.decision import Candidate
from verbteach.dialogue.grounding import GroundingBelief
from verbteach.dialogue.inquiry import (
    InquiryParameters,
    Label,
    Reply,
    candidates,
    doubt,
    grounding_questions,
    settle,
    shifted,
)
from verbteach.verbs.seen_change import SeenChange
from verbteach.world.fluents import Goal, Literal
from verbteach.world.plan import Action


@dataclass(frozen=True)
class LearningInquiry:
    """One demonstration between its end and what is kept of it.

    ``change`` is what e_start, e_end and the actions say has changed;
    ``struck`` what the teacher said does not belong to the goal.
    """

    change: SeenChange
    grounding: GroundingBelief
    parameters: InquiryParameters = field(default_factory=InquiryParameters)
    struck: frozenset[Literal] = frozenset()
    asked: tuple[RobotAct, ...] = ()

    @property
    def goal(self) -> Goal:
        """What would be kept now."""
        return self.change.likely - self.struck

    @property
    def objects(self) -> tuple[str, ...]:
        """The likeliest object of each phrase that has one."""
        best = (self.grounding.best(phrase) for phrase in self.grounding.names)
        return tuple(thing for thing in best if thing is not None)

    def candidates(self) -> tuple[Candidate, ...]:
        """The acts to choose from, questions first; never none."""
        return self._candidates

    @cached_property
    def _candidates(self) -> tuple[Candidate, ...]:
        found: list[Candidate] = []
        if len(self.asked) < self.parameters.cap:
            found = candidates(self._questions(), self._asking())
        return (*found, self._inclusion())

    def after(self, act: RobotAct, reply: Reply) -> LearningInquiry:
        """The state after a reply; an unsure one only uses the question up."""
        asked = (*self.asked, act)
        if reply.label is Label.UNSURE:
            return replace(self, asked=asked)
        match act:
            case NpGrdWhq() | NpGrdYnq():
                grounding = settle(self.grounding, act, reply, self.parameters.trust)
                return replace(self, grounding=grounding, asked=asked)
            case BulkNpGrdYnq(pairs=pairs):
                grounding = _settled_all(self.grounding, pairs, reply, self.parameters.trust)
                return replace(self, grounding=grounding, asked=asked)
            case PredChangeYnq(literal=literal):
                yes = reply.label is Label.YES
                change = self.change.answered(literal, yes, self.parameters.trust)
                return replace(self, change=change, asked=asked)
            case GoalRelevantYnq(literal=literal):
                gone = frozenset() if reply.label is Label.YES else frozenset({literal})
                return replace(self, struck=self.struck | gone, asked=asked)
        raise TypeError(f"{act!r} is no question of this phase")

    def _questions(self) -> Iterator[tuple[RobotAct, dict[str, float]]]:
        yield from grounding_questions(self.grounding, self.asked, self.parameters.object_questions)
        yield from self._bulk_question()
        yield from self._change_questions()
        if self.parameters.goal_relevance:
            yield from self._relevance_questions()

    def _bulk_question(self) -> Iterator[tuple[RobotAct, dict[str, float]]]:
        open_phrases = [
            phrase
            for phrase in self.grounding.names
            if phrase not in self.grounding.settled and len(self.grounding[phrase]) > 1
        ]
        if len(open_phrases) < 2:
            return
        best = [self.grounding[phrase][0] for phrase in open_phrases]
        pairs = tuple(
            (phrase, thing) for phrase, (thing, _) in zip(open_phrases, best, strict=True)
        )
        question = BulkNpGrdYnq(pairs)
        if question not in self.asked:
            chance = math.prod(chance for _, chance in best)
            yield question, {"bulk_np_grd_ynq": 1.0, "bulk_np_grd_ynq.probability": chance}

    def _change_questions(self) -> Iterator[tuple[RobotAct, dict[str, float]]]:
        rows = [
            (min(chance, 1.0 - chance), literal, chance) for literal, chance in self.change.chances
        ]
        rows = [row for row in rows if row[0] > self.parameters.doubt]
        for _, literal, chance in sorted(rows, key=lambda row: (-row[0], row[1]))[
            : self.parameters.change_questions
        ]:
            question = PredChangeYnq(literal)
            if question not in self.asked:
                yield (
                    question,
                    {
                        "pred_change_ynq": 1.0,
                        "pred_change_ynq.probability": chance,
                        "pred_change_ynq.doubt": doubt(chance),
                    },
                )

    def _relevance_questions(self) -> Iterator[tuple[RobotAct, dict[str, float]]]:
        named = set(self.objects)
        for literal in sorted(self.goal):
            question = GoalRelevantYnq(literal)
            if question not in self.asked:
                aside = float(not named.intersection(literal.fluent.args))
                yield question, {"goal_relevant_ynq": 1.0, "goal_relevant_ynq.aside": aside}

    def _asking(self) -> dict[str, float]:
        return {
            "ask.certainty": self.change.certainty,
            "ask.open": self._open,
            "ask.asked": len(self.asked) / 10.0,
        }

    @property
    def _open(self) -> float:
        chances = [min(p, 1.0 - p) for _, p in self.change.chances]
        return math.log1p(math.fsum(chances))

    def _inclusion(self) -> Candidate:
        if not self.goal:
            act: RobotAct = RequestDemonstration(Reason.NOTHING_CHANGED)
            return Candidate(act, {"request_demonstration": 1.0, "include_fluent.open": self._open})
        return Candidate(
            IncludeFluent(self.goal),
            {
                "include_fluent": 1.0,
                "include_fluent.certainty": self.change.certainty,
                "include_fluent.open": self._open,
                "include_fluent.size": len(self.goal) / 10.0,
                "include_fluent.asked": len(self.asked) / 10.0,
            },
        )


def shown_grounding(
    phrases: Sequence[str],
    fitting: Sequence[Sequence[str]],
    changed: Goal,
    actions: Iterable[Action],
) -> GroundingBelief:
    """*Grd* after a demonstration: what changed, and what was handled, is likelier to be meant."""
    moved = {word for literal in changed for word in literal.fluent.args}
    handled = {word for action in actions for word in action.args}
    weights = {
        phrase: {
            thing: 10.0 if thing in moved else 3.0 if thing in handled else 1.0 for thing in things
        }
        for phrase, things in zip(phrases, fitting, strict=True)
    }
    belief = GroundingBelief.of(weights)
    first = {p: {o: i for i, o in enumerate(t)} for p, t in zip(phrases, fitting, strict=True)}
    ordered = tuple(
        (phrase, tuple(sorted(rows, key=lambda row: (-row[1], first[phrase][row[0]]))))
        for phrase, rows in belief.phrases
    )
    return GroundingBelief(ordered, belief.settled)


def _settled_all(
    grounding: GroundingBelief, pairs: Sequence[tuple[str, str]], reply: Reply, trust: float
) -> GroundingBelief:
    """A yes settles every pair; a no says only that not all are right, so doubts each a little."""
    for phrase, thing in pairs:
        if reply.label is Label.YES and trust < 1.0:
            grounding = shifted(grounding, phrase, thing, trust)
        elif reply.label is Label.YES:
            grounding = grounding.confirm(phrase, thing)
        else:
            weights = {o: p * (0.5 if o == thing else 1.0) for o, p in grounding[phrase]}
            doubted = grounding.restrict(phrase, weights)
            grounding = GroundingBelief(doubted.phrases, grounding.settled)
    return grounding


FEATURES: dict[str, str] = {
    "np_grd_whq": "asks which object a noun phrase is",
    "np_grd_whq.entropy": "entropy of the phrase's candidates, in nats (Table 3)",
    "np_grd_whq.many": "the phrase has more than 4 candidates (Table 3)",
    "np_grd_ynq": "asks whether a noun phrase is an object",
    "np_grd_ynq.probability": "probability that it is (Table 3)",
    "bulk_np_grd_ynq": "asks whether several noun phrases are these objects",
    "bulk_np_grd_ynq.probability": "probability that all are",
    "pred_change_ynq": "asks whether the demonstration made a literal true",
    "pred_change_ynq.probability": "probability that it did (Table 3)",
    "pred_change_ynq.doubt": "1 at one half, 0 at 0 and 1",
    "goal_relevant_ynq": "asks whether a change belongs to the goal",
    "goal_relevant_ynq.aside": "the change is about no object that the command names",
    "ask.certainty": "probability that just what is believed has changed, for any question",
    "ask.open": "log(1 + expected number of literals judged wrongly), for any question",
    "ask.asked": "questions asked so far / 10, for any question",
    "include_fluent": "keeps what is believed to have changed",
    "include_fluent.certainty": "probability that just this has changed",
    "include_fluent.open": "log(1 + expected number of literals judged wrongly)",
    "include_fluent.size": "number of its literals / 10",
    "include_fluent.asked": "questions asked so far / 10",
    "request_demonstration": "keeps nothing: nothing seems to have changed",
}
"""The learning phase's features by name; each is 0 where it does not apply."""

"""A live episode as the inquiries of both phases see it: what could be asked or done now.

An inquiry is made anew from the episode each time, from what is believed and
what has been answered, so that it needs no place in the state.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import islice, product

from verbteach.dialogue.acts import (
    BulkNpGrdYnq,
    EnvPredYnq,
    GoalPredYnq,
    GoalRelevantYnq,
    PredChangeYnq,
    RobotAct,
)
from verbteach.dialogue.decision import Candidate
from verbteach.dialogue.draft import Draft
from verbteach.dialogue.execution_inquiry import ExecutionInquiry
from verbteach.dialogue.grounding import GroundingBelief
from verbteach.dialogue.inquiry import Label, Reply
from verbteach.dialogue.learning_inquiry import LearningInquiry
from verbteach.dialogue.state import EpisodeState, Exchange
from verbteach.dialogue.worth import essential
from verbteach.perception.belief import Belief
from verbteach.verbs.analogy import Analogies
from verbteach.verbs.examples import Example, Memory
from verbteach.verbs.knowledge import VerbKnowledge
from verbteach.verbs.pool import PLACES, PoolSource
from verbteach.verbs.resemblance import Said
from verbteach.verbs.seen_change import SeenChange, seen_change
from verbteach.verbs.space import HypothesisSpace
from verbteach.world.fluents import Literal
from verbteach.world.reliance import foresight

_MOVED, _HANDLED = 10.0, 3.0
"""How much likelier a thing is meant that a demonstration changed, or only handled."""
_LABELS = {"yes": Label.YES, "no": Label.NO}


def execution_inquiry(draft: Draft) -> ExecutionInquiry:
    """The execution phase as it stands: the belief, the groundings, the answers so far."""
    episode, parameters = draft.episode, draft.mind.parameters
    task = draft.mind.setting.task
    grounding = known_phrases(episode.grounding)
    said = Said(episode.frame.verb, grounding.names)
    joint = _joint(grounding, parameters.selection.application.groundings)
    analogies = Analogies(said, joint, draft.mind.setting.surroundings)
    source = PoolSource(analogies, confirmed_memory(draft.state.knowledge), parameters.pool)
    inquiry = ExecutionInquiry.begin(
        source,
        task.static,
        _changing(draft),
        grounding,
        parameters.inquiry,
        foresight(task, draft.mind.setting.planner),
    )
    for exchange in episode.asked:
        inquiry = _told(inquiry, exchange)
    return replace(inquiry, asked=_questions(episode))


def learning_inquiry(draft: Draft, after: Belief) -> LearningInquiry:
    """The learning phase as it stands; ``after`` is what was seen when all was shown."""
    episode, parameters = draft.episode, draft.mind.parameters
    shown = episode.demonstrated.actions if episode.demonstrated else ()
    change = seen_change(draft.mind.setting.task, episode.belief, after, shown)
    change = replace(change, chances=_worth_asking(draft, change))
    inquiry = LearningInquiry(change, known_phrases(episode.grounding), parameters.inquiry)
    for exchange in episode.asked:
        label = _LABELS.get(exchange.answer)
        if isinstance(exchange.question, PredChangeYnq | GoalRelevantYnq) and label:
            inquiry = inquiry.after(exchange.question, Reply(label))
    return replace(inquiry, asked=_questions(episode))


def seen_grounding(draft: Draft, after: Belief) -> GroundingBelief:
    """*Grd* after a demonstration: what changed, and what was handled, is likelier to be meant."""
    episode = draft.episode
    shown = episode.demonstrated.actions if episode.demonstrated else ()
    handled = {word for action in shown for word in action.args}
    changed = learning_inquiry(draft, after).change.likely
    moved = {word for literal in changed for word in literal.fluent.args}
    grounding = episode.grounding
    for phrase in known_phrases(grounding).names:
        if phrase not in grounding.settled and len(grounding[phrase]) > 1:
            weights = {
                thing: chance * (_MOVED if thing in moved else _HANDLED if thing in handled else 1)
                for thing, chance in grounding[phrase]
            }
            grounding = grounding.restrict(phrase, weights)
    return grounding


def _worth_asking(draft: Draft, change: SeenChange) -> tuple[tuple[Literal, float], ...]:
    """The chances of what may be meant; what never changes was seen wrongly."""
    setting = draft.mind.setting
    static = setting.task.domain.static
    moving = [(one, p) for one, p in change.chances if one.fluent.predicate not in static]
    meant = essential(frozenset(one for one, _ in moving), setting.lexicon)
    return tuple((one, p) for one, p in moving if one in meant)


def known_phrases(grounding: GroundingBelief) -> GroundingBelief:
    """The belief about the phrases that something fits."""
    kept = tuple((phrase, objects) for phrase, objects in grounding.phrases if objects)
    return GroundingBelief(kept, grounding.settled)


def confirmed_memory(knowledge: VerbKnowledge) -> Memory:
    """What a teacher said yes to: goals read back or carried out. Without any, all that was shown.

    A person's word on what belongs to a goal counts for more than what happened to
    change. Of one lesson the smallest goal is kept: the one that was read back.
    """
    spaces = [space for space in knowledge.spaces if space.nodes]
    confirmed = [space for space in spaces if space.confirmed]
    smallest: dict[str, HypothesisSpace] = {}
    for space in sorted(confirmed, key=lambda space: len(space.base)):
        smallest.setdefault(space.demonstration.id.rpartition("/")[0], space)
    kept = list(smallest.values()) or spaces
    return Memory.keeping(
        Example(s.demonstration, s.nodes[0].literals, s.nodes[0].bindings[0]) for s in kept
    )


def answered(episode: EpisodeState, kind: type[RobotAct], answer: str) -> tuple[RobotAct, ...]:
    """This episode's questions of a kind that got this answer."""
    return tuple(
        one.question
        for one in episode.asked
        if isinstance(one.question, kind) and one.answer == answer
    )


def sensible(draft: Draft, options: Sequence[Candidate]) -> list[Candidate]:
    """The candidates without questions that no person would understand.

    Goals carried over from other things speak of facts that cannot be here,
    and of the robot's own bookkeeping; that a thing has left its place follows
    from where it comes to.
    """
    setting = draft.mind.setting

    def makes_sense(act: RobotAct) -> bool:
        if isinstance(act, GoalPredYnq):
            fluent = act.literal.fluent
            if not act.literal.positive and fluent.predicate in PLACES:
                return False
        elif isinstance(act, EnvPredYnq):
            fluent = act.fluent
        else:
            return True
        unspoken = fluent.predicate in setting.lexicon.unspoken
        return not unspoken and setting.task.is_fluent(fluent)

    return [one for one in options if makes_sense(one.act)]


def settled_in_bulk(grounding: GroundingBelief, act: BulkNpGrdYnq, yes: bool) -> GroundingBelief:
    """A yes settles every pair; a no says only that not all are right, so doubts each a little."""
    for phrase, thing in act.pairs:
        if yes:
            grounding = grounding.confirm(phrase, thing)
        else:
            halved = {o: p * (0.5 if o == thing else 1.0) for o, p in grounding[phrase]}
            grounding = grounding.restrict(phrase, halved)
    return grounding


def _told(inquiry: ExecutionInquiry, exchange: Exchange) -> ExecutionInquiry:
    label = _LABELS.get(exchange.answer)
    question = exchange.question
    if label is None:
        return inquiry
    if isinstance(question, EnvPredYnq):
        return inquiry.after(question, Reply(label))
    # A grounding answered since may have left the pool without the literal that was asked about.
    if isinstance(question, GoalPredYnq) and question.literal in inquiry.pool.literals:
        return inquiry.after(question, Reply(label))
    return inquiry


def _questions(episode: EpisodeState) -> tuple[RobotAct, ...]:
    return tuple(one.question for one in episode.asked)


def _joint(grounding: GroundingBelief, most: int) -> Sequence[tuple[str, ...]]:
    """Joint groundings, those of the likeliest objects first."""
    objects = [[thing for thing, _ in grounding[phrase]] for phrase in grounding.names]
    return tuple(islice(product(*objects), most))


def _changing(draft: Draft) -> Belief:
    """The belief without what never changes, which is known."""
    static, belief = draft.mind.setting.task.static, draft.episode.belief
    return Belief({f: c for f, c in belief.items() if f not in static}, belief.exclusive)

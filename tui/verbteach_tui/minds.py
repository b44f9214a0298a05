"""The robot's state, turned into what the mind panel shows."""

from __future__ import annotations

from verbteach.dialogue.decision import Candidate, Decision
from verbteach.dialogue.demonstration import ordered
from verbteach.dialogue.explanation import label
from verbteach.dialogue.grounding import GroundingBelief
from verbteach.dialogue.promise import Promise
from verbteach.dialogue.speech import Speech
from verbteach.dialogue.state import RankedGoal, RobotState
from verbteach.verbs.knowledge import VerbKnowledge
from verbteach_tui.hypotheses import Vocabulary, known_verbs
from verbteach_tui.views.labels import Labels
from verbteach_tui.views.mind import ActValue, GoalBelief, Mind, PhraseBelief, Share

_GOALS = 12
_SEEN = 0.005  # what two decimals show


def mind_of(
    state: RobotState,
    learned_from: VerbKnowledge,
    labels: Labels,
    speech: Speech,
    words: Vocabulary,
    previous: Mind | None = None,
    promise: Promise | None = None,
) -> Mind:
    """The mind as it stands; probabilities that differ from ``previous`` say what they were."""
    episode = state.episode
    verbs = known_verbs(state.knowledge, learned_from, words)
    promised = (promise.text, promise.short) if promise else ("", "")
    if episode is None:
        return Mind((), (), (), verbs, *promised)
    before = {belief.phrase: belief for belief in previous.phrases} if previous else {}
    return Mind(
        _phrases(episode.grounding, labels, before),
        _goals(episode.goals, speech),
        _acts(state.turn.decisions[-1], speech) if state.turn.decisions else (),
        verbs,
        *promised,
    )


def _phrases(
    grounding: GroundingBelief, labels: Labels, before: dict[str, PhraseBelief]
) -> tuple[PhraseBelief, ...]:
    found = []
    for phrase, objects in grounding.phrases:
        old = before.get(phrase)
        known = {share.target: share.share for share in old.shares} if old else {}
        shares = tuple(
            Share(labels[thing], chance, known.get(thing), thing) for thing, chance in objects
        )
        found.append(PhraseBelief(phrase, shares, phrase in grounding.settled))
    return tuple(found)


def _goals(goals: tuple[RankedGoal, ...], speech: Speech) -> tuple[GoalBelief, ...]:
    if not goals:
        return ()
    first = goals[0].goal
    return tuple(
        GoalBelief(
            one.share,
            tuple(speech.words.describe(literal) for literal in ordered(one.goal)),
            tuple(speech.words.describe(literal) for literal in ordered(one.goal - first)),
        )
        for one in goals[:_GOALS]
    )


def _acts(decision: Decision, speech: Speech) -> tuple[ActValue, ...]:
    """The chosen act first, then the others by their value."""
    if len(decision.candidates) < 2:
        return ()
    order = sorted(
        range(len(decision.candidates)),
        key=lambda i: (i != decision.chosen, -(decision.candidates[i].value or 0.0), i),
    )
    return tuple(_value(decision.candidates[i], i == decision.chosen, speech) for i in order)


def _value(candidate: Candidate, chosen: bool, speech: Speech) -> ActValue:
    shares = candidate.shares
    largest = sorted(shares, key=lambda name: (-abs(shares[name]), name))
    parts = tuple((name, shares[name]) for name in largest if abs(shares[name]) >= _SEEN)
    return ActValue(label(candidate.act, speech), candidate.value, chosen, parts)

"""The robot's state, turned into what the mind panel shows."""

from __future__ import annotations

from verbteach.dialogue import acts
from verbteach.dialogue.decision import Candidate, Decision
from verbteach.dialogue.demonstration import ordered
from verbteach.dialogue.grounding import GroundingBelief
from verbteach.dialogue.speech import Speech
from verbteach.dialogue.state import RankedGoal, RobotState
from verbteach.verbs.knowledge import VerbKnowledge
from verbteach_tui.hypotheses import Vocabulary, known_verbs
from verbteach_tui.views.labels import Labels
from verbteach_tui.views.mind import ActValue, GoalBelief, Mind, PhraseBelief, Share

_GOALS = 12


def mind_of(
    state: RobotState,
    learned_from: VerbKnowledge,
    labels: Labels,
    speech: Speech,
    words: Vocabulary,
    previous: Mind | None = None,
) -> Mind:
    """The mind as it stands; probabilities that differ from ``previous`` say what they were."""
    episode = state.episode
    verbs = known_verbs(state.knowledge, learned_from, words)
    if episode is None:
        return Mind(verbs=verbs)
    before = {belief.phrase: belief for belief in previous.phrases} if previous else {}
    return Mind(
        _phrases(episode.grounding, labels, before),
        _goals(episode.goals, speech),
        _acts(state.turn.decisions[-1]) if state.turn.decisions else (),
        verbs,
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


def _acts(decision: Decision) -> tuple[ActValue, ...]:
    """The chosen act first, then the others by their value."""
    if len(decision.candidates) < 2:
        return ()
    order = sorted(
        range(len(decision.candidates)),
        key=lambda i: (i != decision.chosen, -(decision.candidates[i].value or 0.0), i),
    )
    return tuple(_value(decision.candidates[i], i == decision.chosen) for i in order)


def _value(candidate: Candidate, chosen: bool) -> ActValue:
    return ActValue(_told(candidate.act), candidate.value, chosen)


def _told(act: acts.RobotAct) -> str:
    match act:
        case acts.NpGrdWhq(np=phrase) | acts.NpGrdYnq(np=phrase):
            return f'{act.name} "{phrase}"'
        case acts.SelectHypo(plan=plan):
            return f"{act.name}, {len(plan)} steps"
        case acts.IncludeFluent(goal=goal):
            return f"{act.name}, {len(goal)} fluents"
        case acts.RequestDemonstration():
            return "ask to be shown"
    return act.name

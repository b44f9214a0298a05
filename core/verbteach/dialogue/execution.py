"""The execution phase: from a command to an execution, a question or a request to be shown."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import product

from verbteach.dialogue import carrying_out, demonstration
from verbteach.dialogue.acts import (
    QUESTIONS,
    DemonstrationReason,
    NpGrdWhq,
    NpGrdYnq,
    RequestDemonstration,
    SelectHypo,
)
from verbteach.dialogue.acts.execution import CORRECTED
from verbteach.dialogue.asking import execution_inquiry, sensible
from verbteach.dialogue.draft import Draft
from verbteach.dialogue.moves import Phase
from verbteach.dialogue.promise import held_to
from verbteach.dialogue.proposals import (
    being_shown,
    grounding_questions,
    hypothesis,
    unknown_words,
)
from verbteach.dialogue.questions import ask
from verbteach.dialogue.referring import ground_phrases
from verbteach.dialogue.seeing import perceived
from verbteach.dialogue.state import EpisodeState, RankedGoal
from verbteach.language.frames import VerbFrame
from verbteach.language.refer import Candidates
from verbteach.verbs.application import GroundingBelief, Situation
from verbteach.verbs.selection import GoalCandidate, Selection, candidates, select
from verbteach.verbs.space import FrameKey
from verbteach.world.fluents import Goal, State
from verbteach.world.plan import Plan

_CONSIDERED = 6
"""Goals that are tried for a plan, the best first."""


def begin(draft: Draft, command: str, frame: VerbFrame, *, shown: bool = False) -> None:
    """Take up a command: perceive, ground its noun phrases, and decide what to do.

    ``shown``: the teacher wants to show it, which decides that.
    """
    _open(draft, command, frame)
    if shown and unknown_words(draft) is None:
        demonstration.request(draft, DemonstrationReason.TAKEN_OVER)
    else:
        deliberate(draft)


def begin_with_goal(draft: Draft, command: str, frame: VerbFrame, goal: Goal) -> bool:
    """Take up a command whose goal the teacher has told; False where no plan leads to it."""
    planner = draft.mind.setting.planner
    answer = planner.plan(perceived(draft, draft.state.world, "before").believed(), goal)
    if not isinstance(answer, Plan) or not answer.actions:
        return False
    _open(draft, command, frame)
    carrying_out.execute(draft, SelectHypo(goal, CORRECTED, answer.actions))
    return True


def _open(draft: Draft, command: str, frame: VerbFrame) -> None:
    """Begin an episode: perceive, and ground the noun phrases."""
    world = draft.state.world
    grounding, guessed = ground_phrases(draft, frame)
    episode = EpisodeState(
        number=draft.state.totals.episodes,
        phase=Phase.EXECUTION,
        command=command,
        frame=frame,
        start=world,
        belief=perceived(draft, world, "before"),
        grounding=grounding,
        guessed=guessed,
    )
    draft.remember(episode=episode)


def deliberate(draft: Draft) -> None:
    """One step of the execution phase: the policy chooses among what matters now."""
    if not draft.mind.asks:
        _deliberate_plainly(draft)
    elif (unclear := unknown_words(draft)) is not None:
        draft.decisions.append(unclear)
        ask(draft, unclear.act, Phase.EXECUTION)
    elif draft.episode.frame.verb not in draft.state.knowledge.verbs:
        demonstration.request(draft, DemonstrationReason.UNKNOWN_VERB)
    else:
        _deliberate_asking(draft)


def _deliberate_asking(draft: Draft) -> None:
    """The policy chooses among all questions and the goal it would carry out."""
    inquiry = execution_inquiry(draft)
    ranked = () if inquiry.pool.empty else inquiry.pool.goals(_CONSIDERED)
    total = math.fsum(value for _, value in ranked) or 1.0
    draft.update(goals=tuple(RankedGoal(goal, value / total) for goal, value in ranked))
    options = held_to(draft.mind.promise, sensible(draft, inquiry.candidates()))
    act = draft.choose(options, Phase.EXECUTION)
    if isinstance(act, QUESTIONS):
        ask(draft, act, Phase.EXECUTION)
    elif isinstance(act, SelectHypo):
        _do_the_best(draft, inquiry.believed)
    elif isinstance(act, RequestDemonstration) and act.reason is DemonstrationReason.NOT_SURE:
        demonstration.request(draft, act.reason)
    else:
        demonstration.request(draft, _reason(draft, _candidates(draft), None))


def _do_the_best(draft: Draft, believed: State) -> None:
    """Execute the best goal that has a plan; ask to be shown where none has."""
    wanted = [one for one in draft.episode.goals if one.goal not in draft.episode.rejected]
    for one in wanted:
        answer = draft.mind.setting.planner.plan(believed, one.goal)
        if isinstance(answer, Plan) and answer.actions:
            carrying_out.execute(draft, SelectHypo(one.goal, "expected", answer.actions))
            return
    reason = DemonstrationReason.NO_PLAN if wanted else DemonstrationReason.NO_HYPOTHESIS
    demonstration.request(draft, reason)


def _deliberate_plainly(draft: Draft) -> None:
    """Only unclear words are asked about; the selected hypothesis is executed."""
    wanted = _candidates(draft)
    draft.update(goals=tuple(RankedGoal(one.goal, one.share) for one in wanted))
    selection = select(
        wanted, draft.episode.belief.believed(), draft.mind.setting.planner,
        draft.mind.parameters.selection,
    )  # fmt: skip
    options = [
        *grounding_questions(draft),
        *([hypothesis(selection)] if selection else []),
        being_shown(_reason(draft, wanted, selection)),
    ]
    act = draft.choose(options, Phase.EXECUTION)
    if isinstance(act, NpGrdWhq | NpGrdYnq):
        ask(draft, act, Phase.EXECUTION)
    elif isinstance(act, SelectHypo):
        carrying_out.execute(draft, act)
    elif isinstance(act, RequestDemonstration):
        demonstration.request(draft, act.reason)


def correct_reference(draft: Draft, phrase: str, things: Candidates) -> None:
    """A correction offered unasked ("no, the other pot"): start over with it, or with them."""
    carrying_out.disapprove(draft)
    episode = draft.episode
    draft.remember(world=episode.start)
    if len(things) == 1:
        draft.experience.append((phrase, things[0][0]))
    draft.update(grounding=episode.grounding.restrict(phrase, dict(things)), execution=None)
    deliberate(draft)


def correct_goal(draft: Draft, goal: Goal) -> bool:
    """A goal put right by the teacher: carry it out from the start; False where no plan does."""
    episode = draft.episode
    believed = execution_inquiry(draft).believed if draft.mind.asks else episode.belief.believed()
    answer = draft.mind.setting.planner.plan(believed, goal)
    if goal in episode.rejected or not isinstance(answer, Plan) or not answer.actions:
        return False
    carrying_out.disapprove(draft)
    draft.remember(world=episode.start)
    carrying_out.execute(draft, SelectHypo(goal, CORRECTED, answer.actions))
    return True


def joint_groundings(episode: EpisodeState) -> GroundingBelief:
    """Every combination of the phrases' objects; two phrases seldom mean one object."""
    distributions = [episode.grounding[phrase] for phrase in episode.phrases]
    joint = []
    for combination in product(*distributions):
        objects = tuple(thing for thing, _ in combination)
        if len(set(objects)) == len(objects):
            joint.append((objects, math.prod(chance for _, chance in combination)))
    return tuple(joint) or ((episode.best_objects, 1.0),)


def _candidates(draft: Draft) -> tuple[GoalCandidate, ...]:
    """The goals the verb may mean here: of its own frame, else of the verb's other frames."""
    episode, parameters = draft.episode, draft.mind.parameters.selection
    situation = Situation(
        FrameKey(episode.frame.verb, len(episode.phrases)),
        episode.phrases,
        joint_groundings(episode),
        episode.belief.believed(),
        draft.mind.setting.surroundings,
    )
    found = candidates(draft.state.knowledge, situation, parameters)
    return tuple(one for one in found if one.goal not in episode.rejected)


def _reason(
    draft: Draft, wanted: Sequence[GoalCandidate], selection: Selection | None
) -> DemonstrationReason:
    verb = draft.episode.frame.verb
    if verb not in draft.state.knowledge.verbs:
        return DemonstrationReason.UNKNOWN_VERB
    if not wanted or selection:
        return DemonstrationReason.NO_HYPOTHESIS
    if any(one.satisfied == 1.0 for one in wanted):
        return DemonstrationReason.NOTHING_TO_DO
    return DemonstrationReason.NO_PLAN

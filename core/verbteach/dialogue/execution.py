"""The execution phase: from a command to an execution, a question or a request to be shown."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import product

from verbteach.dialogue import closing, demonstration
from verbteach.dialogue.acts import (
    DemonstrationReason,
    NpGrdWhq,
    NpGrdYnq,
    Outcome,
    ReportExecution,
    RequestDemonstration,
    SelectHypo,
)
from verbteach.dialogue.draft import Draft
from verbteach.dialogue.moves import Phase
from verbteach.dialogue.obstacles import obstacle
from verbteach.dialogue.proposals import being_shown, grounding_questions, hypothesis
from verbteach.dialogue.questions import ask
from verbteach.dialogue.seeing import perceived
from verbteach.dialogue.state import EpisodeState
from verbteach.dialogue.turn import Trace
from verbteach.dialogue.understanding import ground_phrases
from verbteach.language.frames import VerbFrame
from verbteach.verbs.application import GroundingBelief, Situation
from verbteach.verbs.learning import lifted_space
from verbteach.verbs.selection import GoalCandidate, Selection, candidates, select
from verbteach.verbs.space import Demonstration, FrameKey
from verbteach.world.simulator import run


def begin(draft: Draft, command: str, frame: VerbFrame) -> None:
    """Take up a command: perceive, ground its noun phrases, and decide what to do."""
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
    deliberate(draft)


def deliberate(draft: Draft) -> None:
    """One step of the execution phase: the policy chooses among what matters now."""
    wanted = _candidates(draft)
    draft.update(goals=wanted)
    selection = select(
        wanted, draft.episode.belief.believed(), draft.mind.setting.planner,
        draft.mind.parameters.selection,
    )  # fmt: skip
    options = [
        *grounding_questions(draft),
        *([hypothesis(selection)] if selection else []),
        being_shown(_reason(draft, wanted, selection)),
    ]
    act = draft.choose(options)
    if isinstance(act, NpGrdWhq | NpGrdYnq):
        ask(draft, act, Phase.EXECUTION)
    elif isinstance(act, SelectHypo):
        execute(draft, act)
    elif isinstance(act, RequestDemonstration):
        demonstration.request(draft, act.reason)


def execute(draft: Draft, act: SelectHypo) -> None:
    """Run the plan on the true world, up to the first action that cannot be done."""
    setting = draft.mind.setting
    states = run(setting.task, draft.state.world, act.plan)
    done = act.plan[: len(states) - 1]
    failed = act.plan[len(done)] if len(done) < len(act.plan) else None
    why = obstacle(setting, states[-1], failed) if failed else ""
    draft.trace = Trace(done, tuple(states), failed, why)
    draft.remember(world=states[-1])
    draft.update(execution=act)
    if failed:
        draft.say(ReportExecution(done, failed, why))
    draft.wait(act, Phase.JUDGEMENT)


def approve(draft: Draft) -> None:
    """The execution was right: the hypothesis and the grounding are confirmed."""
    act = _execution(draft.episode)
    draft.earn(draft.mind.parameters.rewards.of(act.name, positive=True))
    space = lifted_space(
        described(draft, "executed"), (act.goal,), draft.mind.setting.surroundings, confirmed=True
    )
    draft.learned.append(space)
    draft.remember(knowledge=draft.state.knowledge.with_space(space))
    meant = zip(draft.episode.phrases, draft.episode.best_objects, strict=True)
    draft.experience.extend(meant)
    closing.close(draft, Outcome.EXECUTED)


def disapprove(draft: Draft) -> None:
    """The execution was wrong: it costs, and its goal is not tried again for this command."""
    act = _execution(draft.episode)
    draft.earn(draft.mind.parameters.rewards.of(act.name, positive=False))
    draft.update(rejected=draft.episode.rejected | {act.goal})


def correct_reference(draft: Draft, phrase: str, thing: str) -> None:
    """A correction offered unasked ("no, the other pot"): start over with it."""
    disapprove(draft)
    episode = draft.episode
    draft.remember(world=episode.start)
    draft.experience.append((phrase, thing))
    draft.update(grounding=episode.grounding.confirm(phrase, thing), execution=None)
    deliberate(draft)


def described(draft: Draft, how: str) -> Demonstration:
    """The episode as the source of a hypothesis."""
    episode = draft.episode
    name = f"{draft.state.scene}#{episode.number}/{how}"
    return Demonstration(name, episode.frame.verb, episode.phrases, episode.best_objects)


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


def _execution(episode: EpisodeState) -> SelectHypo:
    if episode.execution is None:
        raise RuntimeError("nothing was executed")
    return episode.execution

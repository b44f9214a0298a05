"""The learning phase: from a demonstration to the goal that is kept.

The goal read back is the smallest part of what changed that asks for the same
actions (the most general hypothesis of the demonstration's space); the teacher
says right or wrong, strikes parts of it or keeps parts that were left out.
"""

from __future__ import annotations

from dataclasses import replace

from verbteach.dialogue import closing, demonstration
from verbteach.dialogue.acts import (
    QUESTIONS,
    DemonstrationReason,
    GoalRelevantYnq,
    IncludeFluent,
    Learned,
    Outcome,
    RequestDemonstration,
    ReviseGoal,
)
from verbteach.dialogue.asking import answered, learning_inquiry, seen_grounding
from verbteach.dialogue.carrying_out import described
from verbteach.dialogue.decision import Candidate
from verbteach.dialogue.draft import Draft
from verbteach.dialogue.moves import IllegalMoveError, Phase
from verbteach.dialogue.proposals import grounding_questions
from verbteach.dialogue.questions import ask
from verbteach.dialogue.relevance import weighed_by_relevance
from verbteach.dialogue.seeing import perceived
from verbteach.dialogue.state import ReadBack
from verbteach.dialogue.worth import essential
from verbteach.perception.belief import Belief
from verbteach.verbs.change import ObjectSet, StateChange
from verbteach.verbs.hypothesis import Learner, NoHypothesis, Shown
from verbteach.verbs.learning import derive, ground_goals, insisted, lifted_space, struck
from verbteach.verbs.space import HypothesisSpace
from verbteach.world.fluents import Goal, Literal

# Where too much changed, or no plan reaches all of it, speak of fewer things.
_NARROWER = (
    ObjectSet.ALL,
    ObjectSet.MANIPULATED,
    ObjectSet.ARGUMENT_RELATED,
    ObjectSet.ARGUMENT_ONLY,
)


def sum_up(draft: Draft) -> None:
    """The demonstration is over: ask what is unclear, else read the goal back."""
    shown = draft.episode.demonstrated
    if shown is None or not shown.actions:
        demonstration.ask_for_more(draft, DemonstrationReason.NO_STEP)
    elif not demonstration.change(draft):
        demonstration.ask_for_more(draft, DemonstrationReason.NOTHING_CHANGED)
    else:
        if draft.mind.asks:
            draft.update(grounding=seen_grounding(draft, _seen_after(draft)))
        deliberate(draft)


def deliberate(draft: Draft) -> None:
    """One step of the learning phase: the policy chooses among questions and the goal."""
    read_back = _first_reading(draft)
    act = draft.choose(_options(draft, read_back), Phase.LEARNING)
    if isinstance(act, QUESTIONS):
        ask(draft, act, Phase.LEARNING)
    elif isinstance(act, RequestDemonstration):
        draft.end_phase()
        demonstration.ask_for_more(draft, act.reason)
    else:
        draft.update(read_back=read_back)
        draft.wait(IncludeFluent(read_back.goal), Phase.READ_BACK)


def _options(draft: Draft, read_back: ReadBack) -> list[Candidate]:
    """The policy's choices; what would be kept is always the goal that would be read back."""
    include = IncludeFluent(read_back.goal)
    if not read_back.goal and not draft.mind.asks:
        return [Candidate(RequestDemonstration(DemonstrationReason.NOTHING_CHANGED), {})]
    if not draft.mind.asks:
        return [
            *grounding_questions(draft),
            Candidate(include, {"size": float(len(read_back.goal))}),
        ]
    options = learning_inquiry(draft, _seen_after(draft)).candidates()
    if not read_back.goal:
        return [one for one in options if not isinstance(one.act, GoalRelevantYnq)]
    return weighed_by_relevance(draft, options, include)


def strike(draft: Draft, literal: Literal) -> None:
    """The literal is no part of the goal."""
    read_back = _read_back(draft)
    if literal not in read_back.goal:
        raise IllegalMoveError(f"{literal} is not in the goal that was read back")
    _edit(draft, read_back.goal - {literal})


def keep(draft: Draft, literal: Literal) -> None:
    """The literal is part of the goal. It must hold after the demonstration."""
    read_back = _read_back(draft)
    if not draft.mind.setting.task.is_fluent(literal.fluent):
        raise IllegalMoveError(f"{literal} names nothing in this scene")
    if not literal.holds(draft.state.world):
        raise IllegalMoveError(f"{literal} does not hold now, so it was not shown")
    opposite = Literal(literal.fluent, not literal.positive)
    _edit(draft, (read_back.goal - {opposite}) | {literal})


def restate(draft: Draft, goal: Goal) -> None:
    """The goal is ``goal``. Every part of it must hold after the demonstration."""
    for literal in sorted(goal):
        if not literal.holds(draft.state.world):
            raise IllegalMoveError(f"{literal} does not hold now, so it was not shown")
    _edit(draft, goal)


def reject(draft: Draft) -> None:
    """The goal read back is wrong: it costs once, and the teacher may correct it."""
    read_back = _read_back(draft)
    if not read_back.rejected:
        draft.earn(draft.mind.parameters.rewards.of(IncludeFluent.name, positive=False))
        draft.end_phase()
    draft.update(read_back=replace(read_back, rejected=True))
    draft.wait(ReviseGoal(read_back.goal), Phase.READ_BACK)


def accept(draft: Draft) -> None:
    """The goal is right: the verb is kept. It was wrong at first if the teacher corrected it."""
    read_back = _read_back(draft)
    if not read_back.goal:
        raise IllegalMoveError("nothing is left of the goal; keep something, show again or skip")
    if not read_back.rejected:
        right = read_back.goal == read_back.first
        draft.earn(draft.mind.parameters.rewards.of(IncludeFluent.name, positive=right))
        draft.end_phase()
    before = draft.state.knowledge
    confirmed = lifted_space(
        described(draft, "confirmed"),
        (read_back.goal,),
        draft.mind.setting.surroundings,
        confirmed=True,
    )
    spaces = [space for space in (_corrected(draft, read_back), confirmed) if space is not None]
    for space in spaces:
        draft.remember(knowledge=draft.state.knowledge.with_space(space))
    draft.learned.extend(spaces)
    draft.experience.extend(zip(draft.episode.phrases, draft.episode.best_objects, strict=True))
    key = confirmed.demonstration.frame
    old = len(before.frames[key].nodes) if key in before.frames else 0
    new = len(draft.state.knowledge.frames[key].nodes) - old
    name = " ".join(str(literal) for literal in confirmed.nodes[0].literals)
    draft.say(Learned(key.verb, key.arity, name, new))
    closing.close(draft, Outcome.LEARNED)


def abandon(draft: Draft) -> None:
    """The teacher passes over it: nothing is kept, the world stays as it is."""
    closing.close(draft, Outcome.ABANDONED)


def _first_reading(draft: Draft) -> ReadBack:
    """What the robot makes of the demonstration, answers about what matters in it included."""
    whole = _changed(draft)
    space = _space(draft, whole)
    goal = whole if space is None else _smallest(draft, space)
    wanted = answered(draft.episode, GoalRelevantYnq, "yes")
    unwanted = answered(draft.episode, GoalRelevantYnq, "no")
    more = {act.literal for act in wanted if isinstance(act, GoalRelevantYnq)}
    less = {act.literal for act in unwanted if isinstance(act, GoalRelevantYnq)}
    edited = bool(more - goal or less & goal)
    said = (goal | more) - less
    return ReadBack(whole, said, space, said, edited=edited)


def _smallest(draft: Draft, space: HypothesisSpace) -> Goal:
    """The most general goal of the space: the fewest literals that ask for the same actions."""
    goals = ground_goals(space)
    fewest = min(len(goal) for goal in goals)
    smallest = [goal for goal in goals if len(goal) == fewest]
    return min(smallest, key=lambda one: _telling_order(draft, one))


def _telling_order(draft: Draft, goal: Goal) -> tuple[int, int, list[Literal]]:
    """Order goals: about the command's objects first, what is before what is not."""
    objects = set(draft.episode.best_objects)
    about = sum(bool(objects & set(literal.fluent.args)) for literal in goal)
    return -about, -sum(literal.positive for literal in goal), sorted(goal)


def _space(draft: Draft, whole: Goal) -> HypothesisSpace | None:
    """The demonstration's own space, over the widest object set that gives one."""
    shown, setting = _shown(draft, whole), draft.mind.setting
    for objects in _NARROWER:
        parameters = replace(draft.mind.parameters.learning, object_set=objects)
        learner = Learner(setting.planner, setting.surroundings, parameters, setting.task)
        space = derive(described(draft, "shown"), shown, learner)
        if not isinstance(space, NoHypothesis):
            return space
    return None


def _changed(draft: Draft) -> Goal:
    """What has changed as far as the robot can tell, and may be meant.

    A robot that asks weighs what it saw with what the actions do and with what
    it was told; She & Chai (2016) compare what was seen before and after.
    """
    setting = draft.mind.setting
    if draft.mind.asks:
        change = learning_inquiry(draft, _seen_after(draft)).change.likely
    else:
        before, after = draft.episode.belief.believed(), _seen_after(draft).believed()
        change = StateChange.between(before, after, setting.scene.domain.static).literals
    return essential(change, setting.lexicon)


def _shown(draft: Draft, whole: Goal) -> Shown:
    """The demonstration as the robot saw it: the believed world, and that with the change."""
    demonstrated = draft.episode.demonstrated
    if demonstrated is None:
        raise RuntimeError("nothing was demonstrated")
    before = draft.episode.belief.believed()
    gone = {literal.fluent for literal in whole if not literal.positive}
    come = {literal.fluent for literal in whole if literal.positive}
    return Shown(before, demonstrated.actions, (before - gone) | come)


def _seen_after(draft: Draft) -> Belief:
    """What the robot sees when all has been shown."""
    return perceived(draft, draft.state.world, "after")


def _edit(draft: Draft, goal: Goal) -> None:
    draft.update(read_back=replace(_read_back(draft), goal=goal, edited=True))
    draft.wait(IncludeFluent(goal), Phase.READ_BACK)


def _corrected(draft: Draft, read_back: ReadBack) -> HypothesisSpace | None:
    """The demonstration's space without what the teacher's corrections exclude."""
    space: HypothesisSpace | None = read_back.space
    if not read_back.edited:
        return space
    surroundings = draft.mind.setting.surroundings
    first = _smallest(draft, space) if space else frozenset()
    for literal in sorted(first - read_back.goal):
        space = struck(space, literal, surroundings) if space else None
    for literal in sorted(read_back.goal - first):
        if space and literal in space.base:
            space = insisted(space, literal, surroundings)
    return space


def _read_back(draft: Draft) -> ReadBack:
    if draft.episode.read_back is None:
        raise RuntimeError("no goal was read back")
    return draft.episode.read_back

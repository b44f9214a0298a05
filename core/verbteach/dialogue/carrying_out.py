"""Carrying a goal out: the plan runs in the true world, and the teacher's judgement is taken in."""

from __future__ import annotations

from verbteach.dialogue import closing
from verbteach.dialogue.acts import Outcome, ReportExecution, SelectHypo
from verbteach.dialogue.draft import Draft
from verbteach.dialogue.moves import Phase
from verbteach.dialogue.obstacles import obstacle
from verbteach.dialogue.state import EpisodeState
from verbteach.dialogue.turn import Trace
from verbteach.verbs.learning import lifted_space
from verbteach.verbs.space import Demonstration
from verbteach.world.simulator import run


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
    draft.end_phase()
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
    draft.end_phase()
    draft.update(rejected=draft.episode.rejected | {act.goal})


def described(draft: Draft, how: str) -> Demonstration:
    """The episode as the source of a hypothesis."""
    episode = draft.episode
    name = f"{draft.state.scene}#{episode.number}/{how}"
    return Demonstration(name, episode.frame.verb, episode.phrases, episode.best_objects)


def _execution(episode: EpisodeState) -> SelectHypo:
    if episode.execution is None:
        raise RuntimeError("nothing was executed")
    return episode.execution

"""The robot's sentences: one for each act, in plain English.

It knows acts and what they are about; how fluents, actions and things read is
the language room's business.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from verbteach.dialogue import acts
from verbteach.dialogue.acts import DemonstrationReason, Outcome, RobotAct
from verbteach.dialogue.acts.execution import CORRECTED
from verbteach.dialogue.demonstration import ordered
from verbteach.dialogue.draft import Draft
from verbteach.dialogue.lacking import lacking
from verbteach.dialogue.speech import Speech
from verbteach.dialogue.state import EpisodeState
from verbteach.dialogue.worth import spoken, without_departures
from verbteach.language.distinguish import glimpse
from verbteach.language.first_person import first_person
from verbteach.language.frames import PRONOUNS
from verbteach.language.morphology import listing
from verbteach.perception.noise import NoiseModel
from verbteach.world.fluents import Goal, Literal

_NAMED = 3
"""Changes that are told beside the goal; the rest are counted, and listed where it is edited."""


@dataclass(frozen=True)
class _About:
    """What a sentence can speak of: the words of the scene and the episode, if one is on."""

    speech: Speech
    draft: Draft
    episode: EpisodeState | None

    @property
    def doing(self) -> str:
        """The command as a gerund, "boiling the water"."""
        return self.speech.words.doing(self.episode.frame) if self.episode else "that"

    @property
    def todo(self) -> str:
        """The command as it would follow "to": "boil the water"."""
        return self.speech.words.clause(self.episode.frame) if self.episode else "do that"


def word_turn(draft: Draft) -> tuple[str, ...]:
    """A sentence or two for each of the draft's acts.

    Things are named as they can be told apart in the world as the turn leaves it.
    """
    speech = Speech.of(draft.mind.setting, draft.state.world)
    about = _About(speech, draft, draft.state.episode)
    return tuple(first_person(_sentence(act, about)) for act in draft.acts)


def _sentence(act: RobotAct, about: _About) -> str:
    return _WORDING[type(act)](act, about)


def _await_command(act: acts.AwaitCommand, about: _About) -> str:
    if len(about.draft.acts) > 1:
        return "What should I do next?"
    return f"I am in {about.speech.place}. What should I do?"


def _start_clause(act: acts.StartClause, about: _About) -> str:
    return f"One thing at a time. Now: {act.clause}."


def _np_grd_whq(act: acts.NpGrdWhq, about: _About) -> str:
    found = about.episode.grounding[act.np] if about.episode else ()
    if not found and act.np.lower() in _POINTERS:
        asked = f"What do you mean by {_quoted(act.np)}? Name the thing, or point at it."
        return f"{asked} If it is not here, skip."
    if not found:
        nothing = f"I see nothing that I would call {_quoted(act.np)}. Which is it,"
        return f"{nothing} can you show me? If it is not here, skip."
    which = f"{_which(act.np, about)}, can you show me?"
    if len(found) == 1:
        return which
    things = [about.speech.thing(thing) for thing, _ in found[:6]]
    more = ", or something else" if len(found) > 6 else ""
    return f"{which} It could be {listing(things, 'or')}{more}."


def _which(phrase: str, about: _About) -> str:
    """Which is the mug; of "a mug" or of several, since one is taken: which one do you mean."""
    said = about.episode.frame.phrases if about.episode else ()
    guessed = about.episode.guessed if about.episode else frozenset()
    open_choice = phrase.split(" ", 1)[0].lower() in _QUANTIFIERS
    if open_choice or phrase in guessed or any(one.text == phrase and one.plural for one in said):
        return f"Which one do you mean by {_quoted(phrase)}"
    return f"Which is {_the(phrase)}"


def _np_grd_ynq(act: acts.NpGrdYnq, about: _About) -> str:
    if about.episode and act.np in about.episode.guessed:
        return f"I do not know {_quoted(act.np)}. Do you mean {about.speech.thing(act.object)}?"
    if not about.speech.looks.is_thing(act.object):
        return f"By {_quoted(act.np)}, do you mean {about.speech.thing(act.object)} itself?"
    return f"I see {glimpse(act.object, about.speech.looks)}, is that {_the(act.np)}?"


def _bulk(act: acts.BulkNpGrdYnq, about: _About) -> str:
    parts = [f"{_the(np)} is {about.speech.thing(thing)}" for np, thing in act.pairs]
    return f"I think {listing(parts)}, am I right?"


def _env_pred_ynq(act: acts.EnvPredYnq, about: _About) -> str:
    return _capital(about.speech.words.question(act.fluent))


def _goal_pred_ynq(act: acts.GoalPredYnq, about: _About) -> str:
    return f"{_capital(about.speech.words.should_it(act.literal))} after {about.doing}?"


def _pred_change_ynq(act: acts.PredChangeYnq, about: _About) -> str:
    return (
        f"{_capital(about.speech.words.describe(act.literal))} after what you did, is that correct?"
    )


def _goal_relevant_ynq(act: acts.GoalRelevantYnq, about: _About) -> str:
    return f"So after {about.doing}, {about.speech.words.should_it(act.literal)}?"


def _select_hypo(act: acts.SelectHypo, about: _About) -> str:
    told = without_departures(ordered(act.goal))
    goal = listing([about.speech.words.describe(one) for one in told])
    done = about.draft.trace.done if about.draft.trace else act.plan
    steps = listing([about.speech.words.did(step) for step in done])
    did = f" I {steps}." if steps else ""
    back = "I see, and have put everything back first. " if act.hypothesis == CORRECTED else ""
    return f"{back}I take {about.doing} to mean that {goal}.{did} Was that right?"


def _report_execution(act: acts.ReportExecution, about: _About) -> str:
    if act.failed is None:
        return "Done."
    return f"I could not {about.speech.words.action(act.failed)}: {act.obstacle}. I stopped there."


def _request_demonstration(act: acts.RequestDemonstration, about: _About) -> str:
    restored = "I have put everything back as it was before. " if act.restored else ""
    return _REQUESTS[act.reason].format(
        todo=about.todo, doing=about.doing, restored=restored, misfit=_misfit(act, about)
    )


def _misfit(act: acts.RequestDemonstration, about: _About) -> str:
    """Why what was learned of the verb cannot be done here, as far as the robot knows."""
    if act.reason is not DemonstrationReason.NO_HYPOTHESIS:
        return ""
    missing = lacking(about.draft)
    if not missing:
        return "nothing that I learned of it fits here"
    return f"I see no {listing(list(missing), 'or')} here"


def _observe_step(act: acts.ObserveStep, about: _About) -> str:
    step = f"I see: {about.speech.words.action(act.action)}."
    return f"{step} {_so_far(act.change, about)}"


def _refuse_step(act: acts.RefuseStep, about: _About) -> str:
    return f"That cannot be done now: {act.reason}."


def _revise_steps(act: acts.ReviseSteps, about: _About) -> str:
    if not act.steps:
        return "Then I have seen no step yet."
    count = "one step" if len(act.steps) == 1 else f"{len(act.steps)} steps"
    last = about.speech.words.action(act.steps[-1])
    return f"I see {count} now, the last: {last}. {_so_far(act.change, about)}"


def _so_far(change: Sequence[Literal], about: _About) -> str:
    """What is different from before, as far as it is worth saying."""
    said = spoken(frozenset(change), about.speech.setting.lexicon)
    told = without_departures(literal for literal in change if literal in said)
    if not told:
        return "So far nothing is different from before."
    return f"So far: {'; '.join(about.speech.words.became(literal) for literal in told)}."


def _refuse_revision(act: acts.RefuseRevision, about: _About) -> str:
    step = about.speech.words.action(act.action)
    stays = "I leave the steps as they are"
    return f"{stays}: step {act.step}, {step}, could not be done, because {act.reason}."


def _revise_verb(act: acts.ReviseVerb, about: _About) -> str:
    said = "I keep to that for" if act.wanted else "I take that out of"
    left = "is left" if act.left == 1 else "are left"
    return f"{said} {_quoted(act.verb)}: {act.left} of its {act.before} hypotheses {left}."


def _include_fluent(act: acts.IncludeFluent, about: _About) -> str:
    if not act.goal:
        return f"Then {about.doing} asks for nothing at all. Keep something, show me again or skip."
    told = without_departures(_shown_first(act.goal, about))
    must = listing([about.speech.words.must(literal) for literal in told])
    return f"So after {about.doing}, {must}.{_need_not(about, act.goal)} Right?"


def _shown_first(goal: Goal, about: _About) -> list[Literal]:
    """In the order they are told; of uncertain eyes, what was handled comes before the rest."""
    if _sees_well(about):
        return list(ordered(goal))
    shown = about.episode.demonstrated if about.episode else None
    handled = {thing for action in (shown.actions if shown else ()) for thing in action.args}
    return sorted(ordered(goal), key=lambda literal: handled.isdisjoint(literal.fluent.args))


def _sees_well(about: _About) -> bool:
    return about.draft.mind.parameters.noise == NoiseModel()


def _need_not(about: _About, goal: Goal) -> str:
    """What changed as well and is not kept, told once so that a teacher can object.

    A robot with uncertain eyes may only believe that it changed, and says so.
    """
    read_back = about.episode.read_back if about.episode else None
    if not read_back or not read_back.whole - goal:
        return ""
    told = without_departures(_shown_first(read_back.whole | goal, about))
    rest = [about.speech.words.became(literal) for literal in told if literal not in goal]
    if not rest:
        return ""
    more = [f"{len(rest) - _NAMED} more things have changed"] if len(rest) > _NAMED + 1 else []
    changes = listing([*rest[: _NAMED if more else None], *more])
    if _sees_well(about):
        return f" I take it as the way there, not as the goal, that {changes}."
    return f" It looks to me as if {changes}, but I am not sure, and keep it out of the goal."


def _revise_goal(act: acts.ReviseGoal, about: _About) -> str:
    return (
        "What is wrong with it? Strike what does not matter, keep what I left out,"
        " show me again, or skip."
    )


def _learned(act: acts.Learned, about: _About) -> str:
    return f"I have learned {_quoted(act.verb)}."


def _close_episode(act: acts.CloseEpisode, about: _About) -> str:
    return _OUTCOMES[act.outcome]


def _ask_rephrase(act: acts.AskRephrase, about: _About) -> str:
    return act.reason


def _ask_again(act: acts.AskAgain, about: _About) -> str:
    return act.reason


def _quoted(words: str) -> str:
    return f'"{words}"'


def _the(phrase: str) -> str:
    """The phrase as the teacher said it, with an article where it had none."""
    first = phrase.split(" ", 1)[0].lower()
    return phrase if first in _DETERMINERS else f"the {phrase}"


def _capital(sentence: str) -> str:
    return sentence[:1].upper() + sentence[1:]


_DETERMINERS = frozenset({
    *("the", "a", "an", "my", "your", "his", "her", "its", "our", "their"),
    *("this", "that", "these", "those", "some", "any", "it", "them"),
})  # fmt: skip

_QUANTIFIERS = frozenset({
    *("a", "an", "some", "all", "both", "every", "each", "another", "everything", "any", "either"),
    *("something", "anything", "one"),
})  # fmt: skip
_POINTERS = PRONOUNS | frozenset({
    *("there", "here", "both", "all", "all of them", "both of them", "them all", "them both"),
    *("the other one", "the other", "another one", "the same", "the same one", "this one"),
    *("that one", "these ones", "those ones", "one more"),
})  # fmt: skip
"""They name nothing themselves."""

_REQUESTS: Mapping[DemonstrationReason, str] = {
    DemonstrationReason.UNKNOWN_VERB: ("I don't know how to {todo}, could you show me an example?"),
    DemonstrationReason.NO_HYPOTHESIS: (
        "I know {doing} from elsewhere, but {misfit}. Could you show me how to do it here?"
    ),
    DemonstrationReason.NO_PLAN: (
        "I know what {doing} should lead to, but I find no way to it from here. Could you show me?"
    ),
    DemonstrationReason.NOTHING_TO_DO: (
        "All that I know {doing} to ask for holds already."
        " If you mean something else, please show me; if not, skip."
    ),
    DemonstrationReason.WRONG_EXECUTION: "I see. {restored}Could you show me how to {todo}?",
    DemonstrationReason.TAKEN_OVER: "{restored}Please show me how to {todo}.",
    DemonstrationReason.SHOW_AGAIN: "{restored}Please show me again how to {todo}.",
    DemonstrationReason.NOT_SURE: (
        "I am not sure enough of what {doing} asks for here to do it, could you show me?"
    ),
    DemonstrationReason.NO_STEP: "I have seen no step yet. Show me at least one, or skip.",
    DemonstrationReason.NOTHING_CHANGED: (
        "As far as I can see, nothing is different from before. Go on showing me, or skip."
    ),
}

_OUTCOMES: Mapping[Outcome, str] = {
    Outcome.EXECUTED: "Good, I will do it like that again.",
    Outcome.LEARNED: "Thank you.",
    Outcome.UNJUDGED: "I leave it as it is.",
    Outcome.ABANDONED: "All right, I have learned nothing from this.",
}

_WORDING: Mapping[type[RobotAct], Callable[[Any, _About], str]] = {
    acts.AwaitCommand: _await_command,
    acts.StartClause: _start_clause,
    acts.NpGrdWhq: _np_grd_whq,
    acts.NpGrdYnq: _np_grd_ynq,
    acts.BulkNpGrdYnq: _bulk,
    acts.EnvPredYnq: _env_pred_ynq,
    acts.GoalPredYnq: _goal_pred_ynq,
    acts.PredChangeYnq: _pred_change_ynq,
    acts.GoalRelevantYnq: _goal_relevant_ynq,
    acts.SelectHypo: _select_hypo,
    acts.ReportExecution: _report_execution,
    acts.RequestDemonstration: _request_demonstration,
    acts.ObserveStep: _observe_step,
    acts.RefuseStep: _refuse_step,
    acts.ReviseSteps: _revise_steps,
    acts.RefuseRevision: _refuse_revision,
    acts.ReviseVerb: _revise_verb,
    acts.IncludeFluent: _include_fluent,
    acts.ReviseGoal: _revise_goal,
    acts.Learned: _learned,
    acts.CloseEpisode: _close_episode,
    acts.AskRephrase: _ask_rephrase,
    acts.AskAgain: _ask_again,
}

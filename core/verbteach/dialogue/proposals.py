"""What the robot could do now: the candidate acts of a phase, with what tells them apart.

Only acts that matter are proposed: questions about the command's own noun
phrases that are not settled yet, the selected hypothesis, and being shown.
"""

from __future__ import annotations

from collections.abc import Iterator

from verbteach.dialogue.acts import (
    DemonstrationReason,
    NpGrdWhq,
    NpGrdYnq,
    RequestDemonstration,
    RobotAct,
    SelectHypo,
)
from verbteach.dialogue.decision import Candidate, Decision
from verbteach.dialogue.draft import Draft
from verbteach.dialogue.state import EpisodeState
from verbteach.verbs.selection import Selection


def grounding_questions(draft: Draft) -> Iterator[Candidate]:
    """Table 2's acts 1 and 2 for the phrases that the teacher has not settled."""
    episode = draft.episode
    if len(episode.asked) >= draft.mind.parameters.question_cap:
        return
    asked = [one.question for one in episode.asked]
    for phrase in episode.grounding.names:
        if phrase not in episode.grounding.settled:
            yield from _about(episode, phrase, asked)


def _about(episode: EpisodeState, phrase: str, asked: list[RobotAct]) -> Iterator[Candidate]:
    belief = episode.grounding
    objects = belief[phrase]
    guessed = float(phrase in episode.guessed)
    for thing, chance in objects[: 1 if guessed else 0]:
        question = NpGrdYnq(phrase, thing)
        if question not in asked:
            yield Candidate(question, {"probability": chance, "guessed": guessed})
    which = NpGrdWhq(phrase)
    if which not in asked:
        yield Candidate(
            which,
            {
                "entropy": belief.entropy(phrase),
                "margin": belief.margin(phrase),
                "candidates": float(len(objects)),
            },
        )


def unknown_words(draft: Draft) -> Decision | None:
    """To ask about words that no object fits, or that had to be guessed: no policy weighs that."""
    options = tuple(one for one in grounding_questions(draft) if _nothing_fits(one))
    if not options:
        return None
    return Decision(options, 0, reason="I do not know a thing here by these words")


def _nothing_fits(candidate: Candidate) -> bool:
    features = candidate.features
    return features.get("candidates") == 0.0 or features.get("guessed", 0.0) > 0.0


def hypothesis(selection: Selection) -> Candidate:
    """Table 2's act 5 for the goal that was selected."""
    candidate = selection.candidate
    name = " ".join(str(literal) for literal in candidate.hypothesis)
    act = SelectHypo(candidate.goal, name, selection.plan.actions)
    return Candidate(
        act,
        {"share": candidate.share, "satisfied": candidate.satisfied, "score": selection.score},
    )


def being_shown(reason: DemonstrationReason) -> Candidate:
    """Ask for a demonstration: always possible."""
    return Candidate(RequestDemonstration(reason), {})

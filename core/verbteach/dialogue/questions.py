"""Asking and being answered: what an answer does to the robot's belief, in both phases.

A yes sets a grounding to one, a no to zero (She & Chai 2017, section 4.3). An
answer that cannot be read is asked for again, never guessed.
"""

from __future__ import annotations

from dataclasses import dataclass

from verbteach.dialogue.acts import (
    QUESTIONS,
    AskAgain,
    BulkNpGrdYnq,
    EnvPredYnq,
    No,
    NpGrdWhq,
    NpGrdYnq,
    Point,
    RobotAct,
    Say,
    Skip,
    TeacherAct,
    Unsure,
    Yes,
)
from verbteach.dialogue.asking import settled_in_bulk
from verbteach.dialogue.choosing import find_objects
from verbteach.dialogue.contradictions import (
    CONTRADICTORY,
    contradiction,
    was_put_again,
    withdrawn,
)
from verbteach.dialogue.draft import Draft
from verbteach.dialogue.grounding import GroundingBelief
from verbteach.dialogue.moves import Phase
from verbteach.dialogue.replies import Reply, read_reply
from verbteach.dialogue.state import Exchange


@dataclass(frozen=True)
class Answer:
    """An answer as read: a label, objects that were named or pointed at, or a problem."""

    label: str = ""
    objects: tuple[tuple[str, float], ...] = ()
    problem: str = ""

    @property
    def text(self) -> str:
        """The answer as the record keeps it."""
        return " ".join([self.label, *(thing for thing, _ in self.objects)]).strip()


def ask(draft: Draft, question: RobotAct, phase: Phase) -> None:
    """Put a question."""
    draft.update(question=question)
    draft.count(questions=1)
    draft.wait(question, phase)


def read_answer(draft: Draft, act: TeacherAct) -> Answer:
    """How ``act`` answers the question that waits."""
    match act:
        case Yes():
            return Answer("yes")
        case No():
            return Answer("no")
        case Unsure() | Skip():
            return Answer("unsure")
        case Point(object=thing):
            return Answer("", ((thing, 1.0),))
        case Say(text=text):
            return _read_words(draft, read_reply(text))
    raise TypeError(f"{act!r} answers no question")


def _read_words(draft: Draft, reply: Reply) -> Answer:
    question = draft.episode.question
    if not isinstance(question, NpGrdWhq | NpGrdYnq):
        if reply.reserved:
            return Answer(problem=_RESERVED)
        return Answer(reply.label, problem="" if reply.label else reply.problem)
    if not reply.rest:
        return Answer(reply.label, problem="" if reply.label else reply.problem)
    found = find_objects(draft, question.np, reply.rest)
    if found.objects:
        return Answer(reply.label, found.objects)
    if reply.reserved:
        return Answer(problem=_RESERVED)
    label = reply.label or found.label
    return Answer(label, problem="" if label else found.problem or reply.problem)


_RESERVED = "Is that a yes or a no, just as I asked it? I can take in nothing beside it."


def settle(draft: Draft, answer: Answer) -> bool:
    """Take the answer in. False where it did not answer the question, which is then put again."""
    question = draft.episode.question
    if question is not None and _contradicts(draft, question, answer):
        return False
    if isinstance(question, NpGrdWhq):
        problem = _settle_which(draft, question.np, answer)
    elif isinstance(question, NpGrdYnq):
        problem = _settle_whether(draft, question.np, question.object, answer)
    elif isinstance(question, QUESTIONS):
        problem = _settle_fact(draft, question, answer)
    else:
        raise TypeError(f"{question!r} is not a question this robot asks")
    if problem and _times_put(draft, question) < draft.mind.parameters.same_question:
        _put_again(draft, question, answer, problem)
        return False
    _close_question(draft, question, answer, problem)
    return True


def _contradicts(draft: Draft, question: RobotAct, answer: Answer) -> bool:
    """Whether the question is put once more, since the answer does not go with an earlier one.

    If it was put once more before, this answer counts and the earlier one does not.
    """
    objects = tuple(thing for thing, _ in answer.objects)
    found = contradiction(draft, question, answer.label, objects)
    if found is None:
        return False
    if was_put_again(draft.episode, question):
        draft.update(asked=withdrawn(draft.episode, found.earlier))
        return False
    draft.update(asked=(*draft.episode.asked, Exchange(question, CONTRADICTORY)))
    draft.say(AskAgain(f"Before, you said that {found.said}. Both cannot be, so once more:"))
    draft.wait(question, draft.episode.phase)
    return True


def _settle_which(draft: Draft, phrase: str, answer: Answer) -> str:
    if answer.objects:
        return _take_objects(draft, phrase, answer)
    if answer.label in {"yes", "no"}:
        return "I asked which one it is."
    return answer.problem


def _settle_whether(draft: Draft, phrase: str, thing: str, answer: Answer) -> str:
    grounding = draft.episode.grounding
    if answer.objects:
        return _take_objects(draft, phrase, answer)
    if answer.label == "yes":
        draft.update(grounding=grounding.confirm(phrase, thing))
    elif answer.label == "no":
        draft.update(grounding=grounding.deny(phrase, thing))
    return answer.problem


def _settle_fact(draft: Draft, question: RobotAct, answer: Answer) -> str:
    """A yes/no question about the world or the goal; the inquiries read it from what was asked."""
    if answer.objects:
        return "I asked for a yes or a no."
    if answer.label in {"yes", "no"} and isinstance(question, BulkNpGrdYnq):
        yes = answer.label == "yes"
        draft.update(grounding=settled_in_bulk(draft.episode.grounding, question, yes))
    if answer.label in {"yes", "no"} and isinstance(question, EnvPredYnq):
        belief = draft.episode.belief.answered(question.fluent, answer.label == "yes")
        draft.update(belief=belief)
    return answer.problem


def _take_objects(draft: Draft, phrase: str, answer: Answer) -> str:
    grounding = draft.episode.grounding.restrict(phrase, dict(answer.objects))
    draft.update(grounding=grounding)
    if len(answer.objects) == 1:
        return ""
    return f"That could be {len(answer.objects)} things."


def _times_put(draft: Draft, question: RobotAct) -> int:
    return sum(one.question == question for one in draft.episode.asked) + 1


def _put_again(draft: Draft, question: RobotAct, answer: Answer, problem: str) -> None:
    draft.update(asked=(*draft.episode.asked, Exchange(question, answer.text or "unread")))
    draft.say(AskAgain(problem))
    draft.wait(question, draft.episode.phase)


def _close_question(draft: Draft, question: RobotAct, answer: Answer, problem: str) -> None:
    positive = answer.label == "yes" or bool(answer.objects)
    draft.earn(draft.mind.parameters.rewards.of(question.name, positive=positive))
    heard = answer.text or ("unread" if problem else "unsure")
    draft.update(asked=(*draft.episode.asked, Exchange(question, heard)), question=None)
    draft.reading = heard
    _learn_words(draft, question)


def _learn_words(draft: Draft, question: RobotAct) -> None:
    """What a teacher confirmed a phrase to mean is experience for later commands."""
    grounding: GroundingBelief = draft.episode.grounding
    if isinstance(question, NpGrdWhq | NpGrdYnq) and question.np in grounding.settled:
        thing = grounding.best(question.np)
        if thing is not None:
            draft.experience.append((question.np, thing))

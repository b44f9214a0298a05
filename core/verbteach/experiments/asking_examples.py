"""Commands that a robot that asks did not do exactly, told in words."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from verbteach.dialogue.acts import EnvPredYnq, GoalPredYnq, NpGrdWhq, NpGrdYnq
from verbteach.experiments.asking_gains import Answered
from verbteach.experiments.asking_mishaps import Examined
from verbteach.language.morphology import listing
from verbteach.language.wording import Wording
from verbteach.world.fluents import Literal


def telling(found: Sequence[Examined], most: int) -> tuple[Examined, ...]:
    """Those that lost most, one for each verb as long as there are verbs."""
    ranked = sorted(found, key=lambda one: (one.sji, one.instance.id))
    first: dict[str, Examined] = {}
    for one in ranked:
        first.setdefault(one.instance.verb, one)
    of_verbs = list(first.values())
    return (*of_verbs, *(one for one in ranked if one not in of_verbs))[:most]


def told(one: Examined, words: Wording) -> str:
    """A command in a few sentences: what was asked, done, missed and done needlessly."""
    instance = one.instance
    said = f"*{instance.verb} ({', '.join(instance.phrases)})*"
    asked = "; ".join(_question(question, words) for question in one.questions)
    parts = [
        f"{instance.id}, {said}. Asked: {asked or 'nothing'}.",
        f"Done: {'; '.join(map(words.action, one.plan)) or 'nothing'}.",
        _literals("Left out", one.wanted - one.chosen, words),
        _literals("Too much", one.chosen - one.wanted, words),
        f"SJI {one.sji:.2f}, expected {one.expected:.2f},"
        f" asked on {one.outcomes.asked_on.sji:.2f}, all answered {one.outcomes.answered.sji:.2f}.",
    ]
    return " ".join(filter(None, parts))


def _question(question: Answered, words: Wording) -> str:
    match question.act:
        case NpGrdWhq(np=phrase):
            text = f"which is “{phrase}”?"
        case NpGrdYnq(np=phrase, object=thing):
            text = f"is “{phrase}” {thing}?"
        case EnvPredYnq(fluent=fluent):
            text = words.question(fluent)
        case GoalPredYnq(literal=literal):
            text = f"{words.should_it(literal)}?"
        case act:
            text = act.name
    return f"{text} {question.label.value}"


def _literals(title: str, literals: Iterable[Literal], words: Wording) -> str:
    described = [words.describe(literal) for literal in sorted(literals)]
    return f"{title}: {listing(described)}." if described else ""

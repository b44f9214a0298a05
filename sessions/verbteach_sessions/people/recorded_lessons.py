"""Lessons from records: what people had done, as something that can be taught again.

A lesson begins with the scene as it is found, so an episode that began with
the world changed gives none; nor does one whose goal nobody confirmed.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from verbteach.dialogue import acts
from verbteach.dialogue.lesson import Lesson
from verbteach.dialogue.setting import Settings
from verbteach.verbs.space import HypothesisSpace
from verbteach.world.fluents import Goal
from verbteach.world.plan import Action
from verbteach_sessions.errors import SessionError
from verbteach_sessions.header import SIMULATED
from verbteach_sessions.people.golds import LessonBook
from verbteach_sessions.people.observations import later
from verbteach_sessions.people.recorded import Recorded, Said
from verbteach_sessions.people.standing import Standing


@dataclass(frozen=True)
class Taught:
    """A command of a record with the lesson that teaches the same, and its episodes."""

    lesson: Lesson
    episodes: tuple[tuple[Said, ...], ...]


def taught(recorded: Recorded, book: LessonBook, settings: Settings) -> Iterator[Taught]:
    """The commands of a record that a lesson is known for.

    The ``book`` tells what a simulated teacher or a study's task meant, where
    it knows just one lesson of these words; else the record itself has to.
    """
    told = recorded.header.teacher == SIMULATED or recorded.header.study is not None
    for episodes in _commands(recorded):
        first = episodes[0]
        command = first[-1].before.command
        known = book.meant(first[-1].before.scene, command) if told else ()
        if len(known) == 1:
            yield Taught(known[0], episodes)
        elif len(episodes) == 1:
            yield from (Taught(one, episodes) for one in _lessons(recorded, first, settings))


def _commands(recorded: Recorded) -> Iterator[tuple[tuple[Said, ...], ...]]:
    """The episodes, those of one command's clauses together."""
    together: list[tuple[Said, ...]] = []
    for episode in recorded.episodes():
        begins = any(isinstance(one.act, acts.Command) for one in episode)
        if begins and together:
            yield tuple(together)
            together = []
        if begins or together:
            together.append(episode)
    if together:
        yield tuple(together)


def _lessons(recorded: Recorded, episode: Sequence[Said], settings: Settings) -> Iterator[Lesson]:
    """The lesson that the episode itself amounts to, if it came to a confirmed goal."""
    last = episode[-1]
    before, outcome = last.before, last.after.outcome
    if before.start is None or before.start != settings(before.scene).scene.initial:
        return
    goal, steps = _confirmed(before, outcome)
    if goal and steps:
        yield Lesson(
            f"{recorded.header.id}:{last.seq}",
            before.scene,
            before.command,
            *_frame(last, later(episode).meant),
            steps,
            goal,
            recorded.person,
        )


def _confirmed(before: Standing, outcome: acts.Outcome | None) -> tuple[Goal, tuple[Action, ...]]:
    """The goal that the person called right, and how it was reached; empty where there is none."""
    waiting = before.waiting
    if outcome is acts.Outcome.EXECUTED and isinstance(waiting, acts.SelectHypo):
        return waiting.goal, waiting.plan
    if outcome is acts.Outcome.LEARNED and isinstance(waiting, acts.IncludeFluent):
        return waiting.goal, before.shown
    return frozenset(), ()


def _frame(said: Said, meant: Mapping[str, str]) -> tuple[str, Mapping[str, tuple[str, ...]]]:
    """The verb and the grounding: as kept by the robot, and as what was done then shows it."""
    spaces = said.record["spaces"] if said.record else []
    if not spaces:
        return "", {phrase: (thing,) for phrase, thing in meant.items()}
    try:
        kept = HypothesisSpace.from_json(spaces[-1]).demonstration
        pairs = list(zip(kept.phrases, kept.grounding, strict=True))
    except ValueError as error:
        raise SessionError(f"event {said.seq}: what was learned cannot be read, {error}") from error
    return kept.verb, {phrase: (meant.get(phrase, thing),) for phrase, thing in pairs}

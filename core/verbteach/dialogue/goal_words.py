"""A goal put in a person's own words: as a whole, or what belongs to it and what does not.

What is said is looked for first among what the goal speaks of, then in the
whole scene. Who repeats a part of the goal says all of it; who names something
else puts it to the goal.
"""

from __future__ import annotations

from collections.abc import Callable, Container, Sequence
from dataclasses import dataclass
from typing import NamedTuple

from verbteach.dialogue.draft import Draft
from verbteach.dialogue.facts import Facts, mentioning, said_of_any
from verbteach.dialogue.referring import looks_now
from verbteach.dialogue.speech import Speech
from verbteach.dialogue.worth import without_departures
from verbteach.language.goal_talk import GoalTalk, How, read_goal_talk
from verbteach.language.morphology import listing
from verbteach.language.statements import Statement, Words, read_statements, without_leads
from verbteach.language.words import QUESTION_WORDS
from verbteach.world.fluents import Goal, Literal


class Restated(NamedTuple):
    """The goal as the teacher has it, or what is unclear about their words."""

    goal: Goal = frozenset()
    problem: str = ""


@dataclass(frozen=True)
class Said:
    """What statements come to: literals that matter and fluents that do not, or a problem.

    ``doubtful``: they are understood as far as what they are about, and no further.
    """

    needed: Goal = frozenset()
    unneeded: Goal = frozenset()
    problem: str = ""
    doubtful: bool = False


def restated(draft: Draft, text: str, goal: Goal, whole: Goal) -> Restated | None:
    """What ``text`` makes of ``goal``; ``None`` where it speaks of no goal.

    ``whole`` is all that has changed, from which parts may be kept.
    """
    talk = read_goal_talk(text)
    if talk is None:
        return None
    if talk.how is How.ALL:
        return None if talk.said_yes else Restated(frozenset(without_departures(goal | whole)))
    said = named_parts(draft, talk, goal, goal | whole)
    if said is None or (talk.said_yes and _agrees(talk.how, goal, said)):
        return None
    problem = said.problem or _strikes_nothing(goal, said)
    return Restated(_changed(talk.how, goal, goal | whole, said), problem)


def _agrees(how: How, goal: Goal, said: Said) -> bool:
    """Whether it only repeats of the goal what is in it."""
    repeats = said.needed <= goal and not said.unneeded and not said.problem
    return repeats and how in {How.SAYS, How.WITH}


def _strikes_nothing(goal: Goal, said: Said) -> str:
    """What is said where all that should not matter does not matter already."""
    fluents = {one.fluent for one in goal}
    left_out = bool(said.unneeded) and fluents.isdisjoint(one.fluent for one in said.unneeded)
    return _NO_PART if left_out else ""


def _changed(how: How, goal: Goal, whole: Goal, said: Said) -> Goal:
    """The goal with what was said of it."""
    fluents = {one.fluent for one in said.needed | said.unneeded}
    kept = frozenset(one for one in goal if one.fluent not in fluents)
    match how:
        case How.ONLY:
            return said.needed
        case How.ALL_BUT:
            arrived = without_departures(whole)
            return frozenset(one for one in arrived if one.fluent not in fluents)
        case How.WITHOUT:
            return kept
        case How.SAYS if said.needed & goal and not said.unneeded:
            return said.needed
    return kept | said.needed


def named_parts(draft: Draft, talk: GoalTalk, goal: Goal, whole: Goal) -> Said | None:
    """The parts that the words name, by what is said of things or by the things alone."""
    reader = StatementReader.of(draft, goal, whole)
    statements = read_statements(talk.tokens)
    said = reader.read(statements)
    if said is not None and not (said.problem and talk.how is How.WITHOUT):
        return said
    if talk.how is How.SAYS:
        return None
    it_is = reader.facts.about(("it",), talk.tokens)  # "only clean"
    return Said(frozenset(it_is)) if len(it_is) == 1 else _by_things(reader, talk, goal, whole)


def _by_things(reader: StatementReader, talk: GoalTalk, goal: Goal, whole: Goal) -> Said | None:
    """The parts about the things that the words name: "only the mug", "not the tap"."""
    parts: set[Literal] = set()
    for statement in read_statements(talk.tokens):
        things = reader.facts.things(_bare(statement.subject or statement.said))
        if not things:
            named = " ".join(talk.tokens)
            return Said(problem=_NO_THING.format(named)) if named.startswith(_THE) else None
        about = _about(talk.how, things, goal, whole)
        if not about:
            return Said(problem=_NOTHING_OF_IT.format(thing=reader.named(things)))
        parts |= set(about)
    return Said(needed=frozenset(parts))


def _about(how: How, things: Sequence[str], goal: Goal, whole: Goal) -> tuple[Literal, ...]:
    """The parts that naming the things alone may mean."""
    if how is How.ALL_BUT:
        return mentioning(whole, things)
    if how is How.WITHOUT:
        return said_of_any(goal, things) or mentioning(goal, things)
    if how is How.WITH:
        return said_of_any(whole - goal, things) or mentioning(whole, things)
    return (
        said_of_any(goal, things)
        or said_of_any(whole, things)
        or mentioning(goal, things)
        or mentioning(whole, things)
    )


def _bare(words: Words) -> Words:
    return without_leads(words)


@dataclass(frozen=True)
class StatementReader:
    """Reads statements in this scene; things that ``whole`` speaks of come first."""

    draft: Draft
    facts: Facts
    goal: Goal
    whole: Goal

    @classmethod
    def of(cls, draft: Draft, goal: Goal, whole: Goal) -> StatementReader:
        """A reader for the episode under way, in the world as it is now."""
        return cls(draft, Facts(draft, looks_now(draft), spoken_of(draft, goal)), goal, whole)

    def read(self, statements: Sequence[Statement]) -> Said | None:
        """What all of them come to; ``None`` where they state nothing of anything here."""
        needed: set[Literal] = set()
        unneeded: set[Literal] = set()
        earlier: Words = ()
        waiting: list[Words] = []
        named: set[str] = set()
        for statement in statements:
            subjects, found = self._of(statement, earlier)
            if not found:
                if statement.loose and self.facts.things(statement.said):
                    waiting.append(statement.said)  # "the mug and the plate should be clean"
                    continue
                return self._unread(statement)
            for words, literals in [
                *((w, self.facts.about(w, statement.said)) for w in waiting),
                (subjects, found),
            ]:
                whole = not statement.said or self.facts.several(words)
                among = literals if whole else self._narrowed(literals, named)
                chosen = among if self._settled(words, among, statement) else ()
                if not chosen:
                    return Said(problem=self._which(among))
                (needed if statement.needed else unneeded).update(chosen)
                named.update(thing for one in chosen for thing in one.fluent.args)
            earlier, waiting = subjects, []
        return None if waiting else Said(frozenset(needed), frozenset(unneeded))

    def _of(self, statement: Statement, earlier: Words) -> tuple[Words, tuple[Literal, ...]]:
        """The subject and all that may be meant by what is said of it."""
        subject, said, positive = statement.subject, statement.said, statement.positive
        if statement.loose or subject == ("there",):
            parted = self.facts.parted(said, positive=positive)
            if parted[1] or not earlier or statement.subject:
                return parted
            return earlier, self.facts.about(earlier, said, positive=positive)
        if not said or (not statement.needed and said[0] in _SOMEWHERE):
            how = How.WITH if statement.needed else How.WITHOUT
            things = self.facts.things(subject)
            found = _about(how, things, self.goal, self.whole)
            return subject, found or mentioning(self.whole, things)
        return subject, self.facts.about(subject, said, positive=positive)

    def _narrowed(self, literals: Sequence[Literal], named: Container[str]) -> tuple[Literal, ...]:
        """Those that the goal speaks of, else those about what was spoken of, else all.

        ``named`` are the things of what was said just before.
        """
        things = {thing for one in self.whole for thing in one.fluent.args}
        tests: tuple[Callable[[Literal], bool], ...] = (
            lambda one: one.fluent in {part.fluent for part in self.goal},
            lambda one: one.fluent in {part.fluent for part in self.whole},
            lambda one: one.fluent.args[0] in named,
            lambda one: one.fluent.args[0] in self.facts.spoken,
            lambda one: things.issuperset(one.fluent.args),
        )
        among = tuple(literals)
        for test in tests:
            among = tuple(filter(test, among)) or among
        return among

    def _settled(self, subject: Words, among: Sequence[Literal], statement: Statement) -> bool:
        """Whether it is one, or several are spoken of."""
        changed = {one.fluent for one in self.whole}
        known = all(one.fluent in changed for one in among)
        if subject[:1] == ("both",):
            return len(among) == 2
        return len(among) == 1 or known or not statement.said or self.facts.several(subject)

    def _unread(self, statement: Statement) -> Said | None:
        """Why a statement is not understood; ``None`` where it may be about something else."""
        if statement.loose:
            return None
        subject = " ".join(statement.subject)
        if statement.subject[0] in _NO_SUBJECTS:
            return None
        if not self.facts.things(statement.subject):
            return Said(problem=f'I see nothing here that I would call "{subject}".')
        if not (said := " ".join(statement.said)):
            return Said(problem=_NOTHING_OF_IT.format(thing=subject))
        return Said(problem=_UNREAD.format(subject=subject, said=said), doubtful=True)

    def _which(self, literals: Sequence[Literal]) -> str:
        words = Speech.of(self.draft.mind.setting, self.draft.state.world).words
        told = [words.must(one) for one in literals[:_MOST]]
        return f"Which do you mean: {listing(told, 'or')}? Please say the whole of it."

    def named(self, things: Sequence[str]) -> str:
        """The things in words."""
        name = Speech.of(self.draft.mind.setting, self.draft.state.world).thing
        return listing([name(thing) for thing in things[:_MOST]], "or")


def spoken_of(draft: Draft, goal: Goal) -> tuple[str, ...]:
    """What a pronoun may mean: what the command named, then what the goal is about."""
    things = [*draft.episode.best_objects]
    for literal in sorted(goal):
        things += literal.fluent.args
    return tuple(dict.fromkeys(things))


_MOST = 4
_UNREAD = 'I cannot tell what "{said}" means for {subject} here.'
_SOMEWHERE = frozenset({"there", "anywhere", "here", "somewhere", "wherever"})
_NO_SUBJECTS = QUESTION_WORDS | {"i", "we", "he", "she", "they", "there"}
_NO_THING = 'I see nothing here that I would call "{}".'
_THE = ("the ", "a ", "an ", "my ", "that ", "this ")
_NO_PART = "That is no part of it anyway."
_NOTHING_OF_IT = "Nothing of what changed is about {thing}."

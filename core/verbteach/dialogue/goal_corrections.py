"""What should have come of an execution, said after it: "no, put it in the sink", "close it too".

A statement says how things should be; an action, what it would bring about.
Either is put into the goal that was carried out, in place of what it excludes.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import groupby
from typing import NamedTuple

from verbteach.dialogue.draft import Draft
from verbteach.dialogue.facts import Facts
from verbteach.dialogue.goal_words import Said, StatementReader, spoken_of
from verbteach.dialogue.referring import fitting_objects, looks_now
from verbteach.dialogue.speech import Speech
from verbteach.language.anaphora import resolve
from verbteach.language.frames import Argument, VerbFrame
from verbteach.language.goal_talk import GoalTalk, How, read_goal_talk
from verbteach.language.grammar import parse
from verbteach.language.household import VERBS
from verbteach.language.inflection import base_of_participle
from verbteach.language.statements import Statement, Words, read_statements
from verbteach.language.step_patterns import step_words
from verbteach.language.steps import StepReader
from verbteach.language.wordlist import word_set
from verbteach.world.fluents import Fluent, Goal, Literal
from verbteach.world.plan import Action


class Meant(NamedTuple):
    """The goals that the words may make of the executed one, the first that can be reached counts.

    ``problem``: why they make none. ``first``: they say how to go about it, not what should be.
    ``doubtful``: they may as well name a thing that was taken wrongly.
    """

    goals: tuple[Goal, ...] = ()
    problem: str = ""
    first: bool = False
    doubtful: bool = False


_ORDER = word_set("first before beforehand after afterwards then slowly carefully quickly faster")
_RATHER_THAN = frozenset({("instead", "of"), ("rather", "than"), ("and", "not")})
_WANTED = frozenset({("i", "wanted"), ("i", "meant"), ("i", "said")})
_ROBOT = frozenset({("you",), ("robot",), ("the", "robot")})
_NOT_HERE = 'I see nothing here that I would call "{}".'
_NOTHING: tuple[Goal, frozenset[Fluent]] = (frozenset(), frozenset())
_NO_WORDS = frozenset({"do", "not", "never"})


def goals_meant(draft: Draft, text: str) -> Meant:
    """What ``text`` makes of the goal that was carried out; nothing where it speaks of none.

    Words that tell to do something count behind a no: alone they may be the next command.
    """
    execution, talk = draft.episode.execution, read_goal_talk(text)
    if execution is None or talk is None or talk.how in {How.ALL, How.ALL_BUT, How.WITHOUT}:
        return Meant()
    talk = _corrective(talk)
    if not _ORDER.isdisjoint(talk.tokens):
        return Meant(first=talk.said_no and _acts(draft, talk.tokens))
    said = _stated(draft, talk, execution.goal)
    if said.problem or not said.goals:
        return said
    (wanted,) = said.goals
    return said._replace(goals=tuple(_put_into(execution.goal, wanted, talk)))


def _corrective(talk: GoalTalk) -> GoalTalk:
    """Without what should not have been, and with the no that "i wanted" comes to."""
    words = talk.tokens
    cut = next((at for at in range(len(words)) if words[at : at + 2] in _RATHER_THAN), len(words))
    return talk._replace(tokens=words[:cut], said_no=talk.said_no or _wants(talk))


def says_how_it_should_be(text: str) -> bool:
    """Whether it is said of a thing, and not only told what to take or to do."""
    talk = read_goal_talk(text)
    statements = read_statements(talk.tokens) if talk is not None else ()
    return bool(statements) and bool(statements[0].subject) and statements[0].subject not in _ROBOT


def said_anew(draft: Draft, text: str) -> tuple[VerbFrame, ...]:
    """The command said again in other words: its verb, with a thing that it did not name."""
    talk, setting = read_goal_talk(text), draft.mind.setting
    if talk is None or talk.how is not How.SAYS or not talk.said_no:
        return ()
    was = draft.episode.frame
    frames = parse(" ".join(talk.tokens), setting.lexicon, setting.vocabulary)
    if [frame.verb for frame in frames] != [was.verb]:
        return ()
    named = {phrase.text for phrase in was.phrases}
    anew = any(not p.is_pronoun and p.text not in named for p in frames[0].phrases)
    known = all(_is_here(draft, argument) for argument in frames[0].arguments)
    return resolve([was, *frames])[1:] if anew and known else ()


def _is_here(draft: Draft, argument: Argument) -> bool:
    looks = looks_now(draft)
    return argument.phrase.is_pronoun or bool(fitting_objects(draft, argument, looks))


def _stated(draft: Draft, talk: GoalTalk, goal: Goal) -> Meant:
    """What the statements and actions of the words come to together, as one goal."""
    reader = StatementReader.of(draft, goal, goal)
    wanted: Goal = frozenset()
    groups = groupby(read_statements(talk.tokens), lambda one: _tells_to_do(draft, one))
    for tells, group in groups:
        listed = list(group)
        if (listed[0].loose and not talk.said_no) or any(one.observed for one in listed):
            return Meant()  # "the mug is dirty" only says what is to be seen
        said = _done(draft, listed, wanted) if tells else _said(reader, listed)
        if said is None or not (said.problem or said.needed):
            return Meant()
        if said.problem:
            return Meant(problem=said.problem, doubtful=said.doubtful)
        wanted = said.needed if tells else wanted | said.needed
    bare = bool(listed) and listed[0].loose and not tells and not _wants(talk)
    return Meant((wanted,), doubtful=bare) if wanted else Meant()


def _wants(talk: GoalTalk) -> bool:
    return talk.tokens[:2] in _WANTED


def _tells_to_do(draft: Draft, statement: Statement) -> bool:
    told = _told_to_do(statement)
    return bool(told) and _acts(draft, told)


def _said(reader: StatementReader, listed: Sequence[Statement]) -> Said | None:
    elsewhere = _elsewhere(reader, listed[0].said) if listed[0].loose else frozenset()
    return Said(elsewhere) if elsewhere else reader.read(listed)


def _told_to_do(statement: Statement) -> Words:
    """The words for something to do: "you should have closed it" says "close it"."""
    if statement.loose or statement.subject not in _ROBOT:
        return statement.said if statement.loose else ()
    words = statement.said[statement.said[:1] == ("have",) :]
    base = base_of_participle(words[0], VERBS) if words else None
    return (base, *words[1:]) if base else words


def _done(draft: Draft, listed: Sequence[Statement], wanted: Goal) -> Said | None:
    """What doing one after the other brings about; the problem where a thing is not here."""
    for words in map(_told_to_do, listed):
        action = _action(draft, words)
        come, gone = _brought_about(draft, action) if action is not None else _NOTHING
        if not come:
            frames = _frames(draft, words)
            if missing := [a for f in frames for a in f.arguments if not _is_here(draft, a)]:
                return Said(problem=_NOT_HERE.format(missing[0].phrase.text))
            come, gone = _state_meant(draft, frames), frozenset()
        if not come:
            return None
        wanted = frozenset(one for one in wanted if one.fluent not in gone) | come
    return Said(wanted)


def _frames(draft: Draft, words: Words) -> tuple[VerbFrame, ...]:
    setting = draft.mind.setting
    return parse(" ".join(step_words(" ".join(words))), setting.lexicon, setting.vocabulary)


def _state_meant(draft: Draft, frames: Sequence[VerbFrame]) -> Goal:
    """What a verb that is no single step asks for: "wash it", "fill it with water"."""
    if len(frames) != 1 or not frames[0].phrases:
        return frozenset()
    execution = draft.episode.execution
    spoken = spoken_of(draft, execution.goal if execution else frozenset())
    facts = Facts(draft, looks_now(draft), spoken)
    first, *places = frames[0].arguments
    subject = tuple(first.phrase.text.split())
    if places:
        place = tuple(places[0].phrase.text.split())
        found = facts.about(subject, (*places[0].role.split(), *place))
    else:
        found = facts.about(subject, (frames[0].verb,))
    return frozenset(found) if len(found) == 1 else frozenset()


def _elsewhere(reader: StatementReader, said: Words) -> Goal:
    """Of "on the table" alone: what the goal has put somewhere is there instead."""
    if said[0] not in reader.facts.looks.prepositions:
        return frozenset()
    placed = {one.fluent.args[0] for one in reader.goal if one.positive and one.fluent.args[1:]}
    found = reader.facts.about(("it",), said)
    return frozenset(one for one in found[:1] if one.fluent.args[0] in placed)


def _acts(draft: Draft, words: Words) -> bool:
    """Whether the words tell the robot to do something."""
    frames, verbs = _frames(draft, words), {*VERBS, *draft.mind.setting.lexicon.verbs}
    return bool(frames) and frames[0].verb.split(" ")[0] in verbs


def _action(draft: Draft, words: Words) -> Action | None:
    """The action of the domain that the words tell to do, in the world as it is now."""
    if not _NO_WORDS.isdisjoint(words):
        return None
    setting = draft.mind.setting
    speech = Speech.of(setting, draft.state.world)
    execution = draft.episode.execution
    spoken = spoken_of(draft, execution.goal if execution else frozenset())
    reader = StepReader(setting.task, speech.looks, speech.words, setting.vocabulary, spoken[::-1])
    return reader.read(" ".join(words)).action


def _brought_about(draft: Draft, action: Action) -> tuple[Goal, frozenset[Fluent]]:
    """What the action is for: what comes of it, else what goes; and all that goes with it."""
    task = draft.mind.setting.task
    ground = next((one for one in task.actions if one.action == action), None)
    if ground is None:
        return frozenset(), frozenset()
    adds, deletes = ground.add, ground.delete
    if not adds | deletes:
        adds, deletes = ground.changes(task.encode(draft.state.world))
    come = _telling(draft, _literals(draft, adds, positive=True))
    gone = _literals(draft, deletes, positive=False)
    return come or _telling(draft, gone), frozenset(one.fluent for one in gone)


def _literals(draft: Draft, bits: int, *, positive: bool) -> Goal:
    return frozenset(Literal(f, positive) for f in draft.mind.setting.task.named(bits))


def _telling(draft: Draft, goal: Goal) -> Goal:
    """Without the robot's bookkeeping and what comes along with anything."""
    lexicon = draft.mind.setting.lexicon
    passed = lexicon.unspoken | lexicon.incidental
    return frozenset(one for one in goal if one.fluent.predicate not in passed)


def _put_into(goal: Goal, wanted: Goal, talk: GoalTalk) -> Iterator[Goal]:
    """The goal with what is wanted: with all the rest, with what is of other things, alone."""
    fluents = {one.fluent for one in wanted}
    rest = frozenset(one for one in goal if one.fluent not in fluents)
    about = {one.fluent.args[0] for one in wanted} | {one.fluent.args[-1] for one in wanted}
    others = frozenset(one for one in rest if about.isdisjoint(one.fluent.args))
    if talk.how is How.ONLY:
        yield wanted
        return
    yield rest | wanted
    if talk.how is not How.WITH:
        yield others | wanted
        yield wanted

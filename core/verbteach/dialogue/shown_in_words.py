"""A demonstration told in words: one step or several in a line, and what is said around them."""

from __future__ import annotations

import re

from verbteach.dialogue import acts, commands, demonstration, enquiries, learning
from verbteach.dialogue.acts import AskAgain
from verbteach.dialogue.draft import Draft
from verbteach.dialogue.facts import Facts
from verbteach.dialogue.moves import Phase
from verbteach.dialogue.referring import looks_now
from verbteach.dialogue.speech import Speech
from verbteach.language.answers import Label, read_answer
from verbteach.language.goal_talk import read_goal_talk
from verbteach.language.grammar import Unread, explain_unread
from verbteach.language.small_talk import (
    Talk,
    asks_in_a_command,
    meant_word,
    small_talk,
    without_greeting,
)
from verbteach.language.statements import read_statements
from verbteach.language.steps import HOW, StepReader, StepReading
from verbteach.language.tokens import spelled_out, tokenise
from verbteach.language.words import QUESTION_WORDS
from verbteach.world.plan import Action

_LEAVE = "To leave, say quit; you can go on later."
_BACK = "To take the last step back, say undo."
_OTHERWISE = f"{_BACK} Then say the right one."
_NOT_TO_DO = "Show me only what is to be done, not what is not."
_AT_THE_END = (
    "What must hold at the end you tell me when all is shown: say done after the last step."
)
_ENDING = re.compile(
    r"(?<=\w)[\s,.;]+(?:(?:and|then|now)\s+)*"
    r"(?:(?:i am|i'm|im|it is|it's|its|we are)\s+)?(?:all\s+)?"
    r"(?:done|finished|that's it|thats it|that is it|that's all|thats all|that is all)[\s.!]*$",
    re.IGNORECASE,
)
"""Behind the last step in the same line."""
_ASKING = QUESTION_WORDS | {"is", "are", "am", "do", "does", "did", "was", "were"}
_MISTAKEN = ("no", "nope", "wrong", "sorry", "oops", "not", "rather")
_FORBIDDING = (["do", "not"], ["never"], ["must", "not"], ["should", "not"])


def hear(draft: Draft, text: str) -> None:
    """Take what was said during a demonstration: steps, that it is over, or something else.

    A step that could be several is kept in mind until it is said which.
    """
    before, text = draft.state.heard, without_greeting(text)
    draft.remember(heard="")
    talk = small_talk(text)
    waits = talk is Talk.WAIT and bool(_reader(draft).read(text).action)
    match None if waits else talk:  # "wait a minute" may be a step
        case Talk.DONE:
            draft.reading = acts.Done.name
            learning.sum_up(draft)
        case Talk.GIVE_UP | Talk.ABSENT:
            draft.reading = acts.Skip.name
            learning.abandon(draft)
            commands.go_on(draft)
        case Talk.LEAVE:
            draft.wait(AskAgain(_LEAVE), Phase.DEMONSTRATION)
        case Talk.BACK:
            draft.wait(AskAgain(_BACK), Phase.DEMONSTRATION)
        case Talk.WAIT:
            draft.wait(AskAgain(f"I am waiting. {HOW}"), Phase.DEMONSTRATION)
        case Talk():
            draft.wait(AskAgain(HOW), Phase.DEMONSTRATION)
        case None if problem := _no_step(draft, text):
            draft.wait(AskAgain(problem), Phase.DEMONSTRATION)
        case None:
            _watch(draft, text, before)


def _no_step(draft: Draft, text: str) -> str:
    """What is said to words that show nothing: a correction, a prohibition or a question."""
    setting = draft.mind.setting
    tokens = [token for token in tokenise(spelled_out(text)) if token[:1].isalpha()]
    if tokens[:1] and tokens[0] in {"you", "we"}:
        tokens = tokens[1:]
    if any(tokens[: len(words)] == words for words in _FORBIDDING):
        return _NOT_TO_DO
    corrects = tokens[:2] == ["i", "meant"] or tokens[-1:] == ["instead"]
    if len(tokens) > 1 and (corrects or tokens[0] in _MISTAKEN):
        return _about_the_end(draft, text) or _OTHERWISE
    answer = read_answer(text)
    if answer.label is Label.UNSURE or (answer.label is Label.YES and not answer.rest):
        return HOW
    if answer.label is Label.NO and not answer.rest:
        return _BACK
    asks = "?" in text or (tokens[:1] and tokens[0] in _ASKING)
    unread = explain_unread(text, setting.lexicon, setting.vocabulary) if asks else None
    asks = asks and tokens[0] in QUESTION_WORDS
    if asks or unread is Unread.QUESTION or asks_in_a_command(text):
        return enquiries.answer(draft, text) or HOW
    return _about_the_end(draft, text) or _slip(text)


def _about_the_end(draft: Draft, text: str) -> str:
    """What is said to a word on how things should be: that comes after the last step."""
    talk = read_goal_talk(text)
    if talk is None or _reader(draft).says_a_step(text):
        return ""
    statements = read_statements(talk.tokens)
    facts = Facts(draft, looks_now(draft), draft.episode.best_objects)
    said = any(one.subject and one.said and facts.things(one.subject) for one in statements)
    return _AT_THE_END if said else ""


def _slip(text: str) -> str:
    near = meant_word(text)
    return f'If you mean "{near}", please say it like that.' if near else ""


def _watch(draft: Draft, text: str, before: str) -> None:
    """Watch the steps in order; the first that cannot be read or done ends the line."""
    end = _ENDING.search(text)
    parts = _reader(draft).parts(text[: end.start()] if end else text)
    read: list[Action] = []
    for number, said in enumerate(parts):
        reading = _read(draft, said, before if number == 0 else "")
        if reading.action is None:
            draft.remember(heard=said if reading.open else "")
            draft.wait(AskAgain(reading.problem), Phase.DEMONSTRATION)
            break
        read.append(reading.action)
        demonstration.observe(draft, reading.action)
        if isinstance(draft.acts[-1], acts.RefuseStep):
            break
    else:
        if end:
            learning.sum_up(draft)
    draft.reading = "; ".join(map(str, read))


def _read(draft: Draft, text: str, before: str) -> StepReading:
    """A step in the domain's words, letters' case ignored, or in the person's own."""
    setting = draft.mind.setting
    words = text.strip().removeprefix("(").removesuffix(")").lower().split()
    names = {name.lower(): name for name in setting.task.domain.actions}
    ids = {name.lower(): name for name in setting.scene.objects}
    taking = setting.task.domain.actions[names[words[0]]] if words and words[0] in names else None
    bare = len(words) == 1 and taking is not None and taking.parameters  # "open": what?
    if taking is not None and not bare and all(word in ids for word in words[1:]):
        return StepReading(Action(names[words[0]], tuple(ids[word] for word in words[1:])))
    return _reader(draft).read(text, before)


def _reader(draft: Draft) -> StepReader:
    setting = draft.mind.setting
    shown = draft.episode.demonstrated
    named = [thing for action in (shown.actions if shown else ()) for thing in action.args]
    latest_last = tuple(dict.fromkeys(reversed(named)))[::-1]
    speech = Speech.of(setting, draft.state.world)
    return StepReader(setting.task, speech.looks, speech.words, setting.vocabulary, latest_last)

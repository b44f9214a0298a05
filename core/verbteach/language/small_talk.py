"""What people say about the conversation itself: "help", "never mind", "that's it", "hello".

Only a whole utterance is one of these: "stop" is, "stop the microwave" is a command.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from enum import Enum

from verbteach.language.tokens import COMMA, STOP, spelled_out, tokenise
from verbteach.language.typos import suggest
from verbteach.language.wordlist import phrase_list, word_set


class Talk(Enum):
    """What such an utterance wants."""

    HELP = "help"
    DONE = "done"
    GIVE_UP = "give_up"
    ABSENT = "absent"
    BACK = "back"
    GREETING = "greeting"
    REPLY = "reply"
    LEAVE = "leave"
    REPEAT = "repeat"
    SHOW = "show"
    WAIT = "wait"


_SAID = {
    Talk.HELP: """
        help, help me, what, what now, what next, what do i do, what do i do now, what do i say,
        what should i do, what should i do now, what should i say, what can i do, what can i say,
        what can you do, what do you mean, what is this, what is that, what 's this, what 's that,
        what does that mean, what is going on, how, how do i do that, how do i do this,
        how do i teach you, how does this work, how do i show you, i do not understand,
        i do not get it, i need help, huh, eh, excuse me, sorry, pardon, where am i, who are you,
        i am lost, i am stuck, let us start, let us begin, let us go, start, begin,
        are you ready, come on, go ahead, carry on,
        proceed, continue, go on, you do it, do it yourself, do it,
        you know that, you know that already, you already know that, see, you see, got it,
        did you get that, understood, did you understand, what can you do for me, what do you want,
        what are the steps, which steps are there, what are the options, i can not, please, can you
        help me, do something, i do not know how, i do not know how to do it,
        i do not know what to do, i do not know what to say, how do i start, tell me what to do,
        could you help me, help me please, please help me
    """,
    Talk.DONE: """
        done, i am done, finish demonstration, finish the demonstration, that is how,
        end the demonstration, demonstration finished, that is it, that is all, that 's it,
        that 's all, finished, i am finished,
        all done, ready, it is done, that was it, that was all, the end, end, end of demonstration,
        complete, completed, that is everything, i have finished, nothing more, no more steps,
        no more, nothing else, finish, end it, that is how you do it, that 's how you do it,
        that is how it is done, that 's how it 's done, that 's how it is done, that is how it
        works,
        like that, like this, your turn, now you, now you do it, it is your turn, stop here,
        that should do it, that will do, that would be everything,
        that would be all, that would be it, it is finished, it is finish, it is ready, i finish,
        i finished, that was everything, we are done, we are finished, you are done, this is it,
        i am finished now, that is all for today,
        that 's all for today, that 's all folks, that is all for now, that 's all for now
    """,
    Talk.GIVE_UP: """
        skip, skip it, skip this, skip that, pass, never mind, nevermind, forget it, forget that,
        forget about it, cancel, cancel that, cancel it, abort, stop, stop it, stop that, give up,
        i give up, leave it, enough, do nothing, not now, next, next one, move on, nothing, later,
        no idea,
        let it be, never mind that, stop this, stop now, stop asking, leave that,
        no thanks, no thank you
    """,
    Talk.ABSENT: """
        none, there is none, none of them, none of these, none of those, neither, nowhere,
        not here, it is not here, it 's not here, there is not one, there is not any,
        there are none, there is no such thing, i see none, it is not there, it does not exist,
        i do not have one, i do not have any, we do not have one, we have none, i have none,
        you can not see it, it is gone, it is somewhere else, it is in another room
    """,
    Talk.BACK: """
        undo, undo that, undo it, go back, back, wrong, that was wrong, that is wrong, oops, no,
        no not that, no not that one, not that one, not that, i made a mistake, take that back,
        mistake, my mistake, start over, start again, restart, reset, do not, do not do that,
        do not do it, no do not, that was a mistake, that is a mistake, delete that, delete it,
        scratch that, remove that step, remove the last step, delete that step,
        delete the last step, take that step back, take back that step, take back the last step,
        take the last step back, undo the last step, undo that step, undo everything, go back one,
        go back a step, go back one step, one step back, step back, not like that, wrong step,
        forget everything, forget what i taught you, forget what i showed you, forget what i said,
        undo the last command, undo my last command, take back what i said, undo what i said,
        take back my last command, forget what you learned, forget all that, unlearn that, unlearn
        it
    """,
    Talk.GREETING: """
        hello, hi, hey, hello there, hi there, hey there, good morning, good day, good evening,
        good afternoon, greetings, how are you, how are you doing, how are you today,
        how do you do, nice to meet you,
        pleased to meet you, how is it going, how are things
    """,
    Talk.REPLY: """
        yes, yeah, yep, ok, okay, sure, good, great, nice, cool, well done, perfect, thanks,
        thank you, thank you very much, thanks a lot, good job, good robot, maybe, y, n, no,
        correct, right
    """,
    Talk.LEAVE: """
        how do i leave, how do i quit, how do i exit, how do i stop, how do i get out,
        quit, exit, bye, goodbye, good bye, leave, i want to leave, i want to stop, log out,
        close the app, let me out, i am leaving, see you, see you later, goodbye for now,
        i have to go, i need to go, i must go, bye bye, that will be all for today,
        that is all for today goodbye, good night, see you tomorrow
    """,
    Talk.REPEAT: """
        repeat, repeat that, repeat it, repeat the question, repeat yourself, say that again,
        say it again, come again, what was that, what did you say, what did you ask, once more,
        what was the question, i did not hear you, i did not hear that, i beg your pardon
    """,
    Talk.SHOW: """
        show, let me show you, i will show you, i shall show you, i show you, i can show you,
        i want to show you, i would like to show you, watch, watch me, watch this, look here,
        let me show you again, i will show you again, show me again, i want to show you again,
        let me do it, i will do it, let me demonstrate, i will demonstrate, let me teach you,
        i will teach you, i want to teach you, let me show you how, i will show you how,
        i want to show you how, let me try again, let me show you how it is done,
        i will show you how it is done, let me show you how it works, i will show you how it works,
        let me show you how to do it, i will show you how to do it, let me show you how to do that,
        i will do it myself, let me do it myself, i show you how, i will show you again, show again
    """,
    Talk.WAIT: """
        wait a minute, wait a moment, wait a second, wait a sec, hold on, hang on, hold on a second,
        hang on a second, hold on a minute, one moment, one minute, one second, just a moment,
        just a minute, just a second, just a sec, a moment, give me a second, give me a moment,
        give me a minute, let me think, let me see, no wait, hmm, hm, mm, wait please, please wait
    """,
}
_TO_BE_SHOWN = re.compile(
    r"\s*(?:(?:now|ok|okay|so|well|please|today)[\s,]+)*"
    r"(?:(?:let me|lemme|i will|i'll|i want to|i would like to|i'd like to|i am going to"
    r"|i'm going to|i can|i)\s+(?:show|teach)\s+you(?:\s+now)?\s+(?:how\s+(?:to|i|you|we)|to)"
    r"|learn\s+(?:how\s+)?to|(?:watch|look|see)(?:\s+me)?\s+how\s+(?:i|to))\s+(?P<command>\S.*)",
    re.IGNORECASE | re.DOTALL,
)
_POLITE = frozenset({Talk.GREETING, Talk.REPLY})
_FIRST_PART = re.compile(r"\s*(?P<first>[^,.!?;:]+)[,.!?;:]+\s*(?P<rest>\w.*)", re.DOTALL)
_ASKING = re.compile(
    r"\s*(?:(?:please|now)\s+)*(?:(?:can|could|would|will)\s+you\s+(?:please\s+)?)?"
    r"(?:(?:tell|show)\s+me\s+(?:where|what|which|whether|if|how|who)"
    r"|(?<=you )see\s+(?:the|a|any|my)|say\s+(?:where|what|which|whether|if))\b"
    r"|\s*(?:(?:please|now|can you|could you)\s+)*(?:check|see|look|find out|watch)\s+"
    r"(?:if|whether|what|where|which|how many)\b"
    r"|\s*(?:whats|wheres|hows|whos|where)\b",
    re.IGNORECASE,
)
_AROUND = frozenset({COMMA, STOP}) | word_set(
    "please robot well oh um uh hm so and but now then ok okay sorry dear alright yay wow haha"
)
_TABLE = {
    tuple("is" if word == "'s" else word for word in words): kind
    for kind, text in reversed(_SAID.items())
    for words in phrase_list(text)
}
_ENDS_SHOWING = re.compile(
    r"[,.;!]\s*(?:let me|i will|i'll|i shall)\s+(?:show|teach)\s+you"
    r"(?:\s+how(?:\s+(?:it is|it's|that is|to do it|it works|i do it)(?:\s+done)?)?)?[\s.!]*$",
    re.IGNORECASE,
)
"""Whatever stands before it: "oh, that is quite alright, let me show you how it is done"."""


def small_talk(text: str) -> Talk | None:
    """What ``text`` says about the conversation; ``None`` where it is about something else.

    Said twice it is the same: "that's it, done".
    """
    tokens = tokenise(spelled_out(text))
    found = Talk.SHOW if _ENDS_SHOWING.search(text) else _kind(tokens)
    if found is None:
        parts = [part for part in _parts(tokens) if not set(part) <= _AROUND]
        kinds = {_kind(part) for part in parts}
        kinds = kinds - _POLITE or kinds
        found = kinds.pop() if len(kinds) == 1 and len(parts) > 1 else None
    return found


def without_greeting(text: str) -> str:
    """The text without the greetings and thanks, parted off by a mark, that stand before it."""
    found = _FIRST_PART.match(text)
    polite = found is not None and small_talk(found["first"]) in _POLITE
    return without_greeting(found["rest"]) if found and polite else text


def meant_word(text: str) -> str:
    """The word that ends or leaves something and that a single word is a slip of; else empty."""
    tokens = [token for token in tokenise(text) if token not in _AROUND]
    known = _KIND_WORDS - {*tokens}
    near = suggest(tokens[0], known) if len(tokens) == 1 and tokens[0] not in _KIND_WORDS else ()
    return near[0] if near else ""


_KIND_WORDS = word_set("done finished finish ready skip stop cancel undo help quit")


def asks_in_a_command(text: str) -> bool:
    """Whether a question is put like a command: "tell me where the pot is"."""
    return _ASKING.match(text) is not None


def to_be_shown(text: str) -> str:
    """The command in "let me show you how to boil water"; empty where nothing is announced."""
    found = _TO_BE_SHOWN.match(text)
    return found["command"] if found else ""


def _kind(tokens: Sequence[str]) -> Talk | None:
    """What the words say as a whole, with or without the small words around them."""
    bare = list(tokens)
    while bare and bare[0] in _AROUND:
        bare = bare[1:]
    while bare and bare[-1] in _AROUND:
        bare = bare[:-1]
    return _TABLE.get(_words(bare)) or _TABLE.get(_words(tokens))


def _words(tokens: Sequence[str]) -> tuple[str, ...]:
    spelled = ("is" if token == "'s" else token for token in tokens)
    return tuple(token for token in spelled if token not in {COMMA, STOP})


def _parts(tokens: Sequence[str]) -> list[list[str]]:
    """The words between commas and stops."""
    parts: list[list[str]] = [[]]
    for token in tokens:
        if token in {COMMA, STOP}:
            parts.append([])
        else:
            parts[-1].append(token)
    return parts

"""What people say about the conversation itself: "help", "never mind", "that's it", "hello".

Only a whole utterance is one of these: "stop" is, "stop the microwave" is a command.
"""

from __future__ import annotations

from enum import Enum

from verbteach.language.tokens import COMMA, STOP, spelled_out, tokenise
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


_SAID = {
    Talk.HELP: """
        help, help me, what, what now, what next, what do i do, what do i do now, what do i say,
        what should i do, what should i do now, what should i say, what can i do, what can i say,
        what can you do, what do you mean, what is this, what is that, what 's this, what 's that,
        what does that mean, what is going on, how, how do i do that, how do i do this,
        how do i teach you, how does this work, how do i show you, i do not understand,
        i do not get it, i need help, huh, eh, excuse me, sorry, pardon, where am i, who are you,
        i am lost, i am stuck
    """,
    Talk.DONE: """
        done, i am done, that is it, that is all, that 's it, that 's all, finished, i am finished,
        all done, ready, it is done, that was it, that was all, the end, end, end of demonstration,
        complete, completed, that is everything, i have finished, nothing more, no more steps
    """,
    Talk.GIVE_UP: """
        skip, skip it, skip this, skip that, pass, never mind, nevermind, forget it, forget that,
        forget about it, cancel, cancel that, cancel it, abort, stop, stop it, stop that, give up,
        i give up, leave it, enough, not now, next, next one, move on, nothing, later, no idea
    """,
    Talk.ABSENT: """
        none, there is none, none of them, none of these, none of those, neither, nowhere,
        not here, it is not here, it 's not here, there is not one, there is not any,
        there are none, there is no such thing, i see none, it is not there, it does not exist
    """,
    Talk.BACK: """
        undo, undo that, undo it, go back, back, wrong, that was wrong, that is wrong, oops, no,
        no not that, no not that one, not that one, not that, i made a mistake, take that back,
        mistake, my mistake, start over, start again, restart, reset
    """,
    Talk.GREETING: """
        hello, hi, hey, hello there, hi there, hey there, good morning, good day, good evening,
        good afternoon, greetings, how are you, how are you doing
    """,
    Talk.REPLY: """
        yes, yeah, yep, ok, okay, sure, good, great, nice, cool, well done, perfect, thanks,
        thank you, thank you very much, thanks a lot, good job, good robot, maybe, y, n, no,
        correct, right
    """,
    Talk.LEAVE: """
        how do i leave, how do i quit, how do i exit, how do i stop, how do i get out,
        quit, exit, bye, goodbye, good bye, leave, i want to leave, i want to stop, log out,
        close the app, let me out, i am leaving
    """,
}
_AROUND = frozenset({COMMA, STOP}) | word_set("please robot well oh um uh hm so and but now then")
_TABLE = {words: kind for kind, text in reversed(_SAID.items()) for words in phrase_list(text)}


def small_talk(text: str) -> Talk | None:
    """What ``text`` says about the conversation; ``None`` where it is about something else."""
    tokens = tokenise(spelled_out(text))
    whole = tuple(token for token in tokens if token not in {COMMA, STOP})
    while tokens and tokens[0] in _AROUND:
        tokens = tokens[1:]
    while tokens and tokens[-1] in _AROUND:
        tokens = tokens[:-1]
    bare = tuple(token for token in tokens if token not in {COMMA, STOP})
    return _TABLE.get(bare) or _TABLE.get(whole)

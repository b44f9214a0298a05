"""Commands that ask what the robot sees or can do: "look at the fridge", "can you fly?".

They look like commands for a verb. Whether one is taken for a question hangs on
what is in the room and on what was taught, which is not known here.
"""

from __future__ import annotations

import re

from verbteach.language.frames import VerbFrame
from verbteach.language.wordlist import word_set

_ABILITY = re.compile(
    r"\s*(?:(?:hey|hi|hello|so|and|but|ok|okay|well|now|robot)[\s,]+)*"
    r"(?:(?:can|could)\s+(?:you|u)|are you able to|would you be able to"
    r"|do you think (?:that )?you can|is it possible for you to)\s+(?P<rest>\S.*)",
    re.IGNORECASE | re.DOTALL,
)
_MENTAL = word_set(
    "hear understand know remember feel smell taste believe like love think hate talk speak learn"
)
_ASKED_NICELY = re.compile(r"\b(?:please|pls|plz|kindly)\b|\bfor me\b", re.IGNORECASE)
_LOOKING = word_set(
    "see look watch find seek locate spot search check inspect examine observe identify notice "
    "describe recognize recognise view study detect discover perceive behold glance peek"
)


def what_it_can(text: str) -> str:
    """The command in "can you open the fridge?"; empty where nothing is put like that."""
    found = _ABILITY.match(text)
    return found["rest"] if found else ""


def asks_whether_able(text: str) -> bool:
    """Whether it may ask what the robot can do: "can you fly?"; with a "please" it is a request."""
    return bool(what_it_can(text)) and _ASKED_NICELY.search(text) is None


def is_mental(frame: VerbFrame) -> bool:
    """Whether it is nothing that could be shown: "can you hear me?"."""
    return frame.verb.split(" ")[0] in _MENTAL


def is_looking(frame: VerbFrame) -> bool:
    """Whether nothing is to be done but to look, or to look for something."""
    return frame.verb.split(" ")[0] in _LOOKING or _is_shown_to_me(frame)


def _is_shown_to_me(frame: VerbFrame) -> bool:
    """As in "show me the kettle", which the robot does by saying where it is."""
    to_me = any(one.role == "to" and one.phrase.head in {"me", "us"} for one in frame.arguments)
    return frame.verb == "show" and to_me

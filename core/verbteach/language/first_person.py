"""The robot speaks of itself as "I": sentences about "the robot" turned into its own."""

from __future__ import annotations

import re

_PLAIN = {"has": "have", "does": "do", "holds": "hold", "carries": "carry"}


def first_person(sentence: str) -> str:
    """``sentence`` with the robot as its speaker; what it says of others stays as it is."""
    if "he robot" not in sentence:
        return sentence
    told = re.sub(r"\b([Ii])s the robot\b", lambda m: f"{'A' if m[1] == 'I' else 'a'}m I", sentence)
    told = re.sub(r"\b([Hh]a|[Dd]oe)s the robot\b", _asked, told)
    told = re.sub(r"\b([Ss]hould|[Mm]ust) the robot\b", r"\1 I", told)
    told = re.sub(r"\b[Tt]he robot is\b", "I am", told)
    told = re.sub(r"\b[Tt]he robot((?: now| no longer)?) (has|does|holds|carries)\b", _does, told)
    return re.sub(r"\b[Tt]he robot (should|must|need not|may|cannot)\b", r"I \1", told)


def _asked(found: re.Match[str]) -> str:
    return {"ha": "have", "doe": "do", "Ha": "Have", "Doe": "Do"}[found[1]] + " I"


def _does(found: re.Match[str]) -> str:
    return f"I{found[1]} {_PLAIN[found[2]]}"

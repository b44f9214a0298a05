"""What a study says to participants beside its own texts: the same on the screen and in lines."""

from __future__ import annotations

from collections.abc import Mapping

from verbteach_sessions.study.stopping import LESSONS, MASTERY, MINUTES, TASKS

ASK_CONSENT = "Do you agree to take part?"
REFUSED = "You do not take part. Nothing has been kept."
CODE = "Your code is {code}. With it you can come back, and later have your record deleted."
BACK = "To come back:"
WELCOME_BACK = "Welcome back. You go on where you were."
PAUSED = "Paused. Everything is kept; you go on where you are now."
PRACTICE = "Practice: what the robot learns now is forgotten afterwards."
STOP_ASKED = (
    "To stop taking part, type end once more; to go on, type no. What you did so far is kept, "
    "unless you have it deleted by your code."
)
ENDING = "end: stops taking part for good; quit only pauses"
GOES_ON = "You go on."
STOPPED = "You have stopped. Thank you for what you did."
OVER: Mapping[str, str] = {
    TASKS: "That was the last task of this part.",
    LESSONS: "That was the last command of this part.",
    MINUTES: "The time for this part is up.",
    MASTERY: "The robot has learned what this part was for.",
}
"""What is said when a stretch is over, by why it is."""

TLX = (
    "Now a few questions about the teaching you have just done. Each is about the whole of it. "
    "You may leave any of them out."
)
COMPLETION = "Your completion code: {code}"
WITHDRAWAL = (
    "To have your record deleted, give this code to whoever invited you; nobody will ask why: "
    "{code}"
)


def paused(code: str, command: str) -> tuple[str, ...]:
    """What is said to one who leaves before the end; ``command`` leads back."""
    return PAUSED, CODE.format(code=code), BACK, command


def headed(number: int, total: int, text: str) -> str:
    """A task with its place among all."""
    return f"Task {number} of {total}: {text}"

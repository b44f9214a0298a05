"""What is kept of a participant's way through a study: every type of event and its fields.

The file is written like a session's log, line by line, each with the hash of
the one before.
"""

from __future__ import annotations

from collections.abc import Mapping

from verbteach_sessions.shapes import INTEGER, TEXT, TEXTS, Field, Shape, list_of, of_shape, row_of

ENROLLED, OPENED, BEGAN, DONE, FINISHED = "enrolled", "opened", "began", "done", "finished"

YES = "yes"
CONSENT = Shape(
    "consent",
    "The participant's consent; without it nothing is written at all.",
    (
        Field("answer", TEXT, "what was answered"),
        Field("text", TEXT, "SHA-256 of the text that was shown, in UTF-8"),
    ),
)
_WEIGHTS = list_of(row_of(TEXT, TEXT))
"""A condition, and the SHA-256 of its file of weights, a copy of which lies beside."""
_CREATED = Field("created", TEXT, "wall-clock time, ISO 8601, UTC")
_INTERFACE = Field("interface", TEXT, "`app`, `plain` or `browser`")
_STEP = Field("step", INTEGER, "which step, from 0")

VISIT_EVENTS: Mapping[str, Shape] = {
    one.name: one
    for one in (
        Shape(
            ENROLLED,
            "The participant consented and got a place; always the first event.",
            (
                Field("study", TEXT, "the study's id"),
                Field("study_hash", TEXT, "SHA-256 of its file, a copy of which lies beside"),
                Field("participant", TEXT, "the participant's code"),
                Field("slot", INTEGER, "the place in the order of participants, from 0"),
                Field("order", TEXTS, "the conditions, in the order they come"),
                Field("weights", _WEIGHTS, "those that conditions begin with", optional=True),
                Field("consent", of_shape(CONSENT), "the consent"),
                _CREATED,
                _INTERFACE,
            ),
        ),
        Shape(OPENED, "The participant came back.", (_CREATED, _INTERFACE)),
        Shape(
            BEGAN,
            "The session of a step was begun.",
            (_STEP, Field("session", TEXT, "its name, also its folder's")),
        ),
        Shape(DONE, "A step is over.", (_STEP, Field("why", TEXT, "what ended it"))),
        Shape(
            FINISHED,
            "The participant saw the thanks.",
            (Field("completion", TEXT, "the completion code that was shown"),),
        ),
    )
}

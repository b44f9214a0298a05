"""What happens in a session: every type of event, its fields, and what each field means.

The tables are the one place that says so: the checks, the content hash and
``docs/session-format.md`` follow them. How events are stored is not known here.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from verbteach_sessions.shapes import (
    ANSWER,
    FLAG,
    INTEGER,
    NUMBER,
    OBJECT,
    TEXT,
    TEXTS,
    Field,
    Shape,
    fitting,
    list_of,
    mapping_of,
    of_shape,
    or_null,
    row_of,
)

HEADER = "header"
TEACHER = "teacher"
LEARNED = "learned"
ROBOT = "robot"
UNDO = "undo"
REDO = "redo"
FLAGGED = "flag"
NOTE = "note"
WHY = "why"
REPEAT = "repeat"
FAULT = "fault"
RESUME = "resume"
REBUILD = "rebuild"
END = "end"
QUESTIONNAIRE = "questionnaire"

REVISION = Shape(
    "revision",
    "A fluent of a hypothesis that the teacher struck out or confirmed.",
    (
        Field("frame", TEXT, "the verb frame, such as `boil/1`"),
        Field("hypothesis", TEXTS, "the lifted hypothesis that names the fluent's things"),
        Field("literal", TEXT, "the fluent, as it stands in the hypothesis"),
        Field("wanted", FLAG, "whether it is part of the goal"),
    ),
)
PRACTICE = Shape(
    "practice",
    "One step that the question policy learned from.",
    (
        Field("phase", TEXT, "`execution` or `learning`"),
        Field(
            "seen", mapping_of(NUMBER), "features of the act, less those of the next, discounted"
        ),
        Field("reward", NUMBER, "what the learner was told, in hundreds, at its own prices"),
        Field("delta", NUMBER, "how far that was from what it expected"),
        Field("weights", mapping_of(NUMBER), "the phase's weights afterwards, by feature"),
        Field("digest", TEXT, "the hash of both phases' weights afterwards"),
    ),
)
RECORD = Shape(
    "record",
    "What was learned at one point; all records together give the robot's whole knowledge.",
    (
        Field("spaces", list_of(OBJECT), "the hypothesis spaces that came in, one a demonstration"),
        Field("experience", list_of(row_of(TEXT, TEXT)), "noun phrases and what they meant"),
        Field(
            "policy",
            list_of(of_shape(PRACTICE)),
            "what the question policy learned; missing where it learned nothing",
            optional=True,
        ),
        Field(
            "revisions",
            list_of(of_shape(REVISION)),
            "what the teacher corrected in what was known; may be missing, which is none",
            optional=True,
        ),
    ),
)
SOURCE = Shape(
    "source",
    "The session that this one goes on from; nothing more is needed of it.",
    (
        Field("id", TEXT, "its name"),
        Field("content_hash", TEXT, "its content hash when it was read"),
    ),
)
PROMISE = Shape(
    "promise",
    "How much of what the robot carries out is to be right, and what it takes for that.",
    (
        Field("rate", NUMBER, "the share that is to be right, 0 to 1"),
        Field("sure", NUMBER, "it carries out only what it is at least so sure of, 0 to 1"),
        Field("lessons", INTEGER, "how many commands that was calibrated on"),
        Field(
            "sureness",
            OBJECT,
            "`weights` of the features of `select_hypo`; how sure it is, is their weighted sum"
            " through the logistic function",
        ),
    ),
)
CANDIDATE = Shape(
    "candidate",
    "An act that the robot could have taken.",
    (
        Field("act", OBJECT, "the act"),
        Field("features", mapping_of(NUMBER), "its features by name"),
        Field("q", or_null(NUMBER), "its value under the policy, where that gives one"),
    ),
)
PARENT = Shape(
    "parent",
    "The session that this one branched from; its events up to the branch are this one's own.",
    (
        Field("id", TEXT, "its name"),
        Field("seq", INTEGER, "the last event that both share"),
        Field("hash", TEXT, "SHA-256 of that event's whole line in the parent"),
    ),
)
DECISION = Shape(
    "decision",
    "One choice of the policy.",
    (
        Field("candidates", list_of(of_shape(CANDIDATE)), "all it could choose from"),
        Field("chosen", INTEGER, "the index of the one chosen"),
        Field("propensity", NUMBER, "the chosen act's probability under the policy"),
        Field("explored", FLAG, "whether it was chosen to explore"),
        Field("reason", TEXT, "the reason, where the policy gives one"),
        Field(
            "weights",
            TEXT,
            "the hash of the weights that chose; missing where there are none",
            optional=True,
        ),
    ),
)
PHRASE = Shape(
    "phrase",
    "The grounding belief of one noun phrase.",
    (
        Field("phrase", TEXT, "the noun phrase as it was said"),
        Field("objects", list_of(row_of(TEXT, NUMBER)), "objects with their probabilities"),
    ),
)
GOAL = Shape(
    "goal",
    "A goal that the robot thinks may be meant.",
    (
        Field("goal", TEXTS, "its literals, sorted"),
        Field("share", NUMBER, "its probability among the goals listed"),
    ),
)
BELIEFS = Shape(
    "beliefs",
    "What the robot believed when it chose.",
    (
        Field("grounding", list_of(of_shape(PHRASE)), "the command's noun phrases, in order"),
        Field("goals", list_of(of_shape(GOAL)), "the goals it weighs, the best first"),
        Field(
            "uncertain",
            list_of(row_of(TEXT, NUMBER)),
            "fluents it is not sure of, with its confidence; all others are 0 or 1",
        ),
    ),
)
TRACE = Shape(
    "trace",
    "An execution on the true world.",
    (
        Field("done", TEXTS, "the actions done"),
        Field("failed", or_null(TEXT), "the action that could not be done"),
        Field("obstacle", TEXT, "why it could not"),
        Field("worlds", TEXTS, "SHA-256 of the world before the first and after each action"),
    ),
)
AFTER = Shape(
    "after",
    "The state that holds after the event, in short.",
    (
        Field("scene", TEXT, "where the robot is"),
        Field("digest", TEXT, "SHA-256 of the robot's whole state"),
        Field("world", TEXT, "SHA-256 of the true world: its fluents as sorted text"),
        Field("knowledge", TEXT, "SHA-256 of what it has learned of verbs"),
        Field("totals", mapping_of(NUMBER), "counts and the reward of the session so far"),
        Field("verbs_learned", TEXTS, "the verbs it knows, sorted"),
    ),
)
DIFFERENCE = Shape(
    "difference",
    "Where recomputing gave something else than was recorded.",
    (
        Field("seq", INTEGER, "the event"),
        Field("field", TEXT, "the path of the value in its data"),
        Field("recorded", TEXT, "SHA-256 of the value recorded"),
        Field("recomputed", TEXT, "SHA-256 of the value recomputed"),
    ),
)
SHAPES = (
    RECORD,
    PRACTICE,
    REVISION,
    SOURCE,
    PARENT,
    PROMISE,
    DECISION,
    CANDIDATE,
    BELIEFS,
    PHRASE,
    GOAL,
    TRACE,
    AFTER,
    DIFFERENCE,
)

_PERSON = (
    Field("reply_to", INTEGER, "`seq` of the `robot` event that was on the screen"),
    Field("raw", TEXT, "what was typed, or the key that was pressed, as it came"),
    Field("via", TEXT, "how it came, such as `typed`, `key`, `mouse`, `script`, `simulated`"),
    Field("shown_at", or_null(NUMBER), "session time at which the robot's turn was shown"),
    Field("answered_at", NUMBER, "session time at which the person acted"),
    Field(
        "in_view",
        TEXTS,
        "the panels in view since the robot's turn was shown: `dialogue`, `scene`, `mind`,"
        " `belief` (what it took the scene for), `verbs` (what it has learned); missing where"
        " there are no panels",
        optional=True,
    ),
)
_MACHINE = (
    Field("created", TEXT, "wall-clock time, ISO 8601, UTC"),
    Field("software", mapping_of(TEXT), "versions of the packages that recomputing depends on"),
    Field("python", TEXT, "version of Python"),
    Field("platform", TEXT, "operating system and processor"),
    Field("interface", TEXT, "such as `app`, `plain`, `script`, `simulated`, `browser`"),
    Field("terminal", or_null(row_of(INTEGER, INTEGER)), "columns and rows of the terminal"),
)
_AFTER = Field("after", of_shape(AFTER), "the state that now holds", content=True)
_TO = Field("to", INTEGER, "`seq` of the `robot` event that holds again")

_TYPES = (
    Shape(
        HEADER,
        "What was settled before anything was said; always the first event.",
        (
            Field("id", TEXT, "the session's name, also its folder's"),
            *_MACHINE,
            Field("participant", or_null(TEXT), "the person's random code"),
            Field("study", or_null(OBJECT), "the study's condition and the consent text's hash"),
            Field("teacher", TEXT, "`human`, `simulated` or `script`"),
            Field("scene", TEXT, "the scene it begins in", content=True),
            Field("policy", OBJECT, "the question policy: `name`, its parameters", content=True),
            Field("seed", INTEGER, "the seed of every random draw", content=True),
            Field("noise", OBJECT, "the noise model of what the robot sees", content=True),
            Field("parameters", OBJECT, "the method's other parameters", content=True),
            Field(
                "second_opinion",
                FLAG,
                "whether a second reader took part; may be missing, which is false",
                content=True,
                optional=True,
            ),
            Field(
                "promise",
                of_shape(PROMISE),
                "what the robot promises of its executions; missing where it promises nothing",
                content=True,
                optional=True,
            ),
            Field("source", or_null(of_shape(SOURCE)), "the session it goes on from"),
            Field("parent", or_null(of_shape(PARENT)), "the session it branched from; since 2"),
            Field("learned_before", list_of(of_shape(RECORD)), "what that taught", content=True),
        ),
    ),
    Shape(
        TEACHER,
        "What the teacher said or did. It counts once a `robot` event replies to it.",
        (*_PERSON, Field("act", OBJECT, "the act, its name in `act`", content=True)),
    ),
    Shape(
        LEARNED,
        "What the robot learned from the teacher's act, written just before its reply.",
        (
            Field("reply_to", INTEGER, "`seq` of the `teacher` event"),
            Field("record", of_shape(RECORD), "enough to rebuild the knowledge", content=True),
        ),
    ),
    Shape(
        ROBOT,
        "What the robot said and did, and why.",
        (
            Field("reply_to", INTEGER, "`seq` of the `teacher`, `header` or `rebuild` event"),
            Field("reading", TEXT, "how the robot read the teacher's act", content=True),
            Field("acts", list_of(OBJECT), "its acts in order; the last one waits", content=True),
            Field("texts", TEXTS, "the wording of each act", content=True),
            Field("phase", TEXT, "what it waits for", content=True),
            Field("reward", NUMBER, "what the teacher's act earned", content=True),
            Field("decisions", list_of(of_shape(DECISION)), "its choices in order", content=True),
            Field("beliefs", or_null(of_shape(BELIEFS)), "within a command only", content=True),
            Field("trace", or_null(of_shape(TRACE)), "if it carried out a plan", content=True),
            _AFTER,
        ),
    ),
    Shape(
        UNDO,
        "The teacher took back the last act that counted, or several.",
        (*_PERSON, _TO, _AFTER),
    ),
    Shape(REDO, "The teacher took back an `undo`, or a part of it.", (*_PERSON, _TO, _AFTER)),
    Shape(FLAGGED, "The teacher marked the robot's turn as odd.", _PERSON),
    Shape(
        NOTE,
        "The teacher wrote something down.",
        (*_PERSON, Field("text", TEXT, "what was written", content=True)),
    ),
    Shape(
        WHY,
        "The teacher asked why the robot asks.",
        (*_PERSON, Field("texts", TEXTS, "the explanation", content=True)),
    ),
    Shape(
        REPEAT,
        "The teacher wanted to hear it again.",
        (*_PERSON, Field("texts", TEXTS, "what was said again", content=True)),
    ),
    Shape(
        FAULT,
        "The robot could not reply to the teacher's act, which so does not count.",
        (
            Field("reply_to", INTEGER, "`seq` of the `teacher` event"),
            Field("error", TEXT, "the kind of error"),
            Field("message", TEXT, "what it says"),
        ),
    ),
    Shape(
        RESUME,
        "The session was opened again.",
        (*_MACHINE, Field("recovered", TEXTS, "what the person was told about repairs")),
    ),
    Shape(
        REBUILD,
        "Recomputing gave something else than was recorded, so the knowledge was rebuilt from"
        " the records and the scene began anew. What came before cannot be undone.",
        (
            Field("standing", INTEGER, "`seq` of the `robot` event that held"),
            Field("scene", TEXT, "the scene that begins anew", content=True),
            Field("difference", of_shape(DIFFERENCE), "the first difference"),
        ),
    ),
    Shape(END, "The session was left in good order.", _PERSON),
    Shape(
        QUESTIONNAIRE,
        "What the person answered about the session, mostly after its end. The last one counts.",
        (
            Field("name", TEXT, "which questionnaire", content=True),
            Field(
                "answers",
                mapping_of(ANSWER),
                "ratings (0 to 100) and free texts by the question; null where none was given",
                content=True,
            ),
            Field("seconds", NUMBER, "how long the person took"),
        ),
    ),
)

EVENT_TYPES: Mapping[str, Shape] = {one.name: one for one in _TYPES}
FITTING: Mapping[str, Callable[[Any], bool]] = {one.name: fitting(one) for one in _TYPES}
"""For each type of event, whether its data is of its shape."""

# Where and how a session ran is no part of what was said in it.
OUTSIDE_CONTENT = frozenset({FAULT, RESUME, END})

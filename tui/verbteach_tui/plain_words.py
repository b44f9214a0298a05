"""What the plain mode prints besides the dialogue: choices, the scene, the mind, help, in lines.

Every line can stand alone, as a screen reader reads it: no boxes, no columns,
no signs that only an eye understands.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence

from verbteach.dialogue.moves import Phase
from verbteach_tui.keys import MEANS, answer_keys, anytime
from verbteach_tui.prompts import step_example
from verbteach_tui.snapshot import Snapshot
from verbteach_tui.views.dialogue import SPEAKERS
from verbteach_tui.views.marks import Mark
from verbteach_tui.views.picture import Picture, Thing
from verbteach_tui.views.visible import visible

LOCAL = {
    "help": "what you can say now",
    "look": "what is where in the scene",
    "seen": "the same as the robot saw it when it got the command",
    "mind": "what the robot makes of it",
    "verbs": "the verbs it has learned",
    "steps": "the actions you can show, numbered",
    "shown": "the steps you have shown, numbered, and what they have changed",
}
"""Words that only the plain mode knows; they are not for the robot and leave no record."""

_READ_BACK = "say y if that is right, n if not; a number strikes that part, or keeps it after all."

_ANSWER = (
    "Answer in words, or with one of these. "
    "The price says how much the question takes off the robot's reward."
)
_ASKS = {
    Phase.COMMAND: (
        "Say what the robot should do, such as: open the window. "
        "If it does not know how, it asks you to show it."
    ),
    Phase.EXECUTION: _ANSWER,
    Phase.LEARNING: _ANSWER,
    Phase.JUDGEMENT: "Say whether it was right, or stop: N if it should have stopped after a step.",
    Phase.DEMONSTRATION: (
        "Type a step in your own words, such as: {step}; or several with commas between. "
        "Or type steps for numbered ones. Say done after the last one."
    ),
    Phase.READ_BACK: "Type the number of a part to strike it or keep it after all.",
}


def hint(snapshot: Snapshot) -> list[str]:
    """The numbered choices of the moment, and where there are parts of a goal, what to do."""
    if snapshot.choices:
        labels = snapshot.depictor.labels
        return [f"{digit}. {labels[thing]}" for digit, thing in snapshot.choices.items()]
    if snapshot.phase is Phase.READ_BACK:
        parts = [part.must if part.kept else part.need_not for part in snapshot.parts]
        return [*numbered(parts), f"{SPEAKERS['note']}: {_READ_BACK}"] if parts else []
    return []


def numbered(texts: Iterable[str]) -> list[str]:
    """Texts with numbers from 1."""
    return [f"{number}. {text}" for number, text in enumerate(texts, 1)]


def help_lines(snapshot: Snapshot, hidden: Collection[str] = (), rooms: bool = True) -> list[str]:
    """What can be said now, one thing to a line, with its short form.

    Without the words that are ``hidden`` here; ``rooms``: one may go to another scene.
    """
    lines = [_ASKS[snapshot.phase].format(step=step_example(snapshot))]
    said: dict[str, list[str]] = {}
    for key in answer_keys(snapshot.phase):
        said.setdefault(key.word, []).append(key.key)
    lines += [f"{word} or {' or '.join(keys)}" for word, keys in said.items()]
    lines += [
        f"{key.word} or {key.key}: {MEANS[key.word]}" for key in anytime() if key.word != "note"
    ]
    lines += ["note: TEXT keeps a note beside the turn", "quit leaves; you can go on later"]
    if snapshot.phase is Phase.COMMAND and rooms:
        lines.append("scene: NAME goes to another scene; a NAME that is none gets you all of them")
    return lines + [f"{word}: {about}" for word, about in LOCAL.items() if word not in hidden]


def look_lines(picture: Picture) -> list[str]:
    """The scene, one piece of furniture to a line."""
    lines = [f"{picture.title}."]
    for actor in picture.actors:
        if actor.holds:
            lines.append(f"The {actor.label} holds {_listed(actor.holds)}.")
    lines += [_told(place) for place in (*picture.places, *picture.others)]
    return lines


def shown_lines(snapshot: Snapshot) -> list[str]:
    """The steps of the demonstration, what they changed, and how they are edited."""
    if not snapshot.shown:
        return ["Nothing shown yet."]
    told = [change for change in snapshot.change if not change.trifle] or snapshot.change
    changes = [f"Changed: {change.text}." for change in told]
    edits = "To edit: remove: N, remove: N-M, move: N M, insert: N STEP."
    return [*numbered(snapshot.shown), *(changes or ["Nothing is different so far."]), edits]


def mind_lines(snapshot: Snapshot) -> list[str]:
    """What words may refer to and which goals the robot sees, with their shares."""
    lines = promise_lines(snapshot)
    for phrase in snapshot.mind.phrases:
        shares = ", ".join(f"{share.label} {share.share:.0%}" for share in phrase.shares[:5])
        lines.append(f'"{visible(phrase.phrase)}" may be: {shares or "nothing here"}')
    for goal in snapshot.mind.goals[:5]:
        lines.append(f"{goal.share:.0%} sure that the goal is: {'; '.join(goal.conditions)}")
    if not snapshot.mind.phrases and not snapshot.mind.goals:
        lines.append("The robot has nothing in mind: it waits for a command.")
    return lines


def promise_lines(snapshot: Snapshot) -> list[str]:
    """What the robot promises of its executions, where it does."""
    return [f"The robot {snapshot.mind.promise}."] if snapshot.mind.promise else []


def verb_lines(snapshot: Snapshot) -> list[str]:
    """The verbs and what each means most likely."""
    lines = [
        f"{verb.title}: {'; '.join(verb.meaning)} ({verb.hypotheses_held})"
        for verb in snapshot.mind.verbs
    ]
    return lines or ["The robot knows no verb yet."]


def _told(place: Thing) -> str:
    text = f"{place.label}{_conditions(place.marks)}"
    groups: dict[str, list[Thing]] = {}
    for thing in place.contents:
        groups.setdefault("with" if thing.part else thing.relation, []).append(thing)
    held = [f"{relation} it {_listed(things)}" for relation, things in groups.items()]
    return f"{text}: {'; '.join(held)}." if held else f"{text}."


def _listed(things: Sequence[Thing]) -> str:
    return ", ".join(_inline(thing) for thing in things)


def _inline(thing: Thing) -> str:
    inside = f" with {_listed(thing.contents)}" if thing.contents else ""
    sure = "" if thing.sure is None else f", {thing.sure:.0%} sure that it is there,"
    return f"{thing.label}{_conditions(thing.marks)}{sure}{inside}"


def _conditions(marks: Sequence[Mark]) -> str:
    words = [
        mark.word if mark.sure is None else f"{mark.word}: {mark.sure:.0%} sure" for mark in marks
    ]
    return f" ({', '.join(words)})" if words else ""

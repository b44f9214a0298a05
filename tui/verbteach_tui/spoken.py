"""The dialogue's lines as shown: the record's words, with actions and objects in the scene's."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from verbteach.dialogue import acts
from verbteach.verbs.space import FrameKey
from verbteach.world.fluents import FluentSyntaxError, Literal
from verbteach.world.plan import Action
from verbteach_sessions.history import Node
from verbteach_sessions.transcript import ROBOT, TEACHER, Line
from verbteach_tui.hypotheses import Vocabulary, title_of
from verbteach_tui.views.dialogue import CONSEQUENCE, DialogueLine
from verbteach_tui.views.wording import Wording
from verbteach_tui.watched import Watched

_TABLE = frozenset({acts.SelectHypo.name, acts.IncludeFluent.name})
"""Acts of the paper's Table 2 that are no questions, whose names are shown all the same."""

_SEEN_STEPS = frozenset({acts.ObserveStep.name, acts.ReviseSteps.name})


class Sayings:
    """Words what was said; each line in the words of the scene that it was said in.

    ``wording`` gives a scene's words, ``outcome`` what came of a turn's answer.
    """

    def __init__(
        self,
        wording: Callable[[str], Wording],
        outcome: Callable[[Watched, Node], str] = lambda session, turn: "",
    ) -> None:
        self._wording, self._outcome = wording, outcome
        self._known: dict[tuple[str, Line], DialogueLine] = {}
        self._outcomes: dict[int, str] = {}

    def lines_of(self, session: Watched) -> tuple[DialogueLine, ...]:
        """What was said and still holds, each answer with what it came to.

        While something is shown, what the robot saw stands only after the last
        step: it repeats the whole change so far each time.
        """
        lines, turns = session.transcript(), session.turns()
        outcomes = {turn.seq: self.outcome(session, turn) for turn in turns}
        last = turns[-1].seq if turns else 0
        scene, shown = session.scene, list[DialogueLine]()
        for line in lines:
            if line.kind == acts.GoToScene.name:
                scene = line.text
            if line.speaker == ROBOT and (came := outcomes.pop(line.seq, "")):
                shown.append(DialogueLine(CONSEQUENCE, came))
            if line.kind not in _SEEN_STEPS or line.seq == last:
                shown.append(self._worded(scene, line))
        return tuple(shown)

    def outcome(self, session: Watched, turn: Node) -> str:
        """What came of the answer that ``turn`` replies to, in one line or none."""
        if turn.seq not in self._outcomes:
            self._outcomes[turn.seq] = self._outcome(session, turn)
        return self._outcomes[turn.seq]

    def _worded(self, scene: str, line: Line) -> DialogueLine:
        key = (scene, line)
        if key not in self._known:
            self._known[key] = _line(line, self._wording(scene))
        return self._known[key]


def _line(line: Line, wording: Wording) -> DialogueLine:
    if line.speaker == TEACHER:
        return DialogueLine(line.speaker, in_words(line.kind, line.text, wording))
    if line.speaker != ROBOT or (line.price is None and line.kind not in _TABLE):
        return DialogueLine(line.speaker, line.text)
    return DialogueLine(line.speaker, line.text, line.kind, price_text(line.price))


def price_text(price: tuple[float, float] | None) -> str:
    """As in: -1/-2: answered with yes and otherwise; one number where they are the same."""
    if price is None:
        return ""
    return "/".join(f"{value:g}".replace("-", "−") for value in dict.fromkeys(price))


def in_words(kind: str, text: str, wording: Wording) -> str:
    """What the teacher did, as the scene names it: "go to the kettle" for "moveto Kettle_1"."""
    try:
        return _TOLD[kind](text, wording) if kind in _TOLD else text
    except (ValueError, FluentSyntaxError):
        return text


def _inserted(text: str, wording: Wording) -> str:
    at, _, action = text.partition(" ")
    return f"insert as step {at}: {wording.action(Action.parse(action))}"


def _moved(text: str, wording: Wording) -> str:
    at, to = text.split()
    return f"step {at} comes at {to}"


def _removed(text: str, wording: Wording) -> str:
    first, dash, last = text.partition("-")
    return f"without steps {first} to {last}" if dash else f"without step {first}"


def _ruled_out(text: str, wording: Wording) -> str:
    title, fluent = _learned(text, wording)
    return f"{title} need not mean that {fluent}"


def _confirmed(text: str, wording: Wording) -> str:
    title, fluent = _learned(text, wording)
    return f"{title} means that {fluent}"


def _learned(text: str, wording: Wording) -> tuple[str, str]:
    """The verb frame and the fluent of a correction, in words."""
    if wording.domain is None:
        raise ValueError("these words know no domain")
    frame, _, rest = text.partition(" ")
    literal = Literal.parse(rest.partition(" of ")[0])
    words = Vocabulary(wording.domain, wording.lexicon)
    return title_of(FrameKey.parse(frame)), words.conditions((literal,))[0]


_TOLD: Mapping[str, Callable[[str, Wording], str]] = {
    acts.Do.name: lambda text, wording: wording.action(Action.parse(text)),
    acts.Insert.name: _inserted,
    acts.Remove.name: _removed,
    acts.Move.name: _moved,
    acts.Point.name: lambda text, wording: f"the {wording.labels[text]}",
    acts.Strike.name: lambda text, wording: f"strike: {wording.holds(Literal.parse(text))}",
    acts.Keep.name: lambda text, wording: f"keep: {wording.holds(Literal.parse(text))}",
    acts.RuleOut.name: _ruled_out,
    acts.Confirm.name: _confirmed,
    acts.GoToScene.name: lambda text, wording: f"go to {text}",
}

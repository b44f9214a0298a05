"""The plain mode's conversation: a line comes in, lines come out; nothing is read or printed here.

It speaks to the same session with the same acts as the app. Numbers pick from
the choices that were printed last.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from verbteach.dialogue import acts
from verbteach.dialogue.moves import Phase
from verbteach.world.plan import Action
from verbteach_sessions.script import LineSyntaxError, ScriptAct
from verbteach_sessions.session import Session
from verbteach_sessions.session_acts import Flag, Note, Quit, Redo, Repeat, Undo, Why
from verbteach_tui import plain_words
from verbteach_tui.observer import Observer
from verbteach_tui.reading import lines_of, without_slash
from verbteach_tui.snapshot import Snapshot
from verbteach_tui.spoken import price_text
from verbteach_tui.teaching import REFUSALS
from verbteach_tui.views.dialogue import SPEAKERS
from verbteach_tui.views.steps import Choice
from verbteach_tui.views.visible import visible


class MisfitError(ValueError):
    """A line that does not fit what the robot waits for; the message says why."""


@dataclass(frozen=True)
class _Picking:
    """A step being picked by numbers: the action, the objects so far, and what is offered."""

    offered: tuple[Choice, ...]
    name: str = ""
    chosen: tuple[str, ...] = ()


class Talk:
    """A conversation in lines with one session."""

    def __init__(self, session: Session) -> None:
        self._session = session
        self._observer = Observer(session)
        self._snapshot = self._observer.look()
        self._picking: _Picking | None = None

    @property
    def snapshot(self) -> Snapshot:
        """What holds now."""
        return self._snapshot

    @property
    def ended(self) -> bool:
        """Whether the person has left."""
        return self._session.ended

    def opening(self) -> list[str]:
        """What stands at the beginning."""
        promised = [
            f"{SPEAKERS['note']}: {line}" for line in plain_words.promise_lines(self._snapshot)
        ]
        return [*promised, *self._robot(self._session.said)]

    def complete(self, text: str) -> list[str]:
        """What ``text`` may become: steps while something is shown."""
        if self._snapshot.phase is not Phase.DEMONSTRATION:
            return []
        return self._snapshot.menu.completions(text)

    def hear(self, line: str, via: str) -> list[str]:
        """Take a line the person said; answer with the lines to print. Raises ``MisfitError``."""
        phase = self._snapshot.phase
        first, *more = lines_of(line, phase)
        heard = self._hear(first, via)
        for rest in more:
            if self._snapshot.phase is phase and not self._snapshot.problem:
                heard = [*heard, *self._hear(rest, via)]
        return heard

    def _hear(self, line: str, via: str) -> list[str]:
        text = line.strip()
        local = self._local(without_slash(text))
        if local is not None:
            return local
        try:
            act = self._picked(self._number_of(text)) or self._snapshot.reader.read(line)
        except LineSyntaxError as error:
            raise MisfitError(str(error)) from error
        if isinstance(act, _Picking):
            return self._offer(act)
        return [] if act is None else self.say(act, text, via)

    def say(self, act: ScriptAct, raw: str, via: str) -> list[str]:
        """Say ``act`` to the robot. Raises ``MisfitError``; nothing has changed then."""
        try:
            self._session.perform(act, raw=raw, via=via)
        except REFUSALS as error:
            raise MisfitError(str(error.args[0] if error.args else error)) from error
        self._picking = None
        self._snapshot = self._observer.look()
        return self._heard(act)

    def _heard(self, act: ScriptAct) -> list[str]:
        note = _NOTES.get(type(act), "")
        lines = [f"{SPEAKERS['note']}: {note}"] if note else []
        if isinstance(act, Flag | Note | Quit):
            return lines
        if not isinstance(act, Undo | Redo | Why | Repeat):
            came = self._snapshot.consequence
            lines += [f"{SPEAKERS['robot']}: {visible(came)}"] if came else []
            lines += self._execution()
        return lines + self._robot(self._session.said)

    def _execution(self) -> list[str]:
        """The steps of an execution, numbered, so that one can be named."""
        steps = self._snapshot.steps
        if not steps:
            return []
        failure = [f"The robot {self._snapshot.failure}."] if self._snapshot.failure else []
        return ["The robot does:", *plain_words.numbered(steps), *failure]

    def _robot(self, said: tuple[str, ...]) -> list[str]:
        lines = [f"{SPEAKERS['robot']}: {visible(text)}" for text in said]
        price = self._price()
        if price and said == self._session.turn.texts:
            lines[-1] += f" ({price})"
        return [*lines, *plain_words.hint(self._snapshot)]

    def _price(self) -> str:
        """What the question that waits costs."""
        rewards = self._session.header.method.parameters.rewards
        act = self._snapshot.waiting
        if not isinstance(act, acts.QUESTIONS):
            return ""
        return f"price {price_text(rewards.prices.get(act.name))}"

    # ---- words of the plain mode itself

    def _local(self, text: str) -> list[str] | None:
        asked = text == "?" and self._snapshot.phase not in (Phase.EXECUTION, Phase.LEARNING)
        answer = _LOCAL.get("help" if asked else text.lower())
        return None if answer is None else answer(self)

    def _help(self) -> list[str]:
        return plain_words.help_lines(self._snapshot)

    def _look(self) -> list[str]:
        snapshot = self._snapshot
        return plain_words.look_lines(snapshot.depictor.picture(snapshot.moment.state))

    def _seen(self) -> list[str]:
        believed = self._snapshot.believed
        if believed is None:
            raise MisfitError("the robot looks around when it gets a command")
        return plain_words.look_lines(believed)

    def _shown(self) -> list[str]:
        if self._snapshot.phase is not Phase.DEMONSTRATION:
            raise MisfitError(_NOT_SHOWING)
        return plain_words.shown_lines(self._snapshot)

    def _mind(self) -> list[str]:
        return plain_words.mind_lines(self._snapshot)

    def _verbs(self) -> list[str]:
        return plain_words.verb_lines(self._snapshot)

    def _steps(self) -> list[str]:
        if self._snapshot.phase is not Phase.DEMONSTRATION:
            raise MisfitError(_NOT_SHOWING)
        return self._offer(_Picking(self._snapshot.menu.names))

    # ---- numbers

    def _offer(self, picking: _Picking) -> list[str]:
        self._picking = picking
        menu = self._snapshot.menu
        head = [f"{menu.prompt(picking.name, picking.chosen)}:"] if picking.name else []
        possible = [choice.label for choice in picking.offered if choice.possible]
        rest = len(picking.offered) - len(possible)
        others = [f"And {rest} that cannot be done now; type one to hear why."] if rest else []
        return [*head, *plain_words.numbered(possible), *others]

    def _number_of(self, text: str) -> str:
        """The number of the object that was offered for a step and is called by its name."""
        if self._picking is None or not self._picking.name:
            return text
        name = text.lower().removeprefix("the ").rstrip(".!")
        offered = enumerate(self._picking.offered, 1)
        named = [number for number, choice in offered if name in (choice.label, choice.id.lower())]
        return str(named[0]) if len(named) == 1 else text

    def _picked(self, text: str) -> ScriptAct | _Picking | None:
        if not text.isdecimal():
            return None
        snapshot, number = self._snapshot, int(text[:9])
        if snapshot.phase is Phase.READ_BACK:
            if not 1 <= number <= len(snapshot.parts):
                raise MisfitError(f"there is no part {number}")
            part = snapshot.parts[number - 1]
            return acts.Strike(part.literal) if part.kept else acts.Keep(part.literal)
        if self._picking is None:
            if snapshot.choices and text not in snapshot.choices:
                raise MisfitError(f"there is no choice {number}")
            return snapshot.reader.read(text)
        if not 1 <= number <= len(self._picking.offered):
            raise MisfitError(f"there is no choice {number}")
        return self._chosen(self._picking, self._picking.offered[number - 1])

    def _chosen(self, picking: _Picking, choice: Choice) -> ScriptAct | _Picking:
        name = picking.name or choice.id
        chosen = (*picking.chosen, choice.id) if picking.name else ()
        offered = self._snapshot.menu.objects(name, chosen)
        return _Picking(offered, name, chosen) if offered else acts.Do(Action(name, chosen))


_NOT_SHOWING = "there are steps only while you show the robot something; it asks you when"

_NOTES: Mapping[type[ScriptAct], str] = {
    Flag: "flagged.",
    Note: "kept.",
    Quit: "you can go on with this session later.",
    Undo: "taken back.",
    Redo: "done again.",
}

_LOCAL: Mapping[str, Callable[[Talk], list[str]]] = {
    "help": lambda talk: talk._help(),
    "look": Talk._look,
    "seen": Talk._seen,
    "shown": Talk._shown,
    "mind": Talk._mind,
    "verbs": Talk._verbs,
    "steps": Talk._steps,
}

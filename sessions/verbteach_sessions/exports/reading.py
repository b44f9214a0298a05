"""From a record to a dialogue. Nothing is recomputed: what was recorded is what is exported."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

from verbteach.dialogue.codec import teacher_act_from_json
from verbteach_sessions import events as kinds
from verbteach_sessions.account import Account
from verbteach_sessions.errors import LogError, NotASessionError
from verbteach_sessions.exports.alias import alias, encodable, timeless
from verbteach_sessions.exports.dialogue import ROBOT, TEACHER, Dialogue, Price, Turn
from verbteach_sessions.history import Node
from verbteach_sessions.lines import Event
from verbteach_sessions.script import spoken

Redact = Callable[[Any], Any]
"""Replaces what must not leave the folder in a JSON value; everything else stays."""

_BESIDE = (kinds.FLAGGED, kinds.NOTE, kinds.WHY, kinds.REPEAT, kinds.UNDO, kinds.REDO)


def nothing(value: Any) -> Any:
    """Redacts nothing."""
    return value


def read_dialogue(path: Path, redact: Redact = nothing) -> Dialogue:
    """The dialogue of the session at ``path``, a folder or a log. Raises the errors of reading.

    A teacher's act without a reply (the robot failed on it, or the record ends
    there) does not count and is left out.
    """
    account, turns = Account(path), _Turns(lambda value: redact(encodable(value)))
    reader, history = account.reader, account.history
    last = 0.0
    for event in account:
        with account.at(event):
            turns.take(event, history.current)
        last = event.at
    header = history.header
    if header is None or history.current is None:
        raise NotASessionError(f"{reader.path}: nothing was said in this session")
    standing = {node.seq for node in history.effective()}
    try:
        described = _described(redact(timeless(encodable(header.data))), history.current)
    except ValueError as error:
        raise LogError(reader.path, 1, str(error)) from error
    return replace(
        described,
        content_hash=account.content.hexdigest,
        ended=history.ended,
        questionnaires=turns.questionnaires,
        seconds=last,
        turns=tuple(turns.finished(standing)),
        warnings=reader.warnings,
    )


def _described(header: Mapping[str, Any], current: Node) -> Dialogue:
    policy = header["policy"]
    source, parent = header["source"], header.get("parent")
    return Dialogue(
        id=alias(header["id"]),
        participant=header["participant"],
        teacher=header["teacher"],
        interface=header["interface"],
        scene=header["scene"],
        policy=str(policy.get("name")),
        seed=header["seed"],
        noise=header["noise"],
        method={"policy": policy, "parameters": header["parameters"]},
        software={**header["software"], "python": header["python"]},
        study=header["study"],
        source=None if source is None else alias(source["id"]),
        parent=None if parent is None else (alias(parent["id"]), parent["seq"]),
        content_hash="",
        ended=False,
        seconds=0.0,
        totals=dict(current.after["totals"]),
        verbs_learned=tuple(current.after["verbs_learned"]),
        prices=_prices(header["parameters"]),
        turns=(),
    )


def _prices(parameters: Mapping[str, Any]) -> dict[str, Price]:
    """The table of prices; a record of another make may have none."""
    rewards = parameters.get("rewards")
    prices = rewards.get("prices") if isinstance(rewards, Mapping) else None
    pairs = prices.items() if isinstance(prices, Mapping) else ()
    return {name: (pair[0], pair[1]) for name, pair in pairs if _is_price(pair)}


def _is_price(pair: Any) -> bool:
    return isinstance(pair, list) and len(pair) == 2 and all(type(p) in (int, float) for p in pair)


class _Turns:
    """Grows with the events. Commands are counted as they are given, taken back or not."""

    def __init__(self, redact: Redact) -> None:
        self._redact = redact
        self._turns: list[tuple[Turn, int]] = []  # with the robot event that it stands or falls by
        self._screens: dict[int, Turn] = {}  # the robot's turns by their events
        self._commands = 0
        self.questionnaires: dict[str, Mapping[str, Any]] = {}

    def take(self, event: Event, current: Node | None) -> None:
        """Add an event that the history has just taken; ``current`` is the turn that now holds."""
        if event.type == kinds.ROBOT and current is not None:
            self._take_reply(event, current)
        elif event.type in _BESIDE:
            self._take_beside(event)
        elif event.type == kinds.QUESTIONNAIRE:
            data = self._redact(event.data)
            self.questionnaires[data["name"]] = data["answers"]

    def finished(self, standing: set[int]) -> Iterator[Turn]:
        """The turns in order, each told whether it still holds."""
        for turn, root in self._turns:
            yield replace(turn, holds=root in standing or turn.kind in _BESIDE)

    def _take_reply(self, event: Event, node: Node) -> None:
        data = self._redact({**event.data, "record": node.record})
        command, replied = self._take_teacher(node)
        turn = Turn(
            number=len(self._turns),
            seq=event.seq,
            reply_to=replied,
            speaker=ROBOT,
            kind=kinds.ROBOT,
            at=event.at,
            texts=tuple(data["texts"]),
            phase=data["phase"],
            scene=data["after"]["scene"],
            command=command,
            acts=tuple(data["acts"]),
            reading=data["reading"],
            reward=data["reward"],
            decisions=tuple(data["decisions"]),
            beliefs=data["beliefs"],
            trace=data["trace"],
            learned=data["record"],
            world=data["after"]["world"],
            verbs_learned=tuple(data["after"]["verbs_learned"]),
        )
        self._screens[event.seq] = turn
        self._turns.append((turn, node.seq))

    def _take_teacher(self, node: Node) -> tuple[int | None, int | None]:
        """Add the act that a robot's turn replies to; the command it is part of, and its number."""
        event = node.teacher
        if event is None:
            return None, None
        data = self._redact(event.data)
        said = self._redact(spoken(teacher_act_from_json(event.data["act"])))
        turn = replace(self._person(event, data), acts=(data["act"],), texts=(said,))
        name = turn.act_names[0]
        if name == "command":
            turn = replace(turn, command=self._commands)
            self._commands += 1
        elif name == "scene":
            turn = replace(turn, command=None)
        self._turns.append((turn, node.seq))
        return turn.command, turn.number

    def _take_beside(self, event: Event) -> None:
        data = self._redact(event.data)
        root = event.data["reply_to"]
        said = (data["text"],) if "text" in data else (event.type,)
        turn = replace(self._person(event, data), texts=said)
        self._turns.append((turn, root))
        if "texts" in data:
            answer = replace(turn, number=turn.number + 1, reply_to=turn.number, speaker=ROBOT)
            texts = tuple(data["texts"])
            answer = replace(answer, texts=texts, raw="", via="", answer_seconds=None)
            self._turns.append((answer, root))

    def _person(self, event: Event, data: Mapping[str, Any]) -> Turn:
        """What a person's event says for itself and by the turn that was on the screen."""
        screen = self._screens[event.data["reply_to"]]
        shown, answered = data["shown_at"], data["answered_at"]
        return Turn(
            number=len(self._turns),
            seq=event.seq,
            reply_to=screen.number,
            speaker=TEACHER,
            kind=event.type,
            at=event.at,
            texts=(),
            phase=screen.phase,
            scene=screen.scene,
            command=screen.command,
            raw=data["raw"],
            via=data["via"],
            answer_seconds=None if shown is None else max(0.0, answered - shown),
            world=screen.world,
            verbs_learned=screen.verbs_learned,
        )

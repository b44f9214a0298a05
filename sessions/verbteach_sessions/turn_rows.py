"""A session's turns as rows of plain JSON, so that their order need not be read from the log."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

from verbteach_sessions.history import History, Node, Remark
from verbteach_sessions.lines import Event, LineError
from verbteach_sessions.past_lines import PastLines, PastRecord


class RowsFormatError(ValueError):
    """The rows are not those of a session's turns."""


class Turn(NamedTuple):
    """A robot turn, and the number of the ``learned`` event written with it, if there is one."""

    node: Node
    learned: int | None


class Rows:
    """Turns and remarks so far, in the order of their events; grows by :meth:`extend`.

    What was learned stays in the log: it is looked up when it is asked for.
    """

    def __init__(self) -> None:
        self.turns: list[Turn] = []
        self._rows: list[Any] = []
        self._remarks: list[Any] = []
        self._verbs: list[list[str]] = []
        self._numbers: dict[tuple[str, ...], int] = {}
        self._standing: Mapping[str, Any] = {}

    def since(self, history: History, turns: Sequence[Turn]) -> dict[str, Any]:
        """What ``history`` holds beyond these rows, which it then no longer does."""
        verbs = len(self._verbs)
        more = turns[len(self.turns) :]
        rows = [self._row(turn) for turn in more]
        remarks = [
            [one.seq, one.node.seq, one.type, list(one.texts)]
            for one in history.remarks[len(self._remarks) :]
        ]
        self.turns += more
        self._remarks += remarks
        return {
            "turns": rows,
            "remarks": remarks,
            "verbs": self._verbs[verbs:],
            "current": history.current.seq if history.current else None,
            "redoable": [node.seq for node in history.redoable],
            "ended": history.ended,
        }

    def extend(self, data: Mapping[str, Any]) -> None:
        """Take rows as :meth:`since` gave them; nothing is looked at yet."""
        self._rows += data["turns"]
        self._remarks += data["remarks"]
        for verbs in data["verbs"]:
            self._number(verbs)
        self._standing = data

    def history(self, lines: PastLines) -> History:
        """The history that the rows come from. Raises :class:`RowsFormatError`."""
        try:
            return self._history(lines)
        except (LookupError, TypeError, ValueError, LineError) as error:
            raise RowsFormatError(f"not a session's turns: {error!r}"[:200]) from error

    def _history(self, lines: PastLines) -> History:
        nodes: dict[int, Node] = {}
        self.turns = []
        for row in self._rows:
            turn = self._turn(row, nodes, lines)
            nodes[turn.node.seq] = turn.node
            self.turns.append(turn)
        self._rows = []
        history = History()
        history.header, history.last = lines.event(0), lines.event(lines.last)
        history.current = nodes[self._standing["current"]]
        history.redoable = [nodes[seq] for seq in self._standing["redoable"]]
        history.ended = self._standing["ended"]
        history.remarks = [
            Remark(seq, nodes[beside], kind, tuple(texts))
            for seq, beside, kind, texts in self._remarks
        ]
        return history

    def _row(self, turn: Turn) -> list[Any]:
        node = turn.node
        teacher = node.teacher and [node.teacher.seq, node.teacher.at, node.teacher.data]
        after = {**node.after, "verbs_learned": self._number(node.after["verbs_learned"])}
        parent = None if node.parent is None else node.parent.seq
        kept = [node.acts, node.texts, node.phase, after]
        return [node.seq, parent, node.root, teacher, turn.learned, *kept]

    def _turn(self, row: Sequence[Any], nodes: Mapping[int, Node], lines: PastLines) -> Turn:
        seq, parent, root, teacher, learned, acts, texts, phase, after = row
        after["verbs_learned"] = self._verbs[after["verbs_learned"]]
        node = Node(
            seq=seq,
            parent=None if parent is None else nodes[parent],
            root=root,
            teacher=None if teacher is None else Event(teacher[0], "teacher", *teacher[1:]),
            record=None if learned is None else PastRecord(lines, learned),
            acts=tuple(acts),
            texts=tuple(texts),
            phase=phase,
            after=after,
        )
        return Turn(node, learned)

    def _number(self, verbs: Sequence[str]) -> int:
        key = tuple(verbs)
        if key not in self._numbers:
            self._numbers[key] = len(self._verbs)
            self._verbs.append(list(verbs))
        return self._numbers[key]

"""Figures of a corpus: turns, questions and their prices, answering times, words, agreement."""

from __future__ import annotations

import re
from collections import Counter, defaultdict
from collections.abc import Iterable, Mapping, Sequence
from itertools import groupby
from statistics import fmean, median
from typing import Any

from verbteach_sessions.corpus.agreement import Agreement
from verbteach_sessions.exports.dialogue import ROBOT, TEACHER, Dialogue, Turn

_WORD = re.compile(r"[^\W_]+(?:['-][^\W_]+)*")
_PROSE = frozenset({"command", "say"})


def words(text: str) -> int:
    """How many words a text has."""
    return len(_WORD.findall(text))


class Stats:
    """Grows by one dialogue after the other. Counted is what held in the end."""

    def __init__(self) -> None:
        self._sessions: Counter[str] = Counter()
        self._turns: Counter[str] = Counter()
        self._commands = 0
        self._seconds = 0.0
        self._questions: dict[str, _Question] = defaultdict(_Question)
        self._answers: list[float] = []
        self._words: dict[str, list[int]] = defaultdict(list)
        self._agreement = Agreement()
        self._people: dict[str, _Person] = defaultdict(_Person)

    def add(self, dialogue: Dialogue) -> None:
        """Count one dialogue more."""
        held = dialogue.held
        self._sessions[dialogue.teacher] += 1
        self._turns.update(turn.speaker for turn in held)
        self._commands += len({turn.command for turn in held if turn.command is not None})
        self._seconds += dialogue.seconds
        self._add_questions(held)
        self._add_words(held)
        self._agreement.add(dialogue)
        if dialogue.participant is not None:
            self._people[dialogue.participant].add(dialogue)

    def _add_questions(self, held: Sequence[Turn]) -> None:
        """A question, its answer and what that cost are three turns in a row."""
        for before, turn, after in zip(held, held[1:], (*held[2:], None), strict=False):
            if before.speaker != ROBOT or turn.speaker != TEACHER:
                continue
            if turn.answer_seconds is not None:
                self._answers.append(turn.answer_seconds)
            if before.question is not None:
                self._questions[before.question].add(turn, after)

    def _add_words(self, held: Sequence[Turn]) -> None:
        for command, group in groupby(held, key=lambda turn: turn.command):
            turns = list(group)
            learned = [str(act["verb"]) for t in turns for act in t.acts if _is_lesson(act)]
            said = sum(words(t.text) for t in turns if _is_prose(t))
            if command is not None and learned:
                self._words[learned[-1]].append(said)

    def to_json(self) -> dict[str, Any]:
        """What ``sessions stats --json`` prints."""
        taught = [count for counts in self._words.values() for count in counts]
        asked = sum(question.count for question in self._questions.values())
        return {
            "sessions": sum(self._sessions.values()),
            "teachers": _sorted(self._sessions),
            "participants": len(self._people),
            "turns": {"robot": self._turns[ROBOT], "teacher": self._turns[TEACHER]},
            "commands": self._commands,
            "seconds": round(self._seconds, 3),
            "questions": {
                "count": asked,
                "price": round(sum(q.price for q in self._questions.values()), 6),
                "by_type": {n: self._questions[n].to_json() for n in sorted(self._questions)},
            },
            "seconds_per_answer": spread(self._answers),
            "words_per_learned_verb": {
                **spread(taught),
                "verbs": {verb: spread(self._words[verb]) for verb in sorted(self._words)},
            },
            "agreement": self._agreement.to_json(),
            "per_participant": {c: self._people[c].to_json() for c in sorted(self._people)},
        }


class _Question:
    """All questions of one type."""

    def __init__(self) -> None:
        self.count = 0
        self.price = 0.0
        self._answers: Counter[str] = Counter()
        self._seconds: list[float] = []

    def add(self, answer: Turn, after: Turn | None) -> None:
        self.count += 1
        self._answers[answer.act_names[0]] += 1
        if after is not None and after.reward is not None:
            self.price += after.reward
        if answer.answer_seconds is not None:
            self._seconds.append(answer.answer_seconds)

    def to_json(self) -> dict[str, Any]:
        return {
            "count": self.count,
            "price": round(self.price, 6),
            "answers": _sorted(self._answers),
            "seconds": spread(self._seconds),
        }


class _Person:
    """All sessions of one participant."""

    def __init__(self) -> None:
        self._count: Counter[str] = Counter()
        self._reward = self._seconds = 0.0
        self._verbs: set[str] = set()
        self._answers: list[float] = []

    def add(self, dialogue: Dialogue) -> None:
        held = dialogue.held
        own = [turn for turn in held if turn.speaker == TEACHER]
        self._count["sessions"] += 1
        self._count["turns"] += len(held)
        self._count["questions"] += sum(turn.question is not None for turn in held)
        self._count["words"] += sum(words(turn.text) for turn in own if _is_prose(turn))
        self._reward += sum(turn.reward or 0.0 for turn in held)
        self._seconds += dialogue.seconds
        self._answers += [t.answer_seconds for t in own if t.answer_seconds is not None]
        lessons = (act for turn in held for act in turn.acts if _is_lesson(act))
        self._verbs |= {str(act["verb"]) for act in lessons}

    def to_json(self) -> dict[str, Any]:
        counts = {name: self._count[name] for name in ("sessions", "turns", "questions", "words")}
        return {
            **counts,
            "reward": round(self._reward, 6),
            "seconds": round(self._seconds, 3),
            "seconds_per_answer": spread(self._answers),
            "verbs_taught": sorted(self._verbs),
        }


def spread(values: Iterable[float]) -> dict[str, Any]:
    """How many values there are, their mean and their median; ``None`` where there are none."""
    known = [float(value) for value in values]
    if not known:
        return {"count": 0, "mean": None, "median": None}
    return {"count": len(known), "mean": round(fmean(known), 4), "median": round(median(known), 4)}


def _is_lesson(act: Mapping[str, Any]) -> bool:
    return act.get("act") == "learned" and "verb" in act


def _is_prose(turn: Turn) -> bool:
    return turn.speaker == TEACHER and turn.act_names[0] in _PROSE


def _sorted(counts: Counter[str]) -> dict[str, int]:
    return {name: counts[name] for name in sorted(counts)}

"""The closing questionnaire: the scales of the NASA Task Load Index, and questions of one's own.

The six scales are those of Hart and Staveland (1988), rated raw: 0 to 100 in steps
of 5, without the weighting by pairs. The wording of the questions is this
project's own.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, NamedTuple

STEP, MOST = 5, 100
LONGEST = 4000
"""Characters of a free answer that are kept."""

END, EACH = "end", "each"
WHEN = (END, EACH)
"""After everything, or after each part (and then not again at the end)."""


class Scale(NamedTuple):
    """One scale: its name in the record, its title, the question, and its two ends."""

    id: str
    title: str
    text: str
    low: str
    high: str


NASA_TLX = (
    Scale("mental_demand", "Mental demand",
          "How much thinking, deciding and remembering did the teaching take?", "low", "high"),
    Scale("physical_demand", "Physical demand",
          "How much physical effort was it, such as typing and clicking?", "low", "high"),
    Scale("temporal_demand", "Temporal demand",
          "How hurried did you feel by the pace of the task?", "low", "high"),
    Scale("performance", "Performance",
          "How well did you succeed in teaching what you were asked to?", "perfect", "failure"),
    Scale("effort", "Effort",
          "How hard did you have to work to get as far as you did?", "low", "high"),
    Scale("frustration", "Frustration",
          "How irritated, discouraged or annoyed were you?", "low", "high"),
)  # fmt: skip


class Question(NamedTuple):
    """A question that is answered in free words."""

    id: str
    text: str


@dataclass(frozen=True)
class Questionnaire:
    """What is asked, and when; ``asks`` nothing where it is empty."""

    when: str = END
    nasa_tlx: bool = True
    questions: tuple[Question, ...] = (Question("comment", "Is there anything you want to add?"),)

    @property
    def scales(self) -> tuple[Scale, ...]:
        """The scales to rate."""
        return NASA_TLX if self.nasa_tlx else ()

    @property
    def asks(self) -> bool:
        """Whether there is anything to answer."""
        return bool(self.scales or self.questions)

    def checked(self, answers: Mapping[str, Any]) -> dict[str, int | str | None]:
        """The answers in the questionnaire's order, one that was not given as ``None``.

        Raises ``ValueError`` for a rating that is none, and for an answer to nothing.
        """
        names = {*(scale.id for scale in self.scales), *(one.id for one in self.questions)}
        if unknown := sorted(answers.keys() - names):
            raise ValueError(f"nothing is asked by the name {unknown[0]!r}")
        rated = {scale.id: _rating(scale.id, answers.get(scale.id)) for scale in self.scales}
        told = {one.id: _text(answers.get(one.id)) for one in self.questions}
        return {**rated, **told}


def read_rating(text: str) -> int:
    """A rating as it is typed, 0 to 100, taken to the next step. Raises ``ValueError``."""
    bare = text.strip()
    if not (bare.isascii() and bare.isdigit()) or len(bare) > 3 or int(bare) > MOST:
        raise ValueError(f"a number from 0 to {MOST} is needed")
    return (int(bare) + STEP // 2) // STEP * STEP


def _rating(name: str, value: Any) -> int | None:
    if value is None:
        return None
    if type(value) is not int or not 0 <= value <= MOST or value % STEP:
        raise ValueError(f"{name}: a rating is 0 to {MOST} in steps of {STEP}, not {value!r}")
    return value


def _text(value: Any) -> str | None:
    text = str(value).strip()[:LONGEST] if value is not None else ""
    return text or None

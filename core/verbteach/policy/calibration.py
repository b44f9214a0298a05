"""What a file of weights knows for promises: how commands went that nothing was trained on.

Whole courses are kept (``courses.py``), so that any rate can be promised later;
each policy at each noise level has its own, since a promise holds for the
procedure that was calibrated and no other.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from verbteach.dialogue.promise import Promise, Sureness
from verbteach.policy.courses import Course
from verbteach.policy.stopping import cut_for


class UncalibratedError(ValueError):
    """Nothing is known for promises of this kind; the message says what there is."""


@dataclass(frozen=True)
class Calibration:
    """The courses of commands in ``environments``, asked about by ``policy`` with such eyes."""

    policy: str
    noise: str
    reading: str
    environments: tuple[str, ...]
    courses: tuple[Course, ...]

    @property
    def kind(self) -> str:
        """Which procedure it is for, in words."""
        return f"{self.policy} at {self.noise} ({self.reading})"

    def to_json(self) -> dict[str, Any]:
        """Plain JSON; the courses by rows."""
        courses = [course.to_json() for course in self.courses]
        return {**vars(self), "environments": list(self.environments), "courses": courses}

    @classmethod
    def from_json(cls, data: Mapping[str, Any]) -> Calibration:
        """Read what :meth:`to_json` wrote. Raises ``ValueError``."""
        try:
            return cls(
                str(data["policy"]),
                str(data["noise"]),
                str(data["reading"]),
                tuple(map(str, data["environments"])),
                tuple(Course.from_json(rows) for rows in data["courses"]),
            )
        except (KeyError, TypeError) as error:
            raise ValueError(f"no calibration: {error!r}") from error


@dataclass(frozen=True)
class Calibrations:
    """All calibrations of one set of weights, with the sureness that they are about."""

    sureness: Sureness
    each: tuple[Calibration, ...]

    def promise(self, rate: float, policy: str, noise: str, reading: str) -> Promise:
        """The promise that ``rate`` of what is carried out is right.

        Raises ``UncalibratedError`` for a procedure without a calibration,
        ``UnkeepablePromiseError`` where its calibration does not support that much.
        """
        wanted = Calibration(policy, noise, reading, (), ())
        found = [one for one in self.each if one.kind == wanted.kind]
        if not found:
            there = ", ".join(one.kind for one in self.each) or "nothing"
            raise UncalibratedError(f"nothing is calibrated for {wanted.kind}; there is {there}")
        cut = cut_for(found[0].courses, rate)
        return Promise(rate, cut.sure, cut.lessons, self.sureness)

    def to_json(self) -> dict[str, Any]:
        """Plain JSON."""
        each = [one.to_json() for one in self.each]
        return {"sureness": dict(self.sureness.weights), "calibrations": each}

    @classmethod
    def from_json(cls, data: Mapping[str, Any], features: Sequence[str]) -> Calibrations:
        """Read what :meth:`to_json` wrote, for these features. Raises ``ValueError``."""
        weights = data.get("sureness")
        if not isinstance(weights, Mapping) or sorted(weights) != sorted(features):
            raise ValueError("how sure the robot is, is for other features")
        sureness = Sureness({name: float(weights[name]) for name in features})
        return cls(sureness, tuple(map(Calibration.from_json, data.get("calibrations", ()))))

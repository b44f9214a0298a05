"""Whether a policy meets people and simulator alike: differences are found where there are any."""

from __future__ import annotations

import numpy as np
import pytest

from verbteach_sessions.people.meeting import Met, compare


def met(side: str, rng: np.random.Generator, questions: float, other: float = 0.0) -> list[Met]:
    """Ten people with six commands each."""
    found = []
    for person in range(10):
        own = rng.gamma(4.0, questions / 4.0)
        for _ in range(6):
            asked = int(rng.poisson(own))
            kinds = rng.binomial(asked, other)
            counts = {"goal_pred_ynq": asked - int(kinds), "np_grd_ynq": int(kinds)}
            success = bool(rng.random() < 0.5)
            earned = 100.0 * success - 1.5 * asked
            found.append(Met(f"{side}{person}", counts, 3 + asked, earned, success))
    return found


def test_the_same_people_are_met_alike_nearly_always() -> None:
    alike = sum(
        compare(met("a", rng(n), 2.0), met("b", rng(100 + n), 2.0), rng(n)).alike for n in range(12)
    )
    assert alike >= 10


def test_twice_as_many_questions_are_found() -> None:
    found = compare(met("a", rng(1), 1.0), met("b", rng(2), 4.0), rng(0))
    assert not found.alike
    one = found.statistics["questions"]
    assert one.p < 0.05
    assert one.difference[1] < 0.0
    assert found.statistics["success"].p > 0.05


def test_other_kinds_of_questions_are_found_though_there_are_as_many() -> None:
    found = compare(met("a", rng(1), 2.0), met("b", rng(1), 2.0, other=0.6), rng(0))
    assert found.types_p < 0.05
    assert found.statistics["questions"].p > 0.5


def test_people_are_permuted_and_not_their_commands() -> None:
    """Two talkative people on one side are no evidence, however many commands they gave."""
    quiet = [Met(f"q{n % 2}", {}, 3, 0.0, False) for n in range(60)]
    loud = [Met(f"l{n % 2}", {"np_grd_ynq": 5}, 9, 0.0, False) for n in range(60)]
    assert compare(quiet, loud, rng(0)).statistics["questions"].p > 0.3


def test_a_side_of_one_person_cannot_be_compared() -> None:
    with pytest.raises(ValueError, match="two persons"):
        compare([Met("a", {}, 1, 0.0, True)], met("b", rng(0), 1.0), rng(0))


def rng(seed: int) -> np.random.Generator:
    return np.random.default_rng(seed)

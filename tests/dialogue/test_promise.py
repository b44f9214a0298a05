"""A robot held to a promise carries out only what it is sure enough of."""

from __future__ import annotations

import pytest

from verbteach.dialogue.acts import DemonstrationReason, NpGrdWhq, RequestDemonstration, SelectHypo
from verbteach.dialogue.decision import Candidate
from verbteach.dialogue.promise import Promise, Sureness, held_to

SURENESS = Sureness({"select_hypo": -2.0, "select_hypo.certainty": 4.0})


def acting(certainty: float) -> Candidate:
    features = {"select_hypo": 1.0, "select_hypo.certainty": certainty}
    return Candidate(SelectHypo(frozenset(), "", ()), features)


ASK = Candidate(NpGrdWhq("mug"), {})


def test_sureness_is_a_probability_that_rises_with_what_speaks_for_acting() -> None:
    sure = [SURENESS.of(acting(c).features) for c in (0.0, 0.5, 1.0)]
    assert sure == sorted(sure)
    assert sure[1] == 0.5
    assert SURENESS.now([ASK]) is None
    assert SURENESS.now([ASK, acting(0.5)]) == 0.5
    assert 0.0 < Sureness({"select_hypo": -1e9}).of({"select_hypo": 1.0}) < 1e-9


def test_where_it_is_not_sure_enough_being_shown_stands_for_acting() -> None:
    promise = Promise(0.8, 0.5, 60, SURENESS)
    sure, unsure = [ASK, acting(0.5)], [ASK, acting(0.49)]
    assert held_to(promise, sure) == sure
    shown = RequestDemonstration(DemonstrationReason.NOT_SURE)
    assert [one.act for one in held_to(promise, unsure)] == [ASK.act, shown]
    assert held_to(None, unsure) == unsure
    other = [Candidate(RequestDemonstration(DemonstrationReason.NO_HYPOTHESIS), {})]
    assert held_to(promise, other) == other


@pytest.mark.parametrize(
    ("rate", "sure", "lessons"), [(0.0, 0.5, 9), (1.0, 0.5, 9), (0.8, 1.1, 9), (0.8, 0.5, 0)]
)
def test_numbers_that_are_no_promise_are_refused(rate: float, sure: float, lessons: int) -> None:
    with pytest.raises(ValueError, match="not"):
        Promise(rate, sure, lessons, SURENESS)


def test_a_promise_is_told_in_one_line() -> None:
    assert Promise(0.8, 0.734, 214, SURENESS).text == (
        "acts when at least .73 sure: promised 80%, calibrated on 214 lessons"
    )

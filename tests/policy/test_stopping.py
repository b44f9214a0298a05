from __future__ import annotations

import math

import numpy as np
import pytest

from verbteach.dialogue.acts import NpGrdWhq, SelectHypo
from verbteach.dialogue.decision import Candidate
from verbteach.policy.fixed_rules import RandomPolicy
from verbteach.policy.stopping import Cut, PromisingPolicy, calibrate


@pytest.mark.parametrize("wanted", [0.6, 0.8, 0.9])
def test_the_promise_holds_on_average_over_exchangeable_commands(wanted: float) -> None:
    rng = np.random.default_rng(7)
    broken, executed = [], []
    for _ in range(400):
        scores = rng.random(61)
        right = rng.random(61) < scores**0.5
        cut = calibrate(scores[:60].tolist(), right[:60].tolist(), wanted)
        goes = scores[60] >= cut.certainty
        executed.append(goes)
        broken.append(goes and not right[60])
    assert np.mean(broken) <= 1 - wanted + 0.03
    assert np.mean(executed) > 0.1


def test_more_is_promised_by_doing_less() -> None:
    rng = np.random.default_rng(2)
    scores = rng.random(300)
    right = rng.random(300) < scores
    cuts = [calibrate(scores.tolist(), right.tolist(), w).certainty for w in (0.7, 0.9, 0.97)]
    assert cuts == sorted(cuts)


def test_too_few_commands_promise_nothing() -> None:
    assert calibrate([0.9, 0.8], [True, True], 0.9).certainty == math.inf
    with pytest.raises(ValueError, match="between 0 and 1"):
        calibrate([0.5], [True], 1.0)


def test_the_policy_asks_until_it_is_certain_enough() -> None:
    ask = Candidate(NpGrdWhq("mug"), {})
    policy = PromisingPolicy(RandomPolicy(), Cut(0.7, 0.8, 50))
    rng = np.random.default_rng(0)
    for certainty, asks in ((0.69, True), (0.7, False)):
        execute = Candidate(SelectHypo(frozenset(), "", ()), {"select_hypo.certainty": certainty})
        assert (policy.choose(None, [ask, execute], rng).act == ask.act) == asks
        assert policy.choose(None, [execute], rng).act == execute.act

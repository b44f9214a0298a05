from __future__ import annotations

import numpy as np
import pytest

from verbteach.dialogue.acts import (
    EnvPredYnq,
    GoalPredYnq,
    NpGrdWhq,
    NpGrdYnq,
    RobotAct,
    SelectHypo,
)
from verbteach.dialogue.decision import Candidate
from verbteach.policy.fixed_rules import ManualPolicy, RandomPolicy, SilentPolicy, SplitPolicy
from verbteach.policy.linear import FeatureSpace, LinearPolicy, Weights
from verbteach.world.fluents import Fluent, Literal

SPACE = FeatureSpace(("a", "b"))
RNG = np.random.default_rng(0)


def goal_question(name: str, doubt: float, asked: int = 0) -> Candidate:
    literal = Literal(Fluent("on", (name, "table")))
    features = {"goal_pred_ynq.doubt": doubt, "ask.asked": asked / 10.0}
    return Candidate(GoalPredYnq(literal), features)


EXECUTE = Candidate(SelectHypo(frozenset(), "", ()), {"select_hypo": 1.0})
MUG = Candidate(NpGrdYnq("mug", "Mug_1"), {"np_grd_ynq.probability": 0.5, "ask.asked": 0.0})
DOOR = Candidate(EnvPredYnq(Fluent("open", ("door",))), {"env_pred_ynq.doubt": 0.9})
WHICH = Candidate(NpGrdWhq("mug"), {"np_grd_whq.entropy": 0.7})


def act(policy: ManualPolicy | SplitPolicy | SilentPolicy, *candidates: Candidate) -> RobotAct:
    return policy.choose(None, candidates, np.random.default_rng(0)).act


def test_manual_asks_about_objects_then_the_environment_then_the_goal_then_executes() -> None:
    goal = goal_question("cup", 1.0)
    assert act(ManualPolicy(), goal, DOOR, MUG, WHICH, EXECUTE) == MUG.act
    assert act(ManualPolicy(), goal, DOOR, WHICH, EXECUTE) == DOOR.act
    assert act(ManualPolicy(), goal, WHICH, EXECUTE) == goal.act
    assert act(ManualPolicy(), goal_question("cup", 0.1), EXECUTE) == EXECUTE.act


def test_split_asks_what_halves_best_up_to_its_cap() -> None:
    even, odd = goal_question("cup", 0.9), goal_question("pot", 0.4)
    assert act(SplitPolicy(2), odd, even, MUG, EXECUTE) == even.act
    assert act(SplitPolicy(2), goal_question("cup", 0.9, asked=2), EXECUTE) == EXECUTE.act


def test_a_fractional_cap_is_met_on_average() -> None:
    last = goal_question("cup", 0.9, asked=2)
    rng = np.random.default_rng(3)
    asked = [SplitPolicy(2.3).choose(None, [last, EXECUTE], rng).chosen == 0 for _ in range(2000)]
    assert np.mean(asked) == pytest.approx(0.3, abs=0.04)


def test_silent_asks_nothing_and_random_anything() -> None:
    assert act(SilentPolicy(), MUG, DOOR, EXECUTE) == EXECUTE.act
    rng = np.random.default_rng(1)
    seen = {RandomPolicy().choose(None, [MUG, DOOR, EXECUTE], rng).chosen for _ in range(50)}
    assert seen == {0, 1, 2}


def test_the_highest_value_wins_and_is_told() -> None:
    policy = LinearPolicy(Weights(SPACE, (1.0, -1.0)))
    low, high = Candidate(MUG.act, {"a": 1.0, "b": 2.0}), Candidate(EXECUTE.act, {"a": 0.5})
    decision = policy.choose(None, [low, high], RNG)
    assert decision.act == EXECUTE.act
    assert [one.value for one in decision.candidates] == pytest.approx([-1.0, 0.5])
    assert decision.propensity == 1.0


def test_propensities_are_the_frequencies_of_choices() -> None:
    policy = LinearPolicy(Weights(SPACE, (1.0, 0.0)), epsilon=0.3)
    both = [Candidate(MUG.act, {"a": 1.0}), Candidate(EXECUTE.act, {})]
    rng = np.random.default_rng(5)
    decisions = [policy.choose(None, both, rng) for _ in range(4000)]
    best = [d for d in decisions if d.chosen == 0]
    assert len(best) / len(decisions) == pytest.approx(best[0].propensity, abs=0.03)


def test_weights_for_other_features_are_refused() -> None:
    kept = Weights(SPACE, (0.25, 2.0)).to_json()
    assert Weights.from_json(SPACE, kept).values == (0.25, 2.0)
    with pytest.raises(ValueError, match="other features: c"):
        Weights.from_json(SPACE, {**kept, "c": 1.0})


def test_a_feature_that_the_phase_lacks_is_an_error() -> None:
    with pytest.raises(KeyError):
        SPACE.matrix([Candidate(MUG.act, {"unheard": 1.0})])

"""Features that are worked out when they are read."""

import pytest

from verbteach.dialogue.late_features import LateFeatures


def test_only_what_is_not_ready_has_to_be_worked_out() -> None:
    asked: list[int] = []

    def late() -> dict[str, float]:
        asked.append(1)
        return {"ask.gain": 0.5}

    features = LateFeatures({"ask.asked": 0.0, "goal_pred_ynq": 1.0}, late)
    assert features["ask.asked"] == 0.0
    assert features.get("goal_pred_ynq") == 1.0
    assert not asked

    everything = {"ask.asked": 0.0, "goal_pred_ynq": 1.0, "ask.gain": 0.5}
    assert features["ask.gain"] == 0.5
    assert features == everything
    assert dict(features.items()) == everything
    assert len(features) == len(everything)
    assert asked == [1]


def test_what_is_neither_ready_nor_late_is_missing() -> None:
    features = LateFeatures({"ask.asked": 0.0}, dict)
    with pytest.raises(KeyError):
        features["select_hypo"]
    assert features.get("select_hypo", 0.0) == 0.0

"""Whatever is a question can be proposed, answered, worded and explained; a new one, too."""

from __future__ import annotations

import pytest

from verbteach.dialogue import acts, execution_inquiry, explanation, learning_inquiry, wording
from verbteach.dialogue.moves import ROBOT_MOVES, Phase
from verbteach.dialogue.uncertainty import _SAID as UNSURE

FEATURES = {
    Phase.EXECUTION: execution_inquiry.FEATURES,
    Phase.LEARNING: learning_inquiry.FEATURES,
}


@pytest.mark.parametrize("phase", FEATURES, ids=lambda phase: phase.value)
def test_a_phase_may_ask_just_what_its_inquiry_proposes(phase: Phase) -> None:
    proposed = {kind for kind in acts.QUESTIONS if kind.name in FEATURES[phase]}
    assert proposed == set(ROBOT_MOVES[phase])


@pytest.mark.parametrize("kind", acts.QUESTIONS, ids=lambda kind: kind.name)
def test_a_question_is_worded_and_explained(kind: type[acts.RobotAct]) -> None:
    assert kind in wording._WORDING
    assert kind in explanation._LABELS, "what is weighed is told in words"
    assert kind in UNSURE, "why it is asked is told in words"

"""What another policy would have asked: answered from the record, or not answered."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from tests.sessions.records import first, forge, read_events
from tests.sessions.rooms import BOIL, TAUGHT, begin, recorded, say, settings, teach
from tests.sessions.test_resume import spoke_otherwise
from verbteach.dialogue import acts
from verbteach.dialogue.robot import Robot
from verbteach.perception.noise import NoiseModel
from verbteach_sessions.counterfactual import NotRecomputableError, counterfactual
from verbteach_sessions.method import POLICIES, Method, UnknownPolicyError
from verbteach_sessions.replay import verify

DONE = TAUGHT + "good\n"


@pytest.mark.parametrize("policy", ["she16", "split", "manual"])
@pytest.mark.parametrize("seed", [1, 2, 3])
def test_under_its_own_policy_a_session_is_as_it_was(
    tmp_path: Path, policy: str, seed: int
) -> None:
    with begin(tmp_path, method=Method.named(policy)) as session:
        say(session, BOIL if policy == "she16" else "")
        teach(session, seed, 25)
        totals = session.robot.state.totals
    told = counterfactual(session.path, settings, policy)
    assert told.first_difference is None
    assert told.unanswerable == 0
    assert told.turns == sum(node.teacher is not None for node in session.turns())
    assert told.reward == pytest.approx(totals.reward)
    assert told.questions == told.recorded_questions


def test_a_question_that_was_never_answered_is_counted_and_nothing_made_up(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    noisy = Method.named("she16").with_noise(NoiseModel(spread=0.3))
    path = recorded(tmp_path, BOIL, method=noisy)
    assert counterfactual(path, settings, "she16").unanswerable == 0
    said: list[object] = []
    receive = Robot.receive

    def heard(robot: Robot, act: acts.TeacherAct) -> object:
        said.append(act)
        return receive(robot, act)

    told_acts = [event["data"]["act"] for event in read_events(path) if event["type"] == "teacher"]
    monkeypatch.setattr(Robot, "receive", heard)
    told = counterfactual(path, settings, "manual")
    again = said[len(told_acts) :]  # the first were the recomputing of the record
    assert told.unanswerable >= 1
    assert told.first_difference is not None
    assert told.commands == told.finished + told.unanswerable
    names = [act["act"] for act in told_acts]
    for act in again:
        assert isinstance(act, acts.TeacherAct)
        assert act.name in names, "only what the teacher said is said"
    assert len(again) <= len(told_acts)


def test_what_was_asked_in_both_is_answered_as_it_was(tmp_path: Path) -> None:
    with begin(tmp_path, method=Method.named("manual")) as session:
        rng = np.random.default_rng(4)
        say(session, "command: boil the water\n")
        while session.turn.phase.value == "execution":
            session.perform(acts.Yes() if rng.random() < 0.5 else acts.No())
        path = session.path
    told = counterfactual(path, settings, "manual")
    assert (told.unanswerable, told.questions) == (0, told.recorded_questions)


@pytest.mark.parametrize("policy", sorted(POLICIES))
def test_every_policy_can_be_tried_and_changes_nothing(tmp_path: Path, policy: str) -> None:
    path = recorded(tmp_path, DONE)
    before = {file: file.read_bytes() for file in path.iterdir()}
    one, two = (counterfactual(path, settings, policy) for _ in range(2))
    assert one.to_json() == two.to_json()
    assert one.content_hash == verify(path, settings).content_hash
    assert {file: file.read_bytes() for file in path.iterdir()} == before


def test_a_policy_that_is_not_there_is_named(tmp_path: Path) -> None:
    path = recorded(tmp_path, "")
    with pytest.raises(UnknownPolicyError, match="clairvoyant"):
        counterfactual(path, settings, "clairvoyant")


def test_a_record_that_cannot_be_recomputed_has_no_counterfactual(tmp_path: Path) -> None:
    path = recorded(tmp_path, DONE)
    forge(path, spoke_otherwise)
    assert first(read_events(path), "robot", 1)["data"]["texts"]
    with pytest.raises(NotRecomputableError, match="event 3"):
        counterfactual(path, settings, "split")

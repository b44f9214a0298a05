"""Learning to ask in a session: recorded, recomputed to the bit, undone, carried over, held."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Any

import pytest

from tests.sessions.records import first, forge, read_events
from tests.sessions.rooms import BOIL, babble, begin, resumed, say, settings
from verbteach.dialogue.acts import QUESTIONS, Good, IncludeFluent, Yes
from verbteach.dialogue.moves import Phase
from verbteach.dialogue.parameters import RobotParameters
from verbteach.perception.noise import NoiseModel
from verbteach.policy.learned_policy import LearnedPolicy
from verbteach_sessions import session_acts
from verbteach_sessions.header import Header
from verbteach_sessions.learned import taught_by
from verbteach_sessions.method import Method, starting_policy
from verbteach_sessions.replay import verify
from verbteach_sessions.session import Session, summary
from verbteach_sessions.validate import validate

AGAIN = "scene: kitchen-1\ncommand: boil the water\n"


@cache
def method(*, frozen: bool = False, noise: str = "perfect") -> Method:
    parameters = RobotParameters(noise=NoiseModel.named(noise))
    return Method(starting_policy(frozen=frozen), parameters)


def steps(path: Path) -> list[dict[str, Any]]:
    found = [e["data"]["record"] for e in read_events(path) if e["type"] == "learned"]
    return [step for record in found for step in record.get("policy", ())]


SHOWN = BOIL.removesuffix("good\n")


def answered(session: Session) -> Session:
    """Say yes to all questions."""
    while session.turn.phase in {Phase.LEARNING, Phase.EXECUTION}:
        session.perform(Yes())
    return session


def judged(session: Session) -> None:
    """Say yes to all questions, and good to what comes of it."""
    answered(session).perform(Good())


def taught(folder: Path, **header: Any) -> Path:
    """A session in which boiling was taught and then done rightly."""
    with begin(folder, **header) as session:
        for script in (SHOWN, AGAIN):
            judged(say(session, script))
        return session.path


def weights(session: Session) -> LearnedPolicy:
    policy = session.robot.state.policy
    assert isinstance(policy, LearnedPolicy)
    return policy


def test_every_turn_that_earns_changes_the_weights_and_says_so(tmp_path: Path) -> None:
    path = taught(tmp_path, method=method())
    *asked, learning, execution = steps(path)
    assert (learning["phase"], execution["phase"]) == ("learning", "execution")
    assert learning["reward"] == execution["reward"] == 1.0
    price = starting_policy().how.price
    assert [step["reward"] for step in asked] == [pytest.approx(-0.01 * price)] * len(asked)
    decisions = [
        d for e in read_events(path) if e["type"] == "robot" for d in e["data"]["decisions"]
    ]
    assert decisions[0]["weights"] == starting_policy().digest
    assert decisions[-1]["weights"] == learning["digest"]
    for decision in decisions:
        assert all(one["q"] is not None and one["features"] for one in decision["candidates"])
        assert 0 < decision["propensity"] <= 1


def test_it_is_recomputed_to_the_bit_and_valid(tmp_path: Path) -> None:
    path = taught(tmp_path, method=method(noise="std3"))
    assert len(steps(path)) > 2
    assert verify(path, settings).verified
    assert validate(path, settings).valid


def test_a_weight_that_was_changed_in_the_record_is_found(tmp_path: Path) -> None:
    path = taught(tmp_path, method=method())

    def change(events: list[dict[str, Any]]) -> None:
        step = first(events, "learned")["data"]["record"]["policy"][0]
        name = next(iter(step["weights"]))
        step["weights"][name] += 1e-15

    forge(path, change)
    difference = verify(path, settings).first_difference
    assert difference is not None
    assert difference.field.startswith("record.policy[0].weights.")


def test_undo_brings_the_weights_back_exactly(tmp_path: Path) -> None:
    with begin(tmp_path, method=method()) as session:
        answered(say(session, SHOWN))
        before = weights(session)
        say(session, "good\n")
        after = weights(session)
        assert after.digest != before.digest
        session.perform(session_acts.Undo())
        assert weights(session) == before
        session.perform(session_acts.Redo())
        assert weights(session) == after
        path = session.path
    with resumed(path) as again:
        assert weights(again) == after


def test_verbs_and_weights_carry_over_without_what_was_undone(tmp_path: Path) -> None:
    with begin(tmp_path, method=method()) as session:
        for script in (SHOWN, AGAIN):
            judged(say(session, script))
        session.perform(session_acts.Undo())
        known = weights(session)
        path = session.path
    before = taught_by(path)
    assert before.policy == known
    assert len(before.asked) == 1
    header = Header.new("kitchen-1", Method(known), source=before.source)
    with Session.create(tmp_path, header, settings) as second:
        assert weights(second) == known
        judged(say(second, "command: boil the water\n"))
        assert weights(second).digest != known.digest
        second_path = second.path
        final = weights(second)
    assert verify(second_path, settings).verified
    assert taught_by(second_path).policy == final


def test_frozen_weights_stay_as_they_are(tmp_path: Path) -> None:
    path = taught(tmp_path, method=method(frozen=True))
    assert steps(path) == []
    assert taught_by(path).policy == starting_policy(frozen=True)


def test_a_goal_that_had_to_be_corrected_was_not_right(tmp_path: Path) -> None:
    with begin(tmp_path, method=method()) as session:
        answered(say(session, SHOWN))
        goal = session.turn.waiting_act
        assert isinstance(goal, IncludeFluent)
        out = next(one for one in sorted(goal.goal) if len(goal.goal) > 1)
        say(session, f"strike: {out}\ngood\n")
        corrected = session.path
    assert steps(corrected)[-1]["reward"] == pytest.approx(-0.02)
    assert validate(corrected, settings).valid


def test_a_goal_that_was_put_back_as_it_was_read_was_right(tmp_path: Path) -> None:
    with begin(tmp_path, method=method()) as session:
        goal = answered(say(session, SHOWN)).turn.waiting_act
        assert isinstance(goal, IncludeFluent)
        part = min(goal.goal)
        say(session, f"strike: {part}\nkeep: {part}\ngood\n")
        path = session.path
    assert steps(path)[-1]["reward"] == 1.0
    assert validate(path, settings).valid


def test_a_header_of_a_learned_policy_can_be_read_again() -> None:
    assert Method.from_json(method().to_json()) == method()
    assert Method.named("rl") == method()


@pytest.mark.parametrize("seed", [1, 2])
def test_whatever_is_said_the_record_is_valid(tmp_path: Path, seed: int) -> None:
    with begin(tmp_path, method=method(noise="std5")) as session:
        judged(say(session, SHOWN))
        babble(session, seed, 40)
        counted = summary(session)
        known = weights(session)
        path = session.path
    assert sum(counted["questions_by_type"].values()) == counted["questions"]
    assert set(counted["questions_by_type"]) <= {kind.name for kind in QUESTIONS}
    found = validate(path, settings)
    assert found.valid, found
    assert taught_by(path).policy == known

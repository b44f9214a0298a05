"""Headers, the methods in them, and names that cannot leave their folder."""

from __future__ import annotations

import json
from dataclasses import replace
from datetime import UTC, datetime
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from verbteach.dialogue.parameters import RobotParameters
from verbteach.dialogue.preference import Confirmed
from verbteach.dialogue.rewards import Rewards
from verbteach.perception.noise import LEVELS, READINGS, NoiseModel
from verbteach.policy.demonstration_only import DemonstrationOnlyPolicy
from verbteach.verbs.application import ApplicationParameters
from verbteach.verbs.change import ObjectSet
from verbteach.verbs.criteria import PLAIN_CRITERIA
from verbteach.verbs.hypothesis import LearningParameters
from verbteach.verbs.selection import Pooling, SelectionParameters
from verbteach_sessions.errors import UnsafeNameError
from verbteach_sessions.header import Header, Source
from verbteach_sessions.method import Method, UnknownPolicyError
from verbteach_sessions.names import new_code, new_id, safe_name
from verbteach_sessions.plain_values import ParameterError

chances = st.floats(0, 1)
noises = st.builds(
    NoiseModel,
    st.sampled_from(sorted(LEVELS.values())),
    st.booleans(),
    st.booleans(),
    st.booleans(),
    st.dictionaries(st.text(max_size=5), st.floats(0, 10), max_size=2),
)
parameters = st.builds(
    RobotParameters,
    seed=st.integers(0, 2**63),
    noise=noises,
    rewards=st.builds(
        Rewards, st.dictionaries(st.text(max_size=5), st.tuples(st.floats(-9, 9), chances))
    ),
    learning=st.builds(
        LearningParameters, object_set=st.sampled_from(ObjectSet), prune=st.booleans()
    ),
    selection=st.builds(
        SelectionParameters,
        criterion=st.sampled_from([*PLAIN_CRITERIA.values(), Confirmed(), Confirmed(2.5)]),
        application=st.builds(ApplicationParameters, replace_missing=st.integers(0, 9)),
        pooling=st.sampled_from(Pooling),
    ),
    question_cap=st.integers(0, 50),
)
policies = st.builds(DemonstrationOnlyPolicy, chances, st.booleans())


@given(policies, parameters)
def test_every_choice_of_a_method_comes_back_from_json(
    policy: DemonstrationOnlyPolicy, chosen: RobotParameters
) -> None:
    method = Method(policy, chosen)
    assert Method.from_json(json.loads(json.dumps(method.to_json()))) == method


@pytest.mark.parametrize("reading", READINGS)
@pytest.mark.parametrize("level", sorted(LEVELS))
def test_every_named_noise_can_be_recorded(level: str, reading: str) -> None:
    method = Method().with_noise(NoiseModel.named(level, reading))
    text = json.dumps(method.to_json(), allow_nan=False)
    assert Method.from_json(json.loads(text)).parameters.noise == NoiseModel.named(level, reading)


def changed(path: list[str], value: Any) -> dict[str, Any]:
    data = json.loads(json.dumps(Method().to_json()))
    inner = data
    for name in path[:-1]:
        inner = inner[name]
    inner[path[-1]] = value
    return dict(data)


@pytest.mark.parametrize(
    ("path", "value"),
    [
        (["seed"], "1"),
        (["seed"], True),
        (["noise", "spread"], -1),
        (["noise", "spread"], None),
        (["noise", "spreads"], []),
        (["noise", "surprise"], 1),
        (["parameters", "question_cap"], 1.5),
        (["parameters", "rewards", "prices"], {"x": [1.0]}),
        (["parameters", "learning", "object_set"], "everything"),
        (["parameters", "selection", "criterion"], {"name": "taste"}),
        (["parameters", "selection", "criterion"], 3),
        (["policy", "clear_margin"], "wide"),
        (["policy"], {}),
    ],
)
def test_a_recorded_choice_that_is_none_is_refused(path: list[str], value: Any) -> None:
    with pytest.raises(ParameterError) as refused:
        Method.from_json(changed(path, value))
    assert path[-1] in str(refused.value) or path[0] in str(refused.value)


def test_an_unknown_policy_is_named_with_those_there_are() -> None:
    with pytest.raises(UnknownPolicyError, match="she16"):
        Method.named("oracle")
    assert Method.named("she16") == Method()


def made(**changes: Any) -> Header:
    header = Header.new(
        "kitchen-2",
        interface="app",
        terminal=(100, 30),
        participant="p4",
        study={"condition": "asking"},
        source=Source("old", "1" * 64, ({"spaces": [], "experience": [["a mug", "Mug_1"]]},)),
        now=lambda: datetime(2031, 5, 6, 7, 8, 9, tzinfo=UTC),
        random=lambda count: bytes(range(count)),
    )
    return replace(header, **changes)


def test_a_header_comes_back_from_json() -> None:
    header = made()
    assert header.id == "20310506-070809-abcdefgh"
    assert header.machine.created == "2031-05-06T07:08:09+00:00"
    assert Header.from_json(json.loads(json.dumps(header.to_json()))) == header
    bare = Header.new("kitchen-1")
    assert Header.from_json(json.loads(json.dumps(bare.to_json()))) == bare


def test_a_header_names_the_versions_that_recomputing_depends_on() -> None:
    assert {"verbteach", "numpy"} <= set(made().machine.software)


def test_a_header_of_the_wrong_shape_is_refused() -> None:
    for name in made().to_json():
        data = made().to_json()
        data[name] = [[]]
        with pytest.raises(ValueError, match=name):
            Header.from_json(data)
        del data[name]
        with pytest.raises(ValueError, match=name):
            Header.from_json(data)


@pytest.mark.parametrize(
    "name",
    ["", ".", "..", "../x", "a/b", "a\\b", "-x", "a b", "é", "a\n", "x" * 65, "a\x00", "~", "a.b"],
)
def test_names_that_could_leave_their_folder_are_refused(name: str) -> None:
    with pytest.raises(UnsafeNameError):
        safe_name(name)
    with pytest.raises(UnsafeNameError):
        made(id=name)
    with pytest.raises(UnsafeNameError):
        made(participant=name)


def test_names_and_codes_are_safe_and_differ() -> None:
    names = [new_id() for _ in range(200)] + [new_code() for _ in range(200)]
    assert len(set(names)) == 400
    assert [safe_name(name) for name in names] == names

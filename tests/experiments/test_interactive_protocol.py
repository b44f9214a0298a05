from __future__ import annotations

from dataclasses import replace

import pytest

from tests.experiments.interactive_room import bench
from verbteach.dialogue import execution_inquiry, learning_inquiry
from verbteach.experiments.instance_split import InstanceSplit
from verbteach.experiments.interactive import MOST
from verbteach.experiments.interactive_bench import BenchParameters
from verbteach.experiments.interactive_protocol import Config, run
from verbteach.experiments.interactive_results import Result
from verbteach.experiments.interactive_training import TrainingParameters
from verbteach.experiments.simulated_human import HumanParameters

SMALL = TrainingParameters(dialogues=60, warm=20)
CONFIG = Config(policy="silent", groups=2, training=SMALL)


def result(**changes: object) -> Result:
    return run(bench(), replace(CONFIG, **changes))  # type: ignore[arg-type]


def mean(found: Result, value: str) -> float:
    return sum(float(getattr(t, value)) for t in found.tested) / len(found.tested)


def asked(found: Result) -> float:
    return sum(sum(t.questions.values()) for t in found.tested) / len(found.tested)


def test_every_instance_is_tested_once_and_scores_are_scores() -> None:
    found = result()
    assert [t.instance for t in found.tested] == [i.id for i in bench().instances]
    assert all(0 <= t.sji <= 1 and 0 <= t.ied <= 1 for t in found.tested)
    assert asked(found) == 0


def test_questions_help() -> None:
    assert mean(result(policy="split", split_cap=3.0), "sji") > mean(result(), "sji") + 0.05
    assert asked(result(policy="manual")) > 0


def test_equal_configurations_give_equal_results_whatever_was_done_before() -> None:
    warm = bench()
    config = replace(CONFIG, policy="rl", noise="std3")
    run(warm, replace(CONFIG, policy="manual", noise="std5", run=7))
    assert run(warm, config) == run(bench(), config)


def test_an_environment_held_out_teaches_nothing() -> None:
    """Its result is the same alone as beside the others: no other test has a part in it."""
    for policy in ("split", "rl"):
        whole = result(policy=policy)
        alone = result(policy=policy, held_out=("room-2",))
        own = {i.id for i in bench().instances if i.environment == "room-2"}
        assert tuple(t for t in whole.tested if t.instance in own) == alone.tested


def test_environments_held_out_together_teach_nothing() -> None:
    """The same whether or not they had anything to teach: all else is drawn without them."""
    away = ("room-1", "room-4")
    for policy in ("split", "rl"):
        changes = {"policy": policy, "held_out": away, "together": True, "noise": "std3"}
        found = result(**changes)
        assert [t.instance for t in found.tested] == [
            i.id for i in bench().instances if i.environment in away
        ]
        split = InstanceSplit.of(bench().instances, replace(CONFIG, **changes))  # type: ignore[arg-type]
        learned = [*split.practice, *split.lessons()]
        assert len(learned) == len({i.id for i in learned}) == len(split.instances)
        assert not {i.environment for i in learned} & set(away)
        assert found.taught.dialogues == len(split.lessons())
    with pytest.raises(ValueError, match="none is named"):
        result(together=True)


def test_checkpoints_know_a_growing_part_of_the_verbs() -> None:
    config = {"policy": "split", "held_out": ("room-1", "room-4"), "together": True}
    found = result(**config, checkpoints=(0.2, 1.0))
    few, all_of_them = found.checkpoints
    assert few.lessons < all_of_them.lessons == found.taught.dialogues
    assert all_of_them.tested == found.tested
    alone = result(**config, verb_share=0.2)
    assert few.tested == alone.tested
    assert alone.taught.dialogues == few.lessons


@pytest.mark.parametrize("policy", ["rl", "split", "manual", "random"])
def test_a_trace_scores_the_command_after_every_question(policy: str) -> None:
    plain = result(policy=policy, noise="std3")
    traced = result(policy=policy, noise="std3", trace=True)
    assert [replace(t, trace=()) for t in traced.tested] == list(plain.tested)
    for one in traced.tested:
        asked = sum(one.questions.values())
        assert 1 <= len(one.trace) <= MOST + 1
        if policy != "random":  # which asks others when it does not stop
            assert one.trace[min(asked, MOST)] == (one.ied, one.sji) or asked > MOST
        if policy == "manual":  # it ends where it has nothing left to ask
            assert len(one.trace) == min(asked, MOST) + 1
    assert plain.taught == traced.taught


def test_rl_learns_named_weights_for_both_phases() -> None:
    found = result(policy="rl")
    names = {name.split()[0]: set(weights) for name, weights in found.weights.items()}
    assert names == {
        "learning": set(learning_inquiry.FEATURES),
        "execution": set(execution_inquiry.FEATURES),
    }


def test_changes_are_asked_about_only_where_they_are_in_doubt() -> None:
    names = {"perfect": 0, "uniform": 1}
    for noise, least in names.items():
        asked_about = result(noise=noise, policy="manual").taught.questions
        assert (asked_about.get("pred_change_ynq", 0) > 0) == bool(least)


def test_the_oracle_grounding_leaves_fewer_objects_to_ask_about() -> None:
    manual = replace(CONFIG, policy="manual")
    plain = run(bench(), manual)
    oracle = run(bench(BenchParameters(oracle=True)), manual)
    counts = [sum(t.questions.get("np_grd_ynq", 0) for t in r.tested) for r in (plain, oracle)]
    assert counts[0] > counts[1]


def test_a_teacher_without_patience_is_still_asked_and_answers_nothing() -> None:
    config = {"policy": "split", "split_cap": 3.0}
    mute = result(**config, human=HumanParameters(patience=0))
    assert mean(mute, "sji") == pytest.approx(mean(result(), "sji"), abs=1e-9)
    assert asked(mute) > 0


def test_an_unknown_policy_is_named() -> None:
    with pytest.raises(ValueError, match="'psychic'"):
        result(policy="psychic")

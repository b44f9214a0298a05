"""What a robot that asks loses is put down to one cause a command, and the causes add up."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import replace
from functools import cache

import pytest

from tests.experiments.interactive_room import bench
from verbteach.experiments.asked_command import AskedCommand
from verbteach.experiments.asking_counterfactuals import MENDS, Outcomes, asked_on, grounded, seen
from verbteach.experiments.asking_gains import answered, by_kind
from verbteach.experiments.asking_mishaps import Analysis, Cause, Examiner, analyse, cause
from verbteach.experiments.asking_tables import markdown, to_json
from verbteach.experiments.interactive_bench import Bench, BenchParameters
from verbteach.experiments.interactive_protocol import Config, run
from verbteach.experiments.interactive_results import Result
from verbteach.experiments.interactive_training import TrainingParameters
from verbteach.experiments.judging import Score
from verbteach.experiments.sight import stream
from verbteach.language.lexicon import Lexicon
from verbteach.language.wording import Wording
from verbteach.verbs.instance import Instance

SMALL = TrainingParameters(dialogues=60, warm=20)
WORDS = Wording(Lexicon(), str)


def outcome(own: float, **mended: float) -> Outcomes:
    """Nothing helps but what is named; planning to the true change is perfect."""
    scores = dict.fromkeys(("asked_on", "grounded", "seen", "answered"), own) | {"goal": 1.0}
    chosen = mended.pop("chosen", own)
    given = {name: Score(0.0, sji) for name, sji in (scores | mended).items()}
    return Outcomes(own=Score(0.0, own), chosen=chosen, further=0, **given)


@pytest.mark.parametrize(
    ("known", "aside", "named"),
    [
        (outcome(0.8, goal=0.8), False, Cause.PLANNING),
        (outcome(0.2, seen=0.6, grounded=1.0), False, Cause.BELIEF),
        (outcome(0.2, grounded=0.9, asked_on=1.0), False, Cause.GROUNDING),
        (outcome(0.2, asked_on=0.6, answered=1.0), True, Cause.EARLY),
        (outcome(0.2, asked_on=0.5, chosen=0.7), False, Cause.EXECUTION),
        (outcome(0.2, asked_on=0.5, answered=0.5), True, Cause.NO_CANDIDATE),
        (outcome(0.2, asked_on=0.5, answered=0.7), True, Cause.UNSPOKEN),
        (outcome(0.2, asked_on=0.5, answered=0.7), False, Cause.UNLIKELY),
    ],
)
def test_the_first_mend_that_wins_back_half_is_the_cause(
    known: Outcomes, aside: bool, named: Cause
) -> None:
    assert cause(known, aside) is named


@cache
def warm() -> Bench:
    """A bench that all tests share: what it remembers changes no result."""
    return bench()


@cache
def looked_into(policy: str, noise: str = "perfect") -> tuple[Result, Analysis]:
    config = Config(policy=policy, noise=noise, groups=2, training=SMALL)
    examiner = Examiner(config)
    return run(warm(), config, witness=examiner), examiner.analysis()


def analysed(policy: str, noise: str = "perfect") -> Analysis:
    return looked_into(policy, noise)[1]


@pytest.mark.parametrize("policy", ["rl", "silent"])
def test_every_command_is_looked_into_as_it_went(policy: str) -> None:
    result, found = looked_into(policy, "std3")
    assert [one.instance.id for one in found.commands] == [one.instance for one in result.tested]
    for one, tested in zip(found.commands, result.tested, strict=True):
        assert (one.sji, one.expected) == (tested.sji, tested.expected)
        assert len(one.questions) == sum(tested.questions.values())
        assert (one.cause is None) == (tested.sji == 1.0)
    assert sum(map(found.lost_by, Cause)) == pytest.approx(found.lost)
    assert found.score("own").sji == pytest.approx(1.0 - found.lost)
    config = Config(policy=policy, noise="std3", groups=2, training=SMALL)
    assert run(warm(), config) == result  # to look changes nothing


def test_what_questions_gained_is_what_the_dialogue_gained() -> None:
    silent, manual = analysed("silent"), analysed("manual")
    for before, after in zip(silent.commands, manual.commands, strict=True):
        gained = sum(question.gained for question in after.questions)
        assert gained == pytest.approx(after.sji - before.sji)
    kinds = by_kind(question for one in manual.commands for question in one.questions)
    assert sum(kind.asked for kind in kinds) == sum(len(c.questions) for c in manual.commands)
    assert [kind.asked for kind in kinds] == sorted((k.asked for k in kinds), reverse=True)


def test_asking_on_from_silence_is_what_manual_does() -> None:
    silent, manual = analysed("silent"), analysed("manual")
    for quiet, asking in zip(silent.commands, manual.commands, strict=True):
        assert quiet.outcomes.asked_on == asking.outcomes.own
        assert quiet.outcomes.further == len(asking.questions)
        assert asking.outcomes.further == 0
    assert not manual.of(Cause.EARLY)
    for mend in ("asked_on", "answered", "goal"):
        assert silent.score(mend).sji > silent.score("own").sji
    with pytest.raises(ValueError, match="'luck'"):
        silent.score("luck")


def test_each_mend_puts_right_what_it_says() -> None:
    put: list[AskedCommand] = []
    rooms = ("room-1", "room-4")
    config = Config(policy="silent", noise="uniform", held_out=rooms)
    run(warm(), config, witness=put.append)
    assert {command.instance.environment for command in put} == set(rooms)
    for command in put:
        instance, end = command.instance, command.end
        assert seen(command).believed == instance.start
        if not end.pool.empty:
            right = grounded(command).grounding
            for phrase, meant in zip(instance.phrases, instance.narrowed, strict=True):
                assert {thing for thing, _ in right[phrase]} <= set(meant)
            assert set(end.asked) <= set(asked_on(command).asked)


def odd_bench(change: Sequence[Instance]) -> Bench:
    own = {one.id: one for one in change}
    return replace(bench(), instances=tuple(own.get(i.id, i) for i in bench().instances))


def test_what_the_data_got_wrong_is_told_from_what_the_robot_did() -> None:
    first, second, third, *_ = [i for i in bench().instances if i.verb == "stow"]
    idle = replace(first, end=first.start)
    elsewhere = replace(
        second, phrases=("stove",), candidates=(("Stove_9",),), grounding=("Stove_9",)
    )
    new = replace(third, verb="frob")
    found = analyse(odd_bench((idle, elsewhere, new)), Config(policy="silent"))
    causes = {one.instance.id: one.cause for one in found.commands}
    assert causes[first.id] is Cause.NOTHING_CHANGED
    assert causes[second.id] is Cause.MISALIGNED
    assert causes[third.id] in (Cause.UNSEEN_VERB, None)


def test_a_room_seen_wrongly_is_a_cause_where_the_eyes_are_bad() -> None:
    assert not analysed("manual").of(Cause.BELIEF)
    assert analysed("manual", "uniform").of(Cause.BELIEF)


def test_the_document_is_plain_and_the_page_tells_of_each_cause() -> None:
    oracle = analyse(
        bench(BenchParameters(oracle=True)), Config(policy="silent", held_out=("room-0",))
    )
    analyses = {"corpus": analysed("silent", "std3"), "oracle": oracle}
    document = json.loads(json.dumps(to_json(analyses)))
    commands = analyses["corpus"].commands
    assert document["commands"] == len(commands)
    assert document["exact"] + sum(c["commands"] for c in document["causes"]) == len(commands)
    assert sum(c["share"] for c in document["causes"]) == pytest.approx(1.0)
    assert sum(v["commands"] for v in document["verbs"]) == len(commands)
    assert set(document["ceilings"]) == set(analyses)
    assert all(set(scores) == set(MENDS) for scores in document["ceilings"].values())
    page = markdown(analyses, WORDS)
    for row in document["causes"]:
        assert f"| {row['meaning']} | {row['commands']} |" in page
        told = page.split(f"**{row['meaning'].capitalize()}**")[1].split("**")[0]
        assert 1 <= told.count("\n- ") <= 4
    assert "Asked: nothing." in page


def test_dialogues_are_held_again_as_they_were() -> None:
    config = Config(policy="random", noise="std3", seed=3, held_out=("room-2",))
    put: list[AskedCommand] = []
    run(warm(), config, witness=put.append)
    assert put
    for command in put:
        again = answered(command, stream(3, 0, "test", command.instance.id))
        assert tuple(one.act for one in again) == command.end.asked

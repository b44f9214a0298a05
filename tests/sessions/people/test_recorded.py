"""What is read from a record, held against the state that recomputing the record gives."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.sessions.people.corpus import book, read_all, settings
from tests.sessions.records import forge
from tests.sessions.rooms import BOIL, recorded
from verbteach.dialogue import acts
from verbteach_sessions.errors import LogError
from verbteach_sessions.people.observations import NO, UNREAD, YES, observe
from verbteach_sessions.people.recorded import Recorded, read_header, read_recorded
from verbteach_sessions.replay import replay


def test_the_world_and_the_questions_are_those_of_the_recomputed_session(
    example: tuple[Path, ...], records: tuple[Recorded, ...]
) -> None:
    path, record = example[0], records[0]
    states = {frame.event.seq: frame.state for frame in replay(path, settings())}
    compared = 0
    for said in record.said:
        state = states[said.reply.seq]
        assert state is not None
        now, episode = said.after, state.episode
        assert (now.scene, now.world) == (state.scene, state.world)
        assert now.waiting == state.turn.waiting_act
        if episode is not None:
            assert now.start == episode.start
            assert now.grounding == {
                phrase: tuple(thing for thing, _ in episode.grounding[phrase])
                for phrase in episode.grounding.names
            }
            assert now.asked == len(episode.asked)
            shown = episode.demonstrated.actions if episode.demonstrated else ()
            assert now.shown == shown
            compared += 1
    assert compared > 10


def test_every_answer_of_simulated_people_is_there_with_whether_it_is_right(
    records: tuple[Recorded, ...],
) -> None:
    observed = [one for record in records for one in observe(record, book(), settings())]
    assert len(observed) > 12
    assert {one.question for one in observed} >= {"select_hypo", "include_fluent"}
    answered = [one for one in observed if one.answer in (YES, NO)]
    assert all(one.right is not None for one in answered)  # their lessons tell all
    wrong = sum(not one.right for one in answered)
    assert wrong < len(answered) / 3


def test_a_persons_own_words_are_no_lesson_of_the_book(tmp_path: Path) -> None:
    path = recorded(tmp_path, BOIL, teacher="human", participant="abc")
    (record,) = read_all([path])
    (one,) = observe(record, book(), settings())
    assert (one.person, one.question, one.answer) == ("abc", "include_fluent", YES)
    assert one.right is None  # nobody but the person knows


def test_what_was_done_later_tells_what_a_phrase_meant(tmp_path: Path) -> None:
    script = """\
command: wash the mug
object: Mug_2
do: moveto Mug_2
do: grasp Mug_2
done
good
"""
    path = recorded(tmp_path, script, teacher="human")
    (record,) = read_all([path])
    which = [o for o in observe(record, book(), settings()) if o.question == "np_grd_whq"]
    if which:  # the scene has one mug too few for the question otherwise
        assert which[0].right is True


def test_an_answer_that_could_not_be_read_is_no_right_or_wrong_one(tmp_path: Path) -> None:
    script = BOIL.replace("done\ngood\n", "done\nglorp glorp\ngood\n")
    (record,) = read_all([recorded(tmp_path, script)])
    found = observe(record, book(), settings())
    assert [one.answer for one in found] == [UNREAD]  # the second word is a correction
    assert found[0].right is None


def test_what_was_taken_back_is_not_counted(tmp_path: Path) -> None:
    script = BOIL.replace("done\ngood\n", "done\nbad\nundo\ngood\n")
    (record,) = read_all([recorded(tmp_path, script)])
    assert [one.answer for one in observe(record, book(), settings())] == [YES]


def test_where_the_recorded_world_is_another_nothing_is_said_about_it(tmp_path: Path) -> None:
    path = recorded(tmp_path, BOIL)

    def other_world(events: list[dict[str, object]]) -> None:
        for event in events:
            data = event["data"]
            if event["type"] == "robot" and isinstance(data, dict):
                data["after"]["world"] = "0" * 64

    forge(path, other_world)
    record = read_recorded(path, settings())
    assert all(said.after.world is None for said in record.said)
    assert record.said[-1].after.outcome is acts.Outcome.LEARNED


def test_an_act_that_is_none_is_named_with_its_line(tmp_path: Path) -> None:
    path = recorded(tmp_path, BOIL)

    def wrong_act(events: list[dict[str, object]]) -> None:
        data = events[3]["data"]
        assert isinstance(data, dict)
        data["acts"] = [{"act": "sing"}]

    forge(path, wrong_act)
    with pytest.raises(LogError, match=r"line 4: .*sing"):
        read_recorded(path, settings())


def test_a_header_is_read_without_the_rest(example: tuple[Path, ...]) -> None:
    header = read_header(example[0])
    assert header.teacher == "simulated"
    assert header.id == example[0].name

"""A session's state is a fold over its events: live, undone, redone and refolded alike."""

from __future__ import annotations

import itertools
from pathlib import Path
from tempfile import TemporaryDirectory

from hypothesis import given
from hypothesis import settings as hypothesis_settings
from hypothesis import strategies as st

from tests.sessions.rooms import BOIL, babble, begin, resumed, say, settings, teach
from verbteach.dialogue.state import state_to_json
from verbteach_sessions.header import Header
from verbteach_sessions.replay import replay, verify
from verbteach_sessions.session import Session
from verbteach_sessions.session_acts import Note, Redo, Undo

some = hypothesis_settings(max_examples=12, deadline=None)
seeds = st.integers(0, 2**32 - 1)


def observable(session: Session) -> tuple[object, ...]:
    """All that another process must find again."""
    state = session.robot.state
    return (
        state_to_json(state),
        state.turn,
        state.experience,
        session.transcript(),
        session.content_hash,
        session.can_undo,
        session.can_redo,
    )


@some
@given(seeds, st.booleans())
def test_the_fold_of_the_log_is_the_live_state(seed: int, taught: bool) -> None:
    with TemporaryDirectory() as folder:
        with begin(Path(folder)) as session:
            say(session, BOIL if taught else "")
            babble(session, seed, 25)
            live = observable(session)
        verification = verify(session.path, settings)
        assert verification.first_difference is None
        assert verification.content_hash == session.content_hash
        *_, last = replay(session.path, settings)
        assert last.state is not None
        assert last.state.digest == session.robot.state.digest
        with resumed(session.path) as again:
            assert observable(again) == live
            assert again.recovered == ()


@some
@given(seeds, seeds, seeds, st.integers(1, 8))
def test_undone_is_as_if_it_had_never_been(a: int, b: int, c: int, count: int) -> None:
    with TemporaryDirectory() as folder, begin(Path(folder)) as one, begin(Path(folder)) as two:
        for session in (one, two):
            say(session, BOIL)
            teach(session, a, 5)
        before = state_to_json(one.robot.state)
        teach(one, b, count)
        for _ in range(count):
            one.perform(Undo())
        assert state_to_json(one.robot.state) == before
        assert [x.text for x in one.transcript()] == [x.text for x in two.transcript()]
        assert teach(one, c, 8) == teach(two, c, 8)
        assert one.robot.state.digest == two.robot.state.digest


@some
@given(seeds, seeds, st.integers(1, 8))
def test_redone_is_as_if_it_had_never_been_undone(a: int, b: int, count: int) -> None:
    with TemporaryDirectory() as folder, begin(Path(folder)) as one, begin(Path(folder)) as two:
        for session in (one, two):
            say(session, BOIL)
            teach(session, a, count)
        for _ in range(count):
            one.perform(Undo())
        for _ in range(count):
            one.perform(Redo())
        assert observable(one)[:4] == observable(two)[:4]
        assert teach(one, b, 6) == teach(two, b, 6)
        assert one.robot.state.digest == two.robot.state.digest


def test_undo_goes_back_over_scenes_and_what_was_learned(tmp_path: Path) -> None:
    with begin(tmp_path) as session:
        say(session, BOIL + "scene: kitchen-3\ncommand: boil the water\ngood\n")
        assert session.robot.state.knowledge.verbs == ("boil",)
        while session.can_undo:
            session.perform(Undo())
        state = session.robot.state
        assert (state.scene, state.knowledge.verbs, state.totals.reward) == ("kitchen-1", (), 0.0)
        with begin(tmp_path) as fresh:
            assert state.digest == fresh.robot.state.digest


@some
@given(seeds, st.floats(0.01, 100.0), st.sampled_from(["key", "typed", "browser"]))
def test_the_content_hash_knows_no_time_and_no_interface(
    seed: int, pace: float, interface: str
) -> None:
    with TemporaryDirectory() as folder, begin(Path(folder)) as one:
        header = Header.new("kitchen-1", interface=interface, terminal=(80, 24))
        ticks = itertools.count(7)
        with Session.create(
            Path(folder), header, settings, clock=lambda: pace * next(ticks)
        ) as two:
            for act in teach(one, seed, 6):
                two.perform(act, raw="otherwise", via=interface, shown_at=two.now())
            assert one.content_hash == two.content_hash
            two.perform(Note("and one thing more"))
            assert one.content_hash != two.content_hash

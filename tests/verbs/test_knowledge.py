"""Merging: free of order, associative, undone by keeping the old value, and rebuilt from JSON."""

from __future__ import annotations

import json

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.verbs.strategies import FEW, spaces
from verbteach.verbs.knowledge import FrameSpace, VerbKnowledge
from verbteach.verbs.space import FrameKey, HypothesisSpace
from verbteach.verbs.view import diff, graph, graphs

several = st.lists(spaces(), min_size=1, max_size=6)


def frequencies(knowledge: VerbKnowledge) -> dict[str, int]:
    return {
        f"{key} {node.literals}": node.frequency
        for key, frame in knowledge.frames.items()
        for node in frame.nodes.values()
    }


@FEW
@given(several, st.data())
def test_the_order_of_learning_leaves_no_trace(
    taught: list[HypothesisSpace], data: st.DataObject
) -> None:
    shuffled = data.draw(st.permutations(taught))
    one, other = VerbKnowledge.merged(taught), VerbKnowledge.merged(shuffled)
    assert one == other
    assert one.digest == other.digest
    assert [f.nodes for f in one.frames.values()] == [f.nodes for f in other.frames.values()]


@FEW
@given(several)
def test_one_by_one_is_all_at_once(taught: list[HypothesisSpace]) -> None:
    knowledge = VerbKnowledge()
    for space in taught:
        knowledge = knowledge.with_space(space)
        for frame in knowledge.frames.values():
            assert frame.nodes  # computed now, so that the next one extends it
    whole = VerbKnowledge.merged(taught)
    assert knowledge == whole
    for key, frame in whole.frames.items():
        assert list(knowledge.frames[key].nodes.items()) == list(frame.nodes.items())


@FEW
@given(several, several)
def test_merging_is_associative_over_parts(
    first: list[HypothesisSpace], second: list[HypothesisSpace]
) -> None:
    parts = VerbKnowledge.merged(first).spaces + VerbKnowledge.merged(second).spaces
    assert VerbKnowledge.merged(parts) == VerbKnowledge.merged([*first, *second])


@FEW
@given(several)
def test_frequencies_are_counts_over_demonstrations(taught: list[HypothesisSpace]) -> None:
    expected: dict[str, int] = {}
    for space in taught:
        for node in space.nodes:
            name = f"{space.demonstration.frame} {node.literals}"
            expected[name] = expected.get(name, 0) + 1
    knowledge = VerbKnowledge.merged(taught)
    assert frequencies(knowledge) == expected
    for frame in knowledge.frames.values():
        for mark in ("base", "leaf"):
            marked = {u.demonstration for n in frame.nodes.values() for u in n.uses
                      if getattr(u, mark)}  # fmt: skip
            assert marked == {space.demonstration for space in frame.spaces}


@FEW
@given(several)
def test_json_rebuilds_the_same_knowledge(taught: list[HypothesisSpace]) -> None:
    knowledge = VerbKnowledge.merged(taught)
    again = VerbKnowledge.from_json(json.loads(json.dumps(knowledge.to_json())))
    assert again == knowledge
    assert again.digest == knowledge.digest
    assert [f.nodes for f in again.frames.values()] == [f.nodes for f in knowledge.frames.values()]


@FEW
@given(several, spaces())
def test_the_old_value_stays_and_taking_away_restores_it(
    taught: list[HypothesisSpace], one: HypothesisSpace
) -> None:
    before = VerbKnowledge.merged(taught)
    counts, digest = frequencies(before), before.digest
    after = before.with_space(one)
    assert (frequencies(before), before.digest) == (counts, digest)
    assert after != before
    assert after.without(one) == before
    assert after.replaced(one, None) == before
    assert after.replaced(one, one) == after
    shared = [key for key in before.frames if key != one.demonstration.frame]
    assert all(after.frames[key] is before.frames[key] for key in shared)


def test_taking_away_what_is_not_there_is_refused() -> None:
    with pytest.raises(ValueError, match="missing"):
        VerbKnowledge.from_json({})


@FEW
@given(spaces())
def test_forgetting_the_unknown_is_refused(space: HypothesisSpace) -> None:
    with pytest.raises(ValueError, match="nothing is known"):
        VerbKnowledge().without(space)


@FEW
@given(several)
def test_links_go_one_fluent_down_and_back_up(taught: list[HypothesisSpace]) -> None:
    for frame in VerbKnowledge.merged(taught).frames.values():
        for key, node in frame.nodes.items():
            for lower in node.general:
                assert len(lower) == len(key) - 1
                assert key in frame.specific[lower]


@FEW
@given(several)
def test_the_view_shows_every_node_once_by_level(taught: list[HypothesisSpace]) -> None:
    knowledge = VerbKnowledge.merged(taught)
    for view, frame in zip(graphs(knowledge), knowledge.frames.values(), strict=True):
        shown = [node.literals for level in view.levels for node in level]
        assert sorted(shown) == sorted(frame.nodes)
        sizes = [len(level[0].literals) for level in view.levels]
        assert sizes == sorted(set(sizes), reverse=True)
        assert all({len(n.literals) for n in level} == {len(level[0].literals)}
                   for level in view.levels)  # fmt: skip
        known = {space.demonstration.id for space in frame.spaces}
        assert set(view.demonstrations) == known
        assert {i for level in view.levels for n in level for i in n.demonstrations} == known


@FEW
@given(several, spaces())
def test_the_difference_names_what_one_demonstration_did(
    taught: list[HypothesisSpace], one: HypothesisSpace
) -> None:
    before = VerbKnowledge.merged(taught)
    after = before.with_space(one)
    assert diff(before, before) == ()
    (found,) = diff(before, after)
    assert found.frame == one.demonstration.frame
    touched = {*found.added, *(key for key, _, _ in found.frequencies)}
    assert touched == {node.literals for node in one.nodes}
    assert not found.removed
    assert all(new == old + 1 for _, old, new in found.frequencies)
    (undone,) = diff(after, before)
    assert undone.removed == found.added


def test_frame_keys_read_back() -> None:
    key = FrameKey("turn on", 1)
    assert FrameKey.parse(str(key)) == key
    with pytest.raises(ValueError, match="verb/number"):
        FrameKey.parse("turn on")


def test_an_empty_frame_has_an_empty_graph() -> None:
    assert graph(FrameSpace(FrameKey("go", 0), ())).levels == ()

"""Two readings of a command: what counts as the same."""

from __future__ import annotations

from hypothesis import given

from tests.language.strategies import WORD_SALADS
from verbteach.language.agreement import agree, disputed
from verbteach.language.grammar import parse
from verbteach.language.notation import read_frames


def test_modifiers_order_and_attachment_make_no_difference() -> None:
    one = read_frames("put(obj=mug[red]; on=table[in:sink])")
    assert agree(one, read_frames("put(on=table; obj=mug; in=sink)"))
    assert disputed(one, read_frames("put(on=table; obj=mug; in=sink)")) == ()


def test_verbs_roles_heads_and_number_do() -> None:
    one = read_frames("take(obj=mug) && fill(obj=it; with=water)")
    for other in ("take(obj=cup) && fill(obj=it; with=water)", "take(obj=mug)", ""):
        assert not agree(one, read_frames(other))
    assert disputed(one, read_frames("take(obj=mug) && fill(obj=it; in=water)")) == (1,)
    assert disputed(one, read_frames("take(obj=mug)")) == (0, 1)


@given(WORD_SALADS)
def test_a_reading_agrees_with_itself(text: str) -> None:
    frames = parse(text)
    assert agree(frames, frames)
    assert disputed(frames, frames) == ()

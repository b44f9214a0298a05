"""Who gets which condition: by the study's seed and the participant's place in the order alone.

Places come in blocks. Within a block every condition (between subjects) or
every order of them (within subjects) comes once, in an order that the seed
draws for that block, so that whoever stops recruiting early stops balanced.
"""

from __future__ import annotations

import numpy as np

from verbteach_sessions.study.design import WITHIN, Study

Order = tuple[str, ...]


def orders(study: Study) -> tuple[Order, ...]:
    """What a block is made of: each condition alone, or the rows of a balanced Latin square."""
    ids = tuple(condition.id for condition in study.conditions)
    if study.design != WITHIN:
        return tuple((one,) for one in ids)
    return tuple(tuple(ids[i] for i in row) for row in balanced_latin_square(len(ids)))


def order_of(study: Study, slot: int) -> Order:
    """The conditions of the participant in place ``slot``, from 0, in the order they come."""
    block = orders(study)
    number, place = divmod(slot, len(block))
    drawn = np.random.default_rng([study.seed, number]).permutation(len(block))
    return block[int(drawn[place])]


def seed_of(study: Study, slot: int, part: int) -> int:
    """The seed of the session that a participant holds in a part (0: the practice)."""
    rng = np.random.default_rng([study.seed, 1 + slot, part])
    return int(rng.integers(2**31))


def balanced_latin_square(size: int) -> tuple[tuple[int, ...], ...]:
    """Orders of ``size`` treatments in which each follows each other equally often.

    Williams (1949): ``size`` rows where it is even; where it is odd twice as
    many, the second half the first one mirrored. Each treatment stands equally
    often in each place.
    """
    zigzag = [(step + 1) // 2 if step % 2 else size - step // 2 for step in range(size)]
    rows = [tuple((start + shift) % size for shift in zigzag) for start in range(size)]
    mirrored = [row[::-1] for row in rows] if size % 2 and size > 1 else []
    return tuple(rows + mirrored)

"""Search, heuristic and refinement once more, over flat arrays, for numba to compile.

Importing this module imports numba: only ``compiled`` does, when asked to. It
mirrors ``search``, ``relaxed`` and ``refinement`` step for step and breaks every tie alike,
so the plans are the same; the tests hold the two against each other.

Few arrays are passed around, because compiled code counts references to each
of them at each call: functions of the inner loops take those that they need,
not the whole ``Scratch``, which took ten times as long. A task is one array of
numbers, see ``task_array``. A state
is a row of 64-bit words. Marks hold the number of the round that made them,
so that scratch arrays need no clearing between estimates. It is one file,
because compiled code on the disk is renewed only when its own file changes.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from heapq import heappop, heappush
from importlib import import_module
from pathlib import Path
from typing import Any, NamedTuple, TypeAlias, TypeVar, cast

import numpy as np
import numpy.typing as npt

Ints: TypeAlias = npt.NDArray[np.int64]
Words: TypeAlias = npt.NDArray[np.uint64]
Bytes: TypeAlias = npt.NDArray[np.uint8]
_F = TypeVar("_F", bound=Callable[..., Any])

SOLVED, EXHAUSTED, BOUND = 0, 1, 2
NEVER = 1 << 62
"""More than any cost or key."""
SHIFT = 24
"""Bits of a key left to a state's or a proposition's number."""
MASK = (1 << SHIFT) - 1
ACTION = 20
"""Bits of a key left to an action's number."""

# Where the task's array says: how many fluents, operators, actions and links there are, and
# where its tables start. By operator: needs, actor; by proposition: achievers; by action: needs
# and effects; by effect: needs, fluents added and deleted; by proposition: who needs it.
FLUENTS, OPERATORS, ACTIONS, LINKS = 0, 1, 2, 3
NEEDS, ACTOR, ACHIEVERS, ACTION_NEEDS, EFFECTS, EFFECT_NEEDS, ADDS, DELETES = range(4, 12)
NEEDED_BY = 12
HEADER = 13

# Columns of the scratch arrays; the first ones, marks, start at zero.
WANTED, STACKED, ASKED, EASY, USERS, COST, BEST = range(7)
PROPOSITION_MARKS, PROPOSITION_COLUMNS = 3, 7
ENTERED, FOLLOWED, TAKEN, WAITING, SPENT, FEEDS, READY = range(7)
OPERATOR_MARKS, OPERATOR_COLUMNS = 3, 7
ITEM, NEXT = 0, 1
ROUND, DEPTH, EDGES = 0, 1, 2


class Scratch(NamedTuple):
    """Working memory of the estimate; a linked list's head is 0 where the list is empty.

    ``now`` counts rounds, what is on the stack, and edges in use; ``false`` is
    1 for each proposition that is false in the state judged, ``spelled``, and
    ``unmet`` counts the needs of each operator that are false in it.
    """

    now: Ints
    props: Ints
    ops: Ints
    edges: Ints
    stack: Ints
    false: Bytes
    spelled: Words
    unmet: Ints


class Seen(NamedTuple):
    """The states judged: their rows, how each came about, its next child, and a hash table."""

    rows: Words
    parents: Ints
    via: Ints
    upcoming: Ints
    table: Ints


def task_array(counts: Sequence[int], tables: Sequence[Sequence[Sequence[int]]]) -> Ints:
    """Lay out a task: a header, then for each table where its lists begin, then their items.

    List ``i`` of table ``k`` is ``t[t[t[k] + i] : t[t[k] + i + 1]]``.
    """
    starts: list[int] = []
    body: list[int] = []
    for table in tables:
        starts.append(HEADER + len(body))
        position = HEADER + len(body) + len(table) + 1
        for items in table:
            body.append(position)
            position += len(items)
        body.append(position)
        for items in table:
            body.extend(items)
    return np.array([*counts, *starts, *body], dtype=np.int64)


_functions: list[Any] = []


def _compiled(function: _F) -> _F:
    """Compile on first use, from the disk where it was compiled before; frees the GIL."""
    njit = import_module("numba").njit
    try:
        found = njit(cache=True, nogil=True)(function)
    except RuntimeError:  # no folder to keep compiled code in
        found = njit(nogil=True)(function)
    _functions.append(found)
    return cast(_F, found)


def forget() -> None:
    """Drop the compiled code on the disk: loading it fails where its index is torn or too old."""
    for function in _functions:
        folder = function.stats.cache_path
        for index in Path(folder).glob(f"kernel.{function.__name__}-*.nbi") if folder else ():
            index.unlink(missing_ok=True)


@_compiled
def _span(t: Ints, table: int, number: int) -> tuple[int, int]:
    """Where a list of a table begins and ends."""
    at = t[table] + number
    return int(t[at]), int(t[at + 1])


@_compiled
def _is_easy(t: Ints, props: Ints, unmet: Ints, now: Ints, proposition: int) -> bool:
    """Whether an operator that can be done now makes the proposition true."""
    if props[proposition, ASKED] != now[ROUND]:
        props[proposition, ASKED] = now[ROUND]
        props[proposition, EASY] = 0
        first, last = _span(t, ACHIEVERS, proposition)
        for i in range(first, last):
            if unmet[t[i]] == 0:
                props[proposition, EASY] = 1
                break
    return bool(props[proposition, EASY] == 1)


@_compiled
def _is_easy_operator(
    t: Ints, props: Ints, unmet: Ints, false: Bytes, now: Ints, operator: int
) -> bool:
    """Whether everything the operator lacks can be made true at once."""
    first, last = _span(t, NEEDS, operator)
    for i in range(first, last):
        if false[t[i]] and not _is_easy(t, props, unmet, now, t[i]):
            return False
    return True


@_compiled
def _most_unmet(
    t: Ints, props: Ints, unmet: Ints, false: Bytes, now: Ints, proposition: int
) -> int:
    """How much an achiever may lack and still be the cheapest."""
    first, last = _span(t, ACHIEVERS, proposition)
    if last - first < 2:
        return int(unmet[t[first]]) if last > first else 0
    most, least = 0, NEVER
    for i in range(first, last):
        number = int(unmet[t[i]])
        if number == 0:  # it lacks nothing, so all that it lacks is easy
            return 0
        most = max(most, number)
        if number < least and _is_easy_operator(t, props, unmet, false, now, t[i]):
            least = number
    return min(least, most)


@_compiled
def _stack_need(props: Ints, stack: Ints, now: Ints, need: int) -> None:
    """Put a proposition on the stack of those to be made true, once."""
    if props[need, STACKED] != now[ROUND]:
        props[need, STACKED] = now[ROUND]
        props[need, USERS] = 0
        props[need, COST] = NEVER
        stack[now[DEPTH]] = need
        now[DEPTH] += 1


@_compiled
def _link(edges: Ints, now: Ints, item: int, following: int) -> int:
    """Make an edge in front of another one; return its number."""
    now[EDGES] += 1
    edge = int(now[EDGES])
    edges[edge, ITEM] = item
    edges[edge, NEXT] = following
    return edge


@_compiled
def _enter(ops: Ints, unmet: Ints, now: Ints, operator: int) -> bool:
    """Begin to want an operator; return whether it was not wanted before."""
    if ops[operator, ENTERED] == now[ROUND]:
        return False
    ops[operator, ENTERED] = now[ROUND]
    ops[operator, FEEDS] = 0
    ops[operator, WAITING] = unmet[operator]
    ops[operator, SPENT] = 1
    return True


@_compiled
def _gather(t: Ints, s: Scratch) -> int:
    """Gather backwards what may make the stacked propositions true; return how many are ready."""
    props, ops, edges, stack = s.props, s.ops, s.edges, s.stack
    unmet, false, now = s.unmet, s.false, s.now
    ready = 0
    while now[DEPTH] > 0:
        now[DEPTH] -= 1
        proposition = stack[now[DEPTH]]
        most = _most_unmet(t, props, unmet, false, now, proposition)
        first, last = _span(t, ACHIEVERS, proposition)
        for i in range(first, last):
            operator = t[i]
            if unmet[operator] > most:
                continue
            if _enter(ops, unmet, now, operator):
                begin, end = _span(t, NEEDS, operator)
                for j in range(begin, end):
                    if false[t[j]]:
                        _stack_need(props, stack, now, t[j])
                        props[t[j], USERS] = _link(edges, now, operator, props[t[j], USERS])
                if unmet[operator] == 0:
                    ops[ready, READY] = operator
                    ready += 1
            ops[operator, FEEDS] = _link(edges, now, proposition, ops[operator, FEEDS])
            if most == 0 and last - first > 1:
                break
    return ready


@_compiled
def _offer(props: Ints, ops: Ints, edges: Ints, heap: list[int], operator: int) -> None:
    """Offer an operator, all it waited for being settled, to what it is wanted for."""
    price = ops[operator, SPENT]
    edge = ops[operator, FEEDS]
    while edge:
        proposition = edges[edge, ITEM]
        edge = edges[edge, NEXT]
        if price < props[proposition, COST]:
            props[proposition, COST] = price
            props[proposition, BEST] = operator
            heappush(heap, (price << SHIFT) | proposition)
        elif price == props[proposition, COST] and operator < props[proposition, BEST]:
            props[proposition, BEST] = operator


@_compiled
def _settle(s: Scratch, ready: int, left: int) -> bool:
    """Find the cheapest operators up to the wanted propositions; return whether all were met."""
    props, ops, edges, now = s.props, s.ops, s.edges, s.now
    heap = [NEVER]
    heap.pop()
    for i in range(ready):
        _offer(props, ops, edges, heap, ops[i, READY])
    while heap and left:
        key = heappop(heap)
        price, proposition = key >> SHIFT, key & MASK
        if price > props[proposition, COST]:
            continue
        if props[proposition, WANTED] == now[ROUND]:
            left -= 1
        edge = props[proposition, USERS]
        while edge:
            operator = edges[edge, ITEM]
            edge = edges[edge, NEXT]
            ops[operator, SPENT] += price
            ops[operator, WAITING] -= 1
            if ops[operator, WAITING] == 0:
                _offer(props, ops, edges, heap, operator)
    return left == 0


@_compiled
def _follow(t: Ints, s: Scratch, depth: int, preferred: Ints) -> tuple[int, int]:
    """Follow best supporters back from the stack: the number of actions, and of preferred ones."""
    props, ops, stack, unmet, false, now = s.props, s.ops, s.stack, s.unmet, s.false, s.now[ROUND]
    distance = 0
    count = 0
    while depth:
        depth -= 1
        operator = props[stack[depth], BEST]
        if ops[operator, FOLLOWED] == now:
            continue
        ops[operator, FOLLOWED] = now
        action = t[_span(t, ACTOR, operator)[0]]
        if ops[action, TAKEN] != now:
            ops[action, TAKEN] = now
            distance += 1
        if unmet[operator] == 0:
            preferred[count] = action
            count += 1
        first, last = _span(t, NEEDS, operator)
        for i in range(first, last):
            if false[t[i]]:
                stack[depth] = t[i]
                depth += 1
    return distance, count


@_compiled
def _estimate(t: Ints, s: Scratch, goal: Ints, preferred: Ints) -> tuple[int, int]:
    """Return distance and number of preferred actions, with repeats; distance -1: out of reach."""
    s.now[ROUND] += 1
    s.now[DEPTH] = 0
    s.now[EDGES] = 0
    for proposition in goal:
        if s.false[proposition]:
            _stack_need(s.props, s.stack, s.now, proposition)
            s.props[proposition, WANTED] = s.now[ROUND]
    left = int(s.now[DEPTH])
    if left == 0:
        return 0, 0
    if not _settle(s, _gather(t, s), left):
        return -1, 0
    depth = 0
    for proposition in goal:
        if s.false[proposition]:
            s.stack[depth] = proposition
            depth += 1
    return _follow(t, s, depth, preferred)


@_compiled
def _lack(t: Ints, s: Scratch, proposition: int, more: int) -> None:
    """Count a need more, or less, that is unmet for all who need the proposition."""
    first, last = _span(t, NEEDED_BY, proposition)
    for i in range(first, last):
        s.unmet[t[i]] += more


@_compiled
def scratch(t: Ints) -> Scratch:
    """Make working memory for one search at a time on this task; it can be used again."""
    fluents, links = t[FLUENTS], t[LINKS]
    props = np.empty((2 * fluents, PROPOSITION_COLUMNS), np.int64)
    props[:, :PROPOSITION_MARKS] = 0
    ops = np.empty((max(t[OPERATORS], t[ACTIONS]), OPERATOR_COLUMNS), np.int64)
    ops[:, :OPERATOR_MARKS] = 0
    edges = np.empty((links + 1, 2), np.int64)
    stack = np.empty(2 * fluents + links, np.int64)
    false = np.zeros(2 * fluents, np.uint8)
    false[:fluents] = 1
    spelled = np.zeros(fluents // 64 + 1, np.uint64)
    unmet = np.zeros(t[OPERATORS], np.int64)
    s = Scratch(np.zeros(3, np.int64), props, ops, edges, stack, false, spelled, unmet)
    for fluent in range(fluents):
        _lack(t, s, fluent, 1)
    return s


@_compiled
def _turn(t: Ints, s: Scratch, proposition: int) -> None:
    """Make a proposition false that was true, or true that was false."""
    s.false[proposition] ^= np.uint8(1)
    _lack(t, s, proposition, 1 if s.false[proposition] else -1)


@_compiled
def _spell(t: Ints, s: Scratch, row: Words) -> None:
    """Spell a state out where it differs from the one spelled before."""
    for word in range(len(row)):
        changed = row[word] ^ s.spelled[word]
        s.spelled[word] = row[word]
        fluent = word << 6
        while changed:
            if changed & np.uint64(1):
                _turn(t, s, fluent)
                _turn(t, s, t[FLUENTS] + fluent)
            changed >>= np.uint64(1)
            fluent += 1


@_compiled
def _is_true(t: Ints, row: Words, proposition: int) -> bool:
    """Whether a proposition is true in a state."""
    positive = proposition < t[FLUENTS]
    fluent = proposition if positive else proposition - t[FLUENTS]
    bit = (row[fluent >> 6] >> np.uint64(fluent & 63)) & np.uint64(1)
    return bool((bit == np.uint64(1)) == positive)


@_compiled
def _all_hold(t: Ints, row: Words, table: int, number: int) -> bool:
    """Whether every proposition of a list is true in a state."""
    first, last = _span(t, table, number)
    for i in range(first, last):  # noqa: SIM110 - numba compiles a loop
        if not _is_true(t, row, t[i]):
            return False
    return True


@_compiled
def _apply(t: Ints, action: int, before: Words, after: Words) -> None:
    """Write the state after an action; all deletes come before all adds."""
    after[:] = before
    first, last = _span(t, EFFECTS, action)
    for adding in range(2):
        for i in range(first, last):
            if not _all_hold(t, before, EFFECT_NEEDS, t[i]):
                continue
            begin, end = _span(t, ADDS if adding else DELETES, t[i])
            for j in range(begin, end):
                bit = np.uint64(1) << np.uint64(t[j] & 63)
                if adding:
                    after[t[j] >> 6] |= bit
                else:
                    after[t[j] >> 6] &= ~bit


@_compiled
def _same(left: Words, right: Words) -> bool:
    for i in range(len(left)):  # noqa: SIM110 - numba compiles a loop
        if left[i] != right[i]:
            return False
    return True


@_compiled
def _place(table: Ints, rows: Words, row: Words) -> int:
    """Where in the hash table the state stands, or would stand."""
    mixed = np.uint64(14695981039346656037)
    for word in row:
        mixed = (mixed ^ word) * np.uint64(1099511628211)
        mixed ^= mixed >> np.uint64(29)
    place = np.int64(mixed & np.uint64(len(table) - 1))
    while table[place] >= 0 and not _same(rows[table[place]], row):
        place = np.int64((place + 1) & (len(table) - 1))
    return int(place)


@_compiled
def _path(parents: Ints, via: Ints, state: int) -> Ints:
    """Return the actions that led to a state."""
    length = 0
    at = state
    while parents[at] >= 0:
        at = parents[at]
        length += 1
    path = np.zeros(length, np.int64)
    at = state
    while parents[at] >= 0:
        length -= 1
        path[length] = via[at]
        at = parents[at]
    return path


@_compiled
def _grown(numbers: Ints) -> Ints:
    """Twice the room, zeros at the end."""
    grown = np.zeros(2 * len(numbers), np.int64)
    grown[: len(numbers)] = numbers
    return grown


@_compiled
def _seen(room: int, width: int) -> Seen:
    rows = np.zeros((room, width), np.uint64)
    parents, via, upcoming = (
        np.zeros(room, np.int64),
        np.zeros(room, np.int64),
        np.zeros(room, np.int64),
    )
    return Seen(rows, parents, via, upcoming, np.full(4 * room, -1, np.int64))


@_compiled
def _with_room(seen: Seen, judged: int) -> Seen:
    """Return the same with twice the room where there is none for one state more."""
    room, width = seen.rows.shape
    if judged < room - 1:
        return seen
    rows = np.zeros((2 * room, width), np.uint64)
    rows[:room] = seen.rows
    table = np.full(8 * room, -1, np.int64)
    for i in range(judged):
        table[_place(table, rows, rows[i])] = i
    return Seen(rows, _grown(seen.parents), _grown(seen.via), _grown(seen.upcoming), table)


@_compiled
def _reach(t: Ints, seen: Seen, parent: int, action: int, judged: int) -> bool:
    """Write a child where the next state is to stand; return whether it is a new one."""
    child = seen.rows[judged]
    _apply(t, action, seen.rows[parent], child)
    return bool(seen.table[_place(seen.table, seen.rows, child)] < 0)


@_compiled
def _next_of(t: Ints, seen: Seen, parent: int, judged: int) -> int:
    """Write the parent's next unseen child; return the action that leads there, or -1."""
    upcoming, here = seen.upcoming, seen.rows[parent]
    while upcoming[parent] < t[ACTIONS]:
        action = int(upcoming[parent])
        upcoming[parent] += 1
        if _all_hold(t, here, ACTION_NEEDS, action) and _reach(t, seen, parent, action, judged):
            return action
    return -1


class Draft(NamedTuple):
    """A plan being refined: its steps and the states before each, and room to try others.

    ``rows`` has two rows more than states, ``linked`` says by use and maker
    which step was the last to bring about what another one needs.
    """

    steps: Ints
    tried: Ints
    rows: Words
    linked: Bytes


@_compiled
def _draft(start: Words, steps: Ints) -> Draft:
    length = len(steps)
    rows = np.zeros((length + 3, len(start)), np.uint64)
    rows[0] = start
    linked = np.zeros((length, length), np.uint8)
    return Draft(steps.copy(), steps.copy(), rows, linked)


@_compiled
def _is_met(t: Ints, row: Words, goal: Ints) -> bool:
    """Whether every proposition wanted is true in a state."""
    for proposition in goal:  # noqa: SIM110 - numba compiles a loop
        if not _is_true(t, row, proposition):
            return False
    return True


@_compiled
def _without(t: Ints, d: Draft, left_out: int, length: int, goal: Ints) -> int:
    """Try a plan without a step and what can then not be done.

    Return how many of the later steps are left, or -1 where the goal is lost.
    """
    here, there = len(d.rows) - 2, len(d.rows) - 1
    d.rows[here] = d.rows[left_out]
    left = 0
    for i in range(left_out + 1, length):
        step = d.steps[i]
        if _all_hold(t, d.rows[here], ACTION_NEEDS, step):
            _apply(t, step, d.rows[here], d.rows[there])
            here, there = there, here
            d.tried[left] = step
            left += 1
    return left if _is_met(t, d.rows[here], goal) else -1


@_compiled
def _without_needless(t: Ints, d: Draft, goal: Ints) -> int:
    """Drop needless steps, as ``refinement.without_needless`` does; return how many are left."""
    length, position = len(d.steps), 0
    while position < length:
        left = _without(t, d, position, length, goal)
        if left < 0:
            _apply(t, d.steps[position], d.rows[position], d.rows[position + 1])
            position += 1
        else:
            d.steps[position : position + left] = d.tried[:left]
            length, position = position + left, 0
    return length


@_compiled
def _runs(t: Ints, d: Draft, steps: Ints, length: int, goal: Ints) -> bool:
    """Write the states that steps lead through; return whether all can be done, to the goal."""
    for i in range(length):
        if not _all_hold(t, d.rows[i], ACTION_NEEDS, steps[i]):
            return False
        _apply(t, steps[i], d.rows[i], d.rows[i + 1])
    return _is_met(t, d.rows[length], goal)


@_compiled
def _link_needs(t: Ints, d: Draft, table: int, number: int, use: int) -> None:
    """Link a step with the last makers of what a list says that it needs."""
    first, last = _span(t, table, number)
    for i in range(first, last):
        for maker in range(use - 1, -1, -1):
            held = _is_true(t, d.rows[maker], t[i])
            if not held and _is_true(t, d.rows[maker + 1], t[i]):
                d.linked[use, maker] = 1
                break


@_compiled
def _link_steps(t: Ints, d: Draft, length: int) -> None:
    """Find the last makers of everything needed; the states must be those of the steps."""
    d.linked[:] = 0
    for use in range(length):
        _link_needs(t, d, ACTION_NEEDS, d.steps[use], use)
        first, last = _span(t, EFFECTS, d.steps[use])
        for i in range(first, last):
            if _all_hold(t, d.rows[use], EFFECT_NEEDS, t[i]):
                _link_needs(t, d, EFFECT_NEEDS, t[i], use)


@_compiled
def _deepest_maker(d: Draft, step: int, depth: Ints) -> int:
    """The step with the longest chain that serves a step and is not yet in the order, or -1."""
    best = -1
    for maker in range(step):
        if d.linked[step, maker] and depth[maker] > 0 and (best < 0 or depth[maker] > depth[best]):
            best = maker
    return best


@_compiled
def _chained(d: Draft, length: int) -> bool:
    """Try the order of ``refinement``'s chains; return whether it differs from the steps'."""
    depth = np.zeros(length, np.int64)  # and 0 for a step that is in the order
    for step in range(length):
        depth[step] = 1
        for maker in range(step):
            if d.linked[step, maker]:
                depth[step] = max(depth[step], depth[maker] + 1)
    stack = np.zeros(length + 1, np.int64)
    placed, differs = 0, False
    for step in range(length):
        if d.linked[step + 1 : length, step].any():
            continue
        height, stack[0] = 1, step
        while height:
            top = stack[height - 1]
            maker = _deepest_maker(d, top, depth)
            if maker >= 0:
                stack[height] = maker
                height += 1
                continue
            height -= 1
            depth[top] = 0
            differs = differs or top != placed
            d.tried[placed] = d.steps[top]
            placed += 1
    return differs


@_compiled
def _first_use(d: Draft, step: int, length: int) -> int:
    """The first step that needs what a step brings about; 0 where none does or it needs others."""
    if d.linked[step, :step].any():
        return 0
    for use in range(step + 1, length):
        if d.linked[use, step]:
            return use
    return 0


@_compiled
def _gather_steps(t: Ints, d: Draft, length: int, goal: Ints) -> None:
    """Move each step that needs nothing from the plan to just before its first use, last first."""
    for step in range(length - 2, -1, -1):
        first = _first_use(d, step, length)
        if first <= step + 1:
            continue
        d.tried[:length] = d.steps[:length]
        d.tried[step : first - 1] = d.steps[step + 1 : first]
        d.tried[first - 1] = d.steps[step]
        if _runs(t, d, d.tried, length, goal):
            d.steps[:length] = d.tried[:length]
        else:
            _runs(t, d, d.steps, length, goal)
        _link_steps(t, d, length)


@_compiled
def refined(t: Ints, start: Words, steps: Ints, goal: Ints) -> Ints:
    """Refine a plan as ``refinement.refined`` does; return its actions."""
    d = _draft(start, steps)
    length = _without_needless(t, d, goal)
    if length < 3:
        return d.steps[:length]
    _link_steps(t, d, length)
    if _chained(d, length):
        if _runs(t, d, d.tried, length, goal):
            return d.tried[:length]
        _runs(t, d, d.steps, length, goal)
        _gather_steps(t, d, length, goal)
    return d.steps[:length]


class Queues(NamedTuple):
    """Children along preferred actions, all parents, and how often each queue was served."""

    preferred: list[int]
    every: list[int]
    served: Ints


@_compiled
def _next_child(t: Ints, seen: Seen, queues: Queues, judged: int) -> tuple[int, int]:
    """Write the next state to judge; return its parent and action, -1 where there is none."""
    preferred, every, served = queues.preferred, queues.every, queues.served
    while len(preferred) or len(every):
        if len(preferred) and (not len(every) or served[0] <= served[1]):
            key = heappop(preferred)
            parent, action = (key >> ACTION) & MASK, key & ((1 << ACTION) - 1)
            if _reach(t, seen, parent, action, judged):
                served[0] += 1
                return parent, action
        else:
            parent = every[0] & MASK
            action = _next_of(t, seen, parent, judged)
            if action >= 0:
                served[1] += 1
                return parent, action
            heappop(every)
    return -1, -1


@_compiled
def search(t: Ints, s: Scratch, start: Words, goal: Ints, limits: Ints) -> tuple[int, Ints]:
    """Search as ``search.search`` does; return how it ended and the plan, refined.

    ``limits`` are the bound of expansions and what progress earns.
    """
    seen = _seen(64, len(start))
    seen.rows[0] = start
    chosen = np.empty(t[OPERATORS], np.int64)
    queues = Queues([NEVER], [NEVER], np.zeros(2, np.int64))
    queues.preferred.pop()
    queues.every.pop()
    best, judged, parent, action = NEVER, 0, -1, -1
    while True:
        seen = _with_room(seen, judged)
        seen.parents[judged], seen.via[judged] = parent, action
        seen.table[_place(seen.table, seen.rows, seen.rows[judged])] = judged
        _spell(t, s, seen.rows[judged])
        distance, count = _estimate(t, s, goal, chosen)
        if distance == 0:
            steps = _path(seen.parents, seen.via, judged)
            return SOLVED, refined(t, start, steps, goal)
        if distance < 0 and judged == 0:
            return EXHAUSTED, np.zeros(0, np.int64)
        if distance > 0:
            key = (distance << SHIFT) | judged
            heappush(queues.every, key)
            for i in range(count):
                heappush(queues.preferred, (key << ACTION) | chosen[i])
            if distance < best:
                best = distance
                queues.served[0] -= limits[1]
        judged += 1
        if judged > limits[0]:
            return BOUND, np.zeros(0, np.int64)
        parent, action = _next_child(t, seen, queues, judged)
        if parent < 0:
            return EXHAUSTED, np.zeros(0, np.int64)

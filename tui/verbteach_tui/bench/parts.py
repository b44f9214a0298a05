"""The parts of the benchmark by name: what each measures, as entries of the report."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from verbteach_tui.bench import dialogue, memory, painting, peers, planning, startup
from verbteach_tui.bench.allowance import Allowance
from verbteach_tui.bench.clock import percentiles
from verbteach_tui.bench.questions import spread
from verbteach_tui.bench.workbench import Workbench
from verbteach_tui.commands.streams import counting

Report = dict[str, Any]


def starting(bench: Workbench) -> Report:
    """How long the command takes to start."""
    bench.show("starting", 0, 2)
    version = startup.version_ms()
    bench.show("starting", 1, 2)
    painted = startup.first_paint_ms()
    bench.show("starting", 2, 2)
    return {"startup_ms": {"version": version, "first_paint": painted}}


def plans(bench: Workbench) -> Report:
    """How long a plan takes, with each path of the planner."""
    measured = []
    for path in bench.paths:
        done = counting(bench.show, f"planning, {path}", len(bench.questions))
        allowance = Allowance(bench.seconds / len(bench.paths))
        measured.append(planning.measure(bench.questions, path, done, allowance))
    *others, best = measured
    on = str(bench.data) if bench.data else "lessons"
    return {"plan_ms": {**best, "on": on, "other_paths": others}}


def turns(bench: Workbench) -> Report:
    """How long the robot takes to answer in a long session."""
    held = bench.turns
    longest, act = held.longest
    return {
        "turn_ms": percentiles(held.plain),
        "planned_turn_ms": percentiles(held.planned),
        "turns": {
            "before": held.before,
            "timed": len(held.plain) + len(held.planned),
            "longest_ms": longest,
            "longest_after": act,
            "path": bench.paths[-1],
        },
    }


def rates(bench: Workbench) -> Report:
    """How much the robot does in a second when nobody has to be waited for."""
    bench.show("repeating", 0, 2)
    talks = dialogue.dialogues_per_second(bench.settings, bench.lessons[0].scene)
    bench.show("repeating", 1, 2)
    allowance = Allowance(bench.seconds)
    episodes = dialogue.planned_episodes_per_second(bench.lessons, bench.settings, allowance)
    bench.show("repeating", 2, 2)
    return {"dialogues_per_s": talks, "planned_episodes_per_s": episodes}


def replay(bench: Workbench) -> Report:
    """How many events of a record are recomputed and compared in a second."""
    length = bench.amounts.replayed
    done = counting(bench.show, "a record to replay", length)
    # What was quick to teach is as quick to recompute: a third for the one, the rest for the other.
    allowance = Allowance(bench.seconds / 3)
    made = dialogue.long_session(
        bench.folder, bench.lessons, bench.settings, (0, length), allowance, done
    )
    return {"replay_events_per_s": dialogue.replayed_per_second(made.path, bench.settings)}


def keys(bench: Workbench) -> Report:
    """How long a key takes to show in the app, in a long session."""
    done = counting(bench.show, "keys to the screen", painting.PRESSED)
    found = painting.key_to_paint(bench.turns.path, bench.seconds, done, bench.without)
    return {"key_to_paint_ms": {kind: percentiles(times) for kind, times in found.items()}}


def held(bench: Workbench) -> Report:
    """How much memory the app holds after many turns."""
    done = counting(bench.show, "memory of the app", bench.amounts.app)
    # Every one of its turns is painted: this is the longest part.
    seconds = 3 * bench.seconds
    found = memory.app_memory(bench.folder, bench.amounts.app, seconds, done, bench.without)
    found = found or {"mb": None, "turns": None, "half_mb": None}
    return {
        "rss_mb": found["mb"],
        "rss": {"turns": found["turns"], "half_mb": found["half_mb"]},
    }


def others(bench: Workbench) -> Report:
    """Some of the same plans by the other planners that are installed."""
    some = spread(bench.questions, bench.amounts.peers_questions)
    done = counting(bench.show, "the same, verbteach", len(some))
    found = {"verbteach": planning.measure(some, bench.paths[-1], done)}
    texts = [question.pddl() for question in some]
    for name in peers.here():
        done = counting(bench.show, f"the same, {name}", len(texts))
        found[name] = peers.measure(name, texts, done)
    return {"peers": found}


PARTS: Mapping[str, Callable[[Workbench], Report]] = {
    "startup": starting,
    "plans": plans,
    "turns": turns,
    "keys": keys,
    "rates": rates,
    "replay": replay,
    "memory": held,
    "peers": others,
}
"""In the order in which they are measured."""

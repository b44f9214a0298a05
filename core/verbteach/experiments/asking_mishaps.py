"""Where a robot that asks goes wrong: each command that is not done exactly, put to one cause.

The counterpart of ``mishaps`` for learners that ask. A cause is what mends the
command when it is put right; the causes are tried in a fixed order, so that
they add up to all that is lost.
"""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from enum import Enum

from verbteach.experiments.asked_command import AskedCommand
from verbteach.experiments.asking_counterfactuals import MENDS, Outcomes, outcomes
from verbteach.experiments.asking_gains import Answered, answered
from verbteach.experiments.interactive_bench import Bench
from verbteach.experiments.interactive_protocol import Config, Policies, run
from verbteach.experiments.interactive_training import Heard, unheard
from verbteach.experiments.judging import Score
from verbteach.experiments.sight import stream
from verbteach.verbs.instance import Instance
from verbteach.world.fluents import Goal, Literal
from verbteach.world.plan import Action

EPSILON = 1e-9


class Cause(Enum):
    """Why a command was not done exactly, in the order in which causes are tried."""

    NOTHING_CHANGED = "the demonstration ends as it began"
    MISALIGNED = "the demonstration changes none of the objects spoken of"
    UNSEEN_VERB = "no lesson with the verb was kept"
    PLANNING = "a plan to the demonstrated change differs just as much"
    BELIEF = "the room was taken for another than it is"
    GROUNDING = "the goal was chosen for other objects"
    EARLY = "the robot stopped asking too early"
    EXECUTION = "the goal was chosen well and the plan did not bring it about"
    NO_CANDIDATE = "what was meant is no part of any candidate goal"
    UNSPOKEN = "what was left out is about things that the command does not name"
    UNLIKELY = "what was meant seemed too unlikely to ask about"


@dataclass(frozen=True)
class Examined:
    """A test command, how it went, and why; ``cause`` is None where it was done exactly.

    ``expected`` is the robot's own estimate of its score when it stopped asking.
    """

    instance: Instance
    outcomes: Outcomes
    expected: float
    wanted: Goal
    chosen: Goal
    plan: tuple[Action, ...]
    questions: tuple[Answered, ...]
    cause: Cause | None

    @property
    def sji(self) -> float:
        """As it went."""
        return self.outcomes.own.sji

    @property
    def lost(self) -> float:
        """What is missing to the full score."""
        return 1.0 - self.sji


@dataclass(frozen=True)
class Analysis:
    """Every test command of one run, by instance id."""

    commands: tuple[Examined, ...]

    def of(self, cause: Cause) -> tuple[Examined, ...]:
        """Those of a cause."""
        return tuple(one for one in self.commands if one.cause is cause)

    def verb(self, verb: str) -> tuple[Examined, ...]:
        """Those of a verb."""
        return tuple(one for one in self.commands if one.instance.verb == verb)

    @property
    def verbs(self) -> tuple[str, ...]:
        """The verbs, the most frequent first."""
        counts = Counter(one.instance.verb for one in self.commands)
        return tuple(sorted(counts, key=lambda verb: (-counts[verb], verb)))

    @property
    def lost(self) -> float:
        """The mean SJI that is missing to 1."""
        return self._mean([one.lost for one in self.commands])

    def lost_by(self, cause: Cause) -> float:
        """How much of that is the cause's."""
        return self._mean([one.lost for one in self.of(cause)])

    def score(self, mend: str) -> Score:
        """The mean score with one thing put right, by its name in ``MENDS``."""
        if mend not in MENDS:
            raise ValueError(f"nothing is put right by {mend!r}; there are {', '.join(MENDS)}")
        scores = [getattr(one.outcomes, mend) for one in self.commands]
        return Score(*(self._mean(list(part)) for part in zip(*scores, strict=True)))

    def _mean(self, values: list[float]) -> float:
        return sum(values) / len(self.commands)


class Examiner:
    """A witness of one run who looks into each test command, at little cost beside the run."""

    def __init__(self, config: Config) -> None:
        self._config = config
        self._found: dict[str, Examined] = {}

    def __call__(self, command: AskedCommand) -> None:
        """Look into a command: at a checkpoint's, which come later, it does not look."""
        if command.instance.id not in self._found:
            rng = stream(self._config.seed, self._config.run, "test", command.instance.id)
            self._found[command.instance.id] = _examined(command, answered(command, rng))

    def analysis(self) -> Analysis:
        """What was found."""
        return Analysis(tuple(self._found[name] for name in sorted(self._found)))


def analyse(
    bench: Bench, config: Config, policies: Policies | None = None, heard: Heard = unheard
) -> Analysis:
    """Carry out a configuration and look into each test command; see ``run``."""
    examiner = Examiner(config)
    run(bench, config, policies, heard, examiner)
    return examiner.analysis()


def _examined(command: AskedCommand, questions: tuple[Answered, ...]) -> Examined:
    known, pool = outcomes(command), command.end.pool
    return Examined(
        command.instance,
        known,
        0.0 if pool.empty else float(pool.decision.values.max()),
        command.human.change.literals,
        command.end.best,
        command.carried.plan,
        questions,
        _cause(command, known),
    )


def _cause(command: AskedCommand, known: Outcomes) -> Cause | None:
    instance, wanted = command.instance, command.human.change.literals
    spoken = frozenset(thing for objects in instance.candidates for thing in objects)
    if known.own.sji >= 1.0 - EPSILON:
        return None
    if not wanted:
        return Cause.NOTHING_CHANGED
    if not instance.changed_objects & spoken:
        return Cause.MISALIGNED
    if all(example.demonstration.verb != instance.verb for example in command.memory.examples):
        return Cause.UNSEEN_VERB
    left_out = [literal for literal in sorted(wanted) if literal not in command.end.best]
    return cause(known, _aside(left_out, spoken))


def _aside(literals: list[Literal], spoken: frozenset[str]) -> bool:
    """Whether at least half of the literals speak of nothing that the command names."""
    aside = sum(not spoken.intersection(literal.fluent.args) for literal in literals)
    return 2 * aside >= len(literals)


def cause(known: Outcomes, aside: bool) -> Cause:
    """The first thing which, put right, wins back half of what planning could win.

    Of a command that makes sense and whose verb was taught. Where nothing that
    the robot could still have asked or seen does, the goal was out of reach:
    ``aside`` says whether what it left out is about things not spoken of.
    """
    own, best = known.own.sji, known.goal.sji
    half = own + (best - own) / 2.0 - EPSILON
    if own >= best - EPSILON:
        return Cause.PLANNING
    mends = {
        Cause.BELIEF: known.seen.sji,
        Cause.GROUNDING: known.grounded.sji,
        Cause.EARLY: known.asked_on.sji,
        Cause.EXECUTION: known.chosen,
    }
    for name, score in mends.items():
        if score >= half:
            return name
    if known.answered.sji < half:
        return Cause.NO_CANDIDATE
    return Cause.UNSPOKEN if aside else Cause.UNLIKELY

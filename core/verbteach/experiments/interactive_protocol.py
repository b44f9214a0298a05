"""The interactive protocol: learn to ask, acquire verbs by asking, freeze, test elsewhere.

Fixed before any training (METHOD of the comparison): whole environments are
held out; of the training instances a share teaches the policy and the rest the
verbs; each test command gets one execution phase and one execution, nothing is
fed back. The weights for a held-out environment are trained on none of its
group of environments. Draws depend on seed, run and instance, so that every
policy meets the same noise.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass, field
from typing import Any

import numpy as np

from verbteach.collecting import without_collecting
from verbteach.dialogue.acts import IncludeFluent
from verbteach.dialogue.execution_inquiry import ExecutionInquiry
from verbteach.dialogue.learning_inquiry import LearningInquiry
from verbteach.experiments.asked_command import AskedCommand, Witness, unwitnessed
from verbteach.experiments.carrying_out import Carried, carry_out
from verbteach.experiments.instance_split import InstanceSplit
from verbteach.experiments.interactive import Dialogue, asked_on, hold
from verbteach.experiments.interactive_bench import Bench
from verbteach.experiments.interactive_results import Checkpoint, Result, Taught, Tested
from verbteach.experiments.interactive_training import (
    Heard,
    Practice,
    Remembering,
    Trained,
    TrainingParameters,
    train,
    unheard,
)
from verbteach.experiments.sight import stream
from verbteach.experiments.simulated_human import HumanParameters, SimulatedHuman
from verbteach.perception.noise import NoiseModel
from verbteach.policy.asking_on import asking_on
from verbteach.policy.asking_policy import AskingPolicy
from verbteach.policy.fixed_rules import ManualPolicy, RandomPolicy, SilentPolicy, SplitPolicy
from verbteach.policy.linear import LinearPolicy, Weights
from verbteach.policy.weights_file import EXECUTION, LEARNING
from verbteach.verbs.examples import Example, Memory
from verbteach.verbs.instance import Instance
from verbteach.verbs.lifting import lift
from verbteach.verbs.space import Demonstration


@dataclass(frozen=True)
class Config:
    """One run of one policy at one noise level; equal configurations give equal results.

    ``policy``: ``rl``, ``manual``, ``random``, ``split`` or ``silent``.
    ``policy_share`` of the training instances teach the policy, and
    ``verb_share`` of the rest the verbs. ``held_out`` are the environments to
    test in (all where empty); ``groups`` how many groups of environments the
    weights are trained for. ``together``: the held-out environments are one
    group, from which nothing is learned at all; otherwise each is tested with
    the verbs of all others. ``checkpoints``: the tests are also made with these
    shares of the lessons that teach verbs. ``trace`` scores each test command
    after every question, asked on beyond the policy's own end. ``keep_wrong``
    keeps goals that the human rejected. ``trust`` is the probability with
    which the robot takes a yes or no for right: below 1 an answer makes things
    likelier and settles nothing.
    """

    policy: str = "rl"
    noise: str = "perfect"
    reading: str = "literal"
    seed: int = 0
    run: int = 0
    split_cap: float = 3.0
    policy_share: float = 0.25
    verb_share: float = 1.0
    groups: int = 4
    held_out: tuple[str, ...] = ()
    together: bool = False
    checkpoints: tuple[float, ...] = ()
    trace: bool = False
    keep_wrong: bool = False
    trust: float = 1.0
    human: HumanParameters = field(default_factory=HumanParameters)
    training: TrainingParameters = field(default_factory=TrainingParameters)

    def __post_init__(self) -> None:
        if self.together and not self.held_out:
            raise ValueError("environments are held out together, and none is named")

    def to_json(self) -> dict[str, Any]:
        """Plain JSON: what the row of a sweep is keyed by."""
        return asdict(self)


@dataclass(frozen=True)
class Policies:
    """The policies of both phases."""

    learning: AskingPolicy
    execution: AskingPolicy


def run(
    bench: Bench,
    config: Config,
    policies: Policies | None = None,
    heard: Heard = unheard,
    witness: Witness = unwitnessed,
) -> Result:
    """Carry out one configuration; with ``policies`` none is trained, and those are tested.

    ``heard`` is told of each dialogue: in the stages ``learning`` and
    ``execution`` its return, in ``lessons`` 1 for a goal judged right, in
    ``tests`` the SJI. ``witness`` is told of each test command, at checkpoints too.
    """
    with without_collecting():
        return _Run(bench, config, policies, heard, witness).result()


@dataclass(frozen=True)
class Learned:
    """Both phases' policies, trained with nothing held out, and the verbs acquired in between."""

    learning: Trained
    execution: Trained
    taught: tuple[Taught, ...]


def learn(bench: Bench, configs: Sequence[Config], heard: Heard = unheard) -> Learned:
    """Train both policies on every instance of the bench, as each configuration has it.

    Configurations differ in noise, so that one policy meets every level; the
    first one's training parameters and seed hold. A command is practised
    without examples from its own environment. Raises ``ValueError`` where
    there is nothing to practise on. ``heard`` as in :func:`run`.
    """
    runs = [_Run(bench, config, None, heard) for config in configs]
    first = runs[0]
    shown = [practice for one in runs for practice in one.demonstrations()]
    learning = train(
        shown, LEARNING, first.config.training, first.draws("learning"), first.told("learning")
    )
    policy = LinearPolicy(learning.weights)
    commanded = [practice for one in runs for practice in one.commands(policy)]
    execution = train(
        commanded,
        EXECUTION,
        first.config.training,
        first.draws("execution"),
        first.told("execution"),
    )
    return Learned(learning, execution, tuple(taught for one in runs for taught in one.taught))


class _Acquired(dict[str, Example]):
    """Examples by instance id."""


class _Run:
    def __init__(
        self,
        bench: Bench,
        config: Config,
        policies: Policies | None = None,
        heard: Heard = unheard,
        witness: Witness = unwitnessed,
    ) -> None:
        self.bench = bench
        self.heard = heard
        self.witness = witness
        self.config = config
        self.policies = policies
        noise = NoiseModel.named(config.noise, config.reading)
        self.sight = bench.sight(noise, config.seed, config.run)
        self.environments = sorted({i.environment for i in bench.instances})
        self.split = InstanceSplit.of(bench.instances, config)
        self.quarter = self.split.practice
        self.lessons = self.split.lessons(config.verb_share)
        self.taught: list[Taught] = []
        self.weights: dict[str, Mapping[str, float]] = {}
        self.checkpoints: dict[int, list[Tested]] = {}

    def result(self) -> Result:
        """Every group of held-out environments in turn."""
        tested = _sorted(row for group in self._groups() for row in self._group(group))
        questions: Counter[str] = Counter()
        for one in self.taught:
            questions.update(one.questions)
        taught = Taught(
            sum(one.dialogues for one in self.taught),
            sum(one.right for one in self.taught),
            dict(sorted(questions.items())),
        )
        checkpoints = (Checkpoint(n, _sorted(rows)) for n, rows in self.checkpoints.items())
        return Result(tested, taught, self.weights, tuple(checkpoints))

    def told(self, stage: str) -> Callable[[int, float], None]:
        """What a training tells of its dialogues, told on."""
        total = self.config.training.dialogues
        return lambda done, figure: self.heard(stage, done, total, figure)

    def demonstrations(self) -> list[Practice[LearningInquiry]]:
        """Every demonstration as a situation to practise on."""
        return [self._demonstration_practice(i) for i in self.bench.instances]

    def commands(self, policy: AskingPolicy) -> list[Practice[ExecutionInquiry]]:
        """Every command as one, with the verbs that ``policy`` acquires in the others' rooms."""
        self.lessons = list(self.bench.instances)
        acquired = self._acquire(policy)
        memories = {name: self._memory(acquired, {name}) for name in self.environments}
        return [self._command_practice(i, memories[i.environment]) for i in self.bench.instances]

    def draws(self, *names: str) -> np.random.Generator:
        """A generator for what the names tell apart, from the configuration's seed and run."""
        return stream(self.config.seed, self.config.run, *names)

    @property
    def _learns(self) -> bool:
        return self.config.policy == "rl" and self.policies is None

    def _groups(self) -> list[list[str]]:
        if self.config.together:
            return [sorted(self.config.held_out)]
        order = stream(self.config.seed, self.config.run, "groups").permutation(
            len(self.environments)
        )
        groups = [
            [self.environments[i] for i in sorted(part.tolist())]
            for part in np.array_split(order, self.config.groups if self._learns else 1)
        ]
        return [group for group in groups if self._wanted(group)]

    def _wanted(self, group: Sequence[str]) -> list[str]:
        held_out = self.config.held_out or tuple(self.environments)
        return [name for name in group if name in held_out]

    def _group(self, group: Sequence[str]) -> Iterator[Tested]:
        name = " ".join(group)
        practice = [i for i in self.quarter if i.environment not in group]
        learning = self._learning_policy(practice, name)
        acquired = self._acquire(learning)
        execution = self._execution_policy(practice, group, acquired, name)
        for environment in self._wanted(group):
            own = [i for i in self.bench.instances if i.environment == environment]
            memory = self._memory(acquired, {environment})
            for number, instance in enumerate(own, start=1):
                tested_now = self._test(instance, memory, execution, self.config.trace)
                self.heard("tests", number, len(own), tested_now.sji)
                yield tested_now
            for share in self.config.checkpoints:
                lessons = self.split.lessons(share)
                memory = self._memory(acquired, {environment}, lessons)
                tested = [self._test(i, memory, execution, trace=False) for i in own]
                self.checkpoints.setdefault(len(lessons), []).extend(tested)

    def _learning_policy(self, practice: Sequence[Instance], name: str) -> AskingPolicy:
        if self.policies is not None:
            return self.policies.learning
        if not self._learns:
            return _rule(self.config)
        situations = [self._demonstration_practice(i) for i in practice]
        rng = self.draws("learning", name)
        trained = train(situations, LEARNING, self.config.training, rng, self.told("learning"))
        return self._keep("learning " + name, trained.weights)

    def _execution_policy(
        self,
        practice: Sequence[Instance],
        group: Sequence[str],
        acquired: Mapping[str, Example],
        name: str,
    ) -> AskingPolicy:
        if self.policies is not None:
            return self.policies.execution
        if not self._learns:
            return _rule(self.config)
        memories = {
            environment: self._memory(acquired, {environment, *group})
            for environment in sorted({i.environment for i in practice})
        }
        situations = [self._command_practice(i, memories[i.environment]) for i in practice]
        rng = self.draws("execution", name)
        trained = train(situations, EXECUTION, self.config.training, rng, self.told("execution"))
        return self._keep("execution " + name, trained.weights)

    def _keep(self, name: str, weights: Weights) -> LinearPolicy:
        self.weights[name] = weights.to_json()
        return LinearPolicy(weights)

    def _demonstration_practice(self, instance: Instance) -> Practice[LearningInquiry]:
        human = self._human(instance)
        start = self.bench.demonstration(instance, self.sight, self.config.trust)
        return Practice(start, human, lambda held: float(human.right_goal(held.state.goal)))

    def _command_practice(self, instance: Instance, memory: Memory) -> Practice[ExecutionInquiry]:
        human, gold = self._human(instance), self.bench.gold(instance)
        start = self.bench.command(instance, self.sight, memory, self.config.trust)
        right_from = self.config.human.right_from

        def right(held: Dialogue[ExecutionInquiry]) -> float:
            score = carry_out(held.state, human, gold).sji
            return score if self.config.training.graded else float(score >= right_from)

        return Practice(start, human, right)

    def _acquire(self, policy: AskingPolicy) -> _Acquired:
        """Teach the verbs: one learning phase for each lesson."""
        acquired = _Acquired()
        questions: Counter[str] = Counter()
        right = 0
        for number, instance in enumerate(self.lessons, start=1):
            human = self._human(instance)
            start = self.bench.demonstration(instance, self.sight, self.config.trust)
            rng = self.draws("acquire", instance.id)
            held = hold(start, policy, human, self.config.training.priced, rng)
            questions.update(held.questions)
            if isinstance(held.ended_with, IncludeFluent):
                good = human.right_goal(held.state.goal)
                right += good
                if good or self.config.keep_wrong:
                    acquired[instance.id] = self._example(instance, held.state)
            self.heard("lessons", number, len(self.lessons), float(instance.id in acquired))
        self.taught.append(Taught(len(self.lessons), right, questions))
        return acquired

    def _example(self, instance: Instance, state: LearningInquiry) -> Example:
        surroundings = self.bench.room(instance).surroundings
        change, binding = lift(state.goal, state.objects, surroundings)
        shown = Demonstration(instance.id, instance.verb, instance.phrases, state.objects)
        return Example(shown, change, binding)

    def _memory(
        self,
        acquired: Mapping[str, Example],
        without: set[str],
        lessons: Sequence[Instance] | None = None,
    ) -> Memory:
        return Memory.keeping(
            acquired[i.id]
            for i in (self.lessons if lessons is None else lessons)
            if i.id in acquired and i.environment not in without
        )

    def _test(
        self, instance: Instance, memory: Memory, policy: AskingPolicy, trace: bool
    ) -> Tested:
        human, gold = self._human(instance), self.bench.gold(instance)
        start = Remembering(self.bench.command(instance, self.sight, memory, self.config.trust))
        rng = self.draws("test", instance.id)
        last = hold(start, policy, human, self.config.training.priced, rng).state
        held = last.state
        carried = carry_out(held, human, gold)
        self.witness(
            AskedCommand(instance, human, memory, policy, start.state, held, gold, carried)
        )

        def again(state: Remembering[ExecutionInquiry]) -> Carried:
            return carried if state is last else carry_out(state.state, human, gold)

        traced: tuple[Carried, ...] = ()
        if trace:
            rng = self.draws("trace", instance.id)
            traced = asked_on(start, again, asking_on(policy), human, rng)
        pool = held.pool
        return Tested(
            instance.id,
            instance.group,
            carried.ied,
            carried.sji,
            carried.sji >= self.config.human.right_from,
            0.0 if pool.empty else float(pool.decision.values.max()),
            0.0 if pool.empty else pool.certainty,
            dict(sorted(Counter(act.name for act in held.asked).items())),
            tuple((one.ied, one.sji) for one in traced),
        )

    def _human(self, instance: Instance) -> SimulatedHuman:
        return self.bench.human(instance, self.config.human.teaching(instance.id))


def _sorted(tested: Iterable[Tested]) -> tuple[Tested, ...]:
    return tuple(sorted(tested, key=lambda one: one.instance))


def _rule(config: Config) -> AskingPolicy:
    rules: dict[str, AskingPolicy] = {
        "manual": ManualPolicy(),
        "random": RandomPolicy(),
        "split": SplitPolicy(config.split_cap),
        "silent": SilentPolicy(),
    }
    if config.policy not in rules:
        raise ValueError(f"no policy {config.policy!r}; there are rl, {', '.join(rules)}")
    return rules[config.policy]

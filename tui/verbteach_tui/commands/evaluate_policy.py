"""Scoring question policies, and robots that somebody taught, for `verbteach evaluate`."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeAlias

from verbteach_tui.commands.streams import Progress
from verbteach_tui.conclusion import WrongUseError

if TYPE_CHECKING:
    from verbteach.experiments.asked_command import Witness
    from verbteach.experiments.interactive_bench import Bench
    from verbteach.experiments.interactive_protocol import Config, Policies
    from verbteach.experiments.interactive_results import Result
    from verbteach.policy.asking_policy import AskingPolicy
    from verbteach.verbs.instance import Instance
    from verbteach_scenarios.grounds import EvaluationData
    from verbteach_scenarios.laboratories import LaboratorySource
    from verbteach_sessions.learned import Taught

Spread: TypeAlias = "Callable[[Sequence[int]], list[Result]]"
"""Holds the runs of these numbers, elsewhere, in their order."""

LEARNED = "rl"
RULES = ("manual", "random", "split", "silent")


@dataclass(frozen=True)
class Question:
    """What is asked of the evaluation: policy, eyes, where objects come from, how often."""

    policy: str | None
    noise: str
    reading: str
    grounding: str
    runs: int
    seed: int
    weights: Path | None

    @property
    def about_asking(self) -> bool:
        """Whether it is about a policy that asks."""
        return self.policy in (LEARNED, *RULES) or self.weights is not None

    def check(self) -> None:
        """Raise :class:`WrongUseError` where the parts do not go together."""
        if self.policy not in (None, LEARNED, *RULES):
            raise WrongUseError(f"a policy that asks is {LEARNED}, {', '.join(RULES)}")
        if self.weights is not None and self.policy not in (None, LEARNED):
            raise WrongUseError(f"--weights is for --policy {LEARNED}")
        given_policies(self)  # a file that does not fit is told before the data is read

    def config(self, run: int, apart: tuple[str, ...]) -> Config:
        """The configuration of one run, which tests in ``apart`` where it names environments."""
        from verbteach.experiments.interactive_protocol import Config

        return Config(
            self.policy or LEARNED,
            self.noise,
            self.reading,
            seed=self.seed,
            run=run,
            held_out=apart,
            together=bool(apart),
        )


def policy_document(
    asked: Question,
    data: EvaluationData,
    show: Progress,
    witness: Witness | None = None,
    spread: Spread | None = None,
) -> dict[str, Any]:
    """A policy learns to ask in some rooms, acquires verbs and is tested in the others.

    Test data is tested in one go, with nothing of it learned. ``witness`` is
    told of the first run's test commands, unless ``spread`` holds the runs elsewhere.
    """
    from verbteach.experiments.figures import Observation
    from verbteach.experiments.policy_scores import policy_scores

    if spread is None:
        results = _held_here(asked, data, show, witness)
    else:
        results = spread(range(asked.runs))
    learning = [
        [Observation("lessons", sum(one.taught.questions.values()) / max(1, one.taught.dialogues))]
        for one in results
    ]
    scores = policy_scores([one.tested for one in results], learning, asked.seed)
    return {"policy": asked.policy or LEARNED, "grounding": asked.grounding, **scores}


def _held_here(
    asked: Question, data: EvaluationData, show: Progress, witness: Witness | None
) -> list[Result]:
    from verbteach.experiments.asked_command import unwitnessed
    from verbteach.experiments.interactive_protocol import run

    bench, policies = bench_for(asked, data), given_policies(asked)
    results = []
    for number in range(asked.runs):
        show("runs", number, asked.runs)
        told = (witness if number == 0 else None) or unwitnessed
        config = asked.config(number, data.apart)
        results.append(run(bench, config, policies, staged(show), told))
    show("runs", asked.runs, asked.runs)
    return results


@dataclass(frozen=True)
class Held:
    """Holds a run in whatever process it is in, which reads the data once."""

    asked: Question
    source: LaboratorySource

    def __call__(self, number: int) -> Result:
        """The run of that number."""
        from verbteach.experiments.interactive_protocol import run
        from verbteach_scenarios.laboratories import laboratory

        where = laboratory(self.source)
        return run(where.bench, self.asked.config(number, where.apart), given_policies(self.asked))


def taught_document(
    source: Path, asked: Question, data: EvaluationData, show: Progress
) -> dict[str, Any]:
    """A robot that was taught in a session, on the commands of rooms that it was not taught in."""
    from verbteach.dialogue.asking import confirmed_memory
    from verbteach.experiments.examination import Examination, Pupil
    from verbteach.experiments.figures import Observation
    from verbteach.experiments.policy_scores import policy_scores
    from verbteach.perception.noise import NoiseModel
    from verbteach_sessions.learned import taught_by
    from verbteach_sessions.method import knowledge_of

    taught = taught_by(source)
    knowledge, _ = knowledge_of(taught.source.records)
    if not knowledge.verbs:
        raise WrongUseError(f"{source}: the robot learned no verb in this session")
    rooms = {space.demonstration.id.split("#", 1)[0] for space in knowledge.spaces}
    bench = bench_for(asked, data)
    commands = _elsewhere(bench, rooms, source)
    pupil = Pupil(confirmed_memory(knowledge), _way_of_asking(asked, taught))
    noise = NoiseModel.named(asked.noise, asked.reading)
    exam = Examination(bench, commands, noise, asked.seed)
    total = asked.runs * len(commands)
    held = [
        exam.held(pupil, number, _counted(show, number * len(commands), total))
        for number in range(asked.runs)
    ]
    each = [Observation(f"lesson {i}", float(n)) for i, n in enumerate(taught.asked or (0,))]
    learning = [each] * asked.runs
    known = sum(one.verb in knowledge.verbs for one in commands)
    return {
        "policy": pupil.policy.name,
        "grounding": asked.grounding,
        "from": str(source),
        "verbs": list(knowledge.verbs),
        "commands_of_known_verbs": known,
        **policy_scores(held, learning, asked.seed),
    }


def staged(show: Progress) -> Callable[[str, int, int, float], None]:
    """``show`` for the stages of an experiment, whose figures it leaves out."""
    return lambda stage, done, total, _: show(stage, done, total)


def bench_for(asked: Question, data: EvaluationData) -> Bench:
    """The bench that is asked for."""
    from verbteach_scenarios.benches import bench_grounded

    return bench_grounded(data, asked.grounding)


def given_policies(asked: Question) -> Policies | None:
    """The policies of a file of weights; none where they are to be trained, or are rules."""
    from verbteach.experiments.interactive_protocol import Policies
    from verbteach.policy.linear import LinearPolicy
    from verbteach_scenarios.weights import load_weights

    if asked.weights is None:
        return None
    trained = load_weights(asked.weights)
    return Policies(LinearPolicy(trained.learning), LinearPolicy(trained.execution))


def _way_of_asking(asked: Question, taught: Taught) -> AskingPolicy:
    """As the command line names it, else as the session's robot has learned to ask."""
    from verbteach.policy.fixed_rules import ManualPolicy, RandomPolicy, SilentPolicy, SplitPolicy
    from verbteach.policy.linear import LinearPolicy, Weights
    from verbteach.policy.weights_file import EXECUTION
    from verbteach_scenarios.weights import starting_weights

    rules = {rule.name: rule for rule in (ManualPolicy(), RandomPolicy(), SplitPolicy())}
    given, name = given_policies(asked), asked.policy or taught.method.policy.name
    if given is not None:
        return given.execution
    if name != LEARNED:
        return rules.get(name, SilentPolicy())
    if taught.policy is None:
        return LinearPolicy(starting_weights().execution)
    try:
        return LinearPolicy(Weights.from_json(EXECUTION, taught.policy.trained()["execution"]))
    except ValueError as error:
        raise WrongUseError(f"the session's weights do not fit this version: {error}") from error


def _elsewhere(bench: Bench, rooms: set[str], source: Path) -> list[Instance]:
    commands = [one for one in bench.instances if one.environment not in rooms]
    if not commands:
        raise WrongUseError(f"{source}: the robot was taught in every room that there is")
    return commands


def _counted(show: Progress, before: int, total: int) -> Callable[[int], None]:
    return lambda done: show("commands", before + done, total)

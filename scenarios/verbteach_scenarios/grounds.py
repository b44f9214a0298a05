"""What verb models are evaluated on: the corpus or the lessons, cut into folds, with their tasks.

Whole environments are held out, since that is what a new room is.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import product
from pathlib import Path

from verbteach.dialogue.lesson import Lesson
from verbteach.dialogue.setting import Settings
from verbteach.experiments.evaluation import Grounds
from verbteach.experiments.folds import Fold, held_out, leave_one_environment_out
from verbteach.language.frames import NounPhrase
from verbteach.language.lexicon import Lexicon
from verbteach.language.looks import Looks
from verbteach.language.morphology import is_plural, singular
from verbteach.language.own import Experience, ground_phrase
from verbteach.verbs.application import GroundingBelief, likeliest
from verbteach.verbs.instance import Instance
from verbteach.verbs.space import Demonstration
from verbteach.world import compiled
from verbteach.world.planner import PlannerConfig, SearchPlanner, make_planner
from verbteach.world.scene import Scene
from verbteach.world.simulator import run
from verbteach.world.task import Task
from verbteach_scenarios.errors import WorldFileError
from verbteach_scenarios.lexicon_file import load_lexicon
from verbteach_scenarios.tell_me_dave.corpus import Progress, read_corpus
from verbteach_scenarios.tell_me_dave.documents import Corpus
from verbteach_scenarios.tell_me_dave.errors import CorpusError
from verbteach_scenarios.tell_me_dave.instances import instances
from verbteach_scenarios.tell_me_dave.parting import TEST_DATA, Parting
from verbteach_scenarios.tell_me_dave.rooms import Rooms

TRAINING = PlannerConfig(expansions=500)
JOINT = 24
"""At most so many joint groundings of a command are weighed."""


def training_planner(task: Task) -> SearchPlanner:
    """A planner for evaluations: compiled where the extra is installed, and bounded tightly."""
    compiled.warm_up()
    return make_planner(task, TRAINING)


@dataclass(frozen=True)
class OwnGrounder:
    """The robot's own grounding: from names, looks and experience, the mapping unseen.

    ``scenes`` are the rooms by task key; what they look like is taken from the
    state an instance starts in.
    """

    scenes: Mapping[str, Scene]
    lexicon: Lexicon

    def __call__(self, instance: Instance, experience: Sequence[Demonstration]) -> GroundingBelief:
        """The grounding belief of a new command."""
        looks = Looks(self.scenes[instance.task_key], instance.start, self.lexicon)
        known = _experience(experience)
        each = [ground_phrase(_phrase(text), looks, known)[:JOINT] for text in instance.phrases]
        joint: list[tuple[tuple[str, ...], float]] = []
        for row in product(*each):
            probability = 1.0
            for _, one in row:
                probability *= one
            joint.append((tuple(thing for thing, _ in row), probability))
        return likeliest(tuple(joint), JOINT)


@dataclass(frozen=True)
class EvaluationData:
    """Folds with their tasks, and the robot's own way to ground phrases in them.

    ``apart`` are the environments of test data, which are none of those that are
    learned from whatever they look like; ``left_out`` names the documents that
    are not learned from since they are test data too.
    """

    grounds: Grounds
    own: OwnGrounder
    apart: tuple[str, ...] = ()
    left_out: tuple[str, ...] = ()


def of_corpus(
    data: Path, test: Path | None = None, progress: Progress | None = None
) -> EvaluationData:
    """A Tell Me Dave folder: each environment held out in turn, or learned from for ``test``.

    Raises ``CorpusError``; ``WorldFileError`` where nothing can be held out or learned from.
    """
    corpora = [read_corpus(folder, progress) for folder in (data, test) if folder is not None]
    parting = Parting.of(*corpora) if test is not None else None
    parts = [_part(one) for one in ((parting.learned, parting.tested) if parting else corpora)]
    learned, *tested = [part.instances for part in parts]
    away = [_set_apart(part) for part in tested]
    try:
        folds = held_out(learned, *away) if tested else leave_one_environment_out(learned)
    except ValueError as error:
        raise WorldFileError(data, 0, str(error)) from error
    apart = tuple(sorted({one.environment for part in away for one in part}))
    found = _in_folds(folds, parts)
    return replace(found, apart=apart, left_out=parting.left_out if parting else ())


def to_test(folder: Path, progress: Progress | None = None) -> EvaluationData:
    """A Tell Me Dave folder that is tested on as a whole. Raises ``CorpusError``."""
    part = _part(read_corpus(folder, progress))
    return _in_folds((Fold("test", (), part.instances),), [part])


def _in_folds(folds: tuple[Fold, ...], parts: Sequence[_Part]) -> EvaluationData:
    tasks = {key: task for part in parts for key, task in part.tasks.items()}
    scenes = {key: scene for part in parts for key, scene in part.scenes.items()}
    return EvaluationData(
        Grounds(folds, tasks, training_planner), OwnGrounder(scenes, load_lexicon())
    )


def _set_apart(test: Sequence[Instance]) -> tuple[Instance, ...]:
    """Test instances in environments of their own, so that they can be held out by name."""
    return tuple(replace(one, environment=one.environment + TEST_DATA) for one in test)


@dataclass(frozen=True)
class CorpusFolder:
    """A Tell Me Dave folder, and one to test on, read where they are needed in any process."""

    folder: Path
    test: Path | None = None

    def __call__(self) -> tuple[Grounds, OwnGrounder]:
        """Read them; see ``of_corpus``."""
        found = of_corpus(self.folder, self.test)
        return found.grounds, found.own


def of_lessons(lessons: Sequence[Lesson], settings: Settings) -> EvaluationData:
    """Lessons as instances, each scene held out in turn."""
    names = sorted({lesson.scene for lesson in lessons})
    rooms = {name: settings(name) for name in names}
    found = [_instance(lesson, rooms[lesson.scene].task, settings) for lesson in lessons]
    tasks = {name: room.task for name, room in rooms.items()}
    own = OwnGrounder({name: room.scene for name, room in rooms.items()}, load_lexicon())
    folds = leave_one_environment_out(found)
    return EvaluationData(Grounds(folds, tasks, training_planner), own)


@dataclass(frozen=True)
class _Part:
    """One folder of the corpus."""

    instances: tuple[Instance, ...]
    tasks: Mapping[str, Task]
    scenes: Mapping[str, Scene]


def _part(corpus: Corpus) -> _Part:
    rooms = Rooms.of(corpus)
    found = tuple(one.instance for one in instances(corpus, rooms=rooms))
    if not found:
        reason = "holds no clause with an action and an object that a noun phrase means"
        raise CorpusError(corpus.folder, 0, reason)
    keys = sorted({instance.task_key for instance in found})
    scenes = {key: rooms.rooms[key].scene(key, frozenset()) for key in keys}
    return _Part(found, {key: rooms.task(key) for key in keys}, scenes)


def _instance(lesson: Lesson, task: Task, settings: Settings) -> Instance:
    start = settings(lesson.scene).scene.initial
    candidates = tuple(lesson.grounding.values())
    return Instance(
        id=lesson.id,
        group=f"{lesson.scene}/{lesson.teacher}",
        environment=lesson.scene,
        verb=lesson.verb,
        phrases=tuple(phrase.lower() for phrase in lesson.grounding),
        candidates=candidates,
        grounding=tuple(objects[0] for objects in candidates),
        start=start,
        actions=lesson.demonstration,
        end=run(task, start, lesson.demonstration)[-1],
        goal=lesson.goal,
        task_key=lesson.scene,
    )


def _experience(demonstrations: Sequence[Demonstration]) -> Experience:
    return Experience.of(
        (phrase, thing, 1.0)
        for one in demonstrations
        for phrase, thing in zip(one.phrases, one.grounding, strict=True)
    )


def _phrase(text: str) -> NounPhrase:
    """A noun phrase of which only the words are known, as the corpus has them."""
    *before, head = text.split() or [text]
    return NounPhrase(text, singular(head), tuple(before), plural=is_plural(head))

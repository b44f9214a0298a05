"""How the sessions of this run begin and go on: what the command line named, in one place.

The home screen, a screen opened at once, the plain mode, a script and the
simulated teacher all get their sessions from here. Imports what is heavy only
when a session is opened, so that the home screen appears at once.
"""

from __future__ import annotations

import os
from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

from verbteach_tui.conclusion import WrongUseError
from verbteach_tui.eyes import check_kinds
from verbteach_tui.terminal import has_terminal, size_in_browser

if TYPE_CHECKING:
    from verbteach.dialogue.promise import Promise
    from verbteach.dialogue.setting import Setting, Settings
    from verbteach.policy.learned_policy import LearnedPolicy
    from verbteach.policy.weights_file import PolicyWeights
    from verbteach.world.domain import Domain
    from verbteach.world.scene import Scene
    from verbteach_scenarios.nlp.second_opinion import SecondOpinion
    from verbteach_sessions.header import Source
    from verbteach_sessions.learned import Taught
    from verbteach_sessions.method import Method
    from verbteach_sessions.session import Session

LEARNED, WRITTEN = "rl", "she16"
EXHAUSTIVE = 5
"""Changes up to which a person waits for a plan for every part of a demonstration's goal."""


@dataclass(frozen=True)
class Choices:
    """The method that a new session runs under, by the names on the command line.

    Without a ``policy`` the interface decides.
    ``weights`` is a file for the policy ``rl`` to begin with; with ``freeze`` it
    stays as it is. ``questions`` is the most it asks about one command.
    ``promise`` is the share of its executions that is to be right.
    """

    policy: str | None = None
    noise: str = "perfect"
    noise_reading: str = "literal"
    seed: int = 0
    second_opinion: bool = False
    weights: Path | None = None
    freeze: bool = False
    questions: int | None = None
    promise: float | None = None


@dataclass(frozen=True)
class Beginning:
    """What new sessions begin with, and where they are kept.

    ``interface`` is where the session is held (app, plain, script, simulated),
    ``teacher`` who teaches. ``scenes`` is the person's own folder of scenes;
    ``before`` a session whose verbs and weights new ones start with. ``opened`` holds the
    sessions of this run, the last one last.
    """

    folder: Path
    interface: str
    teacher: str = "human"
    scenes: Path | None = None
    choices: Choices = field(default_factory=Choices)
    participant: str | None = None
    before: Path | None = None
    study: Mapping[str, Any] | None = None
    opened: list[Session] = field(default_factory=list, compare=False)

    def setting(self, scene: str) -> Setting:
        """The scene made ready. Raises ``UnknownSceneError`` and ``WorldFileError``."""
        return self._settings(scene)

    def scene(self, scene: str) -> Scene:
        """The scene to look at, which is quicker. Raises as :meth:`setting` does."""
        from verbteach_scenarios.scenes import load_scene

        return load_scene(scene, self.scenes)

    def scene_ids(self) -> tuple[str, ...]:
        """The scenes there are. Raises ``WorldFileError`` where there is no such folder."""
        from verbteach_scenarios.scenes import scene_ids

        return scene_ids(self.scenes)

    def fluent_kinds(self) -> Collection[str]:
        """The kinds of fluents there are to see. Raises ``WorldFileError``."""
        from verbteach_scenarios.scenes import load_domain

        return load_domain(self.scenes).predicates

    @cached_property
    def method(self) -> Method:
        """The method by its names. Raises :class:`WrongUseError` for one that is not there."""
        if self.choices.second_opinion and self._second is None:
            raise WrongUseError("a second opinion needs the extra verbteach[nlp], not installed")
        from verbteach.dialogue.parameters import RobotParameters
        from verbteach.perception.noise import NoiseModel
        from verbteach.verbs.hypothesis import LearningParameters
        from verbteach_sessions.method import POLICIES, Method
        from verbteach_sessions.study.capping import capped

        chosen = self.choices
        policy = chosen.policy or self._usual_policy
        if policy not in POLICIES:
            has = ", ".join(POLICIES)
            raise WrongUseError(f"this version has no policy {policy!r}; it has: {has}")
        noise = NoiseModel.named(chosen.noise, chosen.noise_reading)
        check_kinds(noise, self._domains())
        # What was promised was calibrated with every part of a demonstration planned for.
        patience = None if chosen.promise is not None else EXHAUSTIVE
        learning = LearningParameters(exhaustive=patience)
        parameters = RobotParameters(seed=chosen.seed, noise=noise, learning=learning)
        if chosen.questions is not None:
            parameters = capped(parameters, chosen.questions)
        promise = None if chosen.promise is None else self._promise(policy, chosen.promise)
        if policy == LEARNED:
            learned = self._learned_policy()
            return Method(learned, parameters, chosen.second_opinion, promise)
        if chosen.weights is not None or chosen.freeze:
            raise WrongUseError(f"--weights and --freeze are for --policy {LEARNED}")
        named = Method.named(policy, parameters)
        return replace(named, second_opinion=chosen.second_opinion, promise=promise)

    def _domains(self) -> Iterator[Domain]:
        """What there may be to see, of each scene as it is asked for."""
        for scene in self.scene_ids():
            yield self.scene(scene).domain

    def _promise(self, policy: str, rate: float) -> Promise:
        """What the calibration that came with the weights supports for such eyes."""
        from verbteach.policy.calibration import UncalibratedError
        from verbteach.policy.stopping import UnkeepablePromiseError

        found, chosen = self._weights.calibrations, self.choices
        if found is None:
            raise WrongUseError(
                "--promise: these weights are not calibrated; verbteach train does that"
            )
        try:
            return found.promise(rate, policy, chosen.noise, chosen.noise_reading)
        except (UncalibratedError, UnkeepablePromiseError) as error:
            raise WrongUseError(f"--promise: {error}") from error

    @cached_property
    def _weights(self) -> PolicyWeights:
        """The file of weights that was chosen, else those that come with the robot."""
        from verbteach_scenarios.weights import load_weights, starting_weights

        chosen = self.choices.weights
        return starting_weights() if chosen is None else load_weights(chosen)

    @property
    def _usual_policy(self) -> str:
        """What asks where somebody is there to answer; what seldom asks for written lines.

        A script, and a pipe into the plain mode, cannot know which questions come.
        """
        if self.choices.weights is not None or self.choices.freeze:
            return LEARNED
        answering = self.interface in {"app", "browser", "simulated"}
        return LEARNED if answering or (self.interface == "plain" and has_terminal()) else WRITTEN

    def _learned_policy(self) -> LearnedPolicy:
        """As the file of weights has it, else as the earlier session left it, else as it comes."""
        from verbteach_sessions.method import starting_policy

        chosen = self.choices
        before = self._taught.policy if self._taught else None
        if chosen.weights is None and before is not None:
            return replace(before, frozen=chosen.freeze)
        return starting_policy(self._weights, frozen=chosen.freeze)

    @property
    def source(self) -> Source | None:
        """The verbs that the earlier session taught. Raises the errors of reading a record."""
        return self._taught.source if self._taught else None

    @cached_property
    def _taught(self) -> Taught | None:
        from verbteach_sessions.learned import taught_by

        return None if self.before is None else taught_by(self.before)

    def create(self, scene: str) -> Session:
        """A new session in a scene. Raises ``UnknownSceneError`` and ``SessionError``."""
        from verbteach_sessions.header import Header
        from verbteach_sessions.session import Session

        method = self.method
        if method.second_opinion and self._second is not None:
            self._second.begin()
        header = Header.new(
            scene,
            method,
            interface=self.interface,
            terminal=_terminal_size(),
            teacher=self.teacher,
            participant=self.participant,
            study=self.study,
            source=self.source,
        )
        return self._keep(Session.create(self.folder, header, self.setting))

    def resume(self, path: Path) -> Session:
        """Go on with the session in ``path``. Raises what ``Session.resume`` raises."""
        from verbteach_sessions.header import Machine
        from verbteach_sessions.session import Session

        machine = Machine.here(self.interface, _terminal_size())
        return self._keep(Session.resume(path, self.setting, machine=machine))

    @cached_property
    def _settings(self) -> Settings:
        from verbteach_scenarios.settings import make_settings

        return make_settings(self.scenes, self._second)

    @cached_property
    def _second(self) -> SecondOpinion | None:
        from verbteach_scenarios.nlp.second_opinion import if_installed

        return if_installed()

    def _keep(self, session: Session) -> Session:
        self.opened.append(session)
        return session


def _terminal_size() -> tuple[int, int] | None:
    try:
        size = os.get_terminal_size()
    except OSError:
        return size_in_browser()
    return size.columns, size.lines

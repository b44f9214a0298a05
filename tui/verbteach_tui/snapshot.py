"""Everything the teach screen shows at one moment, as plain values made from a session.

Made in a worker thread, right after the robot's turn; nothing in it changes
afterwards, so that the screen can draw it without a lock.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property

from verbteach.dialogue import acts
from verbteach.dialogue.moves import Phase
from verbteach.perception.belief import Belief
from verbteach.verbs.knowledge import VerbKnowledge
from verbteach.world.fluents import State
from verbteach_tui.hypotheses import Vocabulary
from verbteach_tui.reading import Reader
from verbteach_tui.views.believed import Believed
from verbteach_tui.views.cards import Emphasis
from verbteach_tui.views.dialogue import DialogueLine
from verbteach_tui.views.mind import Mind
from verbteach_tui.views.picture import Depictor, Picture
from verbteach_tui.views.read_back import GoalPart
from verbteach_tui.views.recorder import Change
from verbteach_tui.views.steps import StepMenu
from verbteach_tui.views.wording import Wording


@dataclass(frozen=True)
class Moment:
    """A world with the one before it, and in words what the step between them changed."""

    state: State
    before: State | None = None
    news: tuple[str, ...] = ()


@dataclass(frozen=True)
class Figures:
    """What the session has come to."""

    episodes: int
    successes: int
    questions: int
    reward: float
    verbs: int

    @property
    def texts(self) -> tuple[str, ...]:
        """In words, what matters most first."""
        return (
            f"verbs {self.verbs}",
            f"questions {self.questions}",
            f"commands {self.episodes}, {self.successes} done right",
            f"reward {self.reward:+g}",
        )


@dataclass(frozen=True)
class Snapshot:
    """A session between two acts of the teacher.

    ``moments`` are the worlds to show one after the other: one, or those of an
    execution. ``choices`` are the objects that digits pick. ``shown`` are the
    demonstrated steps in words, ``change`` what they have changed, ``parts`` the
    goal that was read back; ``shown_moments`` are the worlds before and after each
    of the steps. ``belief`` is what the robot saw when it got the command,
    ``consequence`` what the last answer came to.
    ``learned_from`` is what the robot knew before it
    learned last.
    """

    session: str
    scene: str
    phase: Phase
    lines: tuple[DialogueLine, ...]
    moments: tuple[Moment, ...]
    depictor: Depictor = field(repr=False)
    mind: Mind = field(repr=False)
    menu: StepMenu = field(repr=False)
    words: Vocabulary = field(repr=False)
    wording: Wording = field(repr=False)
    knowledge: VerbKnowledge = field(repr=False)
    learned_from: VerbKnowledge = field(repr=False)
    figures: Figures
    waiting: acts.RobotAct
    choices: Mapping[str, str] = field(default_factory=dict)
    asked: frozenset[str] = frozenset()
    command: str = ""
    problem: str = ""
    steps: tuple[str, ...] = ()
    failure: str = ""
    shown: tuple[str, ...] = ()
    shown_moments: tuple[Moment, ...] = ()
    change: tuple[Change, ...] = ()
    parts: tuple[GoalPart, ...] = ()
    suggested: str = ""
    consequence: str = ""
    can_undo: bool = False
    can_redo: bool = False
    belief: Belief | None = None
    ended: bool = False
    content_hash: str = ""

    @property
    def reader(self) -> Reader:
        """Reads what the teacher types now."""
        return Reader(self.phase, self.choices, self.menu)

    @property
    def emphasis(self) -> Emphasis:
        """What the question is about."""
        return Emphasis(self.asked, {thing: digit for digit, thing in self.choices.items()})

    @cached_property
    def believed(self) -> Picture | None:
        """The scene as the robot saw it; ``None`` between two commands."""
        if self.belief is None:
            return None
        seen = Believed.of(self.belief)
        return self.depictor.picture(seen.state, doubts=seen.doubts)

    @property
    def moment(self) -> Moment:
        """The world as it is now."""
        return self.moments[-1]

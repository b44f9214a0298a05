"""Everything the teach screen shows at one moment, as plain values made from a session.

Made in a worker thread, right after the robot's turn; nothing in it changes
afterwards, so that the screen can draw it without a lock.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from verbteach.dialogue import acts
from verbteach.dialogue.demonstration import ordered
from verbteach.dialogue.moves import Phase
from verbteach.dialogue.setting import Setting
from verbteach.dialogue.speech import Speech
from verbteach.dialogue.state import EpisodeState
from verbteach.dialogue.turn import RobotTurn, Trace
from verbteach.verbs.change import StateChange
from verbteach.verbs.knowledge import VerbKnowledge
from verbteach.world.fluents import Literal, State
from verbteach_sessions.session import Session
from verbteach_tui.hypotheses import Vocabulary
from verbteach_tui.keys import DIGITS
from verbteach_tui.minds import mind_of
from verbteach_tui.reading import Reader
from verbteach_tui.spoken import lines_of
from verbteach_tui.views.cards import Emphasis
from verbteach_tui.views.dialogue import DialogueLine
from verbteach_tui.views.marks import HIDDEN, stem
from verbteach_tui.views.mind import Mind
from verbteach_tui.views.picture import Depictor
from verbteach_tui.views.read_back import GoalPart
from verbteach_tui.views.steps import StepMenu
from verbteach_tui.views.wording import Wording

_NEWS = 3
_TRIFLES = HIDDEN | {"near"}


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


@dataclass(frozen=True)
class Snapshot:
    """A session between two acts of the teacher.

    ``moments`` are the worlds to show one after the other: one, or those of an
    execution. ``choices`` are the objects that digits pick. ``shown`` are the
    demonstrated steps in words, ``change`` what they have changed, ``parts`` the
    goal that was read back. ``learned_from`` is what the robot knew before it
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
    change: tuple[str, ...] = ()
    parts: tuple[GoalPart, ...] = ()
    suggested: str = ""
    can_undo: bool = False
    can_redo: bool = False
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

    @property
    def moment(self) -> Moment:
        """The world as it is now."""
        return self.moments[-1]


def take(session: Session, previous: Snapshot | None = None) -> Snapshot:
    """The session as it stands; what differs from ``previous`` is marked as changed."""
    robot, state, turn = session.robot, session.robot.state, session.turn
    setting, episode, totals = robot.setting, state.episode, state.totals
    speech = Speech.of(setting, state.world)
    depictor = _depictor(setting, previous)
    wording = Wording(depictor.labels, setting.lexicon)
    menu = StepMenu(setting.task, state.world, wording)
    if turn.phase is Phase.DEMONSTRATION:
        menu.prepare()
    words = Vocabulary(setting.scene.domain, setting.lexicon)
    learned_from = _learned_from(state.knowledge, previous)
    choices = _choices(turn.waiting_act, episode)
    shown = episode.demonstrated.actions if episode and episode.demonstrated else ()
    return Snapshot(
        session=session.path.name,
        scene=state.scene,
        phase=turn.phase,
        lines=lines_of(session, wording),
        moments=_moments(setting, speech, state.world, turn.trace, previous),
        depictor=depictor,
        mind=mind_of(state, learned_from, depictor.labels, speech, words,
                     previous.mind if previous else None),
        menu=menu,
        words=words,
        knowledge=state.knowledge,
        learned_from=learned_from,
        figures=Figures(totals.episodes, totals.successes, totals.questions, totals.reward,
                        len(state.knowledge.verbs)),
        waiting=turn.waiting_act,
        choices=choices,
        asked=_asked(turn.waiting_act),
        command=episode.command if episode else "",
        problem=_problem(turn),
        steps=tuple(wording.action(step) for step in turn.trace.done) if turn.trace else (),
        failure=_failure(turn.trace, wording),
        shown=tuple(wording.action(step) for step in shown),
        change=_change(setting, speech, episode, state.world),
        parts=_parts(speech, episode),
        suggested=state.suggested,
        can_undo=session.can_undo,
        can_redo=session.can_redo,
        ended=session.ended,
        content_hash=session.content_hash,
    )  # fmt: skip


def _depictor(setting: Setting, previous: Snapshot | None) -> Depictor:
    if previous is not None and previous.depictor.scene is setting.scene:
        return previous.depictor
    return Depictor(setting.scene)


def _learned_from(knowledge: VerbKnowledge, previous: Snapshot | None) -> VerbKnowledge:
    if previous is None or previous.knowledge == knowledge:
        return previous.learned_from if previous else knowledge
    return previous.knowledge


def _moments(
    setting: Setting, speech: Speech, world: State, trace: Trace | None, previous: Snapshot | None
) -> tuple[Moment, ...]:
    if trace is not None:
        first = Moment(trace.states[0])
        pairs = zip(trace.states, trace.states[1:], strict=False)
        return (first, *(_moment(setting, speech, old, new) for old, new in pairs))
    if previous is None or previous.depictor.scene is not setting.scene:
        return (Moment(world),)
    return (_moment(setting, speech, previous.moment.state, world),)


def _moment(setting: Setting, speech: Speech, old: State, new: State) -> Moment:
    change = StateChange.between(old, new, setting.scene.domain.static).literals
    told = [one for one in ordered(change) if stem(one.fluent.predicate) not in _TRIFLES]
    news = [speech.words.became(literal) for literal in told[:_NEWS]]
    more = [f"and {len(told) - _NEWS} more"] if len(told) > _NEWS else []
    return Moment(new, old, (*news, *more))


def _choices(waiting: acts.RobotAct, episode: EpisodeState | None) -> dict[str, str]:
    """The likeliest objects of the phrase that is asked about, by the digit that picks each."""
    if not isinstance(waiting, acts.NpGrdWhq) or episode is None:
        return {}
    objects = [thing for thing, _ in episode.grounding[waiting.np]]
    return dict(zip(DIGITS, objects, strict=False))


def _asked(waiting: acts.RobotAct) -> frozenset[str]:
    match waiting:
        case acts.NpGrdYnq(object=thing):
            return frozenset({thing})
        case acts.BulkNpGrdYnq(pairs=pairs):
            return frozenset(thing for _, thing in pairs)
        case acts.EnvPredYnq(fluent=fluent):
            return frozenset(fluent.args)
        case acts.GoalPredYnq(literal=literal) | acts.PredChangeYnq(literal=literal):
            return frozenset(literal.fluent.args)
        case acts.GoalRelevantYnq(literal=literal):
            return frozenset(literal.fluent.args)
    return frozenset()


def _problem(turn: RobotTurn) -> str:
    """Why what was tried last in a demonstration came to nothing, if it did."""
    if isinstance(turn.waiting_act, acts.RefuseStep | acts.AskAgain):
        return turn.texts[-1]
    return ""


def _failure(trace: Trace | None, wording: Wording) -> str:
    if trace is None or trace.failed is None:
        return ""
    return f"could not {wording.action(trace.failed)}: {trace.obstacle}"


def _change(
    setting: Setting, speech: Speech, episode: EpisodeState | None, world: State
) -> tuple[str, ...]:
    if episode is None or episode.demonstrated is None:
        return ()
    change = StateChange.between(episode.start, world, setting.scene.domain.static).literals
    return tuple(speech.words.became(literal) for literal in ordered(change))


def _parts(speech: Speech, episode: EpisodeState | None) -> tuple[GoalPart, ...]:
    """The goal's literals first, then what changed as well and is not kept."""
    read_back = episode.read_back if episode else None
    if read_back is None:
        return ()
    # The whole change stands in one order, so that a part struck out stays where it is.
    every = ordered(read_back.whole | read_back.goal)
    return tuple(_part(speech, one, one in read_back.goal) for one in every)


def _part(speech: Speech, literal: Literal, kept: bool) -> GoalPart:
    return GoalPart(
        literal, kept, speech.words.must(literal), f"need not: {speech.words.describe(literal)}"
    )

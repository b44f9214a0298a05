"""Looking at a session: each look makes a snapshot, and what stays the same is kept between looks.

Used in a worker thread, right after the robot's turn.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property, partial
from itertools import pairwise

from verbteach.dialogue import acts
from verbteach.dialogue.demonstration import ordered
from verbteach.dialogue.moves import Phase
from verbteach.dialogue.obstacles import obstacle
from verbteach.dialogue.setting import Setting
from verbteach.dialogue.speech import Speech
from verbteach.dialogue.state import EpisodeState
from verbteach.dialogue.turn import RobotTurn, Trace
from verbteach.verbs.change import StateChange
from verbteach.verbs.knowledge import VerbKnowledge
from verbteach.world.fluents import Literal, State
from verbteach_sessions.history import Node
from verbteach_sessions.session import Session
from verbteach_tui.consequences import consequence
from verbteach_tui.hypotheses import Vocabulary
from verbteach_tui.keys import DIGITS
from verbteach_tui.minds import mind_of
from verbteach_tui.snapshot import Figures, Moment, Snapshot
from verbteach_tui.spoken import Sayings
from verbteach_tui.views.marks import HIDDEN, stem
from verbteach_tui.views.picture import Depictor
from verbteach_tui.views.read_back import GoalPart
from verbteach_tui.views.recorder import Change
from verbteach_tui.views.steps import StepBook, StepMenu
from verbteach_tui.views.wording import Wording
from verbteach_tui.watched import Live, Watched

_NEWS = 3
_TRIFLES = HIDDEN | {"near"}


@dataclass(frozen=True)
class _Place:
    """What is needed to show one scene, whatever happens in it."""

    setting: Setting

    @cached_property
    def depictor(self) -> Depictor:
        return Depictor(self.setting.scene)

    @cached_property
    def wording(self) -> Wording:
        return Wording(self.depictor.labels, self.setting.lexicon, self.setting.scene.domain)

    @cached_property
    def steps(self) -> StepBook:
        return StepBook(self.setting.task, self.wording, partial(obstacle, self.setting))

    @cached_property
    def words(self) -> Vocabulary:
        return Vocabulary(self.setting.scene.domain, self.setting.lexicon)


class Observer:
    """Looks at one session, again and again."""

    def __init__(self, session: Session | Watched, previous: Snapshot | None = None) -> None:
        self._session = Live(session) if isinstance(session, Session) else session
        self._places: dict[str, _Place] = {}
        self._sayings = Sayings(lambda scene: self._place(scene).wording, self._came_of)
        self._previous = previous

    def look(self) -> Snapshot:
        """The session as it stands; what differs from the last look is marked as changed."""
        snapshot = self._looked(self._session, self._previous)
        self._previous = snapshot
        return snapshot

    def _place(self, scene: str) -> _Place:
        if scene not in self._places:
            self._places[scene] = _Place(self._session.settings(scene))
        return self._places[scene]

    def _came_of(self, session: Watched, turn: Node) -> str:
        """What the answer that a turn replies to came to."""
        before = session.state_after(turn.parent) if turn.parent else None
        after = session.state_after(turn)
        if before is None or after is None or before.scene != after.scene:
            return ""
        speech = Speech.of(self._place(after.scene).setting, after.world)
        return consequence(before.episode, after.episode, speech)

    def _looked(self, session: Watched, previous: Snapshot | None) -> Snapshot:
        state = session.state
        turn = state.turn
        place, episode, totals = self._place(state.scene), state.episode, state.totals
        speech = Speech.of(place.setting, state.world)
        wording, trace = place.wording, turn.trace
        learned_from = _learned_from(state.knowledge, previous)
        shown = episode.demonstrated.actions if episode and episode.demonstrated else ()
        steps = tuple(wording.action(step) for step in trace.done) if trace else ()
        failure = _failure(trace, wording)
        if trace is None and previous is not None and _still_judged(turn, previous):
            steps, failure = previous.steps, previous.failure
        menu = StepMenu(place.steps, state.world)
        if turn.phase is Phase.DEMONSTRATION:
            menu.prepare()
        lines = self._sayings.lines_of(session)
        return Snapshot(
            session=session.name,
            scene=state.scene,
            phase=turn.phase,
            lines=lines,
            consequence=self._sayings.outcome(session, session.turns()[-1]),
            moments=_moments(place.setting, speech, state.world, trace, previous),
            depictor=place.depictor,
            mind=mind_of(state, learned_from, wording.labels, speech, place.words,
                         previous.mind if previous else None, session.promise),
            menu=menu,
            words=place.words,
            wording=wording,
            knowledge=state.knowledge,
            learned_from=learned_from,
            figures=Figures(totals.episodes, totals.successes, totals.questions, totals.reward,
                            len(state.knowledge.verbs)),
            waiting=turn.waiting_act,
            choices=_choices(turn.waiting_act, episode),
            asked=_asked(turn.waiting_act),
            command=episode.command if episode else "",
            problem=_problem(turn),
            steps=steps,
            failure=failure,
            shown=tuple(wording.action(step) for step in shown),
            shown_moments=_shown(place.setting, speech, episode),
            change=_change(place.setting, speech, episode, state.world),
            parts=_parts(speech, episode),
            suggested=state.suggested,
            can_undo=session.can_undo,
            can_redo=session.can_redo,
            belief=episode.belief if episode else None,
            ended=session.ended,
            content_hash=session.content_hash,
        )  # fmt: skip


def _learned_from(knowledge: VerbKnowledge, previous: Snapshot | None) -> VerbKnowledge:
    if previous is None or previous.knowledge == knowledge:
        return previous.learned_from if previous else knowledge
    return previous.knowledge


def _still_judged(turn: RobotTurn, previous: Snapshot) -> bool:
    """Whether the execution that was shown last still waits for its verdict."""
    return turn.phase is previous.phase is Phase.JUDGEMENT


def _moments(
    setting: Setting, speech: Speech, world: State, trace: Trace | None, previous: Snapshot | None
) -> tuple[Moment, ...]:
    if trace is not None:
        first = Moment(trace.states[0])
        pairs = zip(trace.states, trace.states[1:], strict=False)
        return (first, *(_moment(setting, speech, old, new) for old, new in pairs))
    if previous is None or previous.scene != setting.scene.id:
        return (Moment(world),)
    return (_moment(setting, speech, previous.moment.state, world),)


def _moment(setting: Setting, speech: Speech, old: State, new: State) -> Moment:
    change = StateChange.between(old, new, setting.scene.domain.static).literals
    told = [one for one in ordered(change) if not _is_trifle(one)]
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
    if isinstance(turn.waiting_act, acts.RefuseStep | acts.RefuseRevision | acts.AskAgain):
        return turn.texts[-1]
    return ""


def _failure(trace: Trace | None, wording: Wording) -> str:
    if trace is None or trace.failed is None:
        return ""
    return f"could not {wording.action(trace.failed)}: {trace.obstacle}"


def _change(
    setting: Setting, speech: Speech, episode: EpisodeState | None, world: State
) -> tuple[Change, ...]:
    if episode is None or episode.demonstrated is None:
        return ()
    change = StateChange.between(episode.start, world, setting.scene.domain.static).literals
    return tuple(Change(speech.words.became(one), _is_trifle(one)) for one in ordered(change))


def _is_trifle(literal: Literal) -> bool:
    return stem(literal.fluent.predicate) in _TRIFLES


def _shown(setting: Setting, speech: Speech, episode: EpisodeState | None) -> tuple[Moment, ...]:
    """The world before the demonstration and after each of its steps."""
    if episode is None or episode.demonstrated is None:
        return ()
    states = episode.demonstrated.states
    after = (_moment(setting, speech, old, new) for old, new in pairwise(states))
    return (Moment(states[0]), *after)


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

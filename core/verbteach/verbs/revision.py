"""A teacher's word on what was learned: a fluent of a hypothesis is struck out, or confirmed.

The fluent is named by the hypothesis that it stands in, since abstract terms are
numbered in each hypothesis anew. It is traced to the things that it stood for in
every demonstration of the frame, and each demonstration's space is corrected there.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping
from typing import Any, NamedTuple

from verbteach.verbs.knowledge import VerbKnowledge
from verbteach.verbs.learning import ground_goals, lifted_space
from verbteach.verbs.lifting import Lifted, affordances_of, bind, terms_of
from verbteach.verbs.space import FrameKey, HypothesisSpace
from verbteach.verbs.surroundings import Surroundings
from verbteach.world.fluents import Goal, Literal


class RevisionError(ValueError):
    """What was said fits nothing that was learned, or would leave nothing; the message says so."""


class Revision(NamedTuple):
    """``literal`` of ``hypothesis`` belongs to the frame's goal (``wanted``) or does not."""

    frame: FrameKey
    hypothesis: Lifted
    literal: Literal
    wanted: bool

    def to_json(self) -> dict[str, Any]:
        """Plain JSON values."""
        return {
            "frame": str(self.frame),
            "hypothesis": [str(literal) for literal in self.hypothesis],
            "literal": str(self.literal),
            "wanted": self.wanted,
        }

    @classmethod
    def from_json(cls, data: Mapping[str, Any]) -> Revision:
        """Rebuild a revision. Raises ``ValueError`` where the data is none."""
        try:
            return cls(
                FrameKey.parse(data["frame"]),
                tuple(Literal.parse(text) for text in data["hypothesis"]),
                Literal.parse(data["literal"]),
                bool(data["wanted"]),
            )
        except (KeyError, TypeError, AttributeError) as error:
            raise ValueError(f"not a revision: {error!r}") from error


def revised(knowledge: VerbKnowledge, revision: Revision) -> VerbKnowledge:
    """Knowledge after the teacher's word. Raises :class:`RevisionError`.

    Struck out: the hypotheses that hold the fluent go, and a demonstration whose
    whole goal held it keeps the rest of that. Confirmed: those without it go, and
    a goal that was confirmed without it gets it. A demonstration that never had
    the fluent stays as it is.
    """
    frame = knowledge.frames.get(revision.frame)
    if frame is None:
        raise RevisionError(f"nothing is known of {revision.frame}")
    if revision.hypothesis not in frame.nodes:
        raise RevisionError(f"{revision.frame} has no such hypothesis")
    if revision.literal not in revision.hypothesis:
        raise RevisionError(f"{revision.literal} is not in that hypothesis")
    meant = _traced(frame.spaces, revision)
    corrected = [_corrected(space, meant[_lesson(space)], revision) for space in frame.spaces]
    left = [space for space in corrected if space is not None]
    if not left:
        raise RevisionError(f"nothing would be left of {revision.frame.verb!r}")
    others = [space for space in knowledge.spaces if space.demonstration.frame != revision.frame]
    return VerbKnowledge.merged([*others, *left])


def _lesson(space: HypothesisSpace) -> str:
    """The lesson of a space: what was shown and what was confirmed then have it in common."""
    demonstration = space.demonstration.id
    return demonstration.rpartition("/")[0] or demonstration


def _traced(spaces: tuple[HypothesisSpace, ...], revision: Revision) -> Mapping[str, Goal]:
    """The ground literals that the fluent stood for, by lesson."""
    found: dict[str, Goal] = defaultdict(frozenset)
    for space in spaces:
        found[_lesson(space)] |= _stood_for(space, revision)
    return found


def _stood_for(space: HypothesisSpace, revision: Revision) -> Goal:
    named = [node for node in space.nodes if node.literals == revision.hypothesis]
    holding = [node for node in space.nodes if revision.literal in node.literals]
    ground: set[Literal] = set()
    for node in named or holding[:1]:
        at = node.literals.index(revision.literal)
        for binding in node.bindings:
            names = dict(zip(terms_of(node.literals), binding, strict=True))
            alone = (node.literals[at],)
            own = tuple(names[term] for term in terms_of(alone))
            ground |= bind(alone, space.demonstration.grounding, own) or frozenset()
    return frozenset(ground)


def _corrected(space: HypothesisSpace, meant: Goal, revision: Revision) -> HypothesisSpace | None:
    """The space as the teacher has it; ``None`` where nothing of it is left."""
    if not meant:
        return space
    base, *smaller = ground_goals(space)
    if revision.wanted:
        base = base if base & meant else base | meant
        goals = [goal for goal in smaller if meant & goal]
    else:
        base -= meant
        goals = [goal for goal in smaller if not meant & goal and goal != base]
    if not base:
        return None
    goals = [goal for goal in goals if goal != base]
    return lifted_space(space.demonstration, (base, *goals), _seen_by(space, revision, meant),
                        space.confirmed)  # fmt: skip


def _seen_by(space: HypothesisSpace, revision: Revision, meant: Goal) -> Surroundings:
    """The things of a space's hypotheses with the affordances that their terms name."""
    things: dict[str, frozenset[str]] = {}
    for node in space.nodes:
        terms = terms_of(node.literals)
        for binding in node.bindings:
            pairs = zip(terms, binding, strict=True)
            things |= {thing: affordances_of(term) for term, thing in pairs}
    for literal in meant:  # a goal that was confirmed without the fluent knows nothing of it
        pairs = zip(revision.literal.fluent.args, literal.fluent.args, strict=True)
        things |= {thing: affordances_of(term) for term, thing in pairs if term.startswith("<")}
    return Surroundings(affordances=things)

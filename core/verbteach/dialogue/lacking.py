"""What the robot misses in a room: kinds of things without which what it learned cannot be done."""

from __future__ import annotations

from verbteach.dialogue.draft import Draft
from verbteach.verbs.lifting import Lifted, affordances_of, terms_of


def lacking(draft: Draft) -> tuple[str, ...]:
    """The kinds of things that the verb needs and the room has none of, sorted.

    Every hypothesis of the verb needs something that is not here, or nothing is
    said; the one that lacks the least speaks for all.
    """
    verb = draft.episode.frame.verb
    hypotheses = [
        hypothesis
        for key, frame in draft.state.knowledge.frames.items()
        if key.verb == verb
        for hypothesis in frame.nodes
    ]
    missed = [_missed(draft, hypothesis) for hypothesis in hypotheses]
    return min(missed, key=lambda kinds: (len(kinds), kinds), default=())


def _missed(draft: Draft, hypothesis: Lifted) -> tuple[str, ...]:
    scene = draft.mind.setting.scene
    domain = scene.domain
    kinds = {
        kind
        for term in terms_of(hypothesis)
        for kind in affordances_of(term)
        if kind in domain.types
    }
    here = {thing.type for name, thing in scene.objects.items() if name not in domain.constants}
    return tuple(sorted(k for k in kinds if not any(domain.is_a(own, k) for own in here)))

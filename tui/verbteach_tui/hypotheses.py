"""What the robot knows of its verbs as graphs to draw, with what the last learning did."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from verbteach.language.lexicon import Lexicon
from verbteach.verbs.knowledge import FrameSpace, VerbKnowledge
from verbteach.verbs.lifting import Lifted, affordances_of, is_variable, terms_of
from verbteach.verbs.space import Demonstration, FrameKey
from verbteach.verbs.view import FrameDifference, NodeView, diff, graph
from verbteach.world.domain import Domain
from verbteach.world.fluents import Literal
from verbteach_tui.views.graph import GraphNode, HypothesisGraph, node_name, uncrossed
from verbteach_tui.views.labels import from_id
from verbteach_tui.views.mind import KnownVerb
from verbteach_tui.views.visible import visible

_VARIABLES = "XYZUVW"


@dataclass(frozen=True)
class Vocabulary:
    """How lifted hypotheses read: their domain's types and the lexicon's words for fluents."""

    domain: Domain
    lexicon: Lexicon

    def conditions(self, hypothesis: Lifted) -> tuple[str, ...]:
        """Each literal in words, with X, Y for the command's things and "a burner" for others."""
        names = {term: self._abstract(term) for term in terms_of(hypothesis)}
        return tuple(self._literal(literal, names) for literal in hypothesis)

    def _literal(self, literal: Literal, names: Mapping[str, str]) -> str:
        fluent = literal.fluent
        args = [names.get(arg) or self._term(arg) for arg in fluent.args]
        wording = self.lexicon.fluents.get(fluent.predicate)
        if wording is None:
            text = " ".join((from_id(fluent.predicate), *args))
            return visible(text if literal.positive else f"not: {text}")
        pattern = wording.is_true if literal.positive else wording.is_false
        return pattern.format(*args)

    def _term(self, term: str) -> str:
        if is_variable(term):
            return _variable(int(term[1:]))
        agent = self.domain.is_a(self.domain.constants.get(term, ""), "agent")
        return f"the {from_id(term)}" if agent else from_id(term)

    def _abstract(self, term: str) -> str:
        """The most particular type in an affordance set; its number tells apart two of a kind."""
        kinds = sorted(word for word in affordances_of(term) if word in self.domain.types)
        name = from_id(kinds[0]) if kinds else "thing"
        number = term[term.rindex(">") + 1 :]
        article = "an" if name[0] in "aeiou" else "a"
        return f"{article} {name}" if number == "0" else f"{article} {name} ({number})"


def title_of(key: FrameKey) -> str:
    """As in: put X Y for the frame put/2."""
    return visible(" ".join((key.verb, *(_variable(index) for index in range(key.arity)))))


def known_verbs(
    knowledge: VerbKnowledge, before: VerbKnowledge, words: Vocabulary
) -> tuple[KnownVerb, ...]:
    """Every frame with what it means most likely; those that differ from ``before`` are news."""
    news = {difference.frame for difference in diff(before, knowledge)}
    return tuple(
        KnownVerb(
            title_of(key),
            len(frame.nodes),
            len(_commands(frame)),
            words.conditions(_likeliest(frame)),
            key in news,
            str(key),
        )
        for key, frame in sorted(knowledge.frames.items())
    )


def _likeliest(frame: FrameSpace) -> Lifted:
    """The hypothesis confirmed most often, then seen most often, then the most general."""
    nodes = frame.nodes.values()
    return max(nodes, key=lambda n: (n.confirmed, n.frequency, -len(n.literals))).literals


def hypothesis_graph(
    knowledge: VerbKnowledge, before: VerbKnowledge, key: FrameKey, words: Vocabulary
) -> HypothesisGraph:
    """A frame's graph; what is new or counted anew since ``before`` says so."""
    frame = knowledge.frames.get(key)
    if frame is None:
        return HypothesisGraph(title_of(key))
    view = graph(frame)
    news = _news(next((d for d in diff(before, knowledge) if d.frame == key), None))
    known = {node.literals: node for level in view.levels for node in level}
    order = uncrossed([[n.literals for n in level] for level in view.levels], view.edges)
    names = {key: node_name(i) for i, key in enumerate(key for level in order for key in level)}
    levels = tuple(
        tuple(_node(known[key], names, news, frame, words) for key in level) for level in order
    )
    links = tuple((names[upper], names[lower]) for upper, lower in view.edges)
    return HypothesisGraph(title_of(key), levels, links, tuple(_commands(frame)))


def _news(difference: FrameDifference | None) -> Mapping[Lifted, str]:
    if difference is None:
        return {}
    again = {key: "seen again" for key, was, now in difference.frequencies if now > was}
    return again | dict.fromkeys(difference.added, "new")


def _node(
    node: NodeView,
    names: Mapping[Lifted, str],
    news: Mapping[Lifted, str],
    frame: FrameSpace,
    words: Vocabulary,
) -> GraphNode:
    commands = _commands(frame)
    seen = dict.fromkeys(commands[_lesson(one)] for one in node.demonstrations)
    return GraphNode(
        names[node.literals],
        words.conditions(node.literals),
        len(seen),
        tuple(seen),
        node.base > 0,
        node.confirmed > 0,
        news.get(node.literals, ""),
        node.literals,
    )


def _commands(frame: FrameSpace) -> dict[str, str]:
    """The lessons behind a frame, each with its command in words.

    A lesson may give two spaces, what was shown and what was confirmed; they
    share the part of their id before the slash.
    """
    return {_lesson(space.demonstration.id): _told(space.demonstration) for space in frame.spaces}


def _lesson(demonstration: str) -> str:
    return demonstration.rpartition("/")[0] or demonstration


def _told(demonstration: Demonstration) -> str:
    scene, _, number = _lesson(demonstration.id).partition("#")
    said = ", ".join(demonstration.phrases)
    where = f" in {scene}" + (f", command {int(number) + 1}" if number.isdecimal() else "")
    return visible(f"{demonstration.verb} {said}{where}")


def _variable(index: int) -> str:
    return _VARIABLES[index] if index < len(_VARIABLES) else f"X{index}"

"""The robot's English for fluents, changes, goals, actions and commands.

Sentences come from the lexicon's templates, and from the names of predicates
and actions where it has none. What a thing is called is passed in, so that
each caller may name things as briefly or as exactly as it needs. The sentences
of the dialogue itself are made elsewhere, out of these.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import groupby

from verbteach.language.assembly import OBJECT
from verbteach.language.fallback import action_wording, fluent_wording
from verbteach.language.frames import PRONOUNS, Argument, VerbFrame
from verbteach.language.inflection import gerund, past, third_person
from verbteach.language.lexicon import FluentWording, Lexicon
from verbteach.language.morphology import listing
from verbteach.world.fluents import Fluent, Literal, State
from verbteach.world.plan import Action

_PLACELESS = frozenset({"obj", "loc"})


@dataclass(frozen=True)
class Wording:
    """Words for one scene: ``name`` turns an object's id into words with an article."""

    lexicon: Lexicon
    name: Callable[[str], str]

    # --- fluents ----------------------------------------------------------

    def describe(self, literal: Literal) -> str:
        """``the kettle is hot``, ``the fridge is not open``."""
        said = self._of(literal.fluent)
        return self._filled(said.is_true if literal.positive else said.is_false, literal.fluent)

    def question(self, fluent: Fluent) -> str:
        """``is the kettle hot?``."""
        return self._filled(self._of(fluent).question, fluent)

    def should(self, literal: Literal) -> str:
        """``the kettle should be hot``."""
        said = self._of(literal.fluent)
        return self._filled(said.should if literal.positive else said.should_not, literal.fluent)

    def should_it(self, literal: Literal) -> str:
        """``should the kettle be hot``, ``should the fridge not be open``: a question's start."""
        said = self.should(literal)
        subject, modal, rest = said.partition(" should ")
        return f"should {subject} {rest}" if modal else f"is it so that {said}"

    def must(self, literal: Literal) -> str:
        """``the kettle must be hot``."""
        return self._with_modal(literal, "must")

    def need_not(self, literal: Literal) -> str:
        """``the kettle need not be hot``: the literal is no part of a goal."""
        said = self._with_modal(literal, "need not")
        return said.replace(" need not not ", " may ", 1)

    def became(self, literal: Literal) -> str:
        """``the kettle is now hot``, ``the kettle is no longer hot``."""
        said = self._of(literal.fluent)
        return self._filled(said.became if literal.positive else said.ceased, literal.fluent)

    def changes(self, literals: Iterable[Literal]) -> str:
        """A change of state: ``the kettle is now hot and the stove is now off``."""
        return listing([self.became(literal) for literal in _in_order(literals)])

    def goal(self, literals: Iterable[Literal]) -> str:
        """What must hold: ``the water must be hot and the stove must be off``."""
        return listing([self.must(literal) for literal in _in_order(literals)])

    def read_back(self, frame: VerbFrame, literals: Iterable[Literal]) -> str:
        """A goal as it is read back: ``after boiling the water, the water must be hot``."""
        return f"after {self.doing(frame)}, {self.goal(literals) or 'nothing has to be different'}"

    # --- actions ----------------------------------------------------------

    def action(self, action: Action) -> str:
        """A primitive action: ``move to the kettle``."""
        return self._acted(action, str)

    def acting(self, action: Action) -> str:
        """``moving to the kettle``."""
        return self._acted(action, gerund)

    def did(self, action: Action) -> str:
        """``moved to the kettle``, behind "I"."""
        return self._acted(action, past)

    def acts(self, action: Action) -> str:
        """``moves to the kettle``, behind "the robot"."""
        return self._acted(action, third_person)

    def why_not(self, unmet: Iterable[Literal], state: State | None = None) -> str:
        """Why an action cannot be done, from what it needs: ``the fridge is not open``.

        Needs that hold in ``state`` are left out, if one is given.
        """
        missing = [n for n in _in_order(unmet) if state is None or not n.holds(state)]
        opposites = (literal._replace(positive=not literal.positive) for literal in missing)
        return listing([self.describe(literal) for literal in opposites])

    # --- commands -----------------------------------------------------------

    def clause(self, frame: VerbFrame) -> str:
        """A command as it would follow "to": ``turn on the tv``, ``turn it on``."""
        said = [*_arguments(frame.arguments)]
        *verb, particle = frame.verb.split(" ")
        if verb and verb != ["not"] and said and _is_it(frame.arguments[0]):
            return " ".join((*verb, said[0], particle, *said[1:]))
        return " ".join((frame.verb, *said))

    def doing(self, frame: VerbFrame) -> str:
        """A command as a gerund: ``turning on the tv``, ``not opening the window``."""
        verb = frame.verb.removeprefix("not ")
        negated = "" if verb == frame.verb else "not "
        return f"{negated}{self.clause(VerbFrame(gerund(verb), frame.arguments))}"

    # --- templates ------------------------------------------------------------

    def _of(self, fluent: Fluent) -> FluentWording:
        said = self.lexicon.fluents.get(fluent.predicate)
        return said or fluent_wording(fluent.predicate, len(fluent.args))

    def _filled(self, template: str, fluent: Fluent) -> str:
        return template.format(*map(self.name, fluent.args))

    def _acted(self, action: Action, form: Callable[[str], str]) -> str:
        """The action with its verbs in a form: "point it at the tv and click" has two."""
        template = self.lexicon.actions.get(action.name)
        if template is None:
            template = action_wording(action.name, len(action.args))
        inflected = " and ".join(map(form, template.split(" and ")))
        return inflected.format(*map(self.name, action.args))

    def _with_modal(self, literal: Literal, modal: str) -> str:
        said = self._of(literal.fluent)
        template = said.should if literal.positive else said.should_not
        return self._filled(template.replace("should", modal, 1), literal.fluent)


def _in_order(literals: Iterable[Literal]) -> list[Literal]:
    """What holds before what does not, each by predicate and arguments: never by hash."""
    return sorted(literals, key=lambda literal: (not literal.positive, literal.fluent))


def _is_it(argument: Argument) -> bool:
    """Whether it is a bare pronoun, which stands before a verb's particle."""
    return argument.role == OBJECT and argument.phrase.text.lower() in PRONOUNS


def _arguments(arguments: Sequence[Argument]) -> Iterator[str]:
    """Each in words; objects that stand side by side are joined: ``the fork and the knife``."""
    for role, group in groupby(arguments, key=lambda argument: argument.role):
        said = list(map(_argument, group))
        yield from [listing(said)] if role == OBJECT else said


def _argument(argument: Argument) -> str:
    said = argument.phrase.text or argument.phrase.head
    return said if argument.role in _PLACELESS else f"{argument.role} {said}"

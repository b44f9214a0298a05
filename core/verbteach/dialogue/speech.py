"""How the things, fluents and actions of a scene read in the robot's sentences."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache, cached_property

from verbteach.dialogue.setting import Setting
from verbteach.language import inflection, morphology
from verbteach.language.distinguish import distinguish
from verbteach.language.frames import Argument, VerbFrame
from verbteach.language.looks import Looks
from verbteach.world.fluents import Literal, State
from verbteach.world.plan import Action


@dataclass(frozen=True)
class Speech:
    """Names things as they can be told apart by their ``looks``."""

    setting: Setting
    looks: Looks

    @classmethod
    def of(cls, setting: Setting, world: State) -> Speech:
        """The words for a setting as the world is now."""
        return cls(setting, Looks(setting.scene, world, setting.lexicon))

    @property
    def place(self) -> str:
        """Where the robot is: "a family kitchen in the morning"."""
        title = self.setting.scene.title
        return title[:1].lower() + title[1:]

    def thing(self, object_id: str) -> str:
        """A thing, with its article and as little else as singles it out."""
        return self._named(object_id)

    def holds(self, literal: Literal) -> str:
        """As in: the pot is on the stove."""
        return self._fluent(literal, "is_true", "is_false")

    def should(self, literal: Literal) -> str:
        """As in: the pot should be on the stove."""
        return self._fluent(literal, "should", "should_not")

    def must(self, literal: Literal) -> str:
        """As in: the pot must be on the stove."""
        return self.should(literal).replace(" should ", " must ", 1)

    def became(self, literal: Literal) -> str:
        """As in: the pot is now on the stove."""
        return self._fluent(literal, "became", "ceased")

    def question(self, literal: Literal) -> str:
        """As in: Is the pot on the stove."""
        asked = self._fluent(literal, "question", "question")
        return asked[:1].upper() + asked[1:]

    def action(self, action: Action) -> str:
        """As in: put the pot on the stove."""
        template = self.setting.lexicon.actions.get(action.name)
        names = [self.thing(arg) for arg in action.args]
        return template.format(*names) if template else " ".join([action.name, *names])

    def listing(self, items: Sequence[str], conjunction: str = "and") -> str:
        """As in: a, b and c."""
        return morphology.listing(items, conjunction)

    def clause(self, frame: VerbFrame) -> str:
        """As in: boil the water."""
        return " ".join([frame.verb, *map(_argument, frame.arguments)])

    def gerund(self, frame: VerbFrame) -> str:
        """As in: boiling the water."""
        return " ".join([inflection.gerund(frame.verb), *map(_argument, frame.arguments)])

    @cached_property
    def _named(self) -> Callable[[str], str]:
        return cache(lambda object_id: distinguish(object_id, self.looks))

    def _fluent(self, literal: Literal, positive: str, negative: str) -> str:
        wording = self.setting.lexicon.fluents.get(literal.fluent.predicate)
        names = [self.thing(arg) for arg in literal.fluent.args]
        if wording is None:
            told = " ".join([literal.fluent.predicate, *names])
            return told if literal.positive else f"not {told}"
        template: str = getattr(wording, positive if literal.positive else negative)
        return template.format(*names)


def _argument(argument: Argument) -> str:
    if argument.role in {"obj", "loc"}:
        return argument.phrase.text
    return f"{argument.role} {argument.phrase.text}"

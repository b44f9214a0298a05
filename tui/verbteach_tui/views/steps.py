"""What can be demonstrated now: actions, the objects that fit each, completion of typed ones."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import cached_property
from itertools import islice
from typing import NamedTuple, TypeAlias

from verbteach.world.fluents import State
from verbteach.world.plan import Action
from verbteach.world.task import GroundAction, Task
from verbteach_tui.views.wording import Wording

WhyNot: TypeAlias = Callable[[State, Action], str]
"""Says what stands in the way of an action in a state; empty where nothing does."""


class Choice(NamedTuple):
    """An action's name or an object: its id, how it reads, and whether it can be done now."""

    id: str
    label: str
    possible: bool


class StepBook:
    """The actions of a task with their words, whatever the state."""

    def __init__(self, task: Task, wording: Wording, why_not: WhyNot | None = None) -> None:
        self.task, self.wording = task, wording
        self.why_not = why_not or _unexplained

    @cached_property
    def by_name(self) -> Mapping[str, Sequence[GroundAction]]:
        """The actions by name, in the domain's order."""
        grouped: dict[str, list[GroundAction]] = {}
        for ground in self.task.actions:
            grouped.setdefault(ground.action.name, []).append(ground)
        return grouped

    @cached_property
    def found(self) -> Mapping[str, Action]:
        """The actions by each way of writing them, the first one where two read the same."""
        found: dict[str, Action] = {}
        for ground, texts in self.typed:
            for text in texts:
                found.setdefault(_folded(text), ground.action)
        return found

    @cached_property
    def typed(self) -> Sequence[tuple[GroundAction, tuple[str, ...]]]:
        """Every action with the ways of writing it: short, in words, in the domain's words."""
        return [(ground, self._variants(ground.action)) for ground in self.task.actions]

    def _variants(self, action: Action) -> tuple[str, ...]:
        words = self.wording.action(action)
        return words.replace(" the ", " "), words, str(action)


class StepMenu:
    """The actions of a task in one state.

    An object fits where some action of the task has it in that place; it is
    possible where such an action can be done now. What fits and is not
    possible is still offered: trying it is how a person learns why not.
    """

    def __init__(self, book: StepBook, state: State) -> None:
        self._book, self._state = book, state
        self._bits = book.task.encode(state)

    def after(self, state: State) -> StepMenu:
        """The same actions in another state."""
        return StepMenu(self._book, state)

    def why_not(self, name: str, chosen: Sequence[str] = ()) -> str:
        """Why a whole action cannot be done now; empty where it can, or is not whole."""
        if self.objects(name, chosen):
            return ""
        return self._book.why_not(self._state, Action(name, tuple(chosen)))

    def prepare(self) -> None:
        """Work out now, in whatever thread this is, what the screen will ask for."""
        assert self.names is not None
        assert self._book.found is not None

    @cached_property
    def names(self) -> tuple[Choice, ...]:
        """The actions' names in the domain's order, the possible ones first."""
        return _possible_first(
            Choice(name, self._book.wording.phrase(name, ()), any(map(self._possible, actions)))
            for name, actions in self._book.by_name.items()
        )

    def objects(self, name: str, chosen: Sequence[str] = ()) -> tuple[Choice, ...]:
        """What fits in the place after ``chosen``; empty where the action is complete."""
        place, prefix = len(chosen), tuple(chosen)
        fitting: dict[str, bool] = {}
        for ground in self._book.by_name.get(name, ()):
            args = ground.action.args
            if len(args) > place and args[:place] == prefix:
                fitting[args[place]] = fitting.get(args[place], False) or self._possible(ground)
        labels = self._book.wording.labels
        choices = (Choice(key, labels[key], now) for key, now in fitting.items())
        return _possible_first(_by_label(choices))

    def prompt(self, name: str, chosen: Sequence[str] = ()) -> str:
        """The action as far as it is chosen: "put the red mug on …"."""
        wording = self._book.wording
        return wording.phrase(name, [f"the {wording.labels[key]}" for key in chosen])

    def find(self, text: str) -> Action | None:
        """The action that ``text`` names: in the domain's words, or as the menu reads."""
        return self._book.found.get(_folded(text))

    def complete(self, text: str) -> str | None:
        """The first action that begins with ``text``, the possible ones first; ``None`` if none."""
        first = next(self._beginning(text), None)
        return text + first[len(text) :] if first else None

    def completions(self, text: str, most: int = 40) -> list[str]:
        """Actions that begin with ``text``, each in one way of writing it."""
        return [text + typed[len(text) :] for typed in islice(self._beginning(text), most)]

    def _beginning(self, text: str) -> Iterator[str]:
        start = text.casefold()
        if not start.strip():
            return
        later = []
        for ground, texts in self._book.typed:
            typed = next((t for t in texts if t.casefold().startswith(start)), None)
            if typed is not None and self._possible(ground):
                yield typed
            elif typed is not None:
                later.append(typed)
        yield from later

    def _possible(self, ground: GroundAction) -> bool:
        return ground.applicable(self._bits)


def _unexplained(state: State, action: Action) -> str:
    return ""


def _possible_first(choices: Iterable[Choice]) -> tuple[Choice, ...]:
    return tuple(sorted(choices, key=lambda choice: not choice.possible))


def _by_label(choices: Iterable[Choice]) -> list[Choice]:
    return sorted(choices, key=lambda choice: (choice.label.casefold(), choice.id))


def _folded(text: str) -> str:
    words = text.casefold().split()
    return " ".join(word for word in words if word != "the")

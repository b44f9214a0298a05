"""What can be demonstrated now: actions, the objects that fit each, completion of typed ones."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cached_property
from itertools import islice
from typing import NamedTuple

from verbteach.world.fluents import State
from verbteach.world.plan import Action
from verbteach.world.task import Task
from verbteach_tui.views.wording import Wording


class Choice(NamedTuple):
    """An action's name or an object: its id, how it reads, and whether it can be done now."""

    id: str
    label: str
    possible: bool


class StepMenu:
    """The actions of a task in one state.

    An object fits where some action of the task has it in that place; it is
    possible where such an action can be done now. What fits and is not
    possible is still offered: trying it is how a person learns why not.
    """

    def __init__(self, task: Task, state: State, wording: Wording) -> None:
        self._task, self._wording = task, wording
        self._bits = task.encode(state)

    def prepare(self) -> None:
        """Work out now, in whatever thread this is, what the screen will ask for."""
        assert self.names is not None
        assert self._found is not None
        assert self._typed is not None

    @cached_property
    def names(self) -> tuple[Choice, ...]:
        """The actions' names in the domain's order, the possible ones first."""
        possible = {action.name for action in self._now}
        fitting = dict.fromkeys(ground.action.name for ground in self._task.actions)
        choices = [Choice(n, self._wording.phrase(n, ()), n in possible) for n in fitting]
        return _possible_first(choices)

    def objects(self, name: str, chosen: Sequence[str] = ()) -> tuple[Choice, ...]:
        """What fits in the place after ``chosen``; empty where the action is complete."""
        place, prefix = len(chosen), tuple(chosen)
        fitting: dict[str, bool] = {}
        for ground in self._by_name.get(name, ()):
            args = ground.args
            if len(args) > place and args[:place] == prefix:
                fitting[args[place]] = fitting.get(args[place], False) or ground in self._now
        labels = self._wording.labels
        choices = (Choice(key, labels[key], now) for key, now in fitting.items())
        return _possible_first(_by_label(choices))

    def prompt(self, name: str, chosen: Sequence[str] = ()) -> str:
        """The action as far as it is chosen: "put the red mug on …"."""
        return self._wording.phrase(name, [f"the {self._wording.labels[key]}" for key in chosen])

    def find(self, text: str) -> Action | None:
        """The action that ``text`` names: in the domain's words, or as the menu reads."""
        return self._found.get(_folded(text))

    def complete(self, text: str) -> str | None:
        """The first action that begins with ``text``, the possible ones first; ``None`` if none."""
        found = self._beginning(text)
        first = next(found, None)
        return text + first[len(text) :] if first else None

    def completions(self, text: str, most: int = 40) -> list[str]:
        """Actions that begin with ``text``, each in one way of writing it."""
        return [text + typed[len(text) :] for typed in islice(self._beginning(text), most)]

    def _beginning(self, text: str) -> Iterator[str]:
        start = text.casefold()
        if start.strip():
            yield from (typed for typed in self._typed if typed.casefold().startswith(start))

    @cached_property
    def _now(self) -> frozenset[Action]:
        return frozenset(g.action for g in self._task.actions if g.applicable(self._bits))

    @cached_property
    def _by_name(self) -> Mapping[str, list[Action]]:
        grouped: dict[str, list[Action]] = {}
        for ground in self._task.actions:
            grouped.setdefault(ground.action.name, []).append(ground.action)
        return grouped

    @cached_property
    def _typed(self) -> tuple[str, ...]:
        """Every possible action, then every other one, as it reads."""
        actions = [ground.action for ground in self._task.actions]
        order = sorted(actions, key=lambda action: action not in self._now)
        return tuple(text for action in order for text in self._variants(action))

    def _variants(self, action: Action) -> tuple[str, str, str]:
        words = self._wording.action(action)
        return words.replace(" the ", " "), words, str(action)

    @cached_property
    def _found(self) -> Mapping[str, Action]:
        found: dict[str, Action] = {}
        for ground in self._task.actions:
            found.setdefault(_folded(self._wording.action(ground.action)), ground.action)
        return found | {_folded(str(ground.action)): ground.action for ground in self._task.actions}


def _possible_first(choices: Iterable[Choice]) -> tuple[Choice, ...]:
    return tuple(sorted(choices, key=lambda choice: not choice.possible))


def _by_label(choices: Iterable[Choice]) -> list[Choice]:
    return sorted(choices, key=lambda choice: (choice.label.casefold(), choice.id))


def _folded(text: str) -> str:
    words = text.casefold().split()
    return " ".join(word for word in words if word != "the")

"""A demonstrated step in a person's own words: "put it on the stove", read as a primitive action.

Words that fit several ways of saying are settled by the scene: what they refer
to, what such an action takes, and what can be done just now. What stays open
is asked; an action that cannot be done is still read, so that the robot can
say what stands in its way.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import product
from typing import NamedTuple

from verbteach.language.frames import PRONOUNS
from verbteach.language.grammar import parse
from verbteach.language.looks import Looks
from verbteach.language.morphology import listing
from verbteach.language.refer import refer
from verbteach.language.step_patterns import (
    Way,
    Words,
    fixed_words,
    step_words,
    ways_in,
    ways_of_saying,
)
from verbteach.language.typos import suggest
from verbteach.language.wording import Wording
from verbteach.language.words import DETERMINERS
from verbteach.world.plan import Action
from verbteach.world.task import Task

_BY_HANDLE = 0.5
"""How much less a knob is meant by "the burner" than the burner itself; a vessel by what it has."""
_MOST_OFFERED = 4
_RUN_TOGETHER = 4
"""So many words make two steps at the least: "go there open it"."""
_SWITCHED: Mapping[str, Words] = {
    "open": ("turn", "on"),
    "close": ("turn", "off"),
    "shut": ("turn", "off"),
}


_BETWEEN = re.compile(r"[,;.\n]|\band then\b|\bthen\b|\band\b")


class StepReading(NamedTuple):
    """A step as it was read, or what is unclear about it; ``open``: it could be several."""

    action: Action | None
    problem: str = ""
    open: bool = False


class _Fit(NamedTuple):
    """An action that the words may mean: how well, whether it can be done, how long ago named."""

    action: Action
    weight: float
    possible: bool
    whole: bool
    age: int


@dataclass(frozen=True)
class StepReader:
    """Reads steps in one state; ``spoken`` are the objects of the steps so far, the latest last."""

    task: Task
    looks: Looks
    wording: Wording
    vocabulary: Sequence[str]
    spoken: Sequence[str] = ()
    _meant: dict[Words, Mapping[str, float]] = field(default_factory=dict)

    def read(self, text: str, before: str = "") -> StepReading:
        """The action that ``text`` says; else a sentence on what is unclear.

        Where ``before`` could have been several, ``text`` may say which of them.
        """
        words = step_words(text)
        ways = ways_in(words, self._patterns)
        if not ways:
            narrowed = list(self._narrowed(words, before))
            return self._chosen(narrowed) if narrowed else StepReading(None, self._unknown(words))
        fits = list(self._fits(ways))
        if not fits and words[0] in _SWITCHED:  # a tap is opened where it is turned on
            switched = ways_in((*_SWITCHED[words[0]], *words[1:]), self._patterns)
            fits = list(self._fits(switched))
        return self._chosen(fits) if fits else self._misfit(ways)

    def parts(self, text: str) -> tuple[str, ...]:
        """The steps that ``text`` says one after the other: itself, where it is one.

        Each begins with the verb of a step; whether it can be read is seen when it comes.
        """
        parts = tuple(part for part in _BETWEEN.split(text.lower()) if step_words(part))
        first, rest = parts[:1], parts[1:]
        begun = rest and all(self._is_step(step_words(part)) for part in first)
        if begun and all(self._beginning(step_words(part)[0], None) for part in rest):
            return parts
        return self._run_together(step_words(text)) or (text,)

    def _run_together(self, words: Words) -> tuple[str, ...]:
        """Steps without a mark between them: "go to the fridge open it"; empty where it is one."""
        if len(words) < _RUN_TOGETHER or self.read(" ".join(words)).action is not None:
            return ()
        starts = [at for at, word in enumerate(words) if at > 1 and self._beginning(word, None)]
        for at in starts:
            first = self.read(" ".join(words[:at]))
            if first.open or first.action in self._grounded:
                rest = " ".join(words[at:])
                return (" ".join(words[:at]), *(self._run_together(words[at:]) or (rest,)))
        return ()

    @cached_property
    def _grounded(self) -> frozenset[Action]:
        return frozenset(ground.action for ground in self.task.actions)

    def says_a_step(self, text: str) -> bool:
        """Whether the words are put as a step, whatever they name."""
        words = step_words(text)
        return bool(words) and self._is_step(words)

    def _is_step(self, words: Words) -> bool:
        return bool(ways_in(words, self._patterns)) or bool(self._beginning(words[0], 1))

    def _narrowed(self, words: Words, before: str) -> Iterator[_Fit]:
        """What ``before`` could have been, where it is about what ``words`` name."""
        named = self._objects(words) or self._objects((*words, "thing")) if before else {}
        for fit in self._fits(ways_in(step_words(before), self._patterns)) if named else ():
            if any(thing in named for thing in fit.action.args):
                yield fit

    @cached_property
    def _patterns(self) -> Mapping[str, tuple[Words, ...]]:
        return ways_of_saying(self.task.domain, self.looks.lexicon)

    # --- what the words may mean ---------------------------------------------

    def _fits(self, ways: Sequence[Way]) -> Iterator[_Fit]:
        """The actions of the task that some way may mean; what was left out must be possible."""
        bits = self.task.encode(self.looks.state)
        by_name: dict[str, list[Way]] = {}
        for way in ways:
            by_name.setdefault(way.name, []).append(way)
        for ground in self.task.actions:
            for way in by_name.get(ground.action.name, ()):
                weight = self._weight(way, ground.action)
                whole = len(way.filled) == len(ground.action.args)
                possible = ground.applicable(bits)
                if weight and (whole or possible):
                    age = self._age(way, ground.action)
                    yield _Fit(ground.action, weight, possible, whole, age)

    def _weight(self, way: Way, action: Action) -> float:
        weight = 1.0
        for slot, said in way.filled.items():
            weight *= self._objects(said).get(action.args[slot], 0.0)
        return weight

    def _age(self, way: Way, action: Action) -> int:
        """How many objects were named since those that a pronoun stands for."""
        recent = list(reversed(self.spoken))
        return sum(
            recent.index(action.args[slot])
            for slot, said in way.filled.items()
            if _is_pronoun(said) and action.args[slot] in recent
        )

    def _objects(self, said: Words) -> Mapping[str, float]:
        if said not in self._meant:
            self._meant[said] = self._with_handles(self._named(said))
        return self._meant[said]

    def _named(self, said: Words) -> dict[str, float]:
        if _is_pronoun(said):
            return dict.fromkeys(self.spoken, 1.0)
        lexicon = self.looks.lexicon
        frames = parse(f"take {' '.join(said)}", lexicon, self.vocabulary)
        if len(frames) != 1 or not frames[0].arguments:
            return {}
        first, *others = frames[0].arguments
        placed = tuple((other.role, other.phrase) for other in others)
        phrase = replace(first.phrase, relations=(*first.phrase.relations, *placed))
        return dict(refer(phrase, self.looks, self.spoken))

    def _with_handles(self, named: Mapping[str, float]) -> dict[str, float]:
        """With what works a thing that was named, and with the vessels of a substance."""
        found = dict(named)
        for fluent in sorted(self.task.static):
            if fluent.predicate in self.looks.lexicon.handles and fluent.args[1] in named:
                found.setdefault(fluent.args[0], _BY_HANDLE * named[fluent.args[1]])
        for thing in self.looks.objects:
            for substance in self.looks.holds(thing):
                if substance in named:
                    found.setdefault(thing, _BY_HANDLE * named[substance])
        return found

    # --- which of them --------------------------------------------------------

    def _chosen(self, fits: Sequence[_Fit]) -> StepReading:
        """The best action, a possible one first; several as good are asked about."""
        best = max(fit.weight for fit in fits)
        pool = [fit for fit in fits if fit.weight == best]
        for wanted in ([f for f in pool if f.possible], [f for f in pool if f.whole], pool):
            if wanted:
                latest = min(fit.age for fit in wanted)
                actions = list(dict.fromkeys(f.action for f in wanted if f.age == latest))
                return self._one_of(actions)
        raise AssertionError("the best of some is one of them")

    def _one_of(self, actions: Sequence[Action]) -> StepReading:
        if len(actions) == 1:
            return StepReading(actions[0])
        said = [self.wording.action(action) for action in actions[:_MOST_OFFERED]]
        more = " and others" if len(actions) > _MOST_OFFERED else ""
        problem = f"That could be: {listing(said, 'or')}{more}. Which one?"
        return StepReading(None, problem, open=True)

    # --- nothing fits ---------------------------------------------------------

    def _misfit(self, ways: Sequence[Way]) -> StepReading:
        """Words for things that are not here, or things that such an action does not take."""
        whole = [way for way in ways if self._is_whole(way)]
        for way in whole:
            named = [self._objects(way.filled[slot]) for slot in sorted(way.filled)]
            if all(named):
                first = next(product(*(sorted(n, key=lambda o: (-n[o], o)) for n in named)))
                return StepReading(Action(way.name, first))
        for way in whole or ways:
            for said in way.filled.values():
                if not self._objects(said):
                    return StepReading(None, self._nothing_called(said))
        return StepReading(None, self._incomplete({way.name for way in ways}))

    def _is_whole(self, way: Way) -> bool:
        return len(way.filled) == len(self.task.domain.actions[way.name].parameters)

    def _nothing_called(self, said: Words) -> str:
        words = " ".join(said)
        if _is_pronoun(said):
            return f'What do you mean by "{words}"? Name the thing.'
        offer = (
            f" If you mean {self._near(said)}, please say it like that." if self._near(said) else ""
        )
        return f'I see nothing here that I would call "{words}".{offer}'

    def _near(self, said: Words) -> str:
        """What the words would name with one of them spelled better, or left out in front."""
        names = self.looks.names
        marks = {mark for thing in self.looks.objects for mark in names.lasting_marks(thing)}
        known = sorted({w for name in {*self.vocabulary, *marks} for w in name.lower().split()})
        spelled = [
            (*said[:place], near, *said[place + 1 :])
            for place, word in enumerate(said)
            for near in suggest(word, known)
        ]
        for words in (*spelled, *(said[start:] for start in range(1, len(said)))):
            found = self._named(words)
            best = [thing for thing, fit in found.items() if fit == max(found.values())]
            if len(best) == 1:
                return self.wording.name(best[0])
            if best:
                the = said[:1] if said[0] in DETERMINERS and words[0] not in DETERMINERS else ()
                return f'"{" ".join((*the, *words))}"'
        return ""

    def _unknown(self, words: Words) -> str:
        """No action is said like that: what the verb takes, or what steps there are."""
        if not words:
            return HOW
        own = self._beginning(words[0], 1)
        names = own or self._beginning(words[0], None)
        if names:
            return self._incomplete(names)
        verbs = {verb for patterns in self._patterns.values() for verb in fixed_words(patterns)}
        if words[0] in DETERMINERS and self._named(words):
            return f"What is to be done with {' '.join(words)}? {HOW}"
        near = suggest(words[0], verbs)
        hint = f'If you mean "{near[0]}", please say it like that.' if near else HOW
        return f'I know no step that begins with "{words[0]}". {hint}'

    def _beginning(self, verb: str, most: int | None) -> set[str]:
        """The actions that are said with ``verb`` first, by their first ``most`` patterns."""
        listed = self._patterns.items()
        return {name for name, patterns in listed if verb in fixed_words(patterns[:most])}

    def _incomplete(self, names: set[str]) -> str:
        """How the actions ``names`` are said, as in: put … on …."""
        known = [n for n in self.task.domain.actions if n in names][:_MOST_OFFERED]
        said = dict.fromkeys(f'"{" ".join(map(_blank, self._patterns[n][0]))}"' for n in known)
        return f"I did not catch the whole step. Say it as {listing(list(said), 'or')}."


def _is_pronoun(said: Words) -> bool:
    return len(said) == 1 and said[0] in PRONOUNS


def _blank(word: str) -> str:
    return "…" if word.startswith("{") else word


HOW = (
    "Show me one step after the other, as in: go to the table. "
    "Say done after the last one, or skip to leave it."
)

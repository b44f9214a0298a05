"""A fitted simulated user: what was counted in records, and the population that it makes."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from verbteach_sessions.errors import SessionError
from verbteach_sessions.people.habits import ASKED, STAGES, Habits, Phrasings, Rates, stage
from verbteach_sessions.people.observations import GAVE_UP, NO, UNREAD, UNSURE, YES, Observed
from verbteach_sessions.people.population import RATES, Beta, Population
from verbteach_sessions.people.shrinkage import Count, Prior, fit

FORMAT, VERSION = "verbteach fitted user", 1
ENOUGH = 10
"""Answers from which on a question type has a Beta of its own; else that of all types is used."""

Counts = Mapping[str, Mapping[str, Mapping[str, Count]]]
"""By person, question type and rate."""


class FittedUserError(SessionError):
    """A file is no fitted user; the message says what is wrong with it."""


@dataclass(frozen=True)
class FittedUser:
    """What people did, by person, and the sessions it was counted in (name and content hash)."""

    counts: Counts
    wording: Mapping[str, Phrasings]
    sessions: tuple[tuple[str, str], ...] = ()
    gold_known: Mapping[str, tuple[int, int]] | None = None

    @classmethod
    def of(
        cls, observed: Sequence[Observed], sessions: Iterable[tuple[str, str]] = ()
    ) -> FittedUser:
        """Count. Raises :class:`FittedUserError` where nothing was answered."""
        if not observed:
            raise FittedUserError("no question was answered in these sessions: nothing to fit")
        people = sorted({one.person for one in observed})
        counts = {
            person: _counts([one for one in observed if one.person == person]) for person in people
        }
        known = {name: _known(observed, name) for name in ASKED}
        return cls(counts, _wording(observed), tuple(sorted(sessions)), known)

    @cached_property
    def population(self) -> Population:
        """People in general, as far as these tell."""
        pooled = {rate: fit(self._pooled(rate)) for rate in RATES}
        spread = {
            name: {rate: self._beta(name, rate, pooled[rate]) for rate in RATES} for name in ASKED
        }
        return Population(spread, self.wording)

    def individual(self, person: str) -> Habits:
        """One of the people: each rate's posterior mean. Raises ``KeyError`` for a stranger."""
        mine, spread = self.counts[person], self.population.spread
        rates = {name: _individual(spread[name], mine.get(name, {})) for name in ASKED}
        return Habits(rates, self.wording)

    def asked(self, question: str) -> int:
        """How many answers of all people there are to a type of question."""
        return sum(_answered(mine.get(question, {})) for mine in self.counts.values())

    def to_json(self) -> dict[str, Any]:
        """Plain JSON: the counts are the authority, the Betas are there to be read."""
        spread = self.population.spread
        return {
            "format": FORMAT,
            "version": VERSION,
            "sessions": [list(pair) for pair in self.sessions],
            "people": {
                person: {
                    name: {rate: list(count) for rate, count in rates.items()}
                    for name, rates in mine.items()
                }
                for person, mine in self.counts.items()
            },
            "wording": {
                answer: [list(pair) for pair in texts] for answer, texts in self.wording.items()
            },
            "gold_known": {name: list(pair) for name, pair in (self.gold_known or {}).items()},
            "betas": {
                name: {rate: [beta.a, beta.b] for rate, beta in betas.items()}
                for name, betas in spread.items()
            },
        }

    @classmethod
    def from_json(cls, data: object) -> FittedUser:
        """Read what :meth:`to_json` wrote. Raises :class:`FittedUserError`."""
        if not isinstance(data, dict) or data.get("format") != FORMAT:
            raise FittedUserError("this is no fitted user: make one with 'verbteach sessions fit'")
        if data.get("version") != VERSION:
            version = data.get("version")
            raise FittedUserError(f"a fitted user of version {version!r}; this reads {VERSION}")
        try:
            return cls(
                _read_counts(data["people"]),
                {str(answer): _read_texts(texts) for answer, texts in data["wording"].items()},
                tuple((str(name), str(hashed)) for name, hashed in data["sessions"]),
                {str(n): (int(a), int(b)) for n, (a, b) in data["gold_known"].items()},
            )
        except (AttributeError, KeyError, TypeError, ValueError) as error:
            raise FittedUserError(f"a fitted user that cannot be read: {error}") from error

    def _beta(self, name: str, rate: str, pooled: Beta) -> Beta:
        """A type's own Beta where enough was answered, drawn towards that of all types."""
        counts = self._counts_of(name, rate)
        if sum(count.of for count in counts) < ENOUGH:
            return pooled
        return fit(counts, Prior(1.0 + 4.0 * pooled.mean, 1.0 + 4.0 * (1.0 - pooled.mean)))

    def _pooled(self, rate: str) -> list[Count]:
        found = []
        for mine in self.counts.values():
            own = [rates[rate] for rates in mine.values() if rate in rates]
            found.append(Count(sum(c.times for c in own), sum(c.of for c in own)))
        return [count for count in found if count.of]

    def _counts_of(self, name: str, rate: str) -> list[Count]:
        found = [mine.get(name, {}).get(rate, Count(0, 0)) for mine in self.counts.values()]
        return [count for count in found if count.of]


def _individual(betas: Mapping[str, Beta], counts: Mapping[str, Count]) -> Rates:
    def mean(rate: str) -> float:
        return betas[rate].after(*counts.get(rate, Count(0, 0))).mean

    first, later, late = (mean(f"gives_up.{one}") for one in STAGES)
    return Rates((first, later, late), mean("unsure"), mean("error"), mean("words"))


def _counts(mine: Sequence[Observed]) -> dict[str, dict[str, Count]]:
    found: dict[str, dict[str, Count]] = {}
    for one in mine:
        rates = found.setdefault(one.question, {})
        for rate, did in outcomes(one).items():
            before = rates.get(rate, Count(0, 0))
            rates[rate] = Count(before.times + did, before.of + 1)
    return {name: dict(sorted(found[name].items())) for name in sorted(found)}


def outcomes(one: Observed) -> dict[str, bool]:
    """What an answer says of each rate it bears on."""
    found = {f"gives_up.{stage(one.asked)}": one.answer == GAVE_UP}
    if one.answer == GAVE_UP:
        return found
    found["words"] = one.spoken
    if one.answer != UNREAD:
        found["unsure"] = one.answer == UNSURE
    if one.answer in (YES, NO):
        found["yes"] = one.answer == YES
    if one.right is not None:
        found["error"] = not one.right
    return found


def _answered(rates: Mapping[str, Count]) -> int:
    return sum(count.of for rate, count in rates.items() if rate.startswith("gives_up"))


def _known(observed: Sequence[Observed], name: str) -> tuple[int, int]:
    """Answers whose rightness is known, and all answers that could be right or wrong."""
    answers = [o for o in observed if o.question == name and o.answer not in (GAVE_UP, UNSURE)]
    return sum(one.right is not None for one in answers), len(answers)


def _wording(observed: Sequence[Observed]) -> dict[str, Phrasings]:
    said: dict[str, Counter[str]] = {YES: Counter(), NO: Counter(), UNSURE: Counter()}
    for one in observed:
        if one.words and one.answer in said:
            said[one.answer][one.words.strip()] += 1
    return {answer: tuple(sorted(texts.items())) for answer, texts in said.items()}


def _read_counts(people: Mapping[str, Any]) -> dict[str, dict[str, dict[str, Count]]]:
    return {
        str(person): {
            str(name): {str(rate): _read_count(pair) for rate, pair in rates.items()}
            for name, rates in mine.items()
        }
        for person, mine in people.items()
    }


def _read_count(pair: Sequence[Any]) -> Count:
    times, of = pair
    if not (isinstance(times, int) and isinstance(of, int) and 0 <= times <= of):
        raise ValueError(f"{pair!r} is no count of times and of how many")
    return Count(times, of)


def _read_texts(texts: Sequence[Any]) -> Phrasings:
    found = tuple((str(text), int(count)) for text, count in texts)
    if not all(count > 0 for _, count in found):
        raise ValueError("a text that was said less than once")
    return found

"""What in a text may say who somebody is: patterns by kind, each with a check where one helps.

A scan can miss and can be wrong; a person decides about each finding.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator
from typing import NamedTuple


class Hit(NamedTuple):
    """A stretch of a text, and what kind of personal data it looks like."""

    kind: str
    text: str


class _Pattern(NamedTuple):
    kind: str
    pattern: re.Pattern[str]
    fits: Callable[[str], bool] = lambda _: True


def _digits(text: str) -> list[int]:
    return [int(sign) for sign in text if sign.isascii() and sign.isdigit()]


def _is_card(text: str) -> bool:
    """Luhn's sum, by which a payment card's number is told from any other."""
    digits = _digits(text)
    doubled = [digit * 2 - 9 * (digit > 4) for digit in digits[-2::-2]]
    return 13 <= len(digits) <= 19 and (sum(digits[-1::-2]) + sum(doubled)) % 10 == 0


def _is_iban(text: str) -> bool:
    bare = "".join(text.split()).upper()
    turned = bare[4:] + bare[:4]
    return int("".join(str(int(sign, 36)) for sign in turned)) % 97 == 1


def _is_address(text: str) -> bool:
    return all(int(part) < 256 for part in text.split("."))


def _is_telephone(text: str) -> bool:
    return 7 <= len(_digits(text)) <= 15


# What people write with a capital after "I am" or "this is" without its being a name.
_NO_NAMES = frozenset(
    re.findall(
        r"\w+",
        "a an the it i you he she we they not no yes ok okay so very just sorry done good bad fine"
        " right wrong sure here there now in on at is are was robot mug cup kitchen",
    )
)


def _is_name(text: str) -> bool:
    return text.split(maxsplit=1)[0].casefold() not in _NO_NAMES


_MONTHS = "jan|feb|mar|apr|may|jun|jul|aug|sep|oct|nov|dec"
_STREETS = "street|st|road|rd|avenue|ave|lane|ln|drive|square|boulevard|blvd|court|way"
_PATTERNS = (
    _Pattern("e-mail", re.compile(r"[\w.+-]{1,64}@[\w-]{1,63}(?:\.[\w-]{1,63})+")),
    _Pattern("web address", re.compile(r"(?i)\b(?:https?://|www\.)[^\s<>\"']+")),
    _Pattern("handle", re.compile(r"(?<![\w.@])@[A-Za-z]\w{2,30}")),
    _Pattern(
        "IBAN", re.compile(r"\b[A-Z]{2}\d{2}(?: ?[A-Z0-9]{4}){2,7}(?: ?[A-Z0-9]{1,4})?\b"), _is_iban
    ),
    _Pattern("card number", re.compile(r"\b\d(?:[ -]?\d){12,18}\b"), _is_card),
    _Pattern("network address", re.compile(r"(?<![\d.])\d{1,3}(?:\.\d{1,3}){3}\b"), _is_address),
    _Pattern(
        "date",
        re.compile(
            r"(?i)\b(?:\d{1,2}[./-]\d{1,2}[./-]\d{2,4}|\d{4}-\d{2}-\d{2}"
            rf"|\d{{1,2}}\.? (?:{_MONTHS})[a-z]*\.? \d{{4}}"
            rf"|(?:{_MONTHS})[a-z]* \d{{1,2}}(?:st|nd|rd|th)?,? \d{{4}})\b"
        ),
    ),
    _Pattern("telephone", re.compile(r"(?<![\w.])\+?\(?\d[\d ()/-]{5,18}\d(?!\w)"), _is_telephone),
    _Pattern("street", re.compile(rf"(?i)\b\d{{1,5}} (?:[a-z]+ ){{1,3}}(?:{_STREETS})\b")),
    _Pattern("street", re.compile(r"(?i)\b[a-zäöü-]+(?:straße|strasse|weg|allee|platz) \d{1,4}\b")),
    _Pattern("user's folder", re.compile(r"(?:/home/|/Users/|[A-Za-z]:\\Users\\)[\w.-]+")),
    _Pattern(
        "name",
        re.compile(
            r"(?i:\b(?:my name(?: is|'s)|i am called|call me|i am|i'm|this is)) "
            r"([A-Z][\w'-]+(?: [A-Z][\w'-]+){0,2})"
        ),
        _is_name,
    ),
)


class Scanner:
    """Finds what looks like personal data. ``names`` are further words to look for."""

    def __init__(self, names: Iterable[str] = ()) -> None:
        known = sorted({name.strip() for name in names if name.strip()}, key=len, reverse=True)
        listed = "|".join(map(re.escape, known))
        self._names = re.compile(rf"(?i)(?<!\w)(?:{listed})(?!\w)") if known else None

    def hits(self, text: str) -> Iterator[Hit]:
        """What was found, each stretch of the text once, by the first kind that fits."""
        taken: list[tuple[int, int]] = []
        for kind, match in self._matches(text):
            start, end = match.span(match.lastindex or 0)
            if all(end <= begun or start >= done for begun, done in taken):
                taken.append((start, end))
                yield Hit(kind, text[start:end])

    def _matches(self, text: str) -> Iterator[tuple[str, re.Match[str]]]:
        for kind, pattern, fits in _PATTERNS:
            for match in pattern.finditer(text):
                if fits(match[match.lastindex or 0]):
                    yield kind, match
        if self._names is not None:
            yield from (("listed name", match) for match in self._names.finditer(text))

"""From a typed text to lower-case tokens; knows letters and punctuation, no words' meanings."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Container, Sequence

STOP = "."
"""The token that every sentence-ending mark becomes."""
COMMA = ","

_TRANSLATED = str.maketrans(
    {
        "\N{RIGHT SINGLE QUOTATION MARK}": "'",
        "\N{LEFT SINGLE QUOTATION MARK}": "'",
        "`": "'",
        "\N{EN DASH}": " ",
        "\N{EM DASH}": ",",
    }
)
_ESCAPE = re.compile(r"\x1b\[[0-9;?]*[A-Za-z]")
_TOKEN = re.compile(
    r"[^\W\d_]+(?:[-'][^\W\d_]+)*|\d+(?:[.,:]\d+)*(?:st|nd|rd|th)?|[^\W_]+|[.!?;:,&+/()\n]|'"
)
_CONTRACTIONS = {
    "can't": ("can", "not"),
    "cannot": ("can", "not"),
    "won't": ("will", "not"),
    "shan't": ("shall", "not"),
    "let's": ("let", "us"),
    "gonna": ("going", "to"),
    "wanna": ("want", "to"),
    "gotta": ("got", "to"),
    "gimme": ("give", "me"),
    "lemme": ("let", "me"),
    "dont": ("do", "not"),
    "pls": ("please",),
    "plz": ("please",),
    "thx": ("thanks",),
    "u": ("you",),
    "w": ("with",),
    "n": ("and",),
    "'n'": ("and",),
    "pick-up": ("pick", "up"),
    "o'clock": ("oclock",),
}
_SLIPS = {
    slip: word
    for word, slips in {
        "the": "teh hte eth thr",
        "and": "adn nad anf",
        "that": "taht tath",
        "this": "tihs thsi",
        "with": "wiht iwth wth",
        "should": "shuold shoud shold shoudl sould shuld",
        "must": "msut mut",
        "could": "cuold coud culd",
        "would": "wuold woud wuld",
        "please": "plese plaese pleas pleae",
        "where": "wehre whre were's",
        "what": "waht wht",
        "you": "yuo yoou",
        "your": "yuor",
        "from": "fomr frmo",
        "into": "itno",
        "can": "cna",
        "put": "putt",
        "not": "nto",
        "meant": "ment",
        "right": "rigth rihgt",
        "correct": "corect",
        "which": "wich whcih",
        "when": "wehn",
        "only": "olny onyl",
    }.items()
    for slip in slips.split()
}
"""Little words that fingers turn round: what they become is no word of its own."""
_SUFFIXES = {
    "n't": ("not",),
    "'s": ("'s",),
    "'re": ("are",),
    "'d": ("would",),
    "'ll": ("will",),
    "'ve": ("have",),
    "'m": ("am",),
}
_APOSTROPHES = {
    word.replace("'", ""): word
    for word in (
        *("that's", "what's", "where's", "it's", "i'm", "i've", "they're", "you're", "there's"),
        *("don't", "doesn't", "didn't", "isn't", "wasn't", "aren't", "can't", "shouldn't"),
        *("needn't", "mustn't", "hasn't", "haven't", "couldn't"),
    )
}
_BARE = re.compile(rf"\b(?:{'|'.join(_APOSTROPHES)})\b", re.IGNORECASE)
_MARKS = {
    ".": STOP,
    "!": STOP,
    "?": STOP,
    ";": STOP,
    ":": STOP,
    "\n": STOP,
    "(": COMMA,
    ")": COMMA,
    "&": "and",
    "+": "and",
    "/": "or",
    ",": COMMA,
}


def spelled_out(text: str) -> str:
    """With the apostrophes that people leave out in passing: "thats it", "i dont know".

    Not for commands, where "its" and the like are words of their own.
    """
    return _BARE.sub(lambda match: _APOSTROPHES[match.group().lower()], text)


def tokenise(text: str) -> list[str]:
    """Lower-case words, numbers, commas and stops; whatever else stands in ``text`` is dropped."""
    tokens: list[str] = []
    for match in _TOKEN.finditer(_normalised(text)):
        tokens.extend(_split(match.group()))
    return tokens


def trimmed(tokens: Sequence[str], around: Container[str]) -> list[str]:
    """The tokens without those at either end that are ``around`` what is said."""
    kept = list(tokens)
    while kept and kept[0] in around:
        kept = kept[1:]
    while kept and kept[-1] in around:
        kept = kept[:-1]
    return kept


def _normalised(text: str) -> str:
    plain = unicodedata.normalize("NFKC", _ESCAPE.sub(" ", text)).translate(_TRANSLATED).lower()
    return "".join(c if c == "\n" or c.isprintable() else " " for c in plain)


def _split(token: str) -> tuple[str, ...]:
    if token in _MARKS:
        return (_MARKS[token],)
    if token in _SLIPS:
        return (_SLIPS[token],)
    if token in _CONTRACTIONS:
        return _CONTRACTIONS[token]
    for suffix, words in _SUFFIXES.items():
        if token.endswith(suffix) and len(token) > len(suffix):
            return (token.removesuffix(suffix), *words)
    return (token,)


def sentences(tokens: list[str]) -> list[list[str]]:
    """The tokens between stops, empty ones left out."""
    parts: list[list[str]] = [[]]
    for token in tokens:
        if token == STOP:
            parts.append([])
        else:
            parts[-1].append(token)
    return [part for part in parts if part]

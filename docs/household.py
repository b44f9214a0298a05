"""Writes the tables of scenes.md from the household's own files.

`python docs/household.py` rewrites the marked blocks; `--check` only says
whether they are current. What a block shows is never edited by hand.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Callable, Iterable, Mapping, Sequence
from pathlib import Path

from verbteach.world.domain import (
    EQUALITY,
    ROOT_TYPE,
    ActionSchema,
    Condition,
    Domain,
    Effect,
    Parameter,
)
from verbteach_scenarios.lessons import load_lessons, report
from verbteach_scenarios.lexicon_file import load_lexicon
from verbteach_scenarios.recipes.tasks import read_teachers
from verbteach_scenarios.scenes import check_scenes, load_domain

PAGE = Path(__file__).resolve().parent / "scenes.md"
RECIPES = PAGE.parents[1] / "scenarios/verbteach_scenarios/data/household/recipes"
_BLOCK = re.compile(r"(<!-- generated: (?P<name>[a-z ]+) -->\n).*?(<!-- end -->)", re.DOTALL)
PAPER = ("979", "75", "215", "4.82", "4.8", "1", "51")


def types() -> str:
    """The domain's types as a tree."""
    return "```\n" + "\n".join(_tree(load_domain(), ROOT_TYPE, 0)) + "\n```\n"


def constants() -> str:
    """The domain's constants by type."""
    by_type: dict[str, list[str]] = {}
    for name, type_name in load_domain().constants.items():
        by_type.setdefault(type_name, []).append(f"`{name}`")
    rows = [f"| {type_name} | {', '.join(names)} |" for type_name, names in by_type.items()]
    return _table("| type | constants |", rows)


def fluents() -> str:
    """The predicates, how they read, and whether anything changes them."""
    domain, lexicon = load_domain(), load_lexicon()
    rows = []
    for name, predicate in domain.predicates.items():
        kinds = [p.type for p in predicate.parameters]
        said = lexicon.fluents[name].is_true.format(*_called(kinds))
        never = "no" if name in domain.static else "yes"
        rows.append(f"| `({' '.join((name, *kinds))})` | {said} | {never} |")
    return _table("| fluent | reads | changes |", rows)


def actions() -> str:
    """The actions: how they read, what they need, and what they always do."""
    lexicon = load_lexicon()
    rows = []
    for name, schema in load_domain().actions.items():
        kinds = [p.type for p in schema.parameters]
        said = lexicon.actions[name].format(*_called(kinds))
        needs = "; ".join(_needed(schema)) or "nothing"
        does = "; ".join(_always(schema)) or "see the domain"
        rows.append(f"| `{' '.join((name, *kinds))}` | {said} | {needs} | {does} |")
    return _table("| action | reads | needs | always does |", rows)


def scenes() -> str:
    """The bundled rooms."""
    rows = [f"| `{row.id}` | {row.title} | {row.objects} |" for row in check_scenes().scenes]
    return _table("| scene | | objects |", rows)


def lessons() -> str:
    """The bundled lessons counted, beside the paper's data."""
    found = report(load_lessons())
    length = found.length
    own = (
        str(found.lessons), str(found.verbs), str(found.noun_phrases),
        f"{length.mean:.2f}", f"{length.sd:.2f}", str(length.min), str(length.max),
    )  # fmt: skip
    what = ("lessons", "verbs", "noun phrases", "mean length", "sd", "shortest", "longest")
    rows = [f"| {w} | {o} | {p} |" for w, o, p in zip(what, own, PAPER, strict=True)]
    return _table("| | here | the paper |", rows)


def teachers() -> str:
    """The teachers and their habits."""
    rows = [f"| {one.name} | {one.about} |" for one in read_teachers(RECIPES)]
    return _table("| teacher | habit |", rows)


def _tree(domain: Domain, type_name: str, depth: int) -> Iterable[str]:
    yield "  " * depth + type_name
    for child, parent in domain.types.items():
        if parent == type_name:
            yield from _tree(domain, child, depth + 1)


def _called(kinds: Sequence[str]) -> list[str]:
    """The types as noun phrases; the second of a kind is the other one."""
    return [f"the {'other ' * (kind in kinds[:i])}{kind}" for i, kind in enumerate(kinds)]


def _names(parameters: Sequence[Parameter]) -> Mapping[str, str]:
    called = _called([p.type for p in parameters])
    return dict(zip([p.name for p in parameters], called, strict=True))


def _needed(schema: ActionSchema) -> list[str]:
    names = _names(schema.parameters)
    return [_condition(condition, names) for condition in schema.precondition]


def _condition(condition: Condition, names: Mapping[str, str]) -> str:
    args = [names.get(arg, f"the {arg.lower()}") for arg in condition.args]
    if condition.predicate == EQUALITY:
        return f"{args[0]} is {'' if condition.positive else 'not '}{args[1]}"
    wording = load_lexicon().fluents[condition.predicate]
    return (wording.is_true if condition.positive else wording.is_false).format(*args)


def _always(schema: ActionSchema) -> list[str]:
    names = _names(schema.parameters)
    plain = (e for e in schema.effects if not e.condition and not e.parameters)
    return [_effect(effect, names) for effect in plain]


def _effect(effect: Effect, names: Mapping[str, str]) -> str:
    wording = load_lexicon().fluents[effect.predicate]
    args = [names.get(arg, f"the {arg.lower()}") for arg in effect.args]
    return (wording.became if effect.positive else wording.ceased).format(*args)


def _table(head: str, rows: Iterable[str]) -> str:
    line = "|" + "---|" * (head.count("|") - 1)
    return "\n".join([head, line, *rows]) + "\n"


BLOCKS: Mapping[str, Callable[[], str]] = {
    "types": types,
    "constants": constants,
    "fluents": fluents,
    "actions": actions,
    "scenes": scenes,
    "lessons": lessons,
    "teachers": teachers,
}


def current(page: str) -> str:
    """The page with every block as the files have it now."""

    def block(match: re.Match[str]) -> str:
        return f"{match[1]}\n{BLOCKS[match['name']]()}\n{match[3]}"

    return _BLOCK.sub(block, page)


def main(arguments: list[str]) -> int:
    """Rewrite the page, or with ``--check`` answer 1 if that would change it."""
    page = PAGE.read_text("utf-8")
    if "--check" in arguments:
        return int(page != current(page))
    PAGE.write_text(current(page), "utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

"""The page on worlds and lessons shows the household as it is, and its examples work."""

from __future__ import annotations

import json
import re
from pathlib import Path

from docs import household
from verbteach_scenarios.lessons import check_lessons
from verbteach_scenarios.lexicon_file import parse_lexicon
from verbteach_scenarios.scenes import check_scenes, load_domain, load_scene


def page() -> str:
    return household.PAGE.read_text("utf-8")


def example(kind: str, marker: str) -> str:
    blocks = re.findall(rf"```{kind}\n(.*?)```", page(), re.DOTALL)
    return str(next(block for block in blocks if marker in block))


def test_generated_blocks_are_current() -> None:
    assert page() == household.current(page()), "run: python docs/household.py"


def test_every_block_is_on_the_page() -> None:
    shown = re.findall(r"<!-- generated: ([a-z ]+) -->", page())
    assert sorted(shown) == sorted(household.BLOCKS)


def test_every_action_and_fluent_of_the_household_is_on_the_page() -> None:
    domain = load_domain()
    for name in domain.actions:
        assert re.search(rf"^\| `{name}[ `]", page(), re.MULTILINE), name
    for name in domain.predicates:
        assert re.search(rf"^\| `\({name}[ )]", page(), re.MULTILINE), name


def test_the_example_scene_with_its_sidecar_is_a_scene(tmp_path: Path) -> None:
    (tmp_path / "attic-1.pddl").write_text(example("", "(define (problem attic-1)"))
    (tmp_path / "attic-1.toml").write_text(example("toml", "[objects.Book_1]"))
    assert check_scenes(tmp_path).problems == ()
    scene = load_scene("attic-1", tmp_path)
    assert scene.title == "The attic"
    assert scene.objects["Book_1"].attributes["colour"] == "brown"


def test_the_example_lexicon_is_a_lexicon() -> None:
    words = parse_lexicon(example("toml", "[fluents]"), Path("lexicon.toml"))
    assert words.fluents["contains"].question == "does {0} contain {1}?"
    assert words.fluents["open"].is_false == "{0} is closed"
    assert "apple" in words.synonyms["fruit"]


def test_the_example_lesson_can_be_taught(tmp_path: Path) -> None:
    lesson = json.loads(example("json", '"boil-1"'))
    (tmp_path / "mine.jsonl").write_text(json.dumps(lesson))
    assert check_lessons(tmp_path).problems == ()

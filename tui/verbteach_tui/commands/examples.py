"""Examples of every command, as its help and the command reference show them."""

from __future__ import annotations

from collections.abc import Mapping

EXAMPLES: Mapping[str, tuple[str, ...]] = {
    "verbteach": (
        "verbteach",
        "verbteach teach --scene kitchen-1",
        "verbteach teach --plain",
        "verbteach sessions list",
        "verbteach doctor",
    ),
    "verbteach teach": (
        "verbteach teach --scene kitchen-1",
        "verbteach teach --plain --from my-sessions/20260101-120000-abcdefgh",
        "verbteach teach --teacher simulated --lessons 50 --seed 1 --json",
        "verbteach teach --teacher lesson.txt --scene kitchen-1",
        "verbteach teach --resume my-sessions/20260101-120000-abcdefgh",
        "verbteach teach --study my-study/study.toml --sessions my-study/records",
    ),
    "verbteach serve": (
        "verbteach serve",
        "verbteach serve --study my-study/study.toml --tokens tokens.txt"
        " --sessions my-study/records",
        "verbteach serve --host 0.0.0.0 --port 8080 --tokens tokens.txt",
    ),
    "verbteach study": ("verbteach study new my-study",),
    "verbteach study new": ("verbteach study new my-study",),
    "verbteach study check": (
        "verbteach study check my-study/study.toml",
        "verbteach study check my-study/study.toml --json",
    ),
    "verbteach study status": (
        "verbteach study status my-study/study.toml --sessions my-study/records",
    ),
    "verbteach study answers": (
        "verbteach study answers --sessions my-study/records --out answers.csv",
    ),
    "verbteach study tokens": ("verbteach study tokens tokens.txt --count 40",),
    "verbteach replay": (
        "verbteach replay my-sessions/20260101-120000-abcdefgh",
        "verbteach replay my-sessions/20260101-120000-abcdefgh --speed 2",
        "verbteach replay my-sessions/20260101-120000-abcdefgh --verify --json",
        "verbteach replay my-sessions/20260101-120000-abcdefgh --policy split",
    ),
    "verbteach sessions": (
        "verbteach sessions list",
        "verbteach sessions export my-sessions --to html --out pages",
    ),
    "verbteach sessions list": (
        "verbteach sessions list",
        "verbteach sessions list --sessions my-sessions --json",
    ),
    "verbteach sessions show": ("verbteach sessions show my-sessions/20260101-120000-abcdefgh",),
    "verbteach sessions validate": (
        "verbteach sessions validate my-sessions",
        "verbteach sessions validate my-sessions/20260101-120000-abcdefgh --json",
    ),
    "verbteach sessions branch": (
        "verbteach sessions branch my-sessions/20260101-120000-abcdefgh --at 12",
    ),
    "verbteach sessions export": (
        "verbteach sessions export my-sessions --to html --out pages",
        "verbteach sessions export my-sessions --to jsonl --out dataset --splits splits.json",
        "verbteach sessions export my-sessions/20260101-120000-abcdefgh --to asciicast --out casts",
    ),
    "verbteach sessions stats": (
        "verbteach sessions stats my-sessions",
        "verbteach sessions stats my-sessions --json",
    ),
    "verbteach sessions scan": (
        "verbteach sessions scan my-sessions",
        "verbteach sessions scan my-sessions --names names.txt --redact",
        'verbteach sessions scan my-sessions --keep "Anna Blume"',
    ),
    "verbteach sessions withdraw": (
        "verbteach sessions withdraw k7m2xq9fhd --sessions my-sessions",
        "verbteach sessions withdraw k7m2xq9fhd --sessions my-sessions --yes --json",
    ),
    "verbteach sessions split": (
        "verbteach sessions split my-sessions --seed 1 --out splits.json",
        "verbteach sessions split my-sessions --train 0.6 --validation 0.2 --test 0.2 --json",
    ),
    "verbteach sessions datasheet": ("verbteach sessions datasheet my-sessions",),
    "verbteach sessions release": (
        "verbteach sessions release my-sessions",
        "verbteach sessions release my-sessions --splits splits.json --names names.txt --json",
    ),
    "verbteach sessions fit": (
        "verbteach sessions fit my-sessions --out people.json",
        "verbteach sessions fit my-sessions --out people.json --check --json",
    ),
    "verbteach sessions evaluate-policy": (
        "verbteach sessions evaluate-policy my-sessions --policy split",
        "verbteach sessions evaluate-policy my-sessions --policy rl --weights weights.json --json",
    ),
    "verbteach sessions example": (
        "verbteach sessions example --out example-corpus",
        "verbteach sessions example --out small --sessions 4 --lessons 2 --seed 1",
    ),
    "verbteach benchmark": ("verbteach benchmark check tell-me-dave",),
    "verbteach benchmark check": (
        "verbteach benchmark check tell-me-dave",
        "verbteach benchmark check tell-me-dave --json",
    ),
    "verbteach lessons": ("verbteach lessons check",),
    "verbteach lessons list": (
        "verbteach lessons list",
        "verbteach lessons list --lessons my-lessons --json",
    ),
    "verbteach lessons check": (
        "verbteach lessons check",
        "verbteach lessons check --lessons my-lessons --scenes my-scenes",
    ),
    "verbteach parse": (
        'verbteach parse "put the red mug in the sink and turn on the tap"',
        'verbteach parse "boil the water" --scene kitchen-1 --json',
    ),
    "verbteach scenes": ("verbteach scenes list",),
    "verbteach scenes list": (
        "verbteach scenes list",
        "verbteach scenes list --scenes my-scenes --json",
    ),
    "verbteach scenes show": ("verbteach scenes show kitchen-1",),
    "verbteach scenes check": (
        "verbteach scenes check",
        "verbteach scenes check --scenes my-scenes",
    ),
    "verbteach evaluate": (
        "verbteach evaluate --from my-sessions/20260101-120000-abcdefgh",
        "verbteach evaluate --data tell-me-dave",
        "verbteach evaluate --data tell-me-dave --policy she16-all --grounding oracle --json",
        "verbteach evaluate --data tell-me-dave --noise std3 --runs 5",
        "verbteach evaluate --data tell-me-dave --policy rl --mistakes --out mistakes",
    ),
    "verbteach train": (
        "verbteach train --out weights.json",
        "verbteach train --noise std3 --learner true-online --episodes 2000 --out weights.json",
        "verbteach train --from my-sessions/20260101-120000-abcdefgh --out weights.json --json",
    ),
    "verbteach reproduce": (
        "verbteach reproduce all --out results",
        "verbteach reproduce table4 --data tell-me-dave --runs 5 --out results --json",
        "verbteach reproduce all --data tell-me-dave --with phantom --with harder-teacher"
        " --out results",
        "verbteach reproduce all --data tell-me-dave --out results --resume",
    ),
    "verbteach bench": (
        "verbteach bench",
        "verbteach bench --part turns --part keys --plain",
        "verbteach bench --peers --data tell-me-dave --json",
    ),
    "verbteach doctor": (
        "verbteach doctor",
        "verbteach doctor --json",
    ),
}


def epilog(command: str) -> str:
    """The examples of ``command`` as the end of its help text, line for line."""
    return "\n".join(("\b", "Examples:", *(f"  {line}" for line in EXAMPLES[command])))

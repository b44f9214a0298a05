"""The formats there are, and whether what they need is installed."""

from __future__ import annotations

from collections.abc import Mapping
from importlib.util import find_spec
from typing import NamedTuple

from verbteach_sessions.exports.errors import MissingExtraError


class Format(NamedTuple):
    """A format: what it is for, the module that writes it, the extra and packages it needs."""

    about: str
    module: str
    extra: str = ""
    packages: tuple[str, ...] = ()


FORMATS: Mapping[str, Format] = {
    "jsonl": Format("JSON Lines with schema and dataset card", "jsonl_dataset"),
    "convokit": Format("a ConvoKit corpus", "convokit_corpus"),
    "convlab": Format("ConvLab-3's unified format", "convlab_folder"),
    "parlai": Format("ParlAI conversations", "parlai_conversations"),
    "minari": Format(
        "a Minari dataset of the robot's choices",
        "minari_dataset",
        "minari",
        ("minari", "pyarrow", "PIL"),
    ),
    "parquet": Format("Parquet tables", "parquet_file", "parquet", ("pyarrow",)),
    "csv": Format("CSV tables, one row a turn", "csv_table"),
    "html": Format("pages to read, with slider, scene and beliefs", "html_page"),
    "markdown": Format("Markdown in the layout of the paper's Table 1", "markdown_table"),
    "asciicast": Format("asciicast v2 for asciinema, with markers", "asciicast"),
    "svg": Format("a picture of each dialogue", "svg_image"),
}


def check_installed(name: str) -> None:
    """Raise :class:`MissingExtraError` where a format's packages are not installed."""
    chosen = FORMATS[name]
    missing = [package for package in chosen.packages if find_spec(package) is None]
    if missing:
        raise MissingExtraError(
            f"--to {name} needs {', '.join(missing)}, not installed here;"
            f" pip install 'verbteach[{chosen.extra}]'"
        )

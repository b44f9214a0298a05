"""HTML, one page a session and a list of them: the dialogue with a slider, the scene, the beliefs.

A page needs nothing from elsewhere and runs no script but its own, by its
policy. What people typed gets in as text only: escaped in the transcript, and
as data that the script hands to the page as text.
"""

from __future__ import annotations

import base64
import json
from collections.abc import Iterable, Mapping
from functools import cache
from hashlib import sha256
from html import escape
from importlib.resources import files
from pathlib import Path
from typing import Any

from verbteach.dialogue.setting import Settings
from verbteach_sessions.exports.dialogue import Dialogue, Turn
from verbteach_sessions.exports.folder import write_text
from verbteach_sessions.exports.lines import summary, title
from verbteach_sessions.exports.sight import Depict
from verbteach_sessions.exports.worlds import follow
from verbteach_sessions.visible import visible

_BEST = 8  # candidates, goals, objects: the first few tell the story


def write(
    dialogues: Iterable[Dialogue],
    folder: Path,
    settings: Settings | None = None,
    depict: Depict | None = None,
) -> None:
    """Write ``SESSION.html`` for each session, and ``index.html``.

    With ``settings`` and ``depict`` the scene is shown beside the dialogue.
    """
    listed = []
    for dialogue in dialogues:
        sights: Mapping[str, Any] = {}
        if settings is not None and depict is not None:
            worlds = follow(dialogue, settings)
            sights = {key: depict(*worlds[key]).to_json() for key in worlds}
        write_text(folder / f"{dialogue.id}.html", page(dialogue, sights))
        listed.append(_entry(dialogue))
    write_text(folder / "index.html", _document("Teaching sessions", [_INDEX, *listed, "</ul>"]))


def page(dialogue: Dialogue, sights: Mapping[str, Any]) -> str:
    """A session's page; ``sights`` are scenes by the world's hash."""
    numbers = {key: index for index, key in enumerate(sights)}
    data = {
        "sights": list(sights.values()),
        "turns": [_told(turn, numbers) for turn in dialogue.turns],
    }
    body = [
        f"<h1>{escape(title(dialogue))}</h1>",
        '<dl class="facts">',
        *(f"<div><dt>{k}</dt><dd>{escape(v)}</dd></div>" for k, v in summary(dialogue)),
        "</dl>",
        _CONTROLS.format(last=len(dialogue.turns) - 1),
        '<main><ol id="dialogue" start="0">',
        *map(_turn, dialogue.turns),
        "</ol>",
        '<aside id="sight" class="panel"></aside><aside id="mind" class="panel"></aside></main>',
        f'<script type="application/json" id="data">{_embedded(data)}</script>',
        f"<script>{_asset('page.js')}</script>",
    ]
    return _document(title(dialogue), body, kind="session")


_CONTROLS = """<nav id="controls" hidden>
<button id="back" aria-label="one turn back">&#9664;</button>
<input id="slider" type="range" min="0" max="{last}" value="0" aria-label="turn">
<button id="on" aria-label="one turn on">&#9654;</button>
<output id="where" for="slider"></output>
</nav>"""

_INDEX = '<h1>Teaching sessions</h1><ul class="sessions">'


def _entry(dialogue: Dialogue) -> str:
    facts = ", ".join(f"{name}: {value}" for name, value in summary(dialogue))
    link = f'<a href="{escape(dialogue.id)}.html">{escape(title(dialogue))}</a>'
    return f"<li>{link}<small>{escape(facts)}</small></li>"


def _document(head: str, body: Iterable[str], kind: str = "index") -> str:
    style = _asset("page.css")
    policy = (
        f"default-src 'none'; style-src '{_hash(style)}';"
        f" script-src '{_hash(_asset('page.js'))}'; base-uri 'none'; form-action 'none'"
    )
    opening = [
        "<!DOCTYPE html>",
        '<html lang="en"><head><meta charset="utf-8">',
        f'<meta http-equiv="Content-Security-Policy" content="{policy}">',
        '<meta name="viewport" content="width=device-width, initial-scale=1">',
        '<meta name="referrer" content="no-referrer">',
        f"<title>{escape(head)}</title>",
        f'<style>{style}</style></head><body class="{kind}">',
    ]
    return "\n".join([*opening, *body, "</body></html>", ""])


@cache
def _asset(name: str) -> str:
    return files("verbteach_sessions.exports").joinpath(name).read_text("utf-8")


def _hash(text: str) -> str:
    """How a content security policy names an inline style or script that may be used."""
    return "sha256-" + base64.b64encode(sha256(text.encode()).digest()).decode()


def _embedded(data: Any) -> str:
    """JSON that no HTML parser takes for markup."""
    text = json.dumps(data, separators=(",", ":"), allow_nan=False)
    signs = (("<", "\\u003c"), (">", "\\u003e"), ("&", "\\u0026"))
    for sign, code in signs:
        text = text.replace(sign, code)
    return text


def _turn(turn: Turn) -> str:
    """A turn as it reads without any script."""
    kind = turn.kind if turn.kind in ("note", "flag") else turn.speaker
    marks = [] if turn.holds else ['<em class="mark">taken back</em>']
    question = f'<em class="mark">{turn.question}</em>' if turn.question else ""
    said = "".join(f"<p>{escape(visible(text))}</p>" for text in turn.texts if text)
    who = "Robot" if turn.speaker == "robot" else "Teacher"
    name = {"note": "Note", "flag": "Flag"}.get(turn.kind, who)
    undone = "" if turn.holds else " undone"
    return (
        f'<li class="{kind}{undone}" value="{turn.number}">'
        f"<b>{name}</b>{question}{''.join(marks)}{said or '<p>&nbsp;</p>'}</li>"
    )


def _told(turn: Turn, sights: Mapping[str, int]) -> dict[str, Any]:
    """What the script shows beside a turn, all text made visible."""
    beliefs: Mapping[str, Any] = turn.beliefs or {"grounding": [], "goals": [], "uncertain": []}
    unsure = sorted(beliefs["uncertain"], key=_certainty)
    told: dict[str, Any] = {
        "sight": sights.get(turn.world),
        "at": round(turn.at, 1),
        "phase": turn.phase,
        "reward": turn.reward,
        "phrases": [
            {"name": one["phrase"], "bars": _bars(one["objects"])} for one in beliefs["grounding"]
        ],
        "goals": _bars([(", ".join(g["goal"]), g["share"]) for g in beliefs["goals"]]),
        "uncertain": _bars(unsure),
        "unlisted": max(0, len(unsure) - _BEST),
        "choices": [_choice(one) for one in turn.decisions],
        "verbs": list(turn.verbs_learned),
    }
    shown: dict[str, Any] = _visible(told)
    return shown


def _certainty(pair: tuple[str, float]) -> float:
    return abs(pair[1] - 0.5)


def _bars(pairs: Iterable[Iterable[Any]]) -> list[list[Any]]:
    return [[name, round(share, 4)] for name, share in pairs][:_BEST]


def _choice(decision: Mapping[str, Any]) -> dict[str, Any]:
    chosen = decision["chosen"]
    rated = [(one, index == chosen) for index, one in enumerate(decision["candidates"])]
    rated.sort(key=lambda pair: (not pair[1], -(pair[0]["q"] or 0.0)))
    return {
        "reason": decision["reason"],
        "candidates": [[_act(one["act"]), one["q"], is_it] for one, is_it in rated[:_BEST]],
        "more": max(0, len(rated) - _BEST),
    }


def _act(act: Mapping[str, Any]) -> str:
    arguments = [_argument(value) for key, value in act.items() if key != "act" and value]
    return " ".join([str(act.get("act")), *filter(None, arguments)])


def _argument(value: Any) -> str:
    if isinstance(value, list):
        return ", ".join(map(_argument, value))
    return "" if value is True else str(value)


def _visible(value: Any) -> Any:
    if isinstance(value, str):
        return visible(value)
    if isinstance(value, Mapping):
        return {key: _visible(item) for key, item in value.items()}
    return [_visible(item) for item in value] if isinstance(value, list) else value

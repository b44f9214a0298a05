"""`verbteach parse`: what the robot reads in a command."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from verbteach_tui.commands.parameters import JsonFlag, SceneOption, ScenesFolder
from verbteach_tui.commands.streams import emit, note, tell
from verbteach_tui.near import known


def parse(
    text: Annotated[str, typer.Argument(metavar="TEXT", help="The command, in English.")],
    scene: SceneOption = None,
    scenes: ScenesFolder = None,
    as_json: JsonFlag = False,
) -> None:
    """Show the frames that the robot reads in a command: verb, roles and heads.

    With a scene its nouns are known. Where nothing can be read the list is empty.
    """
    from verbteach.language.grammar import explain_unread
    from verbteach.language.grammar import parse as read
    from verbteach.language.notation import as_data, write_frames
    from verbteach_scenarios.lexicon_file import load_lexicon

    lexicon, nouns = load_lexicon(scenes), _nouns(scene, scenes)
    frames = read(text, lexicon, nouns)
    if as_json:
        emit(as_data(frames))
    elif frames:
        tell(write_frames(frames))
    else:
        why = explain_unread(text, lexicon, nouns)
        note(f"nothing can be read in this ({why.value if why else 'unclear'})")


def _nouns(scene: str | None, folder: Path | None) -> tuple[str, ...]:
    """What people call the objects of the scene, as the robot knows it there."""
    from verbteach_scenarios.scenes import load_scene, scene_ids

    if scene is None:
        return ()
    found = load_scene(known(scene, scene_ids(folder), "scene"), folder)
    return tuple(name for thing in found.objects.values() for name in thing.names)

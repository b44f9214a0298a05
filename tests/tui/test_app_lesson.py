"""The main job in the app: a command, a demonstration, a verb, another scene, an execution."""

from __future__ import annotations

from pathlib import Path

import pytest
from textual.widgets import OptionList

from tests.tui.room import AS_STEERED, ASKED, OPEN_THE_FRIDGE, TAUGHT, Room, room
from verbteach.dialogue import acts
from verbteach.world.fluents import Fluent
from verbteach_tui.options import OpenHome, OpenSession
from verbteach_tui.screens.teach import TeachScreen
from verbteach_tui.widgets.command_input import CommandInput
from verbteach_tui.widgets.execution_view import ExecutionView
from verbteach_tui.widgets.key_bar import KeyBar
from verbteach_tui.widgets.read_back_view import ReadBackView
from verbteach_tui.widgets.scene_view import SceneView


async def test_a_verb_is_taught_and_carried_out_elsewhere_by_keyboard_alone(tmp_path: Path) -> None:
    async with room(tmp_path, OpenHome()) as here:
        await here.choose("scene-list", "kitchen-1")
        assert isinstance(here.app.screen, TeachScreen)
        here.hurry()

        await here.pilot.press(*"open", "space", *"the", "space", *"fridge")
        await here.key("enter")
        assert here.phase == "demonstration"

        await here.choose("actions", "go to …")
        await here.choose("objects", "fridge")
        await here.choose("actions", "open …")
        await here.choose("objects", "fridge")
        assert "open the fridge" in here.dialogue
        await here.key("d")
        assert here.phase == "read_back"
        await here.key("y")
        assert here.phase == "command"
        assert 'I have learned "open"' in here.dialogue

        await here.key("f6")
        await here.choose("scene-list", "kitchen-2")
        assert here.teach.snapshot.scene == "kitchen-2"
        await here.pilot.press(*"open", "space", *"the", "space", *"fridge")
        await here.key("enter")
        assert here.phase == "judgement"
        assert Fluent("open", ("Fridge_1",)) in here.teach.snapshot.moment.state
        await here.key("g")
        assert here.phase == "command"
        assert here.teach.snapshot.figures.successes == 1


async def test_the_same_by_mouse_alone(tmp_path: Path) -> None:
    async with room(tmp_path) as here:
        await here.line("open the fridge")
        await _click_option(here, "actions", "go to …")
        await here.click_target(here.teach.query_one(SceneView), "Fridge_1")
        await _click_option(here, "actions", "open …")
        await _click_option(here, "objects", "fridge")
        await here.click_target(here.teach.query_one(KeyBar), "done")
        assert here.phase == "read_back"
        await here.click_target(here.teach.query_one(KeyBar), "good")
        assert here.phase == "command"
        assert here.teach.snapshot.figures.verbs == 1


async def _click_option(here: Room, list_id: str, label: str) -> None:
    options = here.app.screen.query_one(f"#{list_id}", OptionList)
    prompts = [str(getattr(o.prompt, "plain", o.prompt)) for o in options.options]
    options.highlighted = prompts.index(label)
    await here.pilot.pause()
    row = options.highlighted - options.scroll_offset.y
    assert await here.pilot.click(options, offset=(3, row))
    await here.settle()


async def test_a_part_of_the_goal_is_struck_and_kept_by_key_and_by_mouse(tmp_path: Path) -> None:
    async with room(tmp_path, after=ASKED) as here:
        view = here.teach.query_one(ReadBackView)
        before = here.teach.snapshot.parts
        assert view.has_focus
        kept = next(index for index, part in enumerate(before) if part.kept)
        await here.key("space")
        assert not here.teach.snapshot.parts[kept].kept
        await here.click_target(view, str(kept))
        assert here.teach.snapshot.parts == before
        said = [line.text for line in here.teach.snapshot.lines if line.speaker == "teacher"]
        assert [text.split(":")[0] for text in said[-2:]] == ["strike", "keep"]


async def test_a_wrong_execution_leads_to_a_demonstration_in_the_world_as_it_was(
    tmp_path: Path,
) -> None:
    async with room(tmp_path, after=(*TAUGHT, "scene: kitchen-2")) as here:
        before = here.teach.snapshot.moment.state
        await here.line("open the fridge")
        assert here.teach.snapshot.moment.state != before
        await here.key("b")
        assert here.phase == "demonstration"
        assert here.teach.snapshot.moment.state == before


async def test_an_execution_is_watched_step_by_step_and_stopped(tmp_path: Path) -> None:
    async with room(tmp_path, speed=AS_STEERED, after=(*TAUGHT, "scene: kitchen-2")) as here:
        await here.line("open the fridge")
        assert here.teach.query_one(ExecutionView).has_focus
        assert here.teach.query_one(SceneView).border_subtitle == ""
        await here.key("right")
        await here.key("left")
        await here.key("right")
        stopped = here.teach.snapshot.waiting
        assert isinstance(stopped, acts.SelectHypo)
        await here.key("x")
        assert here.phase == "demonstration"
        assert here.teach.snapshot.lines[-2].text == "1"


async def test_the_scene_follows_the_execution(tmp_path: Path) -> None:
    async with room(tmp_path, speed=AS_STEERED, after=(*TAUGHT, "scene: kitchen-2")) as here:
        await here.line("open the fridge")
        scene = here.teach.query_one(SceneView)
        assert "fridge ■ shut" in scene.text
        await here.key("right")
        assert "fridge ■ shut ◂ robot" in scene.text
        await here.key("e")
        assert "fridge ✱◫ open" in scene.text


async def test_undo_and_redo_work_at_any_time_and_restore_everything(tmp_path: Path) -> None:
    async with room(tmp_path) as here:
        await here.line("open the fridge")
        digests = [here.teach.teaching.session.robot.state.digest]
        for text in (*OPEN_THE_FRIDGE, "done", "yes"):
            await here.line(text)
            digests.append(here.teach.teaching.session.robot.state.digest)
        for digest in reversed(digests[:-1]):
            await here.key("ctrl+z")
            assert here.teach.teaching.session.robot.state.digest == digest
        for digest in digests[1:]:
            await here.key("ctrl+y")
            assert here.teach.teaching.session.robot.state.digest == digest


async def test_single_keys_undo_and_redo_while_a_question_waits(tmp_path: Path) -> None:
    async with room(tmp_path, after=ASKED) as here:
        await here.key("u")
        assert here.phase == "demonstration"
        await here.key("U")
        assert here.phase == "read_back"


async def test_a_session_is_left_and_gone_on_with(tmp_path: Path) -> None:
    async with room(tmp_path, OpenHome()) as here:
        await here.choose("scene-list", "kitchen-1")
        await here.lines("open the fridge", *OPEN_THE_FRIDGE)
        shown, digest = here.dialogue, here.teach.teaching.session.robot.state.digest
        path = here.teach.teaching.session.path
        await here.key("f10")
        assert not isinstance(here.app.screen, TeachScreen)
        await here.pilot.pause(0.2)
        listed = here.app.screen.query_one("#sessions", OptionList).get_option_at_index(0)
        assert "kitchen-1" in str(listed.prompt)
        assert "✗" not in str(listed.prompt)
        await here.key("c")
        await here.key("enter")
        assert here.teach.teaching.session.path == path
        assert (here.dialogue, here.teach.teaching.session.robot.state.digest) == (shown, digest)

    async with room(tmp_path, OpenSession(path)) as here:
        assert here.dialogue == shown
        await here.lines("done", "yes")
        assert here.teach.snapshot.figures.verbs == 1


async def test_a_refused_step_says_why_and_changes_nothing(tmp_path: Path) -> None:
    async with room(tmp_path) as here:
        await here.line("open the fridge")
        before = here.teach.snapshot.moment.state
        await here.line("open the fridge")
        assert here.phase == "demonstration"
        assert here.teach.snapshot.moment.state == before
        assert here.teach.snapshot.problem.startswith("That cannot be done now")
        assert here.teach.snapshot.shown == ()


async def test_a_typed_step_is_completed(tmp_path: Path) -> None:
    async with room(tmp_path) as here:
        await here.line("open the fridge")
        entry = here.teach.query_one(CommandInput)
        entry.focus()
        await here.pilot.press(*"go", "space", *"to", "space", *"frid")
        await here.pilot.pause(0.1)
        await here.pilot.press("right")
        assert entry.value == "go to fridge"
        await here.key("enter")
        assert here.teach.snapshot.shown == ("go to the fridge",)
        assert entry.has_focus, "one typed step follows another"


async def test_going_back_in_the_lists_gives_up_the_last_choice(tmp_path: Path) -> None:
    async with room(tmp_path) as here:
        await here.line("open the fridge")
        await here.choose("actions", "go to …")
        assert here.app.focused is not None
        assert here.app.focused.id == "objects"
        await here.key("left")
        assert here.app.focused.id == "actions"
        assert here.teach.snapshot.shown == ()


async def test_what_was_said_keeps_the_words_of_its_scene(tmp_path: Path) -> None:
    async with room(tmp_path) as here:
        await here.lines("open the fridge", "go to the left knob", *OPEN_THE_FRIDGE, "done", "yes")
        before = here.dialogue
        await here.line("scene: living-room-1")
        assert here.dialogue.startswith(before)
        path = here.teach.teaching.session.path
    async with room(tmp_path, OpenSession(path)) as here:
        assert here.dialogue.startswith(before)


async def test_a_command_the_robot_offers_is_taken_up_with_a_click(tmp_path: Path) -> None:
    async with room(tmp_path) as here:
        await here.line("opne the fridge")
        assert here.teach.snapshot.suggested == "open the fridge"
        bar = here.teach.query_one(KeyBar)
        await here.click_target(bar, "command: yes")
        assert here.phase == "demonstration"
        assert here.teach.snapshot.command == "open the fridge"


async def test_nothing_moves_by_itself_over_a_slow_line(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("SSH_CONNECTION", "a 1 b 2")
    monkeypatch.delenv("TEXTUAL_ANIMATIONS", raising=False)
    async with room(tmp_path) as here:
        assert here.app.animation_level == "none"


async def test_the_key_that_leads_to_the_line_is_no_part_of_it(tmp_path: Path) -> None:
    async with room(tmp_path) as here:
        await here.pilot.press("slash", *"open", "slash", "space", *"it")
        assert here.teach.query_one(CommandInput).value == "open/ it"

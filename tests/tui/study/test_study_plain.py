"""A study in plain lines, from the consent to the thanks."""

from __future__ import annotations

import json
from hashlib import sha256
from pathlib import Path

import pytest

from tests.study.files import SMALL
from tests.tui.room import SETTINGS
from tests.tui.study.led import SHOW, WHOLE, begun, plainly, sessions_of, study_file, visit_events
from verbteach_scenarios.weights import STARTING
from verbteach_sessions.eventlog import LogReader
from verbteach_sessions.validate import validate
from verbteach_tui.plain_talk import MisfitError
from verbteach_tui.plain_words import LOCAL
from verbteach_tui.study.lesson_talk import _PANELS_OF
from verbteach_tui.study.plain_study import StudyTalk
from verbteach_tui.study.words import GOES_ON, STOP_ASKED

SHOWN = "\n".join(SHOW)
ONE_PANEL = SMALL.replace('policy = "manual"', 'policy = "manual"\npanels = ["scene"]')


def test_a_whole_study_leaves_a_sound_record_of_all_that_was_answered(tmp_path: Path) -> None:
    printed = plainly(tmp_path, WHOLE)
    assert "Your completion code: " in printed
    practice, lessons = sessions_of(tmp_path, "pppp")
    for session in (practice, lessons):
        assert validate(session, SETTINGS).problems == ()
    header, *_, last = LogReader(lessons)
    assert header.data["participant"] == "pppp"
    study = header.data["study"]
    assert study["consent"]["answer"] == "yes"
    assert (study["step"], study["part"], study["questions"]) == ("lessons", 1, 2)
    assert study["condition"]["id"] in ("showing", "asking")
    assert header.data["parameters"]["question_cap"] == 2
    assert last.type == "questionnaire"
    assert last.data["answers"] == {
        "mental_demand": 50,
        "physical_demand": 35,
        "temporal_demand": None,
        "performance": 0,
        "effort": 100,
        "frustration": 5,
        "comment": "nothing more",
    }
    assert [kind for kind, _ in visit_events(tmp_path, "pppp")] == [
        *("enrolled", "done", "began", "done", "began", "done", "done", "finished"),
    ]


def test_a_refusal_leaves_no_trace(tmp_path: Path) -> None:
    assert "Nothing has been kept" in plainly(tmp_path, "no\n")
    assert not (tmp_path / "records").exists()
    plainly(tmp_path, "quit\n")
    assert not (tmp_path / "records").exists()


def test_anything_but_yes_or_no_is_asked_again(tmp_path: Path) -> None:
    talk = StudyTalk(begun(tmp_path, None))
    for line in ("", "maybe", "open the fridge", "yes please", "end"):
        with pytest.raises(MisfitError):
            talk.hear(line, "typed")
    assert not (tmp_path / "records").exists()


def test_a_code_is_drawn_and_told_where_there_is_none(tmp_path: Path) -> None:
    printed = plainly(tmp_path, "yes\nquit\n", code=None)
    (home,) = [path for path in (tmp_path / "records").iterdir() if path.is_dir()]
    assert len(home.name) == 10
    assert f"--participant {home.name}" in printed


def test_who_pauses_in_the_middle_goes_on_there(tmp_path: Path) -> None:
    plainly(tmp_path, "yes\nnext\nopen the fridge\ngo to the fridge\nquit\n")
    printed = plainly(tmp_path, f"open the fridge\ndone\nyes\n{SHOWN}\nopen the fridge\nquit\n")
    assert "Do you agree" not in printed
    assert "Task 2 of 2" in printed
    assert len(sessions_of(tmp_path, "pppp")) == 2
    plainly(tmp_path, "good\n" + "skip\n" * 7)
    assert visit_events(tmp_path, "pppp")[-1][0] == "finished"
    for session in sessions_of(tmp_path, "pppp"):
        assert validate(session, SETTINGS).valid


def test_who_stops_for_good_is_asked_twice_and_then_no_more(tmp_path: Path) -> None:
    printed = plainly(
        tmp_path, f"yes\nnext\n{SHOWN}\nend\nopen the fridge\nend\nend\n" + "skip\n" * 7
    )
    assert "You have stopped" in printed
    assert "Your completion code" in printed
    done = [data["why"] for kind, data in visit_events(tmp_path, "pppp") if kind == "done"]
    assert done == ["read", "tasks", "stopped", "answered"]


@pytest.mark.parametrize("word", ["no", "N", "go on", ""])
def test_who_thinks_again_goes_on_and_is_told_where(tmp_path: Path, word: str) -> None:
    talk = StudyTalk(begun(tmp_path, "pppp"))
    for line in ("yes", "next", "open the fridge"):
        talk.hear(line, "typed")
    talk.hear("/End", "typed")
    assert talk.hear("yes", "typed") == [STOP_ASKED]
    again = talk.hear(word, "typed")
    assert again[0] == GOES_ON
    assert "Task 1 of 1" in again[1]
    assert "show me" in again[2]
    talk.hear("end", "typed")
    talk.hear("End", "typed")
    talk.close()
    done = [data["why"] for kind, data in visit_events(tmp_path, "pppp") if kind == "done"]
    assert {*done} == {"read", "stopped"}


@pytest.mark.parametrize("word", ["quit", "/quit", "QUIT"])
def test_quit_pauses_the_study_however_it_is_written(tmp_path: Path, word: str) -> None:
    talk = StudyTalk(begun(tmp_path, "pppp"))
    for line in ("yes", "next"):
        talk.hear(line, "typed")
    assert "--participant pppp" in talk.hear(word, "typed")[-1]
    assert talk.ended
    talk.close()


def test_what_the_condition_hides_is_not_told(tmp_path: Path) -> None:
    text = SMALL.replace(
        'id = "asking"\npolicy = "manual"', 'id = "other"\npolicy = "manual"\npanels = []'
    )
    for code in ("aaaa", "bbbb"):
        talk = StudyTalk(begun(tmp_path, code, text))
        for line in ("yes", "next"):
            talk.hear(line, "typed")
        hidden = (
            {"seen", "mind", "verbs"}
            if begun_with(tmp_path, code) == "showing"
            else {"look", "seen", "mind", "verbs"}
        )
        for word in ("look", "seen", "mind", "verbs", "/mind", "MIND", "/ Verbs"):
            if word.strip("/ ").lower() in hidden:
                with pytest.raises(MisfitError):
                    talk.hear(word, "typed")
            else:
                assert talk.hear(word, "typed")
        talk.close()


def test_every_word_that_tells_of_a_panel_can_be_hidden() -> None:
    assert {*LOCAL} - {"help", "steps", "shown"} == {*_PANELS_OF}


def begun_with(folder: Path, code: str) -> str:
    return str(visit_events(folder, code)[0][1]["order"][0])


def test_the_task_says_which_room_and_nobody_leaves_it(tmp_path: Path) -> None:
    talk = StudyTalk(begun(tmp_path, "aaaa"))
    for line in ("yes", "next", *SHOW, *SHOW):
        last = talk.hear(line, "typed")
    assert any("galley kitchen" in line for line in last)
    with pytest.raises(MisfitError, match="which room"):
        talk.hear("scene: kitchen-1", "typed")
    talk.hear("undo", "typed")
    with pytest.raises(MisfitError, match="another room"):
        talk.hear("open the fridge", "typed")
    talk.hear("redo", "typed")
    assert talk.hear("open the fridge", "typed")
    talk.close()


@pytest.mark.parametrize(
    ("rule", "said", "why"),
    [
        ("lessons = 1", SHOWN, "lessons"),
        ("mastery = 1", f"{SHOWN}\nscene: kitchen-2\nopen the fridge\ngood", "mastery"),
        ("minutes = 0.00001", SHOWN, "minutes"),
    ],
)
def test_free_choice_ends_by_the_rule(tmp_path: Path, rule: str, said: str, why: str) -> None:
    head, _, rest = SMALL.partition("[practice]")
    _, _, conditions = rest.partition("[[condition]]")
    text = (
        f'{head}[lessons]\nscenes = ["kitchen-1", "kitchen-2"]\n{rule}\n[[condition]]{conditions}'
    )
    plainly(tmp_path, f"yes\nnext\n{said}\nquit\n", text=text)
    assert visit_events(tmp_path, "pppp")[-1] == ("done", {"step": 1, "why": why})


def test_a_study_in_several_conditions_starts_each_with_a_robot_that_knows_nothing(
    tmp_path: Path,
) -> None:
    text = (
        SMALL.replace("[study]", '[study]\ndesign = "within"')
        .replace(
            'scene = "kitchen-2"\ntext = "Open the fridge there."',
            'scene = "kitchen-2"\ntext = "Two."\npart = 2',
        )
        .replace("[questionnaire]", '[questionnaire]\nwhen = "each"')
    )
    said = f"yes\nnext\n{SHOWN}\n{SHOWN}\n" + "skip\n" * 7
    said += f"{SHOWN}\nopen the fridge\ngood\n" + "skip\n" * 7
    assert "completion code" in plainly(tmp_path, said, text=text)
    first, second = sessions_of(tmp_path, "pppp")[1:]
    conditions = {
        next(iter(LogReader(one))).data["study"]["condition"]["id"] for one in (first, second)
    }
    assert conditions == {"showing", "asking"}
    assert [list(LogReader(one))[-1].type for one in (first, second)] == ["questionnaire"] * 2


def test_the_file_may_change_but_not_for_who_has_begun(tmp_path: Path) -> None:
    plainly(tmp_path, "yes\nquit\n")
    study_file(tmp_path, SMALL.replace("Teach.", "Do not teach."))
    run = begun(tmp_path, "pppp", SMALL.replace("Teach.", "Do not teach."))
    assert run.study.instructions == "Teach."
    run.close()


def test_a_conditions_weights_are_what_the_robot_asks_by(tmp_path: Path) -> None:
    """The file's weights, held or not, are in the session's own header, and its hash beside."""
    weights = json.loads(STARTING.read_text("utf-8"))
    weights["phases"]["execution"]["weights"][0] = 0.125
    (tmp_path / "mine.json").write_text(json.dumps(weights), "utf-8")
    named = 'policy = "rl"\nweights = "mine.json"\nfreeze = true'
    text = SMALL.replace('policy = "she16"', named).replace('policy = "manual"', named)
    plainly(tmp_path, "yes\nnext\nopen the fridge\n", text=text)
    (header,) = [
        event.data for path in (tmp_path / "records" / "pppp").glob("*/events.jsonl")
        for event in LogReader(path) if event.seq == 0
    ]  # fmt: skip
    execution = header["policy"]["execution"]
    first = execution["names"].index(weights["phases"]["execution"]["features"][0])
    assert header["policy"]["frozen"] is True
    assert execution["mean"][first] == 0.125
    assert header["study"]["condition"]["weights"] == "mine.json"
    assert (
        header["study"]["condition"]["weights_hash"]
        == sha256((tmp_path / "mine.json").read_bytes()).hexdigest()
    )


def test_help_names_only_what_the_condition_shows_and_how_to_stop(tmp_path: Path) -> None:
    printed = plainly(tmp_path, "yes\nnext\nhelp\n", text=ONE_PANEL)
    assert "look: what is where" in printed
    assert "mind: what the robot" not in printed
    assert "scene: NAME" not in printed, "the task says which room it is"
    assert "end: stops taking part" in printed

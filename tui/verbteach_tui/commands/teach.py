"""`verbteach teach`: a teaching session, by a person, a script or the simulated teacher."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from shlex import quote
from typing import TYPE_CHECKING, Annotated, Any, TextIO

import typer

from verbteach_tui.beginning import Beginning, Choices
from verbteach_tui.commands.parameters import (
    JsonFlag,
    NoiseOption,
    NoiseReading,
    PolicyOption,
    SceneOption,
    ScenesFolder,
    SeedOption,
    SessionsFolder,
    ThemeOption,
    WeightsOption,
)
from verbteach_tui.commands.session_names import session_completions, session_named
from verbteach_tui.commands.streams import columns, counting, emit, note, progress, tell
from verbteach_tui.conclusion import DONE, INTERRUPTED, WRONG_USE, WrongUseError
from verbteach_tui.near import known
from verbteach_tui.options import OpenHome, Opening, OpenNew, OpenSession
from verbteach_tui.stand_ins import FITTED, StandIn, stand_in_for
from verbteach_tui.terminal import has_terminal, in_browser

if TYPE_CHECKING:
    from verbteach_sessions.session import Session

HUMAN, SIMULATED = "human", "simulated"
LESSONS = 20
WORTH_COMPILING = 100  # lessons from which on the compiled planner earns its start
NO_SESSION: Mapping[str, Any] = {
    "session": None,
    "episodes": 0,
    "successes": 0,
    "questions": 0,
    "questions_by_type": {},
    "verbs_learned": [],
    "reward": 0.0,
}


def teach(
    scene: SceneOption = None,
    teacher: Annotated[
        str,
        typer.Option(
            metavar="human|simulated|fitted:FILE|SESSION|FILE|-",
            help="Who teaches: you, the bundled lessons' teacher, a user fitted to sessions, a"
            " recorded session's teacher, or a script's lines.",
        ),
    ] = HUMAN,
    lessons: Annotated[
        int | None,
        typer.Option(min=1, metavar="N", help=f"How many the simulated teacher gives ({LESSONS})."),
    ] = None,
    wrong: Annotated[
        float | None,
        typer.Option(
            "--wrong-answers",
            min=0,
            max=1,
            metavar="P",
            help="How often its answers are wrong (0).",
        ),
    ] = None,
    unsure: Annotated[
        float | None,
        typer.Option("--dont-know", min=0, max=1, metavar="P", help="How often it can't say (0)."),
    ] = None,
    patience: Annotated[
        int | None,
        typer.Option(
            min=0, metavar="N", help="Questions a command after which it can't say (no end)."
        ),
    ] = None,
    plain: Annotated[bool, typer.Option("--plain", help="Lines instead of a full screen.")] = False,
    noise: NoiseOption = None,
    noise_reading: NoiseReading = None,
    policy: PolicyOption = None,
    weights: WeightsOption = None,
    freeze: Annotated[
        bool, typer.Option("--freeze", help="Hold the weights: ask as before, learn only verbs.")
    ] = False,
    promise: Annotated[
        float | None,
        typer.Option(
            metavar="P",
            help="Act only where that is right so often, such as .8; ask or be shown elsewhere.",
        ),
    ] = None,
    second_opinion: Annotated[
        bool | None,
        typer.Option(
            "--second-opinion/--no-second-opinion",
            help="Ask where spaCy (verbteach[nlp]) reads a command differently (no).",
        ),
    ] = None,
    source: Annotated[
        Path | None,
        typer.Option(
            "--from",
            metavar="SESSION",
            parser=session_named,
            autocompletion=session_completions,
            help="Start with this session's verbs and weights.",
        ),
    ] = None,
    participant: Annotated[
        str | None, typer.Option(metavar="CODE", help="The participant's code, for the record.")
    ] = None,
    study: Annotated[
        Path | None,
        typer.Option("--study", metavar="FILE", help="Take part in this study, as its file says."),
    ] = None,
    seed: SeedOption = None,
    sessions: SessionsFolder = None,
    resume: Annotated[
        Path | None,
        typer.Option(
            metavar="SESSION",
            parser=session_named,
            autocompletion=session_completions,
            help="Go on with this session as it began.",
        ),
    ] = None,
    scenes: ScenesFolder = None,
    theme: ThemeOption = None,
    as_json: JsonFlag = False,
) -> None:
    """Teach the robot verbs, in a session that is kept.

    Without a terminal a human teaches in plain lines. A script's line that does
    not fit ends it with status 2; what was said before is kept.
    """
    _refuse_together(
        resume,
        {
            "--scene": scene,
            "--noise": noise,
            "--noise-reading": noise_reading,
            "--policy": policy,
            "--weights": weights,
            "--freeze": freeze or None,
            "--promise": promise,
            "--second-opinion": second_opinion,
            "--from": source,
            "--participant": participant,
            "--seed": seed,
        },
    )
    if study is not None:
        _refuse_in_study(
            {
                "--scene": scene,
                "--noise": noise,
                "--noise-reading": noise_reading,
                "--policy": policy,
                "--weights": weights,
                "--freeze": freeze or None,
                "--promise": promise,
                "--second-opinion": second_opinion,
                "--from": source,
                "--seed": seed,
                "--resume": resume,
                "--teacher": None if teacher == HUMAN else teacher,
            }
        )
    if promise is not None and not 0 < promise < 1:
        raise WrongUseError(f"--promise: a success rate is between 0 and 1, not {promise:g}")
    rates = {"--wrong-answers": wrong, "--dont-know": unsure, "--patience": patience}
    stand_in = None if teacher in (HUMAN, SIMULATED) else stand_in_for(teacher)
    kind = SIMULATED if stand_in and stand_in.kind == FITTED else teacher
    _only_simulated(kind, {"--lessons": lessons})
    _only_simulated(teacher, rates)
    from verbteach_sessions.catalogue import default_folder

    default = Choices()
    beginning = Beginning(
        folder=sessions or default_folder(),
        interface=_interface(kind, plain),
        teacher=kind if kind in (HUMAN, SIMULATED) else "script",
        scenes=scenes,
        choices=Choices(
            policy or default.policy,
            noise or default.noise,
            noise_reading or default.noise_reading,
            default.seed if seed is None else seed,
            default.second_opinion if second_opinion is None else second_opinion,
            weights,
            freeze,
            promise=promise,
        ),
        participant=participant,
        before=source,
    )
    if scene is not None:
        known(scene, beginning.scene_ids(), "scene")
    out = sys.stderr if as_json else sys.stdout
    ways: Mapping[str, Callable[[], int]] = {
        "app": lambda: _on_screen(beginning, scene, resume, theme),
        "simulated": lambda: _simulated(
            beginning, scene, resume, lessons or LESSONS, (wrong or 0.0, unsure or 0.0, patience)
        ),
        "script": lambda: _scripted(beginning, teacher, scene, resume, ignore if as_json else tell),
        "browser": lambda: _on_screen(beginning, scene, resume, theme),
        "plain": lambda: _plain(beginning, scene, resume, out),
    }
    if stand_in is not None:
        own = policy or noise or noise_reading or scene or seed is not None or source or promise
        ways = {
            "simulated": lambda: _fitted(beginning, stand_in, scene, resume, lessons or LESSONS),
            "script": lambda: _recorded(beginning, stand_in, scene, resume, bool(own)),
        }
    if study is not None:
        from verbteach_tui.study.taking_part import ways as ways_in_study

        ways = ways_in_study(beginning, study, theme, out)
    again = "".join(f" {name} {rate}" for name, rate in rates.items() if rate is not None)
    count = f" --teacher {teacher} --lessons {lessons or LESSONS}"
    same = f"{count}{again}" if kind == SIMULATED else ""
    status = _interruptible(beginning, ways[beginning.interface], same)
    if (as_json and status != WRONG_USE) or not (as_json or study or in_browser()):
        _conclude(beginning, as_json)
    if status != DONE:
        raise typer.Exit(status)


def _refuse_together(resume: Path | None, given: dict[str, object]) -> None:
    for option, value in given.items():
        if resume is not None and value is not None:
            raise WrongUseError(f"--resume goes on with what the session began with: no {option}")


def _refuse_in_study(given: dict[str, object]) -> None:
    for option, value in given.items():
        if value is not None:
            raise WrongUseError(f"--study: the study's file says that, so no {option}")


def _only_simulated(teacher: str, given: Mapping[str, object]) -> None:
    for option, value in given.items():
        if value is not None and teacher != SIMULATED:
            raise WrongUseError(f"{option} is for --teacher {SIMULATED}")


def _interface(teacher: str, plain: bool) -> str:
    if teacher == SIMULATED:
        return "simulated"
    if teacher != HUMAN:
        return "script"
    if in_browser():
        return "browser"
    return "plain" if plain or not has_terminal() else "app"


def ignore(text: str) -> None:
    """Say nothing."""


def _on_screen(
    beginning: Beginning, scene: str | None, resume: Path | None, theme: str | None
) -> int:
    from verbteach_tui.room import full_screen

    if theme is not None:
        from verbteach_tui.themes import THEMES

        known(theme, [one.name for one in THEMES], "theme")
    opening: Opening = OpenSession(resume) if resume else OpenNew(scene) if scene else OpenHome()
    return full_screen(beginning, opening, theme)


def _plain(beginning: Beginning, scene: str | None, resume: Path | None, output: TextIO) -> int:
    from verbteach_tui.plain import run_plain

    with _session(beginning, scene or beginning.scene_ids()[0], resume) as session:
        return run_plain(session, output=output)


def _scripted(
    beginning: Beginning,
    script: str,
    scene: str | None,
    resume: Path | None,
    heard: Callable[[str], None],
) -> int:
    from verbteach_tui.headless import play_script, script_lines

    with (
        script_lines(script) as lines,
        _session(beginning, scene or beginning.scene_ids()[0], resume) as session,
    ):
        play_script(session, script, lines, heard)
        return DONE


def _simulated(
    beginning: Beginning,
    scene: str | None,
    resume: Path | None,
    count: int,
    rates: tuple[float, float, int | None],
) -> int:
    from verbteach.dialogue.simulated import TeacherHabits
    from verbteach.world import compiled
    from verbteach_scenarios.lessons import load_lessons
    from verbteach_tui.headless import simulate

    lessons = [one for one in load_lessons() if scene in (None, one.scene)]
    if not lessons:
        raise WrongUseError(f"there is no lesson in the scene {scene!r}")
    with _session(beginning, scene or lessons[0].scene, resume) as session, progress() as show:
        if count >= WORTH_COMPILING:
            show("planner", 0, 1)
            compiled.warm_up()
            show("planner", 1, 1)
        given = counting(show, "lessons", count)
        habits = TeacherHabits(*rates, seed=session.header.method.parameters.seed)
        simulate(session, lessons, count, beginning.setting, given, habits)
        return DONE


def _fitted(
    beginning: Beginning, user: StandIn, scene: str | None, resume: Path | None, count: int
) -> int:
    from verbteach_sessions.people.fitting import load_user
    from verbteach_tui.stand_ins import teach_as_fitted

    population = load_user(user.path).population  # before there is a session
    first = scene or beginning.scene_ids()[0]
    with _session(beginning, first, resume) as session, progress() as show:
        given = counting(show, "lessons", count)
        teach_as_fitted(session, population, count, scene, beginning, given)
        return DONE


def _recorded(
    beginning: Beginning, teacher: StandIn, scene: str | None, resume: Path | None, own: bool
) -> int:
    """As the record began, unless something else was asked for."""
    from verbteach_sessions.people.recorded import read_header
    from verbteach_tui.stand_ins import begin_as_recorded, teach_as_recorded

    if resume is not None:
        raise WrongUseError("--resume: a recorded session is taught again from its beginning")
    with (
        _session(beginning, scene or read_header(teacher.path).scene, None)
        if own
        else begin_as_recorded(beginning, teacher.path)
    ) as session:
        teach_as_recorded(session, teacher.path)
        return DONE


@contextmanager
def _session(beginning: Beginning, scene: str, resume: Path | None) -> Iterator[Session]:
    """A session that was gone on with, or a new one; closed at the end."""
    with beginning.resume(resume) if resume else beginning.create(scene) as session:
        for text in session.recovered:
            note(text)
        yield session


def _interruptible(beginning: Beginning, run: Callable[[], int], same: str) -> int:
    """Ctrl-C ends the run; the session is whole up to there, and can be gone on with.

    ``same`` are the options to give again.
    """
    try:
        return run()
    except KeyboardInterrupt:
        note("interrupted; all that was said is kept")
        if beginning.opened:
            note(f"go on: verbteach teach --resume {beginning.opened[-1].path}{same}")
        return INTERRUPTED


def _conclude(beginning: Beginning, as_json: bool) -> None:
    """Say what became of the session: the last one of this run, if there was one."""
    from verbteach_sessions.session import summary

    if not beginning.opened:
        if as_json:
            emit(NO_SESSION)
        return
    came_of_it = summary(beginning.opened[-1])
    if as_json:
        emit(came_of_it)
        return
    rows = [(key.replace("_", " "), _shown(value)) for key, value in came_of_it.items()]
    if beginning.interface in ("app", "plain"):
        scenes = f" --scenes {quote(str(beginning.scenes))}" if beginning.scenes else ""
        again = f"verbteach teach --resume {quote(came_of_it['session'])}{scenes}"
        rows.append(("to go on", again))
    tell()
    tell(columns(rows))


def _shown(value: object) -> object:
    if isinstance(value, dict):
        return ", ".join(f"{count} {name}" for name, count in value.items()) or "none"
    return (", ".join(value) or "none") if isinstance(value, list) else value

"""One participant's run through a study: between the record of the visit and the sessions in it.

Both interfaces lead it and both get the same events from it; what is shown is
not known here. Everything that touches the disk may be called from a thread.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from pathlib import Path
from shlex import quote

from verbteach.dialogue import acts
from verbteach.dialogue.moves import Phase
from verbteach_sessions.afterwards import add_questionnaire
from verbteach_sessions.names import new_code
from verbteach_sessions.script import ScriptAct
from verbteach_sessions.session import Session
from verbteach_sessions.session_acts import SessionAct
from verbteach_sessions.study.design import PANELS, Condition, Lessons, Study, Task
from verbteach_sessions.study.enrolment import has_enrolled
from verbteach_sessions.study.steps import TEACHING, Kind, Step
from verbteach_sessions.study.stopping import Standing, ended_by, task_now
from verbteach_sessions.study.study_file import parse_study
from verbteach_sessions.study.visit import Visit
from verbteach_sessions.study.weights_beside import copy_of_weights
from verbteach_tui.beginning import Beginning, Choices

VIA = "study"
"""How what the study itself does comes into a session's record."""


@dataclass
class StudyRun:
    """A participant ``code`` in the study that ``source`` says, whose records go to ``folder``.

    ``beginning`` says where sessions are held, ``file`` where the study was
    found. ``visit`` is there once the participant has consented.
    """

    study: Study
    source: bytes
    folder: Path
    code: str
    beginning: Beginning
    file: Path = Path("study.toml")
    visit: Visit | None = None
    consented: Callable[[Path], None] = field(default=lambda home: None)

    @classmethod
    def open(
        cls, file: Path, beginning: Beginning, code: str | None = None, folder: Path | None = None
    ) -> StudyRun:
        """A run of the study in ``file``; a code is drawn where there is none.

        One who has begun before is where they were. Raises ``StudyFileError``,
        ``OSError``, and what ``Visit.come_back`` raises.
        """
        source = file.read_bytes()
        study = parse_study(source, file, beginning.scene_ids(), kinds=beginning.fluent_kinds)
        run = cls(study, source, folder or beginning.folder, code or new_code(), beginning, file)
        if code is not None and has_enrolled(run.folder, code):
            run.visit = Visit.come_back(
                run.folder, study.id, code, beginning.interface, beginning.scene_ids()
            )
            run.study = run.visit.study
        return run

    # ---- the way

    @property
    def step(self) -> Step | None:
        """The step the participant is at; ``None`` before the consent."""
        return None if self.visit is None else self.visit.step

    def consent(self) -> None:
        """The participant has agreed: from now on there is a record."""
        self.visit = Visit.enter(
            self.folder, self.study, self.source, self.code, self.beginning.interface
        )
        self.consented(self.visit.home)

    @property
    def way_back(self) -> str:
        """The command by which the participant goes on, later."""
        from verbteach_sessions.catalogue import default_folder

        # In another folder the code would begin anew.
        elsewhere = self.folder != default_folder()
        where = f" --sessions {quote(str(self.folder))}" if elsewhere else ""
        study = quote(str(self.file))
        return f"verbteach teach --study {study} --participant {self.code}{where}"

    @property
    def here(self) -> Visit:
        """The visit. Raises ``RuntimeError`` before the consent."""
        if self.visit is None:
            raise RuntimeError("nothing is kept before the consent")
        return self.visit

    def close(self) -> None:
        """Let go of the record."""
        if self.visit is not None:
            self.visit.close()

    # ---- a stretch of teaching

    @property
    def lessons(self) -> Lessons:
        """What is taught in this step."""
        return self.here.lessons

    @property
    def condition(self) -> Condition:
        """What the participant meets in this step."""
        return self.here.condition

    @property
    def panels(self) -> frozenset[str]:
        """What is shown beside the dialogue."""
        return frozenset(self.condition.panels)

    @property
    def has_begun(self) -> bool:
        """Whether this step has a session already: the participant has come back to it."""
        begun = self.here.session
        return begun is not None and begun.is_dir()

    def open_session(self) -> Session:
        """The session of this step: the one that was begun, or a new one. Raises as those do."""
        visit = self.here
        if visit.session is not None and self.has_begun:
            return self._with(visit).resume(visit.session)
        session = self._with(visit).create(visit.lessons.first_scene(visit.step.part))
        visit.began(session.path.name)
        return session

    def standing(self, session: Session) -> Standing:
        """How far the session is."""
        return Standing.of(session.turns(), session.now())

    def task(self, session: Session) -> Task | None:
        """What the participant is asked to do now, where the study says."""
        return task_now(self.lessons, self.here.step.part, self.standing(session))

    def over(self, session: Session) -> str:
        """Why the stretch is over, or nothing."""
        return ended_by(self.lessons, self.here.step.part, self.standing(session))

    def moves(self, session: Session, said: ScriptAct | None) -> acts.GoToScene | None:
        """The next task's scene, where it is another; ``said`` is what the participant said last.

        Nobody is moved who has just gone back, or else nothing before could be undone.
        """
        if isinstance(said, SessionAct) or session.ended:
            return None
        task = self.task(session)
        if task is None or session.turn.phase is not Phase.COMMAND:
            return None
        scene = session.robot.state.scene
        return None if scene == task.scene else acts.GoToScene(task.scene)

    def refusal(self, session: Session, act: ScriptAct) -> str:
        """Why the study does not allow the act here, or nothing."""
        task, scenes = self.task(session), self.lessons.scenes
        if isinstance(act, acts.GoToScene):
            if task is not None:
                return "in this study the task says which room it is"
            if act.scene not in scenes:
                return f"in this study there are the rooms: {', '.join(scenes)}"
        wrong_room = task is not None and task.scene != session.robot.state.scene
        if isinstance(act, acts.Command) and wrong_room:
            return "this task is in another room: say redo to go back there"
        return ""

    def finish(self, why: str) -> None:
        """This stretch, whose session is closed, is over."""
        self.here.done(why)

    def answered(self, answers: dict[str, int | str | None], seconds: float) -> None:
        """The questionnaire is filled in: it goes into the record of the last session.

        Raises ``ValueError`` for an answer that is none.
        """
        visit = self.here
        checked = visit.study.questionnaire.checked(answers)
        if visit.last_session is not None:
            part = f"-{visit.step.part}" if visit.step.part else ""
            add_questionnaire(visit.last_session, f"{visit.study.id}{part}", checked, seconds)
        visit.done("answered")

    def _weights(self, condition: Condition) -> Path | None:
        """The copy that was kept when the participant began, whatever the file says now."""
        named = condition.weights_hash
        return copy_of_weights(self.folder, named) if named else None

    def _with(self, visit: Visit) -> Beginning:
        """How this step's session begins."""
        condition = visit.condition
        choices = Choices(
            policy=condition.policy,
            noise=condition.noise,
            noise_reading=condition.noise_reading,
            seed=visit.seed,
            questions=visit.lessons.stop.questions,
            weights=self._weights(condition),
            freeze=condition.freeze,
        )
        return replace(
            self.beginning,
            folder=visit.home,
            choices=choices,
            participant=visit.code,
            study=visit.header(),
        )


def shows_all(run: StudyRun) -> bool:
    """Whether the condition hides no panel."""
    return run.panels == frozenset(PANELS)


def is_teaching(step: Step | None) -> bool:
    """Whether the step has a session."""
    return step is not None and step.kind in TEACHING


def is_practice(step: Step | None) -> bool:
    """Whether the step is only for practice."""
    return step is not None and step.kind is Kind.PRACTICE

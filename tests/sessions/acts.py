"""Strategies for every act a teacher can take."""

from __future__ import annotations

from hypothesis import strategies as st

from verbteach.dialogue import acts
from verbteach.world.fluents import Fluent, Literal
from verbteach.world.plan import Action
from verbteach_sessions import session_acts
from verbteach_sessions.script import WORDS, ScriptAct

names = st.from_regex(r"[A-Za-z][A-Za-z0-9_-]{0,12}", fullmatch=True)
fluents = st.builds(Fluent, names, st.lists(names, max_size=3).map(tuple))
literals = st.builds(Literal, fluents, st.booleans())
actions = st.builds(Action, names, st.lists(names, max_size=3).map(tuple))
numbers = st.integers(1, 99)
frames = st.builds("{}/{}".format, names, st.integers(0, 3))
hypotheses = st.frozensets(literals, min_size=1, max_size=3)
texts = st.text(max_size=40)

script_acts: st.SearchStrategy[ScriptAct] = st.one_of(
    st.sampled_from(sorted(WORDS.values(), key=lambda act: act.name)),
    texts.map(acts.Command),
    texts.map(acts.Say),
    texts.map(session_acts.Note),
    names.map(acts.Point),
    names.map(acts.GoToScene),
    actions.map(acts.Do),
    literals.map(acts.Strike),
    literals.map(acts.Keep),
    st.integers(0, 10**6).map(acts.Stop),
    st.builds(acts.Insert, numbers, actions),
    st.builds(acts.Remove, numbers, numbers),
    st.builds(acts.Move, numbers, numbers),
    st.builds(acts.RuleOut, frames, hypotheses, literals),
    st.builds(acts.Confirm, frames, hypotheses, literals),
    numbers.map(session_acts.Undo),
    numbers.map(session_acts.Redo),
)

"""Commands are read as people mean them; nothing makes the grammar fail or wander."""

from __future__ import annotations

import time

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.language.strategies import ADJECTIVES, NOUNS, TEXTS, WORD_SALADS
from verbteach.language.frames import VerbFrame
from verbteach.language.grammar import Unread, explain_unread, parse
from verbteach.language.lexicon import Lexicon
from verbteach.language.notation import as_data, read_frames, write_frames

READ = {
    "particle before": ("turn on the tv", "turn_on(obj=tv)"),
    "particle after": ("turn the tv on", "turn_on(obj=tv)"),
    "particle after a place": (
        "turn the light on the desk off",
        "turn_off(obj=light[on:desk])",
    ),
    "preposition, not particle": ("put the lid on the jar", "put(obj=lid; on=jar)"),
    "clauses": (
        "take the cup and fill it with water",
        "take(obj=cup) && fill(obj=it; with=water)",
    ),
    "gapping": (
        "put the fork in the sink and the knife on the table",
        "put(obj=fork; in=sink) && put(obj=knife; on=table)",
    ),
    "gapping with particles": (
        "turn the tv on and the light off",
        "turn_on(obj=tv) && turn_off(obj=light)",
    ),
    "gapping with recipients": (
        "give mary the book and john the pen",
        "give(obj=book; to=mary) && give(obj=pen; to=john)",
    ),
    "shared object": ("wash and dry the plates", "wash(obj=plate) && dry(obj=plate)"),
    "pronouns stay": (
        "grab the cups and put them there",
        "grab(obj=cup) && put(obj=them; loc=there)",
    ),
    "politeness": ("could you please be so kind as to open the fridge", "open(obj=fridge)"),
    "wishes": ("i would like you to open the fridge", "open(obj=fridge)"),
    "gerund": ("would you mind closing the door", "close(obj=door)"),
    "prohibition": ("please don't open the window", "not_open(obj=window)"),
    "coordination": (
        "grab the cup, the plate and a spoon",
        "grab(obj=cup; obj=plate; obj=spoon)",
    ),
    "tool first": ("use the sponge to wipe the table", "wipe(obj=table; with=sponge)"),
    "tool in front": ("with the sponge, wipe the table", "wipe(obj=table; with=sponge)"),
    "relative clause": ("take the mug that is on the table", "take(obj=mug[on:table])"),
    "reduced relative": ("take the mug lying on the table", "take(obj=mug[on:table])"),
    "object relative": ("take the thing you are holding", "take(obj=thing[you_hold])"),
    "contents": ("take the bowl full of soup", "take(obj=bowl[with:soup])"),
    "place that tells which": ("grab the mug on the table", "grab(obj=mug[on:table])"),
    "place that is a goal": ("put the mug on the table", "put(obj=mug; on=table)"),
    "place before a goal": (
        "put the mug on the table into the sink",
        "put(obj=mug[on:table]; into=sink)",
    ),
    "recipient": ("bring me the red mug", "bring(obj=mug[red]; to=me)"),
    "unknown verb": ("blorp the mug", "blorp(obj=mug)"),
    "unknown noun": ("grab the fleeb from the shelf", "grab(obj=fleeb; from=shelf)"),
    "noun as a verb": ("book the table and table the book", "book(obj=table) && table(obj=book)"),
    "adverb of place": ("bring it over here", "bring(obj=it; loc=here)"),
    "left and right": ("turn left", "turn(loc=left)"),
    "subordinate clause": ("when you are done, lock the door", "lock(obj=door)"),
    "subordinate without a comma": ("if it is hot turn the stove off", "turn_off(obj=stove)"),
    "complement": ("make sure the tv is off", "make_sure()"),
    "causative": ("let the water boil", "boil(obj=water)"),
    "result": ("leave the door open", "leave_open(obj=door)"),
    "calling the robot": ("hey robot, wash the cup", "wash(obj=cup)"),
    "duration": ("wait two minutes", "wait(for=minute[two])"),
    "sentences": ("Open the fridge. Take the milk!", "open(obj=fridge) && take(obj=milk)"),
    "no conjunction": ("take the bowl wash the bowl", "take(obj=bowl) && wash(obj=bowl)"),
    "possessive": ("fetch dad's slippers", "fetch(obj=slipper[dad])"),
    "one of several": ("take one of the cups", "take(obj=cup)"),
    "dislocation": ("the red mug, put it in the sink", "put(obj=it; in=sink)"),
}
UNREAD = {
    "": Unread.EMPTY,
    "  \t ": Unread.EMPTY,
    "!?!": Unread.NO_WORDS,
    "42": Unread.NO_WORDS,
    "\x00\x1b[31m\x07": Unread.NO_WORDS,
    "🙂🙂": Unread.NO_WORDS,
    "煮水": Unread.NOT_ENGLISH,
    "Поставь чашку на стол": Unread.NOT_ENGLISH,
    "mets la tasse sur la table": Unread.NOT_ENGLISH,
    "Stell die Tasse auf den Tisch": Unread.NOT_ENGLISH,
    "where is the mug?": Unread.QUESTION,
    "is the tv on": Unread.QUESTION,
    "the red mug": Unread.NO_VERB,
    "mug on the table": Unread.NO_VERB,
    "the water should be hot": Unread.NO_VERB,
    "thank you": Unread.NO_VERB,
}
REPEATED = (
    "and a ", "put the cup on the table and ", "of the x ", "could you ", "that is on the ",
    "when you ", "go and ", "put ", "x", "x ", ", ", "'s ", "red and ", "one of the ", "keep ",
    "put a in b and c ", "the mug that is ", "the thing you put ", "煮", "🙂 ", "\x1b[31m",
)  # fmt: skip


@pytest.mark.parametrize(("text", "expected"), READ.values(), ids=READ.keys())
def test_what_the_grammar_reads(text: str, expected: str) -> None:
    assert write_frames(parse(text)) == expected


@pytest.mark.parametrize(("text", "why"), UNREAD.items())
def test_nothing_read_has_a_reason(text: str, why: Unread) -> None:
    assert parse(text) == ()
    assert explain_unread(text) is why


def test_what_is_read_needs_no_explanation() -> None:
    assert explain_unread("boil the water") is None


def test_the_scene_and_the_lexicon_add_words() -> None:
    taught = Lexicon(particles={"zap": frozenset({"over"})})
    assert write_frames(parse("zap over the dax", taught)) == "zap_over(obj=dax)"
    assert write_frames(parse("zap over the dax")) == "zap(over=dax)"
    assert parse("zork on the table", vocabulary=("zork",)) == ()
    assert parse("bring the dax glasses", vocabulary=("dax glasses",))[0].phrases[0].head == (
        "glasses"
    )


@given(TEXTS)
def test_any_text_is_read_without_complaint(text: str) -> None:
    assert (explain_unread(text) is None) == bool(parse(text))


@given(WORD_SALADS)
def test_any_words_in_any_order_give_well_formed_frames(text: str) -> None:
    for frame in parse(text):
        assert frame.verb.strip() == frame.verb != ""
        assert all(a.role and a.phrase.head and a.phrase.text for a in frame.arguments)
        assert hash(frame) == hash(frame)


@given(WORD_SALADS)
def test_reading_is_the_same_every_time_and_whatever_the_case(text: str) -> None:
    assert parse(text) == parse(text.upper())


@pytest.mark.parametrize("piece", REPEATED)
def test_long_input_is_quick(piece: str) -> None:
    text = (piece * 10_000)[:10_000]
    begin = time.perf_counter()
    frames = parse(text)
    assert time.perf_counter() - begin < 5
    assert repr(frames)


def _shown(frame: VerbFrame) -> str:
    words = [frame.verb.partition(" ")[0]]
    for argument in frame.arguments:
        determined = ["the", *argument.phrase.modifiers, argument.phrase.head]
        words += [*([] if argument.role == "obj" else [argument.role]), *determined]
    return " ".join([*words, *frame.verb.split(" ")[1:2]])


@given(
    st.sampled_from(["take", "open", "wash", "grab", "turn on", "pick up", "switch off"]),
    st.lists(ADJECTIVES, max_size=2, unique=True),
    NOUNS,
)
def test_a_frame_in_words_reads_back(verb: str, adjectives: list[str], noun: str) -> None:
    inner = f"[{','.join(adjectives)}]" if adjectives else ""
    frames = read_frames(f"{verb.replace(' ', '_')}(obj={noun}{inner})")
    assert write_frames(parse(_shown(frames[0]))) == write_frames(frames)


@given(st.sampled_from(["on", "in", "under", "next to"]), NOUNS, NOUNS)
def test_a_goal_in_words_reads_back(preposition: str, noun: str, place: str) -> None:
    frames = read_frames(f"put(obj={noun}; {preposition.replace(' ', '_')}={place})")
    assert write_frames(parse(_shown(frames[0]))) == write_frames(frames)


def test_the_data_form_is_the_command_line_contract() -> None:
    (frame,) = as_data(parse("bring me the red mug on the counter"))
    assert frame["verb"] == "bring"
    assert [(a["role"], a["head"], a["modifiers"]) for a in frame["arguments"]] == [
        ("obj", "mug", ["red", "on:counter"]),
        ("to", "me", []),
    ]


@pytest.mark.parametrize(
    ("said", "meant"),
    [
        ("Have the robot boil some water.", "boil some water"),
        ("tell our robot to open the fridge", "open the fridge"),
        ("the robot should turn on the television", "turn on the television"),
        ("i want the robot to wash the mug", "wash the mug"),
    ],
)
def test_a_task_given_as_of_the_robot_is_the_command_to_it(said: str, meant: str) -> None:
    assert parse(said) == parse(meant)

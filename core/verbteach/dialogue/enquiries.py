"""Questions that a person asks the robot: where things are, how they are, what it has learned.

Answered from what the robot sees, which uncertain eyes may have wrong. What it
cannot answer it says, with what it can.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from verbteach.dialogue.draft import Draft
from verbteach.dialogue.facts import Facts
from verbteach.dialogue.referring import read_noun_phrase
from verbteach.dialogue.seeing import perceived
from verbteach.dialogue.speech import Speech
from verbteach.language.distinguish import distinguish_by_looks
from verbteach.language.first_person import first_person
from verbteach.language.grammar import parse
from verbteach.language.looking import is_mental
from verbteach.language.looks import Looks
from verbteach.language.morphology import listing
from verbteach.language.refer import refer
from verbteach.language.small_talk import asks_in_a_command, small_talk
from verbteach.language.tokens import COMMA, STOP, spelled_out, tokenise
from verbteach.language.wordlist import phrase_list, word_set
from verbteach.language.words import PREPOSITIONS, QUESTION_WORDS
from verbteach.world.fluents import Fluent, Literal

_MOST_TOLD = 4
_MOST_LISTED = 10
Words = tuple[str, ...]


def answer(draft: Draft, text: str) -> str:
    """The answer to a question in a sentence or two; empty where the robot has none."""
    words = tuple(t for t in tokenise(spelled_out(text)) if t not in {COMMA, STOP, "please"})
    while words[:1] and words[0] in _BEFORE:
        words = words[1:]
    told_to = next((lead for lead in _TELL if words[: len(lead)] == lead), ())
    asked = words[len(told_to) :]
    if asked[:1] and asked[0] in _ASKED and asked[:2] != ("how", "to"):
        words = _straight(asked)
    if talk := next((told for those, told in _WHOLE if words in those), None):
        return talk(draft)
    return _told(draft, words) or _asked_to(draft, words)


def asked(draft: Draft, text: str) -> str:
    """The answer where ``text`` is a question, whatever the robot waits for; else empty."""
    tokens = tokenise(spelled_out(text))
    asks = text.rstrip().endswith("?") or (bool(tokens) and tokens[0] in QUESTION_WORDS | _COPULAS)
    return answer(draft, text) if asks or asks_in_a_command(text) else ""


def _told(draft: Draft, words: Words) -> str:
    """The answer to a question about things or about a verb."""
    for leads, told in _ANSWERS:
        lead = next((lead for lead in leads if words[: len(lead)] == lead), ())
        if lead and words[len(lead) :] and (said := told(draft, words[len(lead) :])):
            return said
    if words[:1] and words[0] in _COPULAS and (said := _how_it_is(draft, words[1:])):
        return said
    return "To hear why I asked or did something, say why." if words[:1] == ("why",) else ""


def _asked_to(draft: Draft, words: Words) -> str:
    """The answer to "can you find the mug?", "can you fly?"."""
    if words[:2] not in _REQUESTS or not words[2:] or small_talk(" ".join(words)):
        return ""
    return _told(draft, words[2:]) or (_how_to(draft, words[2:]) if words[0] in _ABLE else "")


def _straight(words: Words) -> Words:
    """The question in "if the fridge is open": is the fridge open."""
    at = next((at for at, word in enumerate(words) if word in _COPULAS), 0)
    if words[:1] in {("if",), ("whether",), ("that",)} and at:
        return (words[at], *words[1:at], *words[at + 1 :])
    return words


def _my_place(draft: Draft) -> str:
    return f"I am in {_speech(draft).place}."


def known_verbs(draft: Draft) -> str:
    """The verbs that the robot has learned, as a sentence."""
    verbs = [f'"{verb}"' for verb in draft.state.knowledge.verbs]
    return f"I have learned {listing(verbs)}." if verbs else _NOTHING_LEARNED


def _speech(draft: Draft) -> Speech:
    """The words for what the robot sees just now."""
    belief = perceived(draft, draft.state.world, "before")
    return Speech.of(draft.mind.setting, belief.believed())


def _how_to(draft: Draft, words: Words) -> str:
    """Whether the robot knows a verb: "do you know how to boil water?"."""
    setting = draft.mind.setting
    frames = parse(" ".join(words), setting.lexicon, setting.vocabulary)
    if len(frames) != 1:
        return ""
    if is_mental(frames[0]):
        return ""
    verb = frames[0].verb
    if verb in draft.state.knowledge.verbs:
        return f'Yes, I have learned "{verb}": tell me to, and I do it.'
    return f'No, I have not learned "{verb}" yet: tell me to, and then show me.'


def _where(draft: Draft, words: Words) -> str:
    speech = _speech(draft)
    words = words[:-1] if words[-1] in _AT_THE_END and words[1:] else words
    things = _things(draft, words, speech.looks)
    if not things:
        return f'I see nothing that I would call "{" ".join(words)}".'
    told = [_place(thing, speech) for thing in things[:_MOST_TOLD]]
    more = f" I see {len(things) - len(told)} more." if len(things) > len(told) else ""
    return " ".join(told) + more


def _at(draft: Draft, words: Words) -> str:
    """What is to be seen where one looks: "look at the fridge", "look in the fridge"."""
    if words[0] in PREPOSITIONS - {"at", "for", "to", "after", "over", "like"}:
        return _what_is_there(draft, words)
    words = words[words[0] in _TOWARDS :]
    speech = _speech(draft)
    things = _things(draft, words, speech.looks) if words else []
    if not things:
        return _where(draft, words) if words else ""
    return " ".join(
        told
        for thing in things[:_MOST_TOLD]
        for told in (_place(thing, speech), *_states(thing, draft, speech))
    )


def _states(thing: str, draft: Draft, speech: Speech) -> Iterator[str]:
    """How a thing is: what is so, and what is the other of two states, as closed is."""
    task, lexicon = draft.mind.setting.task, draft.mind.setting.lexicon
    for predicate, _, is_false in speech.looks.names.adjectives:
        fluent = Fluent(predicate, (thing,))
        holds = fluent in speech.looks.state
        told = holds or (is_false and not is_false.startswith("not "))
        if told and fluent in task.bit and predicate not in lexicon.unspoken:
            yield _sentence(speech.words.describe(Literal(fluent, holds)))


def _all_around(draft: Draft) -> str:
    """What stands in the room, and how to ask for the rest."""
    speech = _speech(draft)
    looks = speech.looks
    static = draft.mind.setting.task.static
    standing = [o for o in looks.objects if looks.is_thing(o) and looks.place(o) is None]
    held = {f.args[0] for f in static if len(f.args) == 2 and f.args[1] in standing}
    parts = [o for o in standing if o not in held] or standing
    named = [distinguish_by_looks(thing, looks) for thing in parts[:_MOST_LISTED]]
    return f"I see {listing(named)}, and more. Ask me what is in or on one of them."


def _place(thing: str, speech: Speech) -> str:
    name = speech.thing(thing)
    for fluent in sorted(speech.looks.state):
        if fluent.predicate == _HELD and fluent.args[1:] == (thing,):
            return _sentence(speech.words.describe(Literal(fluent)))
    place = speech.looks.place(thing)
    if place is None:
        return _sentence(f"i see {name} here")
    name = distinguish_by_looks(thing, speech.looks)
    return _sentence(f"{name} is {place[0]} {speech.thing(place[1])}")


def _what_is_there(draft: Draft, words: Words) -> str:
    """What is in or on something: "what is on the table?"."""
    if not words or words[0] not in PREPOSITIONS or len(words) < 2:
        return ""
    speech = _speech(draft)
    places = _things(draft, words[1:], speech.looks)
    if not places:
        return f'I see nothing that I would call "{" ".join(words[1:])}".'
    return " ".join(_contents(place, words[0], speech) for place in places[:_MOST_TOLD])


def _contents(place: str, preposition: str, speech: Speech) -> str:
    looks = speech.looks
    there = [thing for thing in looks.objects if looks.related(thing, preposition, place)]
    named = listing([distinguish_by_looks(thing, looks) for thing in sorted(there)]) or "nothing"
    return _sentence(f"i see {named} {preposition} {speech.thing(place)}")


def _how_it_is(draft: Draft, words: Words) -> str:
    """Whether a thing is so: "is the fridge open?", "is the mug on the table?"."""
    speech = _speech(draft)
    facts = Facts(draft, speech.looks, _spoken(draft))
    for end in range(len(words) - 1, 0, -1):
        found = dict.fromkeys(one.fluent for one in facts.about(words[:end], words[end:]))
        if found:
            told = [Literal(f, f in speech.looks.state) for f in [*found][:_MOST_TOLD]]
            return " ".join(_sentence(speech.words.describe(one)) for one in told)
    return ""


def _spoken(draft: Draft) -> tuple[str, ...]:
    """What "it" may be: of the last step, of the command, of the command before."""
    before = [thing for _, thing in reversed(draft.state.spoken)]
    episode = draft.state.episode
    if episode is None:
        return tuple(before)
    shown = episode.demonstrated.actions if episode.demonstrated else ()
    steps = [thing for step in reversed(shown) for thing in step.args]
    return tuple(dict.fromkeys([*steps, *episode.best_objects, *before]))


def _things(draft: Draft, words: Sequence[str], looks: Looks) -> list[str]:
    told = read_noun_phrase(draft, " ".join(words))
    if told is None:
        return []
    spoken = [thing for _, thing in draft.state.spoken]
    found = [(thing, fit) for thing, fit in refer(told, looks, spoken) if looks.is_thing(thing)]
    return [thing for thing, fit in found if fit == found[0][1]]


def _sentence(said: str) -> str:
    told = first_person(said)
    return f"{told[:1].upper()}{told[1:]}."


_AT_THE_END = word_set("is are here there left anywhere now be")
_BEFORE = word_set("robot hey hi hello so ok okay well now and but")
_ASKED = QUESTION_WORDS | {"if", "whether", "that"}
_ABLE = frozenset({"can", "could"})
_NOTHING_LEARNED = "I have learned no verb yet: tell me what to do, and show me how."
_HELD = "grasping"
_COPULAS = frozenset({"is", "are"})
_ABOUT_KNOWLEDGE = frozenset(
    phrase_list("""
        what do you know, what can you do, what do you know now, what can you do now, what have you
        learned, what did you learn, what did i teach you, what have i taught you, what verbs do you
        know, which verbs do you know, what words do you know, which words do you know, what
        commands do you know, which commands do you know, which verbs have you learned, what verbs
        have you learned, which verbs can you do, what things can you do, what have you learned so
        far, what do you know so far, what do you know how to do, what can i tell you to do,
        what have you learnt, what did you learn so far,
        what you can do, what you know, what you have learned, what you learned, which verbs you
        know, what verbs you know
    """)
)
_HOW_TO = phrase_list("""
    do you know how to, do you know, have you learned how to, have you learned to, have you learned,
    have you learnt how to, have you learnt to, did you learn how to, did you learn to,
    are you able to, do you already know how to, did i teach you how to, did i teach you to,
    do you think you can, do you think that you can, would you be able to,
    is it possible for you to, do you know to
""")
_TELL = phrase_list("""
    tell me, can you tell me, could you tell me, would you tell me, do you know, show me,
    check, see, look, find out, can you check, could you check, can you see, say, go see, go and see
""")
_WHERE = phrase_list("""
    where, see, if there is, whether there is,
    where did i put, where did i leave, where have i put, where can i find, where do i find,
    where could i find, where could be, where might be, where is, where are, where 's,
    where did you put, where do you see, do you see, can you see,
    is there, are there, do you know where, which is, where was, what about
""")
_WHAT_IS = phrase_list("what is, what 's, what are, what do you see, what can you see, what lies")
_AT = phrase_list("""
    look, have a look, take a look, check, check on, inspect, examine, observe, watch, describe,
    study, view, notice, recognize, recognise, look over, have a look over, glance, peek
""")
_FIND = phrase_list("""
    find, look for, search, search for, locate, spot, seek, identify, detect, discover, show me,
    point to, point at, point out, have a look for
""")
_TOWARDS = frozenset({"at", "to", "over", "out", "after", "closely", "inside"})
_REQUESTS = frozenset(
    phrase_list("can you, could you, will you, would you, do you, let us, let 's")
)
_ANSWERS = (
    (_HOW_TO, _how_to),
    (_WHERE, _where),
    (_FIND, _where),
    (_WHAT_IS, _what_is_there),
    (_AT, _at),
)
_ABOUT_ROOM = frozenset(
    phrase_list("""
        look around, look, look around you, look about, have a look around, what do you see,
        what can you see, what is here, what is there, what 's here, what 's there, what is around,
        what is in the room, what is in this room, what is around you, look here, see,
        what do you see here, what things are here, what do we have here, what do you have,
        what is in here, what things do you see, look around the room, describe the room,
        what do you see around you, describe what you see, what you see, what is here in the room
    """)
)
_ABOUT_PLACE = frozenset(
    phrase_list("where are you, where am i, where are we, which room is this, what room is this")
)
_WHOLE = ((_ABOUT_ROOM, _all_around), (_ABOUT_KNOWLEDGE, known_verbs), (_ABOUT_PLACE, _my_place))

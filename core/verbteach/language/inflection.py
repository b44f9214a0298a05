"""Verb forms of English: gerund, third person, past participle, and back to the base.

A verb may carry its particle ("turn on"): only its first word is inflected.
"""

from __future__ import annotations

from collections.abc import Callable, Container

from verbteach.language.morphology import VOWELS, with_s
from verbteach.language.wordlist import pairs, word_set

_IRREGULAR_GERUNDS = {
    "be": "being",
    "die": "dying",
    "dye": "dyeing",
    "lie": "lying",
    "tie": "tying",
    "untie": "untying",
}
_IRREGULAR_THIRD = {"be": "is", "do": "does", "go": "goes", "have": "has", "undo": "undoes"}
_DOUBLING = word_set(
    "bag bat beg begin can cap chip chop clip cram cut dig dim dip drag drop fan fit flip flop get "
    "grab grip hit hop hug hum jam jar jog knit lap let log mop nap nod pad pat pet pin plan plop "
    "plug pop prop put quit refit rid rig rip rub run sag scan scrub set ship shop shred shut sip "
    "sit skip slam slap slip slit snap spin spit split spot step stir stop strap strip submit "
    "sun swap swim tag tan tap thin tip top transfer trap trim tug unpin unplug unwrap unzip wag "
    "wet whip win wrap zip program"
)
_IRREGULAR_PARTICIPLES = pairs(
    "be:been beat:beaten begin:begun bend:bent bite:bitten blow:blown break:broken "
    "bring:brought build:built buy:bought catch:caught choose:chosen come:come cut:cut dig:dug "
    "do:done draw:drawn drink:drunk drive:driven eat:eaten feed:fed feel:felt find:found "
    "fly:flown forget:forgotten freeze:frozen get:got give:given go:gone grind:ground "
    "hang:hung have:had hear:heard hide:hidden hit:hit hold:held keep:kept know:known lay:laid "
    "leave:left lend:lent let:let lie:lain light:lit lose:lost make:made mow:mown pay:paid "
    "put:put read:read ride:ridden ring:rung run:run say:said see:seen seek:sought sell:sold "
    "send:sent set:set sew:sewn shake:shaken show:shown shut:shut sit:sat sleep:slept "
    "speak:spoken spin:spun split:split spread:spread stand:stood steal:stolen stick:stuck "
    "sweep:swept swim:swum swing:swung take:taken teach:taught tear:torn tell:told "
    "think:thought throw:thrown undo:undone wake:woken wear:worn weave:woven wet:wet win:won "
    "wind:wound wring:wrung write:written"
)
_IRREGULAR_PASTS = pairs(
    "be:was beat:beat begin:began bite:bit blow:blew break:broke choose:chose come:came do:did "
    "draw:drew drink:drank drive:drove eat:ate fly:flew forget:forgot freeze:froze give:gave "
    "go:went hide:hid know:knew lie:lay mow:mowed ride:rode ring:rang run:ran see:saw sew:sewed "
    "shake:shook show:showed speak:spoke steal:stole swim:swam take:took tear:tore throw:threw "
    "undo:undid wake:woke wear:wore weave:wove write:wrote"
)
"""Where the past is another form than the participle."""
_BASE_OF_PARTICIPLE = {form: verb for verb, form in _IRREGULAR_PARTICIPLES.items() if form != verb}
_BASE_OF_GERUND = {form: verb for verb, form in _IRREGULAR_GERUNDS.items()}


def _first_word(change: Callable[[str], str]) -> Callable[[str], str]:
    def inflect(verb: str) -> str:
        first, space, rest = verb.partition(" ")
        return change(first) + space + rest if first else verb

    return inflect


def _gerund(verb: str) -> str:
    if verb in _IRREGULAR_GERUNDS:
        return _IRREGULAR_GERUNDS[verb]
    if verb in _DOUBLING:
        return verb + verb[-1] + "ing"
    drops_e = verb.endswith("e") and not verb.endswith(("ee", "oe", "ye")) and len(verb) > 2
    return (verb[:-1] if drops_e else verb) + "ing"


def _third_person(verb: str) -> str:
    return _IRREGULAR_THIRD.get(verb) or with_s(verb)


def _past_participle(verb: str) -> str:
    if verb in _IRREGULAR_PARTICIPLES:
        return _IRREGULAR_PARTICIPLES[verb]
    if verb in _DOUBLING:
        return verb + verb[-1] + "ed"
    if verb.endswith("y") and verb[-2:-1] not in VOWELS | {""}:
        return verb[:-1] + "ied"
    return verb + ("d" if verb.endswith("e") else "ed")


def _past(verb: str) -> str:
    return _IRREGULAR_PASTS.get(verb) or _past_participle(verb)


gerund = _first_word(_gerund)
"""``turn on`` -> ``turning on``."""
third_person = _first_word(_third_person)
"""``wash`` -> ``washes``."""
past = _first_word(_past)
"""``take out`` -> ``took out``."""
past_participle = _first_word(_past_participle)
"""``take out`` -> ``taken out``."""


def base_of_gerund(word: str, known: Container[str]) -> str | None:
    """The verb of which ``word`` is the gerund, or None; ``known`` verbs decide the spelling."""
    if word in _BASE_OF_GERUND:
        return _BASE_OF_GERUND[word]
    stem = word[:-3]
    if not word.endswith("ing") or len(stem) < 2 or not any(c in "aeiouy" for c in stem):
        return None
    for candidate in (stem + "e", stem, stem[:-1]):
        if candidate in known and _gerund(candidate) == word:
            return candidate
    return _likely_base(stem)


def _likely_base(stem: str) -> str:
    if len(stem) > 2 and stem[-1] == stem[-2] and stem[-1] not in "lsz":
        return stem[:-1]
    if stem.endswith(("c", "v", "u", "at", "iz", "dg", "as")) and not stem.endswith("eat"):
        return stem + "e"
    return stem


def base_of_participle(word: str, known: Container[str]) -> str | None:
    """The known verb of which ``word`` is the past participle, or None."""
    if word in _BASE_OF_PARTICIPLE:
        return _BASE_OF_PARTICIPLE[word]
    if not word.endswith("ed"):
        return None
    for candidate in (word[:-1], word[:-2], word[:-3], word[:-3] + "y"):
        if candidate in known and _past_participle(candidate) == word:
            return candidate
    return None

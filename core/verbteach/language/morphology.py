"""Word forms of English: singular and plural nouns, the indefinite article, lists.

Rules with their exceptions; knows no scene. Verb forms are in ``inflection``.
"""

from __future__ import annotations

from collections.abc import Sequence

from verbteach.language.wordlist import word_set

VOWELS = frozenset("aeiou")

_IRREGULAR_PLURALS = {
    "bookshelf": "bookshelves",
    "calf": "calves",
    "child": "children",
    "foot": "feet",
    "inch": "inches",
    "goose": "geese",
    "half": "halves",
    "hero": "heroes",
    "knife": "knives",
    "leaf": "leaves",
    "life": "lives",
    "loaf": "loaves",
    "man": "men",
    "mango": "mangoes",
    "mouse": "mice",
    "person": "people",
    "potato": "potatoes",
    "quiz": "quizzes",
    "scarf": "scarves",
    "self": "selves",
    "shelf": "shelves",
    "thief": "thieves",
    "tomato": "tomatoes",
    "tooth": "teeth",
    "wife": "wives",
    "wolf": "wolves",
    "woman": "women",
}
_IRREGULAR_SINGULARS = {plural: single for single, plural in _IRREGULAR_PLURALS.items()} | {
    "scarfs": "scarf",
    "mangos": "mango",
    "tomatos": "tomato",
    "potatos": "potato",
}
_ALWAYS_PLURAL = word_set(
    "scissors tongs tweezers clothes pants trousers jeans shorts pyjamas pajamas binoculars "
    "headphones sunglasses pliers stairs upstairs downstairs indoors outdoors goods"
)
_UNCOUNTED = word_set(
    "silverware cutlery furniture luggage news series species sheep fish asparagus hummus "
    "couscous molasses citrus tennis apparatus water milk rice broccoli spinach"
)
_SINGULAR_IN_S = word_set(
    "gas bus lens iris canvas atlas cactus octopus thermos virus campus basis status bias bonus "
    "census focus christmas dais chaos plus minus swiss this its yes his as is was has us always "
    "perhaps does pus thus"
)
_IE_SINGULARS = word_set(
    "cookie movie pie tie brownie smoothie veggie calorie selfie zombie lie die hoodie foodie "
    "goodie sweetie"
)
_KEEP_E = word_set(
    "shoe toe hoe canoe oboe axe ache headache toothache cache niche prize size maze breeze gauze "
    "vase case purse house nose rose hose cheese horse cause phase course spouse blouse license "
    "dose pause base mouse noise exercise cruise nurse suitcase bookcase pillowcase briefcase "
    "staircase database mayonnaise glaze doze"
)


def singular(noun: str) -> str:
    """The singular of ``noun``; a word that is no regular plural comes back as it is."""
    if noun in _IRREGULAR_SINGULARS:
        return _IRREGULAR_SINGULARS[noun]
    if len(noun) < 3 or not noun.endswith("s") or noun.endswith(("ss", "us", "is")):
        return noun
    if noun in _ALWAYS_PLURAL or noun in _UNCOUNTED or noun in _SINGULAR_IN_S:
        return noun
    if noun.endswith("ies") and len(noun) > 4:
        return noun[:-1] if noun[:-1] in _IE_SINGULARS else noun[:-3] + "y"
    if noun.endswith("es") and _takes_es(noun[:-2]) and noun[:-1] not in _KEEP_E:
        return noun[:-2]
    return noun[:-1]


def _takes_es(stem: str) -> bool:
    return stem.endswith(("s", "x", "z", "ch", "sh")) or (
        stem.endswith("o") and len(stem) > 3 and stem[-2] not in VOWELS
    )


def is_plural(noun: str) -> bool:
    """Whether ``noun`` has the form of a plural ("mugs", "scissors")."""
    return noun in _ALWAYS_PLURAL or singular(noun) != noun


def plural(noun: str) -> str:
    """The plural of a singular ``noun``; of several words the last is inflected."""
    *before, last = noun.split(" ")
    return " ".join((*before, _plural_word(last)))


def _plural_word(noun: str) -> str:
    if noun in _IRREGULAR_PLURALS:
        return _IRREGULAR_PLURALS[noun]
    if not noun or noun in _ALWAYS_PLURAL or noun in _UNCOUNTED:
        return noun
    return with_s(noun)


def with_s(word: str) -> str:
    """``word`` with the ending -s, -es or -ies, as nouns and verbs share it."""
    if word.endswith("y") and word[-2:-1] not in VOWELS | {""}:
        return word[:-1] + "ies"
    return word + ("es" if word.endswith(("s", "x", "z", "ch", "sh")) else "s")


_SILENT_H = ("hour", "honest", "heir", "honour", "honor")
_LETTER_BY_LETTER = frozenset({"x-ray", "xbox", "lcd", "led", "mp3", "hdmi"})
_SPOKEN_YOU = ("uni", "use", "usu", "uten", "euro", "ufo")
_SPOKEN_UN = ("unin", "unim", "unid")


def article(phrase: str) -> str:
    """``a`` or ``an``, whichever ``phrase`` takes as it is spoken ("an hour", "a one-way")."""
    word = phrase.strip().lower().partition(" ")[0]
    if word.startswith(_SILENT_H) or word in _LETTER_BY_LETTER:
        return "an"
    if word in {"one", "once"} or word.startswith("one-"):
        return "a"
    if word.startswith(_SPOKEN_YOU) and not word.startswith(_SPOKEN_UN):
        return "a"
    return "an" if word[:1] in VOWELS or word.startswith(("8", "11", "18")) else "a"


def listing(items: Sequence[str], conjunction: str = "and") -> str:
    """Join with commas and a conjunction: ``a``; ``a and b``; ``a, b and c``."""
    if len(items) < 2:
        return "".join(items)
    return f"{', '.join(items[:-1])} {conjunction} {items[-1]}"

"""Closed-class English: the words that hold a command together, as data.

Knows no scene, no household noun and no verb's meaning; those live in
``household`` and in the scene. All words are lower case.
"""

from __future__ import annotations

from verbteach.language.wordlist import by_first_word, phrase_list, word_set

ARTICLES = word_set("a an the some any every each another no either neither")
DEMONSTRATIVES = word_set("this that these those")
POSSESSIVES = word_set("my your his her our their its")
DETERMINERS = ARTICLES | DEMONSTRATIVES
PREDETERMINERS = word_set("all both half such")

OBJECT_PRONOUNS = word_set(
    "it them me him her us you this that these those one ones itself themselves everything "
    "something anything nothing everyone someone mine yours"
)
SUBJECT_PRONOUNS = word_set("i you we he she they")
PERSONS = word_set("me him her us you")

NUMBERS = word_set(
    "zero one two three four five six seven eight nine ten eleven twelve fifteen twenty thirty "
    "forty fifty sixty ninety hundred thousand dozen few several couple many"
)
ORDINALS = {
    "first": 0,
    "1st": 0,
    "second": 1,
    "2nd": 1,
    "third": 2,
    "3rd": 2,
    "fourth": 3,
    "4th": 3,
    "fifth": 4,
    "5th": 4,
    "last": -1,
}
"""Each ordinal with the index it means."""

CONJUNCTIONS = word_set("and or but plus nor")
SUBORDINATORS = word_set(
    "when whenever while until till before after once if unless because since so whether although "
    "though as where why how what who wherever"
)
RELATIVES = word_set("that which who")
COPULAS = word_set("is are was were be been being 's am")
AUXILIARIES = COPULAS | word_set(
    "has have had do does did can could will would shall should may might must"
)
QUESTION_WORDS = word_set("what where who which how why when whose")

PREPOSITIONS = word_set(
    "on in at to from with into onto of for by under over above below behind beside between near "
    "inside outside against around across along through off up down upon underneath beneath "
    "towards toward within without per past among opposite via atop like about out alongside "
    "beyond using"
)
COMPOUND_PREPOSITIONS = by_first_word(
    "next to, close to, closer to, nearer to, far from, farther from, further from, near to, "
    "adjacent to, nearest to, closest to, out of, off of, on top of, in front of, in back of, "
    "away from, on to, in to, in between, inside of, outside of, to the left of, to the right of, "
    "on the left of, on the right of, left of, right of, in the middle of, along with, together "
    "with, up to, down to, from under, from behind, from inside, from on top of, from off, "
    "instead of, across from, back to, back in, back into, back on, back onto, back from, over "
    "to, up from, by the side of, at the top of, at the bottom of, to the side of, on the other "
    "side of, out from, up against, down from, by using"
)

PREPOSITION_ROLES = {
    "atop": "on top of",
    "back from": "from",
    "back in": "in",
    "back into": "into",
    "back on": "on",
    "back onto": "onto",
    "back to": "to",
    "along with": "with",
    "beneath": "under",
    "down from": "from",
    "down to": "to",
    "from off": "off",
    "in between": "between",
    "in to": "into",
    "inside of": "inside",
    "left of": "to the left of",
    "near to": "near",
    "off of": "off",
    "on the left of": "to the left of",
    "on the right of": "to the right of",
    "on to": "onto",
    "out from": "from",
    "outside of": "outside",
    "over to": "to",
    "right of": "to the right of",
    "together with": "with",
    "toward": "towards",
    "underneath": "under",
    "up against": "against",
    "up from": "from",
    "up to": "to",
    "upon": "on",
    "using": "with",
    "by using": "with",
}
"""How a preposition is named as a role, where not by itself."""

LOCATIVES = word_set(
    "on in at under over above below behind beside between near inside outside against around by "
    "among opposite within alongside beyond"
) | frozenset(
    " ".join(phrase)
    for phrase in phrase_list(
        "next to, close to, closer to, nearer to, adjacent to, nearest to, closest to, on top of, "
        "in front of, in back of, to the left of, to the right of, in the middle of, across from, "
        "by the side of, to the side of, at the top of, at the bottom of, on the other side of"
    )
)
"""Prepositions of place: the phrase may say where a thing is, or where it should go."""

DIRECTIONALS = word_set("to into onto from off through towards across past out") | frozenset(
    {"out of", "away from", "from under", "from behind", "from inside", "from on top of"}
)
"""Prepositions of movement: the phrase belongs to the verb."""

PARTICLES = word_set("on off up down out in away over back around apart together along through")
BARE_PARTICLES = word_set("away back apart together")
"""Particles that are never prepositions by themselves."""

PLACE_ADVERBS = word_set(
    "there here upstairs downstairs inside outside home indoors outdoors somewhere anywhere "
    "elsewhere nearby aside everywhere"
)

ADVERBS = word_set(
    "please now then again immediately finally first next lastly afterwards afterward also too "
    "just really quite very so carefully slowly quickly gently already twice still only well "
    "thereafter soon today tonight tomorrow maybe perhaps kindly simply later meanwhile halfway "
    "straight right even instead ahead ok okay thanks thank yes quick fast firstly secondly "
    "thirdly"
)
"""Words that say how or when; the frame does not keep them."""

ADVERB_PHRASES = by_first_word(
    "right away, right now, at once, as well, for now, a bit, a little, a little bit, at the same "
    "time, one more time, once more, all the way, by the way, for a while, at last, at first, of "
    "course, thank you, thanks a lot, as soon as possible, as soon as you can, if you can, if you "
    "could, if possible, if you please, if you like, if you would, if you do not mind, each "
    "other, a second time, after that, after this, and so on, first of all, in the meantime, this "
    "time, next time, if it is not too much trouble, if it is no trouble, if it is ok, if it is "
    "okay, if that is ok, if that is okay, if you want, if you want to, if you have time, if it is "
    "possible, if that is possible, if you have a moment, if you are not busy, last of all, to "
    "begin with, to start with, all right, like this, like that, one at a time, one by one, at a "
    "time, once again"
)
"""Fixed phrases read over like adverbs."""

VOCATIVES = word_set(
    "robot hey hi hello ok okay dear buddy yo alright oh well um uh erm now sorry so"
)

PARTITIVES = word_set("one two three four five all both each some any most none many few several")
"""``some of the cups`` is about the cups."""

MEASURES = by_first_word(
    "a couple of, a few, a lot of, lots of, plenty of, a bit of, a little bit of, a little, a "
    "dozen, a number of, a bunch of, a couple"
)

UNITS = word_set(
    "second minute hour foot inch meter metre centimeter centimetre percent degree quarter third "
    "half time way"
)
"""Nouns that measure how long, how far or how much."""

TIME_NOUNS = word_set("second minute hour moment while day week night morning time")

FOREIGN = word_set(
    "le la les un une des du de et dans sur avec pour est der die das den dem ein eine einen und "
    "auf mit ist nicht el los las una y en con para por favor il lo gli che di della nel sul het "
    "een naar met och att det os um uma na em ja nie sie bitte mets prends ouvre pon abre metti "
    "apri"
)
"""Frequent words of a few other languages; they count only where no English word helps."""

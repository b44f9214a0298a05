"""A word typed where keys answer: its first letter has answered before the rest says it is a word.

Knows no screen: it says when what was typed is no mere name of what the key
said, as "yes" is of y, and what then takes the answer back.
"""

from __future__ import annotations

from collections.abc import Mapping

from verbteach_sessions.script import ScriptAct
from verbteach_sessions.session_acts import Redo, Undo

_YES = ("yes", "yeah", "yep", "yup", "yea")
_NO = ("no", "nope", "nah")
_NAMES: Mapping[str, tuple[str, ...]] = {
    "yes": _YES,
    "good": (*_YES, "good", "great"),
    "no": _NO,
    "bad": (*_NO, "bad"),
}
"""Beside the word itself, what people write in full for it."""

_NOTHING_TO_TAKE_BACK = frozenset({"why", "repeat", "flag", "note"})
_AROUND = " .,!?"


class TypedWord:
    """What was typed since a key answered."""

    def __init__(self) -> None:
        self.text = ""
        self._word = ""
        self._harmless = False

    def begin(self, character: str, word: str) -> None:
        """The key ``character`` has said ``word``."""
        self.text, self._word, self._harmless = character, word, False

    def forget(self) -> None:
        """What comes now is no part of that word."""
        self.text = ""

    def refused(self) -> None:
        """What the key said did not fit: there is nothing to take back."""
        self._harmless = True

    def goes_beyond(self, character: str) -> bool:
        """Whether, with ``character`` after it, more is meant than the key has said."""
        if not self.text:
            return False
        self.text += character
        bare = self.text.lower().rstrip(_AROUND)
        names = (self._word, *_NAMES.get(self._word, ()))
        return not any(name.startswith(bare) for name in names)

    def end(self) -> tuple[str, ScriptAct | None]:
        """The text so far, and the act that takes back what the key said; then begin anew."""
        text, act = self.text, self._remedy()
        self.text = ""
        return text, act

    def _remedy(self) -> ScriptAct | None:
        if self._harmless or self._word in _NOTHING_TO_TAKE_BACK:
            return None
        return Redo() if self._word == "undo" else Undo()

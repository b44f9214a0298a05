"""Text from people made safe to show: what could act on a terminal prints as a sign instead."""

from __future__ import annotations

import unicodedata

_PICTURES = 0x2400  # Unicode's block of control pictures: U+2400 + code of a C0 character
_DELETE = 0x7F


def visible(text: str) -> str:
    r"""``text`` on one line, each control or invisible character replaced by a visible sign.

    Escape becomes ``␛`` and a line break ``␊``; what has no picture of its own,
    such as a bidirectional override, is written out as ``\u202e``.
    """
    return text if text.isprintable() else "".join(map(_shown, text))


def _shown(character: str) -> str:
    code = ord(character)
    if code < ord(" "):
        return chr(_PICTURES + code)
    if code == _DELETE:
        return "␡"
    if character == " " or character.isprintable():
        return character
    if unicodedata.category(character) == "Zs":
        return " "
    return f"\\u{code:04x}" if code <= 0xFFFF else f"\\U{code:08x}"

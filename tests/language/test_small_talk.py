"""What people say about the conversation is told from commands, and from answers."""

from __future__ import annotations

import pytest

from verbteach.language.small_talk import Talk, small_talk


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("help", Talk.HELP),
        ("What??", Talk.HELP),
        ("what should I do now?", Talk.HELP),
        ("how do i teach you", Talk.HELP),
        ("that's it!", Talk.DONE),
        ("thats it", Talk.DONE),
        ("Im lost", Talk.HELP),
        ("so now I am done.", Talk.DONE),
        ("finished", Talk.DONE),
        ("never mind", Talk.GIVE_UP),
        ("please skip it", Talk.GIVE_UP),
        ("stop", Talk.GIVE_UP),
        ("there is none", Talk.ABSENT),
        ("no not that one", Talk.BACK),
        ("Hello robot", Talk.GREETING),
        ("thank you", Talk.REPLY),
        ("bye", Talk.LEAVE),
        ("stop the microwave", None),
        ("help me to open the fridge", None),
        ("leave the mug on the table", None),
        ("wait", None),
        ("", None),
    ],
)
def test_only_a_whole_utterance_is_small_talk(text: str, kind: Talk | None) -> None:
    assert small_talk(text) is kind

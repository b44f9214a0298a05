"""How the robot speaks of the scene it is in: its words, and a name for each thing.

A thing is named as briefly as singles it out among the others just now.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache, cached_property

from verbteach.dialogue.setting import Setting
from verbteach.language.distinguish import distinguish
from verbteach.language.looks import Looks
from verbteach.language.wording import Wording
from verbteach.world.fluents import State


@dataclass(frozen=True)
class Speech:
    """Words for a setting as its things look now."""

    setting: Setting
    looks: Looks

    @classmethod
    def of(cls, setting: Setting, world: State) -> Speech:
        """The words for a setting as the world is now."""
        return cls(setting, Looks.at(setting.scene, world, setting.lexicon))

    @property
    def place(self) -> str:
        """Where the robot is: "a family kitchen in the morning"."""
        title = self.setting.scene.title
        return title[:1].lower() + title[1:]

    @cached_property
    def thing(self) -> Callable[[str], str]:
        """From an object's id to its name, with an article."""
        return cache(lambda object_id: distinguish(object_id, self.looks))

    @cached_property
    def words(self) -> Wording:
        """Fluents, goals, actions and commands in English."""
        return Wording(self.setting.lexicon, self.thing)

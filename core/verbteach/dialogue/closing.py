"""The end of an episode, and what comes after it: the next clause, or the next command."""

from __future__ import annotations

from verbteach.dialogue.acts import AwaitCommand, CloseEpisode, Outcome
from verbteach.dialogue.draft import Draft
from verbteach.dialogue.moves import Phase


def close(draft: Draft, outcome: Outcome) -> None:
    """End the episode; its phrases stay in mind for pronouns."""
    episode = draft.episode
    spoken = tuple(zip(episode.phrases, episode.best_objects, strict=True))
    draft.say(CloseEpisode(outcome))
    draft.remember(
        episode=None,
        spoken=spoken or draft.state.spoken,
        referents=(*draft.state.referents, *spoken),
    )
    draft.count(
        episodes=1,
        successes=int(outcome is Outcome.EXECUTED),
        learned=int(outcome is Outcome.LEARNED),
    )


def await_command(draft: Draft) -> None:
    """Be ready for the next command."""
    draft.wait(AwaitCommand(), Phase.COMMAND)

"""A cap on what the robot asks, as a study sets it."""

from __future__ import annotations

from dataclasses import replace

from verbteach.dialogue.parameters import RobotParameters


def capped(parameters: RobotParameters, most: int) -> RobotParameters:
    """The parameters of a robot that asks ``most`` questions about one command, and no more."""
    inquiry = replace(parameters.inquiry, cap=most)
    return replace(parameters, question_cap=most, inquiry=inquiry)

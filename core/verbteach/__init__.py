"""The learner: worlds, language, verbs, dialogue, question policies, without input or output.

It knows numpy and nothing of files, screens or clocks; everything it works on
is passed in, and every random draw comes from a generator that is passed in.
"""

__version__ = "0.1.0"

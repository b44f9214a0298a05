"""Studies with participants: the study's file, who gets which condition, and how far each has come.

What a participant sees is not known here, nor how the sessions are held.
"""

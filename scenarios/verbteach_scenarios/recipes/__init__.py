"""Lessons written from recipes: what is asked, how it is said, and how each teacher shows it.

The recipes are data (``data/household/recipes``), the draws are seeded, and
what comes out is committed; nothing here is needed to read a lesson.
"""

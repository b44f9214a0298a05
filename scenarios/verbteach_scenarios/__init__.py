"""Worlds as data: domains, scenes, lessons, the lexicon, and the readers of their files."""

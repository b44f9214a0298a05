"""Curves drawn: into files with matplotlib, and in the terminal with braille dots."""

"""A second opinion on commands from a statistical parser; needs the extra ``verbteach[nlp]``."""

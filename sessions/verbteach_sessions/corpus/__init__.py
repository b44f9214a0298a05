"""What a folder of sessions needs as a corpus: figures, splits, privacy, and what goes with it."""

"""What a verb means: state changes, goal hypotheses, the hypothesis space, selection."""

"""Robot acts, teacher acts, the episode that alternates them, and simulated teachers."""

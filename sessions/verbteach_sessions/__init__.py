"""Sessions on disk: the event log, its fold, undo, resume and replay, scripted teachers."""

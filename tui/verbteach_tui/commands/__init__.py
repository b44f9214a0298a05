"""One module a command: reads its options, calls the rooms below, prints what came of it."""

"""What a person touches: the command line, the Textual app and the plain mode."""

"""Taking part in a study, on the screen and in plain lines. Importing this imports no Textual."""

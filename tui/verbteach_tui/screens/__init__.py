"""The app's screens, one a file. Importing this package imports no Textual."""

"""The app's widgets, one a file. Importing this package imports no Textual."""

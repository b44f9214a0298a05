"""The app in a browser: tokens, visitors, and the server. Importing this imports no server."""

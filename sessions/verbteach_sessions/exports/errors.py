"""What can keep an export from being made, beside the errors of reading and of the disk."""

from __future__ import annotations

from verbteach_sessions.errors import SessionError


class ExportError(SessionError):
    """The export cannot be made; the message says why and what to do."""


class NothingToExportError(ExportError):
    """The sessions hold nothing of what the format is for."""


class MissingExtraError(ExportError):
    """The format needs packages that are not installed."""

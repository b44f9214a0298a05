"""Single-use tokens: who may come in, and who has.

A token lets one browser in, and makes it one participant. That browser gets a
secret of its own in a cookie, and by it comes back. What remains on disk lies in
the participant's folder and holds hashes only.
"""

from __future__ import annotations

import json
import os
import re
import secrets
from dataclasses import dataclass, field
from hashlib import sha256
from pathlib import Path

from verbteach_sessions.files import open_private, replace_file, write_all
from verbteach_sessions.names import new_code
from verbteach_tui.conclusion import WrongUseError

TICKET_NAME = "ticket.json"
_FITS = re.compile(r"[A-Za-z0-9_-]{8,128}")


class RefusedError(Exception):
    """Why a visitor is not let in, in words for the visitor."""


class UnknownTokenError(RefusedError):
    """There is no such token, or none was given."""


class UsedTokenError(RefusedError):
    """Another browser has used the token."""


def write_tokens(file: Path, count: int) -> tuple[str, ...]:
    """Write ``count`` tokens to a new file. Raises ``FileExistsError`` and ``StorageError``."""
    if file.exists():
        raise FileExistsError(file)
    made = tuple(secrets.token_urlsafe(12) for _ in range(count))
    fd = open_private(file, os.O_WRONLY | os.O_CREAT | os.O_EXCL)
    try:
        write_all(fd, "".join(f"{token}\n" for token in made).encode())
    finally:
        os.close(fd)
    return made


def read_tokens(file: Path) -> frozenset[str]:
    """The tokens in ``file``, one a line; blank lines and ``#`` lines are skipped."""
    found = set()
    for number, line in enumerate(file.read_text("utf-8", "replace").splitlines(), start=1):
        token = line.strip()
        if not token or token.startswith("#"):
            continue
        if not _FITS.fullmatch(token):
            raise WrongUseError(f"{file}:{number}: a token is 8 to 128 letters, digits, - and _")
        found.add(token)
    if not found:
        raise WrongUseError(f"{file}: holds no token; 'verbteach study tokens' makes some")
    return frozenset(found)


def hashed(text: str) -> str:
    """SHA-256 in hexadecimal."""
    return sha256(text.encode("utf-8", "replace")).hexdigest()


@dataclass(frozen=True)
class Ticket:
    """What ties a participant to a token and a browser; both only as hashes."""

    token: str
    browser: str

    def write(self, home: Path) -> None:
        """Put it into the participant's folder. Raises ``StorageError``."""
        replace_file(home / TICKET_NAME, json.dumps(vars(self)).encode() + b"\n")

    @classmethod
    def read(cls, home: Path) -> Ticket | None:
        """The ticket in a participant's folder, if there is one that can be read."""
        try:
            data = json.loads((home / TICKET_NAME).read_bytes())
            return cls(str(data["token"]), str(data["browser"]))
        except (OSError, ValueError, KeyError, TypeError):
            return None


@dataclass(frozen=True)
class Visitor:
    """Somebody let in: the code, and the secret that their browser keeps."""

    code: str
    secret: str
    ticket: Ticket


@dataclass
class Door:
    """Lets people in. ``tokens`` of ``None`` lets in whoever comes, each as another person."""

    folder: Path
    tokens: frozenset[str] | None = None
    _by_browser: dict[str, Visitor] = field(default_factory=dict)
    _by_token: dict[str, Visitor] = field(default_factory=dict)

    def __post_init__(self) -> None:
        """Remember who has been here before."""
        if not self.folder.is_dir():
            return
        for home in sorted(self.folder.iterdir()):
            ticket = Ticket.read(home)
            if ticket is not None:
                self._remember(Visitor(home.name, "", ticket))

    def enter(self, token: str, secret: str) -> Visitor:
        """Who this is: somebody who comes back, or somebody new. Raises :class:`RefusedError`."""
        known = self.known(secret)
        if known is not None and (not token or known.ticket.token == hashed(token)):
            return Visitor(known.code, secret, known.ticket)
        self._check(token)
        fresh = secrets.token_urlsafe(24)
        visitor = Visitor(new_code(), fresh, Ticket(hashed(token) if token else "", hashed(fresh)))
        self._remember(visitor)
        return visitor

    def known(self, secret: str) -> Visitor | None:
        """Who comes back with this secret."""
        return self._by_browser.get(hashed(secret)) if secret else None

    def forget(self, visitor: Visitor) -> None:
        """The visitor did not take part and left nothing: the token may be used again."""
        if (self.folder / visitor.code).exists():
            return
        self._by_browser.pop(visitor.ticket.browser, None)
        self._by_token.pop(visitor.ticket.token, None)

    def _check(self, token: str) -> None:
        if self.tokens is None:
            return
        if not any(
            secrets.compare_digest(token.encode(), one.encode()) for one in sorted(self.tokens)
        ):
            raise UnknownTokenError(
                "This link is not complete, or it is not for this study. "
                "Please use the link exactly as it was given to you."
            )
        if hashed(token) in self._by_token:
            raise UsedTokenError(
                "This link has been used in another browser. If that was you, go on there. "
                "If not, please tell whoever invited you."
            )

    def _remember(self, visitor: Visitor) -> None:
        self._by_browser[visitor.ticket.browser] = visitor
        if visitor.ticket.token:
            self._by_token[visitor.ticket.token] = visitor

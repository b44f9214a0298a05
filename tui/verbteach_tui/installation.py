"""What is installed here: versions of libraries, which extras are there, where can be written."""

from __future__ import annotations

import os
import re
from importlib.metadata import PackageNotFoundError, requires, version
from pathlib import Path

# "numba>=0.61; extra == 'fast'": the package's name, and the extra it belongs to if any.
_NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9._-]*")
_EXTRA = re.compile(r"extra\s*==\s*['\"]([^'\"]+)['\"]")


def installed(package: str) -> str | None:
    """The version of ``package``, or ``None`` where it is not installed."""
    try:
        return version(package)
    except PackageNotFoundError:
        return None


def requirements(distribution: str = "verbteach") -> dict[str, tuple[str, ...]]:
    """Packages that each extra needs, in the order declared; those always needed are under ''."""
    found: dict[str, list[str]] = {}
    for line in requires(distribution) or ():
        name, extra = _NAME.match(line), _EXTRA.search(line)
        if name:
            found.setdefault(extra.group(1) if extra else "", []).append(name.group())
    return {extra: tuple(names) for extra, names in found.items()}


def is_writable(folder: Path) -> bool:
    """Whether sessions can be made in ``folder``, or in the nearest folder above that exists."""
    nearest = next((p for p in (folder, *folder.absolute().parents) if p.exists()), None)
    return nearest is not None and nearest.is_dir() and os.access(nearest, os.W_OK | os.X_OK)

"""`python -m verbteach_tui` is the `verbteach` command."""

from __future__ import annotations

import sys

from verbteach_tui.cli import main

sys.exit(main())

"""The example study that comes along."""

from __future__ import annotations

from pathlib import Path

import verbteach_scenarios

EXAMPLE = Path(verbteach_scenarios.__file__).parent / "data" / "studies" / "asking-or-showing.toml"
"""The comparison of She and Chai (2017) with people; also what a new study starts from."""

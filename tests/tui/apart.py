"""A process for the benchmark to measure: counts, says what it was given, or misbehaves."""

import sys
import time
from importlib.util import find_spec

from verbteach_tui.bench.apart import tell

if __name__ == "__main__":
    word = sys.argv[1]
    if word == "torn":
        sys.exit("it does not work")
    if word == "endless":
        time.sleep(600)
    for number in range(int(word)):
        tell(number + 1)
    tell({"words": sys.argv[1:], "numba": find_spec("numba") is not None})

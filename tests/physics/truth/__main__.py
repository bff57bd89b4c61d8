"""`python -m tests.physics.truth`: the table as Markdown; `--json`: the bare figures."""

from __future__ import annotations

import argparse
import json

from tests.physics.truth.table import EXPERIMENTS, as_markdown, measure


def main() -> None:
    """Measure all rows, or those whose names contain the words given, and print them."""
    parser = argparse.ArgumentParser(prog="python -m tests.physics.truth", description=__doc__)
    parser.add_argument("words", nargs="*", help="only experiments whose names contain one of these")
    parser.add_argument("--json", action="store_true", help="relative errors by experiment and engine")
    options = parser.parse_args()
    chosen = [each for each in EXPERIMENTS if not options.words or any(word in each.name for word in options.words)]
    rows = measure(chosen)
    print(json.dumps(rows, indent=2, ensure_ascii=False) if options.json else as_markdown(rows, chosen))


if __name__ == "__main__":
    main()

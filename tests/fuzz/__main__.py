"""`python -m tests.fuzz`: any number of damaged files, with progress; each that fails is kept as a file.

`python -m tests.fuzz --cases 100000 --seed 3 --kind scenes,snapshots`, or `--replay FILE` to run one of them again.
"""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path

from tests.fuzz.kinds import KINDS, make_case, run_case, text_of
from tests.fuzz.run import run_cases, shares


def main() -> int:
    """Run what the command line asks for; returns 1 if a case failed."""
    parser = argparse.ArgumentParser(prog="python -m tests.fuzz", description=__doc__)
    parser.add_argument("--cases", type=int, default=10_000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--kind", default=",".join(KINDS), help="several with commas between them")
    parser.add_argument("--out", type=Path, default=Path("fuzz-failures"), help="folder for cases that fail")
    parser.add_argument("--replay", type=Path, help="run the case in this file")
    options = parser.parse_args()
    if options.replay:
        run_case(json.loads(options.replay.read_text(encoding="utf-8")))
        return 0
    failed = 0
    for kind, count in shares(options.cases, options.kind.split(",")).items():
        for failure in run_cases(kind, options.seed, 0, count, lambda n, kind=kind, of=count: _progress(kind, n, of)):
            failed += 1
            file = options.out / f"{kind}-{options.seed}-{failure.number}.json"
            file.parent.mkdir(exist_ok=True)
            file.write_text(text_of(make_case(kind, options.seed, failure.number)), encoding="utf-8")
            print(f"\n{file}: {failure.error}")
        print(f"{kind}: {count} cases", flush=True)
    print(f"{failed} failed")
    return 1 if failed else 0


def _progress(kind: str, done: int, count: int) -> None:
    if done % 500 == 0:
        print(f"{kind}: {done} of {count}", end="\r", file=sys.stderr, flush=True)


if __name__ == "__main__":
    raise SystemExit(main())

"""The process that runs cases: `python -m tests.fuzz.worker KIND SEED FIRST END`.

It writes the number of each case before it runs it, so that whoever started it knows which one has ended the process,
and a line of JSON for each case that failed.
"""

from __future__ import annotations

import json
import os
import sys
import traceback
import warnings

from tests.fuzz.budget import limit_process, within_budget
from tests.fuzz.kinds import KINDS, make_case, run_case


def main(kind: str, seed: int, first: int, end: int) -> None:
    """Run the cases from `first` to before `end`."""
    warnings.simplefilter("ignore")
    limit_process()
    KINDS[kind].warm()
    for number in range(first, end):
        _tell(number)
        case = make_case(kind, seed, number)
        try:
            within_budget(lambda case=case: run_case(case))
        except Exception as error:
            place = traceback.extract_tb(error.__traceback__)[-1]
            where = f"{place.filename}:{place.lineno}"
            _tell({"number": number, "error": f"{type(error).__name__}: {str(error)[:300]} ({where})"})


def _tell(what: object) -> None:
    os.write(1, (json.dumps(what) + "\n").encode())


if __name__ == "__main__":
    main(sys.argv[1], *map(int, sys.argv[2:5]))

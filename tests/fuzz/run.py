"""Runs cases in processes of their own, so that one that crashes or hangs is seen as a failure of that case."""

from __future__ import annotations

import json
import signal
import subprocess
import sys
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryFile

from tests.fuzz.kinds import KINDS

ROOT = Path(__file__).parents[2]


@dataclass(frozen=True)
class Failure:
    """A case that failed, and how."""

    kind: str
    seed: int
    number: int
    error: str


def run_cases(kind: str, seed: int, first: int, end: int, progress: Callable[[int], None]) -> Iterator[Failure]:
    """Run the cases of a kind from `first` to before `end`; `progress` is told how many are done."""
    while first < end:
        command = [sys.executable, "-m", "tests.fuzz.worker", kind, str(seed), str(first), str(end)]
        with (
            TemporaryFile("w+") as errors,
            subprocess.Popen(command, cwd=ROOT, stdout=subprocess.PIPE, stderr=errors, text=True) as process,
        ):
            assert process.stdout is not None
            number = first
            for line in process.stdout:
                told = json.loads(line)
                if isinstance(told, dict):
                    yield Failure(kind, seed, told["number"], told["error"])
                else:
                    number = told
                    progress(number - first)
            process.wait()
            errors.seek(0)
            said = errors.read()
        if process.returncode == 0:
            return
        yield Failure(kind, seed, number, _ending(process.returncode, said))
        first = number + 1


def shares(cases: int, kinds: list[str]) -> dict[str, int]:
    """How many of so many cases are of each kind."""
    whole = sum(KINDS[kind].share for kind in kinds)
    return {kind: -(-cases * KINDS[kind].share // whole) for kind in kinds}


def _ending(code: int, said: str) -> str:
    told = " ".join(said.split()[-60:])
    if code == -signal.SIGVTALRM:
        return f"it hangs: {told}"
    return f"the process ended with {signal.Signals(-code).name if code < 0 else code}: {told}"

"""The kinds of cases: how one is made and how it is run. A case is plain data, so that it can be kept in a file."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import dataclass
from random import Random
from typing import Any

from tests.fuzz import commands, recordings, scenes, snapshots

Case = dict[str, Any]


@dataclass(frozen=True)
class Kind:
    """`make` draws a case; `run` runs it and returns how many bodies and joints it had to do with; `warm` compiles and
    loads what cases need."""

    warm: Callable[[], None]
    make: Callable[[Random], Case]
    run: Callable[[Case], int]
    share: int
    """Of a hundred cases, about so many."""


KINDS = {
    "scenes": Kind(scenes.warm, scenes.make, scenes.run, 40),
    "recordings": Kind(recordings.warm, recordings.make, recordings.run, 30),
    "snapshots": Kind(snapshots.warm, snapshots.make, snapshots.run, 10),
    "commands": Kind(commands.warm, commands.make, commands.run, 20),
}


def make_case(kind: str, seed: int, number: int) -> Case:
    """Case `number` of a kind, the same for the same seed."""
    return {"kind": kind, **KINDS[kind].make(Random(f"{kind} {seed} {number}"))}


def run_case(case: Case) -> int:
    """Run a case; whatever it raises is a mistake of the package."""
    return KINDS[case["kind"]].run(case)


def text_of(case: Case) -> str:
    """A case as a file keeps it."""
    return json.dumps(case, indent=1)

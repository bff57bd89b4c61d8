"""How much memory is taken."""

from __future__ import annotations

import sys
from dataclasses import fields, is_dataclass
from typing import Any

import numpy as np

from sandbox.engine.world import World


def table_bytes(world: World) -> int:
    """Bytes of all tables of a world with their spare rows, those that a step only works with included."""
    tables: dict[int, int] = {}
    _note([world.state.arrays, world.scratch], tables)
    return sum(tables.values())


def _note(value: Any, tables: dict[int, int]) -> None:
    """Enter every array once: bundles share them."""
    if isinstance(value, np.ndarray):
        while isinstance(value.base, np.ndarray):
            value = value.base
        tables[value.ctypes.data] = value.nbytes
    elif is_dataclass(value):
        for each in fields(value):
            _note(getattr(value, each.name), tables)
    elif isinstance(value, (list, tuple)):
        for part in value:
            _note(part, tables)


def peak_resident_bytes() -> int | None:
    """The most memory that this process has had so far; None where the system does not tell."""
    try:
        import resource
    except ImportError:  # Windows
        return None
    most = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return most if sys.platform == "darwin" else most * 1024

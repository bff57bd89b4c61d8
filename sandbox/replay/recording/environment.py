"""In which surroundings a recording was made, for people who wonder why another gave other bits."""

from __future__ import annotations

import platform
from functools import cache
from importlib.metadata import PackageNotFoundError, version


@cache
def environment() -> str:
    """One line: `Python 3.11.4, numpy 2.3.1, numba 0.68.0, Linux x86_64`."""
    names = ", ".join(f"{name} {_version(name)}" for name in ("numpy", "numba"))
    return f"Python {platform.python_version()}, {names}, {platform.system()} {platform.machine()}"


def _version(name: str) -> str:
    try:
        return version(name)
    except PackageNotFoundError:  # put beside the program without its metadata
        return "of unknown version"

"""Machine code that comes with the package, so that nobody compiles on usual processors.

A wheel may have a folder for these very sources and this platform, and in it one for each level of processors: code
for all that have what it names. The best that this one can run is taken. `sandbox cache --into` fills such folders,
`.ci/hatch_build.py` puts them into a wheel.
"""

from __future__ import annotations

import os
import platform
import sys
from functools import cache
from pathlib import Path

HOME = Path(__file__).parent / "_data" / "machine-code"
"""Where a wheel has them."""
SWITCH = "SANDBOX_SHIPPED_CODE"
"""With 0, all is compiled for this very processor."""

_AVX2 = frozenset({"avx", "avx2", "bmi", "bmi2", "cx16", "f16c", "fma", "lzcnt", "movbe", "popcnt", "sahf"}) | {
    "sse3", "ssse3", "sse4.1", "sse4.2"
}  # fmt: skip
_X86 = {"x86-64-v3": _AVX2, "x86-64": frozenset[str]()}
_ARM = {"generic": frozenset[str]()}
LEVELS: dict[str, dict[str, frozenset[str]]] = {"x86_64": _X86, "amd64": _X86, "aarch64": _ARM, "arm64": _ARM}
"""By machine: the levels by the names that LLVM has for them, best first, and the features that they need."""


def levels() -> dict[str, frozenset[str]]:
    """Those of this machine; none if it is an unusual one."""
    return LEVELS.get(platform.machine().lower(), {})


def folder_name(sources: str) -> str:
    """Of the folder for sources with this hash, on this platform."""
    return f"{sources}-{sys.platform}-{platform.machine().lower()}"


def shipped_folder(sources: str) -> Path | None:
    """The machine code that came with the package for this processor, if there is some for these sources."""
    folder = HOME / folder_name(sources)
    if os.environ.get(SWITCH) == "0" or not folder.is_dir():
        return None
    has = _features()
    found = (folder / level for level, needs in levels().items() if needs <= has)
    return next((level for level in found if level.is_dir()), None)


@cache
def _features() -> set[str]:
    """What this processor has, by LLVM's names; nothing where LLVM cannot tell."""
    from llvmlite import binding as llvm

    try:
        return {name for name, there in llvm.get_host_cpu_features().items() if there}
    except RuntimeError:
        return set()

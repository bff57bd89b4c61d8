"""Tell the user why the first step on a machine takes its time."""

from __future__ import annotations

import sys


def announce_compilation() -> None:
    """If the engine's kernels have to be compiled first, say so on stderr."""
    from sandbox._jit import cache_is_cold

    if cache_is_cold():
        text = "compiling the engine's kernels, once for this machine and version: about 20 s, with joints 40 s ..."
        print(f"sandbox: {text}", file=sys.stderr, flush=True)

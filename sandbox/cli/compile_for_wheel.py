"""Machine code for a wheel: all entry points, for every level of processors of this platform."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path
from tempfile import TemporaryDirectory

from sandbox.errors import SandboxError


def compile_for_wheel(folder: Path) -> list[Path]:
    """Fill `folder` anew; gives the folders of the levels, best first.

    Raises `SandboxError` on a platform of which no level is known.
    """
    from sandbox._kernel_cache import sources_hash
    from sandbox._shipped_code import folder_name, levels

    if not levels():
        raise SandboxError("no level of processors is known for this machine")
    home = folder / folder_name(sources_hash())
    shutil.rmtree(folder, ignore_errors=True)
    with TemporaryDirectory() as scratch:
        runs = {level: _start(level, Path(scratch, level)) for level in levels()}
        for level, run in runs.items():
            if run.wait() != 0:
                raise SandboxError(f"compiling for {level} has failed")
            (home / level).mkdir(parents=True)
            for file in Path(scratch, level).rglob("*.code"):
                shutil.copy(file, home / level)
    return [home / level for level in runs]


def _start(level: str, cache: Path) -> subprocess.Popen[bytes]:
    """A process that compiles everything for processors of that level."""
    settings = {
        "NUMBA_CPU_NAME": level,
        "NUMBA_CPU_FEATURES": "",
        "SANDBOX_CACHE_DIR": str(cache),
        "SANDBOX_SHIPPED_CODE": "0",
    }
    return subprocess.Popen([sys.executable, "-m", "sandbox.cli.every_entry_point"], env=os.environ | settings)

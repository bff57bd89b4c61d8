"""Machine code for a wheel: all entry points, for every level of processors of this platform.

`python -m sandbox.cli.compile_for_wheel DIR` is the process that makes it. What it calls is compiled for the lowest
level, so that any processor can run it; what numba has made of it becomes machine code for the other levels as well.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

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
    made = [home / level for level in levels()]
    for each in made:
        each.mkdir(parents=True)
    with TemporaryDirectory() as scratch:
        if _compile(home, lowest=made[-1].name, cache=scratch) != 0:
            raise SandboxError(f"compiling for {', '.join(levels())} has failed")
        for file in Path(scratch).rglob("*.code"):
            shutil.copy(file, made[-1])
    if len({frozenset(os.listdir(each)) for each in made}) > 1:
        raise SandboxError(f"{folder} has not got all that was compiled")
    return made


def _compile(home: Path, lowest: str, cache: str) -> int:
    """Compile in a process of its own: into `cache` for the lowest level, into `home` for the others."""
    settings = {
        "NUMBA_CPU_NAME": lowest,
        "NUMBA_CPU_FEATURES": "",
        "SANDBOX_CACHE_DIR": cache,
        "SANDBOX_SHIPPED_CODE": "0",
    }
    command = [sys.executable, "-m", "sandbox.cli.compile_for_wheel", str(home)]
    return subprocess.run(command, env=os.environ | settings, check=False).returncode


def _compile_here(home: Path) -> None:
    """Compile everything, and each entry point for the other levels after it."""
    from sandbox import _jit
    from sandbox._kernel_cache import write
    from sandbox._shipped_code import levels
    from sandbox.cli.every_entry_point import call_every_entry_point

    def for_other_levels(entry: Any, arguments: tuple[Any, ...], file: Path | None) -> None:
        from sandbox._linking import machine_code

        if file is not None:
            for level in list(levels())[:-1]:
                write(home / level / file.name, *machine_code(entry, arguments, level))

    _jit.further.append(for_other_levels)
    call_every_entry_point()


if __name__ == "__main__":
    _compile_here(Path(sys.argv[1]))

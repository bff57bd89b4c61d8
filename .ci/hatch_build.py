"""Takes machine code along into a wheel, if `sandbox cache --into build/machine-code` has made some before.

Such a wheel is for one platform, whatever the version of Python; without that folder a wheel is for all platforms, and
compiles what it needs where it is installed.
"""

from __future__ import annotations

import importlib
import sys
import sysconfig
from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface


class MachineCode(BuildHookInterface):
    """The folder, and the platform that it makes the wheel one for."""

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Called before a wheel is built; for an editable install `version` is `editable`."""
        root = Path(self.root)
        folder = root / "build" / "machine-code"
        if version == "editable" or not folder.is_dir():
            return
        wanted = _sources_hash(root)
        if not any(each.name.startswith(wanted) for each in folder.iterdir()):
            raise RuntimeError(f"{folder} is of other sources: make it anew, or delete it")
        build_data["force_include"][str(folder)] = "sandbox/_data/machine-code"
        build_data["pure_python"] = False
        build_data["tag"] = f"py3-none-{_platform()}"


def _sources_hash(root: Path) -> str:
    """Asked of the package, without what it needs to be imported."""
    sys.path.insert(0, str(root))
    try:
        return importlib.import_module("sandbox._kernel_cache").sources_hash()
    finally:
        sys.path.remove(str(root))


def _platform() -> str:
    """The code needs `memset`, `floor`, `frexp`, `ldexp` and `sched_yield`: any Linux that numba runs on has them."""
    name = sysconfig.get_platform().replace("-", "_").replace(".", "_")
    return name.replace("linux_", "manylinux_2_17_")

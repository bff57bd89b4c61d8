"""The same bits on an emulated arm64: `python -m tests.determinism.arm64 FOLDER [--jit] [--replay PATH]...`.

Fetches an arm64 Python (Debian's packages) and arm64 wheels into FOLDER, once, and runs there what this machine runs,
under `qemu-aarch64-static` (package qemu-user-static): without `--replay` the scenes of this room, comparing every
digest; with it `sandbox replay PATH` on recordings made elsewhere. Kernels run as plain Python, a quarter of an hour;
with `--jit` numba compiles them for arm64 in the emulator, a quarter of an hour too on a quiet machine, and keeps them
in FOLDER. On Debian or Ubuntu, as root. Not a part of the test suite: it wants packages of another architecture.

Exit code 0 if all is the same, 1 if something is not.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
from pathlib import Path

from tests.determinism.processes import ROOT, other_process

PROGRAMS = ["tests.determinism.busy", "tests.determinism.floating", "tests.determinism.jointed"]
VERSIONS = """
import platform, numba, numpy
print(platform.machine(), "Python", platform.python_version(), "NumPy", numpy.__version__, "numba", numba.__version__,
      "without the compiler" if numba.config.DISABLE_JIT else "compiled")
"""
PACKAGES = (
    "libc6 libgcc-s1 libstdc++6 zlib1g libexpat1 libssl3 libffi8 libbz2-1.0 liblzma5 libuuid1 libsqlite3-0 "
    "python3.11-minimal libpython3.11-minimal libpython3.11-stdlib"
)
WHEELS = "numpy numba pydantic platformdirs typer rich"
PLATFORMS = ("manylinux2014_aarch64", "manylinux_2_17_aarch64", "manylinux_2_27_aarch64", "manylinux_2_28_aarch64")


def fetch(folder: Path) -> None:
    """An arm64 Python and what the engine imports, unpacked under `folder`."""
    debs, wheels = folder / "debs", folder / "wheels"
    debs.mkdir(parents=True, exist_ok=True)
    run("dpkg", "--add-architecture", "arm64")
    run("apt-get", "update", "-q")
    run("apt-get", "download", "-q", *(f"{name}:arm64" for name in PACKAGES.split()), cwd=debs)
    for deb in debs.glob("*.deb"):
        run("dpkg", "-x", str(deb), str(folder / "root"))
    platforms = [word for name in PLATFORMS for word in ("--platform", name)]
    choice = ["--only-binary=:all:", "--python-version", "3.11", "--implementation", "cp", *platforms]
    run(sys.executable, "-m", "pip", "download", "-q", "-d", str(wheels), *choice, *WHEELS.split())
    for wheel in wheels.glob("*.whl"):
        run(sys.executable, "-m", "zipfile", "-e", str(wheel), str(folder / "site"))


def run(*command: str, cwd: Path | None = None) -> None:
    subprocess.run(command, cwd=cwd, check=True)


class Emulator:
    """The arm64 Python under `folder`, with or without the compiler."""

    def __init__(self, folder: Path, jit: bool) -> None:
        root = folder / "root"
        paths = os.pathsep.join([str(ROOT), str(folder / "site")])
        self.python = ["qemu-aarch64-static", "-L", str(root), str(root / "usr/bin/python3.11")]
        self.environment = os.environ | {"PYTHONPATH": paths, "SANDBOX_CACHE_DIR": str(folder / "cache")}
        self.environment |= {"NUMBA_DISABLE_JIT": "0" if jit else "1", "SANDBOX_SHIPPED_CODE": "0"}

    def printed(self, *words: str) -> str:
        """What `python WORDS` prints; an error if it fails."""
        command = [*self.python, *words]
        return subprocess.run(
            command, cwd=ROOT, env=self.environment, stdout=subprocess.PIPE, text=True, check=True
        ).stdout

    def replays(self, paths: list[str]) -> bool:
        """Whether `sandbox replay PATHS` finds the bits of the recordings; it prints its table."""
        command = [*self.python, "-m", "sandbox", "replay", *paths]
        return subprocess.run(command, cwd=ROOT, env=self.environment).returncode == 0


def same_digests(emulator: Emulator) -> bool:
    """Whether every program of this room prints there what it prints here."""
    parted = 0
    for program in PROGRAMS:
        here, there = other_process(program), emulator.printed("-m", program).split()
        equal = sum(a == b for a, b in zip(here, there, strict=True))
        parted += len(here) - equal
        print(f"{program}: {equal} of {len(here)} digests equal", flush=True)
    return parted == 0


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path, metavar="FOLDER")
    parser.add_argument("--jit", action="store_true", help="compile the kernels for arm64")
    parser.add_argument("--replay", action="append", metavar="PATH", help="run recordings instead; can be repeated")
    asked = parser.parse_args()
    folder = asked.folder.resolve()
    if not (folder / "site").exists():
        fetch(folder)
    emulator = Emulator(folder, asked.jit)
    print(emulator.printed("-c", VERSIONS).strip(), flush=True)
    same = emulator.replays(asked.replay) if asked.replay else same_digests(emulator)
    return 0 if same else 1


if __name__ == "__main__":
    sys.exit(main())

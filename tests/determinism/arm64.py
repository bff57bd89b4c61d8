"""The same scenes on an emulated arm64: `python -m tests.determinism.arm64 FOLDER [--jit]`. Debian or Ubuntu, as root.

Fetches an arm64 Python (Debian's packages) and arm64 wheels into FOLDER, runs the scenes of this room under
`qemu-aarch64-static` (package qemu-user-static), and compares every digest with those of this machine. Without `--jit`
kernels run as plain Python, a quarter of an hour; with it numba compiles for arm64, which takes the emulator longer.
Not a part of the test suite: it wants packages of another architecture.
"""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

from tests.determinism.processes import ROOT, other_process

PROGRAMS = ["tests.determinism.busy", "tests.determinism.floating", "tests.determinism.jointed"]
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


def emulated(folder: Path, program: str, jit: bool) -> list[str]:
    """The digests that a program of this room prints on arm64."""
    root = folder / "root"
    paths = os.pathsep.join([str(ROOT), str(folder / "site")])
    environment = os.environ | {"PYTHONPATH": paths, "SANDBOX_CACHE_DIR": str(folder / "cache")}
    environment |= {"NUMBA_DISABLE_JIT": "0" if jit else "1"}
    command = ["qemu-aarch64-static", "-L", str(root), str(root / "usr/bin/python3.11"), "-m", program]
    done = subprocess.run(command, cwd=ROOT, env=environment, stdout=subprocess.PIPE, text=True, check=True)
    return done.stdout.split()


def main() -> int:
    folder = Path(sys.argv[1]).resolve()
    if not (folder / "site").exists():
        fetch(folder)
    parted = 0
    for program in PROGRAMS:
        here, there = other_process(program), emulated(folder, program, "--jit" in sys.argv)
        equal = sum(a == b for a, b in zip(here, there, strict=True))
        parted += len(here) - equal
        print(f"{program}: {equal} of {len(here)} digests equal", flush=True)
    return 1 if parted else 0


if __name__ == "__main__":
    sys.exit(main())

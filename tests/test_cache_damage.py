"""The cache of machine code heals by itself, and nothing stops where it cannot be kept."""

from __future__ import annotations

import os
import re
import socket
import subprocess
import sys
from collections.abc import Callable, Sequence
from pathlib import Path

import pytest

from sandbox import _kernel_cache
from sandbox._jit import jit_enabled
from sandbox._machine_code import is_usable
from sandbox._object_file import is_whole

pytestmark = pytest.mark.skipif(not jit_enabled(), reason="there is no machine code without the compiler")
ROOT = Path(__file__).parents[1]
FUNCTION = """
from sandbox._jit import entry_point
@entry_point
def {name}(number: float) -> float:
    return 3.0 * number
print({name}(14.0))
"""
PAIR = ("one", "two")


def run(home: Path, cache: str, names: Sequence[str] = PAIR, prefix: str = "") -> str:
    """What a process tells on stderr that calls entry points of these names."""
    program = home / "program.py"
    program.write_text("".join(FUNCTION.format(name=name) for name in names))
    environment = os.environ | {
        "SANDBOX_CACHE_DIR": str(home / cache),
        "PYTHONPATH": str(ROOT),
        "SANDBOX_SHIPPED_CODE": "0",
    }
    environment.pop("PYTHONPYCACHEPREFIX", None)
    code = f"{prefix}\nimport runpy; runpy.run_path({str(program)!r}, run_name='program')"
    done = subprocess.run([sys.executable, "-c", code], env=environment, capture_output=True, text=True)
    assert (done.returncode, done.stdout) == (0, "42.0\n" * len(names)), done.stderr
    return done.stderr


def code_files(cache: Path) -> list[Path]:
    """All files of machine code."""
    return sorted(cache.rglob("*.code"))


def change(file: Path, edit: Callable[[bytes], bytes]) -> None:
    """Write something else into a file."""
    data = edit(file.read_bytes())
    file.unlink()
    file.write_bytes(data)


def signed(file: Path, edit: Callable[[bytes], bytes]) -> None:
    """Write other machine code into a file, under a digest that is right."""
    found = _kernel_cache.read(file)
    assert found is not None
    _kernel_cache.write(file, found[0], edit(found[1]))


def instead(make: Callable[[Path], object]) -> Callable[[Path], None]:
    """Something else than a file of that name."""

    def put(file: Path) -> None:
        file.unlink()
        make(file)

    return put


def folder(file: Path) -> None:
    """A folder with something in it."""
    file.mkdir()
    (file / "x").write_text("x")


def unix_socket(path: Path) -> None:
    """A socket that nobody serves; their names are short."""
    here = os.getcwd()
    os.chdir(path.parent)
    try:
        with socket.socket(socket.AF_UNIX) as one:
            one.bind(path.name[:60])
        os.rename(path.name[:60], path.name)
    finally:
        os.chdir(here)


def beside(file: Path) -> Path:
    """Another whole file of machine code."""
    return next(other for other in sorted(file.parent.glob("*.code")) if other.name != file.name)


DAMAGE: dict[str, Callable[[Path], object]] = {
    "that of another kernel": lambda file: change(file, lambda data: beside(file).read_bytes()),
    "halved": lambda file: change(file, lambda data: data[: len(data) // 2]),
    "one byte short": lambda file: change(file, lambda data: data[:-1]),
    "emptied": lambda file: change(file, lambda data: b""),
    "zeros": lambda file: change(file, lambda data: bytes(len(data))),
    "a flipped bit": lambda file: change(file, lambda data: data[:300] + bytes([data[300] ^ 1]) + data[301:]),
    "no JSON": lambda file: change(file, lambda data: b"\xff" + data[1:]),
    "garbage, signed": lambda file: signed(file, lambda code: b"garbage" * 100),
    "nothing, signed": lambda file: signed(file, lambda code: b""),
    "halved, signed": lambda file: signed(file, lambda code: code[: len(code) // 2]),
    "one byte short, signed": lambda file: signed(file, lambda code: code[:-1]),
    "returns nonsense, signed": lambda file: _kernel_cache.write(file, {"a": 1}, _kernel_cache.read(file)[1]),
    "a folder": instead(folder),
    "a link to nothing": instead(lambda file: file.symlink_to("nowhere")),
    "a link to itself": instead(lambda file: file.symlink_to(file.name)),
    "a pipe": instead(os.mkfifo),
    "a socket": instead(unix_socket),
    "a device": instead(lambda file: file.symlink_to("/dev/zero")),
}


@pytest.mark.skipif(os.name != "posix", reason="pipes, sockets and links")
@pytest.mark.slow
def test_damaged_files_heal(tmp_path):
    names = [re.sub(r"\W", "_", name) for name in DAMAGE]
    assert run(tmp_path, "cache", names) == ""
    files = code_files(tmp_path)
    for name, damage in zip(names, DAMAGE.values(), strict=True):
        damage(next(file for file in files if f".{name}-" in file.name))
    assert run(tmp_path, "cache", names) == ""
    assert code_files(tmp_path) == files
    assert len(files) == len(DAMAGE)
    for file in files:
        found = _kernel_cache.read(file)
        assert found is not None
        assert is_usable(*found)
        if found[1].startswith(b"\x7fELF"):
            assert not any(is_whole(found[1][:end]) for end in range(len(found[1])))


def one_line(told: str) -> None:
    """It is said once that machine code is not kept."""
    assert re.fullmatch(r"sandbox: machine code cannot be kept in .+: .+; .+SANDBOX_CACHE_DIR.+\n", told)


@pytest.mark.slow
def test_a_folder_that_cannot_be_made_stops_nothing(tmp_path):
    (tmp_path / "file").write_text("")
    one_line(run(tmp_path, "file"))
    one_line(run(tmp_path, "file/below"))


READ_ONLY = """
import os
def refuse(*_, **__):
    raise OSError(30, "Read-only file system")
os.mkdir = os.replace = os.unlink = os.utime = refuse
kept = os.open
os.open = lambda path, flags, *rest, **more: refuse() if flags & os.O_CREAT else kept(path, flags, *rest, **more)
"""
FULL = "import resource; resource.setrlimit(resource.RLIMIT_FSIZE, (100, 100))"


@pytest.mark.parametrize("obstacle", [READ_ONLY, FULL], ids=["read only", "full"])
def test_a_disk_that_takes_nothing_stops_nothing(tmp_path, obstacle):
    if obstacle == FULL:
        pytest.importorskip("resource")
    one_line(run(tmp_path, "cache", prefix=obstacle))
    assert [file for file in tmp_path.rglob("*") if file.suffix in (".code", ".part")] == []


@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() == 0, reason="the administrator may write everywhere")
def test_a_folder_without_permission_stops_nothing(tmp_path):
    cache = tmp_path / "cache"
    cache.mkdir(mode=0o555)
    one_line(run(tmp_path, "cache"))

"""Machine code that comes with a wheel: which is taken, that all is there, and how it gets into a wheel."""

from __future__ import annotations

import importlib
import importlib.util
import os
import shutil
import subprocess
import sys
import types
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import sandbox
from sandbox import _kernel_cache, _shipped_code
from sandbox._jit import EntryPoint, jit_enabled
from sandbox.engine.world import World
from tests.determinism import busy, jointed
from tests.joints.nets import net

ROOT = Path(sandbox.__file__).parents[1]
BEST = frozenset({"avx", "avx2", "bmi", "bmi2", "cx16", "f16c", "fma", "lzcnt", "movbe", "popcnt", "sahf"}) | {
    "sse3", "ssse3", "sse4.1", "sse4.2", "avx512f"
}  # fmt: skip
compiled = pytest.mark.skipif(not jit_enabled(), reason="there is no machine code without the compiler")


@pytest.fixture
def home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The folder of a wheel for a usual processor with AVX-512, with both levels, for sources `abc`."""
    monkeypatch.setattr(_shipped_code, "HOME", tmp_path)
    monkeypatch.delenv(_shipped_code.SWITCH, raising=False)
    monkeypatch.setattr("platform.machine", lambda: "AMD64")
    monkeypatch.setattr(_shipped_code, "_features", lambda: BEST)
    made = tmp_path / _shipped_code.folder_name("abc")
    for level in ("x86-64-v3", "x86-64"):
        (made / level).mkdir(parents=True)
    return made


def test_the_best_level_that_the_processor_can_run_is_taken(home: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    assert _shipped_code.shipped_folder("abc") == home / "x86-64-v3"
    for missing in ("avx2", "fma", "movbe"):
        monkeypatch.setattr(_shipped_code, "_features", lambda missing=missing: BEST - {missing})
        assert _shipped_code.shipped_folder("abc") == home / "x86-64"


def test_a_level_that_is_not_there_is_passed_over(home: Path) -> None:
    (home / "x86-64-v3").rmdir()
    assert _shipped_code.shipped_folder("abc") == home / "x86-64"
    (home / "x86-64").rmdir()
    assert _shipped_code.shipped_folder("abc") is None


def test_code_of_other_sources_machines_and_systems_is_not_taken(home: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    assert _shipped_code.shipped_folder("abd") is None
    monkeypatch.setattr("sys.platform", "another")
    assert _shipped_code.shipped_folder("abc") is None


def test_an_unusual_machine_has_no_levels(home: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("platform.machine", lambda: "riscv64")
    (home.parent / _shipped_code.folder_name("abc") / "generic").mkdir(parents=True)
    assert _shipped_code.shipped_folder("abc") is None


def test_it_can_be_switched_off(home: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv(_shipped_code.SWITCH, "0")
    assert _shipped_code.shipped_folder("abc") is None


def test_arm64_needs_no_features(home: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("platform.machine", lambda: "arm64")
    monkeypatch.setattr(_shipped_code, "_features", set)
    generic = home.parent / _shipped_code.folder_name("abc") / "generic"
    generic.mkdir(parents=True)
    assert _shipped_code.shipped_folder("abc") == generic


def test_what_was_compiled_here_comes_first(home: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(_kernel_cache, "sources_hash", lambda: "abc")
    own, shipped = tmp_path / "own.code", home / "x86-64-v3" / "own.code"
    assert _kernel_cache.read(own) is None
    _kernel_cache.write(shipped, "q", b"shipped")
    assert _kernel_cache.read(own) == ("q", b"shipped")
    _kernel_cache.write(own, "q", b"own")
    assert _kernel_cache.read(own) == ("q", b"own")


def entry_points_without_one_version() -> list[str]:
    """Those that have none or several versions in this process, after every one has been called and worlds with
    everything in them were stepped."""
    from sandbox.cli.every_entry_point import call_every_entry_point

    call_every_entry_point()
    busy.digests(World(busy.scene()))
    jointed.digests(World(jointed.scene()))
    net(16, 16, "hinge").step()
    files = [file for file in (ROOT / "sandbox").rglob("*.py") if "\n@entry_point\n" in file.read_text("utf-8")]
    modules = [importlib.import_module(".".join(file.relative_to(ROOT).with_suffix("").parts)) for file in files]
    found = [each for module in modules for each in vars(module).values() if isinstance(each, EntryPoint)]
    assert len(found) > 12
    return [each.__name__ for each in found if len(each._versions) != 1]


@compiled
def test_every_entry_point_is_called_as_worlds_call_it() -> None:
    """In a process of its own: other tests call them too. With arguments of other types it would be compiled twice."""
    code = "from tests.test_shipped_code import entry_points_without_one_version as found; print(found())"
    done = subprocess.run([sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True)
    assert (done.stdout, done.returncode) == ("[]\n", 0), done.stderr


@compiled
@pytest.mark.slow(seconds=150)
@pytest.mark.parametrize("level", ["", "x86-64"])
def test_nothing_is_compiled_where_the_code_is_there(made: Path, tmp_path: Path, level: str) -> None:
    """The package as it is installed, an empty cache, and no numba at all."""
    site = tmp_path / "site"
    shutil.copytree(ROOT / "sandbox", site / "sandbox", ignore=shutil.ignore_patterns("__pycache__"))
    shutil.copytree(ROOT / "scenes", site / "sandbox" / "_data" / "scenes")
    shutil.copytree(made, site / "sandbox" / "_data" / "machine-code")
    lower = f"import sandbox._shipped_code as s; s._X86.pop('x86-64-v3', None) if {level!r} else None"
    code = f"import sys; sys.modules['numba'] = None; {lower}; import sandbox.cli; sandbox.cli.main()"
    environment = os.environ | {"SANDBOX_CACHE_DIR": str(tmp_path / "cache"), "PYTHONPATH": str(site)}
    environment.pop(_shipped_code.SWITCH, None)
    command = [sys.executable, "-c", code, "replay", str(ROOT / "scenes" / "joints"), str(ROOT / "scenes" / "fields")]
    done = subprocess.run(command, env=environment, cwd=tmp_path, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    assert "compil" not in done.stderr
    assert list((tmp_path / "cache").rglob("*.code")) == []


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Machine code for all levels of this platform."""
    folder = tmp_path_factory.mktemp("wheel") / "machine-code"
    command = [sys.executable, "-m", "sandbox", "cache", "--into", str(folder)]
    subprocess.run(command, cwd=ROOT, check=True, capture_output=True)
    return folder


@pytest.fixture
def hook(monkeypatch: pytest.MonkeyPatch) -> Callable[[Path, str], dict[str, Any]]:
    """What the build hook makes of a project folder."""

    class Interface:
        def __init__(self, root: str) -> None:
            self.root = root

    name = "hatchling.builders.hooks.plugin.interface"
    monkeypatch.setitem(sys.modules, name, types.SimpleNamespace(BuildHookInterface=Interface))  # type: ignore[arg-type]
    spec = importlib.util.spec_from_file_location("hatch_build", ROOT / ".ci" / "hatch_build.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    monkeypatch.setattr(module, "_sources_hash", lambda root: "abc")

    def run(root: Path, version: str) -> dict[str, Any]:
        data: dict[str, Any] = {"force_include": {}}
        module.MachineCode(str(root)).initialize(version, data)
        return data

    return run


def test_a_wheel_takes_the_code_along_if_it_is_there(hook: Callable[..., dict[str, Any]], tmp_path: Path) -> None:
    assert hook(tmp_path, "standard") == {"force_include": {}}
    folder = tmp_path / "build" / "machine-code"
    (folder / "abc-linux-x86_64").mkdir(parents=True)
    data = hook(tmp_path, "standard")
    assert data["force_include"] == {str(folder): "sandbox/_data/machine-code"}
    assert data["tag"].startswith("py3-none-")
    assert data["tag"] != "py3-none-any"
    assert hook(tmp_path, "editable") == {"force_include": {}}


def test_a_wheel_takes_no_code_of_other_sources(hook: Callable[..., dict[str, Any]], tmp_path: Path) -> None:
    (tmp_path / "build" / "machine-code" / "abd-linux-x86_64").mkdir(parents=True)
    with pytest.raises(RuntimeError, match="of other sources"):
        hook(tmp_path, "standard")

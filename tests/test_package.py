"""The public API: every name is there, and importing the package costs nothing."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest

import sandbox
from sandbox import _names, resources


def _modules_after(code: str) -> set[str]:
    """Top-level modules loaded in a fresh process after `code`."""
    program = f"import sys\n{code}\nprint('\\n'.join(sys.modules))"
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    return {name.partition(".")[0] for name in done.stdout.splitlines()}


@pytest.mark.parametrize("name", sandbox.__all__)
def test_every_public_name_resolves(name: str) -> None:
    assert getattr(sandbox, name) is not None
    assert name in dir(sandbox)


def test_lazy_names_come_from_their_homes() -> None:
    assert set(sandbox.__all__) == {*_names.HOMES, "__version__"}
    assert sandbox.SceneError.__module__ == "sandbox.errors"
    assert issubclass(sandbox.SceneError, sandbox.SandboxError)


def test_an_unknown_name_is_an_attribute_error() -> None:
    with pytest.raises(AttributeError, match="no attribute 'Wrold'"):
        sandbox.Wrold  # noqa: B018


def test_importing_the_package_is_light() -> None:
    assert not _modules_after("import sandbox") & {"numpy", "numba", "pydantic", "typer", "pygame", "pymunk"}


def test_errors_do_not_pull_in_the_engine() -> None:
    assert not _modules_after("import sandbox; sandbox.SandboxError") & {"numpy", "numba", "pydantic"}


def test_shipped_scenes_are_found_by_name() -> None:
    scenes = resources.shipped_scenes()
    assert scenes
    assert resources.assets_dir().is_dir()
    bare = scenes[0].name.removesuffix(resources.SCENE_SUFFIX)
    assert resources.find_scene(Path(bare)).name == scenes[0].name


def test_a_path_that_is_nowhere_stays_as_it_is() -> None:
    nowhere = Path("nowhere/at-all.json")
    assert resources.find_scene(nowhere) == nowhere


def test_the_readme_speaks_of_files_that_are_there() -> None:
    root = Path(sandbox.__file__).parents[1]
    text = (root / "README.md").read_text(encoding="utf-8")
    named = re.findall(r"(?:scenes|assets|sandbox)/[\w./-]+\.(?:json|png|gif|md)", text)
    assert len(named) >= 4
    assert [name for name in named if not (root / name).is_file()] == []

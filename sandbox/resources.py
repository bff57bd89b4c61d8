"""Where the shipped scenes and assets are: beside the package in a checkout, inside it when installed."""

from __future__ import annotations

import os
from pathlib import Path

_PACKAGE = Path(__file__).resolve().parent
SCENE_SUFFIX = ".scene.json"
"""What the files of scenes end in, so that folders can be searched for them."""

_BENCHMARKS, _BENCHMARK_SUFFIX = "benchmarks", ".json"


def scenes_dir() -> Path:
    """The folder of the scenes that come with the package."""
    return _folder("scenes")


def assets_dir() -> Path:
    """The folder of fonts, icons and pictures that come with the package."""
    return _folder("assets")


def shipped_scenes() -> list[Path]:
    """Every shipped scene file, sorted by folder and name."""
    return sorted(scenes_dir().rglob("*" + SCENE_SUFFIX))


def benchmark_scenes() -> list[Path]:
    """Every scene that `sandbox bench` runs by itself, sorted by name.

    They are large. Their names do not end in `SCENE_SUFFIX`, so that nobody who searches a folder meets them.
    """
    return sorted((scenes_dir() / _BENCHMARKS).glob("*" + _BENCHMARK_SUFFIX))


def part_file(name: str) -> Path:
    """The file of a part that comes with the package, such as `materials`, for scenes to include."""
    return scenes_dir() / "parts" / f"{name}.json"


def shipped_parts() -> list[str]:
    """The names of the parts that come with the package, sorted."""
    return sorted(path.stem for path in part_file("").parent.glob("*.json"))


def scene_name(path: Path) -> str:
    """The name of a scene file by which it is found: `pyramid-10`."""
    return path.name.removesuffix(SCENE_SUFFIX).removesuffix(_BENCHMARK_SUFFIX)


def find_scene(path: Path) -> Path:
    """`path` itself if it exists, else the scene of that name that comes with the package, else `path`."""
    if os.path.exists(path):  # `Path.exists` raises for a name that is too long
        return path
    wanted = scene_name(path)
    return next((scene for scene in (*shipped_scenes(), *benchmark_scenes()) if scene_name(scene) == wanted), path)


def files_below(folder: Path, ending: str) -> list[Path]:
    """Every file of that ending in a folder and below, sorted, but none in hidden folders and virtual environments.

    An environment in which this package is installed holds its scenes, and they are not the user's.
    """
    found: list[Path] = []
    for home, folders, names in os.walk(folder):
        folders[:] = [name for name in folders if not _is_foreign(home, name)]
        found += [Path(home, name) for name in names if name.endswith(ending)]
    return sorted(found)


def _is_foreign(home: str, name: str) -> bool:
    return name.startswith(".") or name == "node_modules" or os.path.isfile(os.path.join(home, name, "pyvenv.cfg"))


def _folder(name: str) -> Path:
    if (_PACKAGE.parent / "pyproject.toml").is_file():
        return _PACKAGE.parent / name
    return _PACKAGE / "_data" / name

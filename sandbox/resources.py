"""Where the shipped scenes and assets are: beside the package in a checkout, inside it when installed."""

from __future__ import annotations

from pathlib import Path

_PACKAGE = Path(__file__).resolve().parent
SCENE_SUFFIX = ".scene.json"


def scenes_dir() -> Path:
    """The folder of the scenes that come with the package."""
    return _folder("scenes")


def assets_dir() -> Path:
    """The folder of fonts, icons and pictures that come with the package."""
    return _folder("assets")


def shipped_scenes() -> list[Path]:
    """Every shipped scene file, sorted by folder and name."""
    return sorted(scenes_dir().rglob("*" + SCENE_SUFFIX))


def find_scene(path: Path) -> Path:
    """`path` itself if it exists, else the shipped scene of that name (`pyramid-10`), else `path`."""
    if path.exists():
        return path
    wanted = path.name.removesuffix(SCENE_SUFFIX) + SCENE_SUFFIX
    return next((scene for scene in shipped_scenes() if scene.name == wanted), path)


def _folder(name: str) -> Path:
    if (_PACKAGE.parent / "pyproject.toml").is_file():
        return _PACKAGE.parent / name
    return _PACKAGE / "_data" / name

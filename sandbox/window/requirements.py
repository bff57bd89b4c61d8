"""Is all there that the window needs? Says what to install instead of failing half way."""

from __future__ import annotations

import importlib

from sandbox.errors import MissingDependencyError

PACKAGES = {
    "pygame": "pygame-ce>=2.5",
    "moderngl": "moderngl>=5.10",
    "imgui_bundle": "imgui-bundle>=1.92",
    "OpenGL": "PyOpenGL>=3.1",
}
"""What the window imports, and what pip calls it."""

LIBRARIES_HINT = "On Debian or Ubuntu: sudo apt install libgl1 libegl1 libgl1-mesa-dri"
SCREEN_HINTS = (
    "With a virtual screen: sudo apt install xvfb, then xvfb-run -a sandbox run SCENE",
    "Out of sight: sandbox run SCENE --frames 100 --screenshot FILE.png",
    "Without OpenGL: sandbox render SCENE -o FILE.png, or sandbox check SCENE",
)


def check_packages() -> None:
    """Raise `MissingDependencyError` unless every one of `PACKAGES` can be imported."""
    for name in PACKAGES:
        try:
            importlib.import_module(name)
        except ModuleNotFoundError as error:
            raise MissingDependencyError(_package_text(error.name or name)) from error
        except FileNotFoundError:  # of the current folder, not of a library
            raise
        except (ImportError, OSError, AttributeError) as error:
            text = f"the window cannot load {name}: {error}. A system library is missing. {LIBRARIES_HINT}"
            raise MissingDependencyError(text) from error


def _package_text(name: str) -> str:
    wanted = " ".join(f'"{package}"' for package in PACKAGES.values())
    return (
        f"the window needs the Python package {name.partition('.')[0]}, which is not installed. "
        f"All that it needs: python -m pip install {wanted}"
    )


def no_screen() -> MissingDependencyError:
    """The error where nobody could see a window."""
    reason = "there is no screen to open a window on (DISPLAY and WAYLAND_DISPLAY are not set)"
    return MissingDependencyError("\n  ".join((reason, *SCREEN_HINTS)))


def no_window(reason: object) -> MissingDependencyError:
    """The error where a window or OpenGL fails."""
    head = f"cannot open a window with OpenGL 3.3: {reason}"
    return MissingDependencyError("\n  ".join((head, LIBRARIES_HINT, *SCREEN_HINTS)))

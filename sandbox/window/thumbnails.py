"""Small pictures of scenes for the gallery: drawn in a thread, kept on disk, shown as textures."""

from __future__ import annotations

import hashlib
import sys
import threading
from contextlib import suppress
from io import BytesIO
from pathlib import Path
from typing import Any

from sandbox._atomic_write import write_bytes
from sandbox._kernel_cache import cache_root
from sandbox._version import __version__
from sandbox.errors import SandboxError
from sandbox.render.camera import Size
from sandbox.window.threads import start_thread

SIZE: Size = (304, 171)
LARGEST = 4 * 1024 * 1024
"""Bytes of a file that gets a picture."""


class Thumbnails:
    """`texture` gives the picture of a file once there is one; what was asked for last is drawn first."""

    def __init__(self, context: Any) -> None:
        self._context = context
        self._textures: dict[Path, Any] = {}
        self._drawn: dict[Path, bytes | None] = {}
        self._wanted: list[Path] = []
        self._changed = threading.Condition()
        self._closed = False
        self._thread: threading.Thread | None = None

    def texture(self, path: Path) -> Any:
        """The moderngl texture of a file's picture; None as long as there is none, or if there can be none."""
        if path in self._textures:
            return self._textures[path]
        with self._changed:
            if path not in self._drawn:
                self._want(path)
                return None
            pixels = self._drawn[path]
        self._textures[path] = None if pixels is None else self._upload(pixels)
        return self._textures[path]

    def close(self) -> None:
        """Draw no more."""
        with self._changed:
            self._closed = True
            self._changed.notify()

    def _want(self, path: Path) -> None:
        if self._wanted and self._wanted[-1] == path:
            return
        if path in self._wanted:
            self._wanted.remove(path)
        self._wanted.append(path)
        if self._thread is None:
            self._thread = start_thread(self._work, self.close)
        self._changed.notify()

    def _upload(self, pixels: bytes) -> Any:
        import moderngl

        texture = self._context.texture(SIZE, 3, pixels, alignment=1)
        texture.filter = moderngl.LINEAR, moderngl.LINEAR
        return texture

    def _work(self) -> None:
        while True:
            with self._changed:
                while not self._wanted and not self._closed:
                    self._changed.wait()
                if self._closed:
                    return
                path = self._wanted.pop()
            try:
                pixels = _pixels(path)
            except Exception:  # a mistake of this program costs one picture, not those of all other files
                threading.excepthook(threading.ExceptHookArgs((*sys.exc_info(), threading.current_thread())))
                pixels = None
            with self._changed:
                self._drawn[path] = pixels


def _pixels(path: Path) -> bytes | None:
    """RGB of the picture, from the disk or drawn now; None if the file cannot be shown."""
    from PIL import Image

    try:
        if path.stat().st_size > LARGEST:
            return None
        kept = _kept(path)
        with suppress(OSError, ValueError), Image.open(kept) as image:
            if image.size == SIZE:
                return image.convert("RGB").tobytes()
        picture = _draw(path)
    except (OSError, SandboxError):
        return None
    data = BytesIO()
    picture.save(data, "PNG")
    with suppress(OSError):
        kept.parent.mkdir(parents=True, exist_ok=True)
        write_bytes(kept, data.getvalue(), durable=False)
    return bytes(picture.tobytes())


def _kept(path: Path) -> Path:
    """Where the picture of a file with this content is kept."""
    code = hashlib.blake2b(path.read_bytes() + f"{__version__} {SIZE}".encode(), digest_size=12).hexdigest()
    return cache_root() / "thumbnails" / f"{code}.png"


def _draw(path: Path) -> Any:
    from sandbox.render.thumbnail import thumbnail
    from sandbox.replay.recording.limits import SUFFIX
    from sandbox.replay.recording.recording import Recording
    from sandbox.scene import load_scene

    scene = Recording.load(path).load_scene() if path.name.endswith(SUFFIX) else load_scene(path)
    return thumbnail(scene, SIZE).convert("RGB")

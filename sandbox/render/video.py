"""Films as MP4 (H.264) and WebM (VP9), by FFmpeg's libraries through PyAV."""

from __future__ import annotations

import importlib
from collections.abc import Iterable
from fractions import Fraction
from io import BytesIO
from pathlib import Path
from typing import Any

from sandbox._atomic_write import write_bytes
from sandbox.errors import MissingDependencyError

PACKAGE = "av>=14"
CODECS = {
    ".mp4": ("mp4", "libx264", {"crf": "18", "preset": "medium"}),
    ".webm": ("webm", "libvpx-vp9", {"crf": "28", "b": "0", "row-mt": "1", "cpu-used": "4"}),
}
"""Of each suffix: the container, the encoder, and how fine: lines of one pixel stay sharp."""


def check_video(suffix: str) -> None:
    """Raise `MissingDependencyError` unless films with that suffix can be written here."""
    try:
        av = _av()
    except ImportError as error:
        raise MissingDependencyError(
            f"films as {suffix} need the Python package av, which is not installed ({error}): "
            f'python -m pip install "{PACKAGE}"; a film as .gif needs nothing'
        ) from error
    encoder = CODECS[suffix][1]
    if encoder not in av.codecs_available:
        raise MissingDependencyError(
            f"films as {suffix} need the encoder {encoder}, which this build of av has not: "
            f'python -m pip install --only-binary av "{PACKAGE}"; a film as .gif needs nothing'
        )


def save_video(pictures: Iterable[Any], path: Path, fps: float) -> int:
    """Write Pillow images of one size as a film; gives their number. Raises `MissingDependencyError` and `OSError`.

    Sides of an odd number of pixels lose the last one, as both encoders keep colours of two by two pixels.
    """
    suffix = path.suffix.lower()
    check_video(suffix)
    av = _av()
    kind, encoder, options = CODECS[suffix]
    data, count = BytesIO(), 0
    with av.open(data, mode="w", format=kind) as container:
        stream: Any = None
        for picture in pictures:
            if stream is None:
                stream = _stream(container, encoder, options, picture.size, fps)
            even = picture.crop((0, 0, stream.width, stream.height))
            container.mux(stream.encode(av.VideoFrame.from_image(even)))
            count += 1
        if stream is not None:
            container.mux(stream.encode(None))
    write_bytes(path, data.getvalue())
    return count


def _av() -> Any:
    """PyAV, which only films need. Raises `ImportError`."""
    return importlib.import_module("av")


def _stream(container: Any, encoder: str, options: dict[str, str], size: tuple[int, int], fps: float) -> Any:
    stream = container.add_stream(encoder, rate=Fraction(fps).limit_denominator(1000))
    stream.width, stream.height = (side - side % 2 for side in size)
    stream.pix_fmt = "yuv420p"
    stream.options = options
    return stream

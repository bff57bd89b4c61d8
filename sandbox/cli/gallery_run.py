"""The work behind `sandbox gallery`: run every scene, over processes if that is asked for, and write."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Sequence
from io import BytesIO
from typing import Any, TypeVar

from rich.console import Console

from sandbox._atomic_write import write_bytes, write_text
from sandbox._printable import told
from sandbox.cli.compiling import announce_compilation
from sandbox.cli.document import print_document
from sandbox.cli.failures import HOLDS, UNUSABLE, problems_of, report
from sandbox.cli.gallery_options import GalleryOptions
from sandbox.cli.pool import elsewhere
from sandbox.cli.progress import SceneProgress
from sandbox.engine.compile_first import compile_first
from sandbox.errors import SandboxError
from sandbox.render.thumbnail import thumbnail
from sandbox.report.gallery_card import GalleryCard, gallery_card
from sandbox.scene import load_scene
from sandbox.scene.catalog import Entry

SMALL = (192, 108)
"""Pixels of a picture on a sheet."""
WIDEST = 8
"""Pictures side by side at most."""

Made = TypeVar("Made")


def write_page(options: GalleryOptions, entries: Sequence[Entry]) -> int:
    """Write the page; the exit code."""
    from sandbox.report.gallery_page import gallery_page

    cards, troubles = _made(_card, entries, options)
    if cards:
        write_text(options.output, gallery_page(options.title, cards))
    return _told(options, len(cards), troubles, "a page")


def write_sheet(options: GalleryOptions, entries: Sequence[Entry]) -> int:
    """Write the sheet, in 256 colours; the exit code."""
    from PIL import Image

    from sandbox.render.contact_sheet import contact_sheet

    pictures, troubles = _made(_picture, entries, options)
    if pictures:
        sheet, data = contact_sheet(pictures, min(WIDEST, len(pictures))), BytesIO()
        sheet.quantize(256, kmeans=2, dither=Image.Dither.NONE).save(data, "PNG", optimize=True)
        write_bytes(options.output, data.getvalue())
    return _told(options, len(pictures), troubles, "a sheet")


def _card(entry: Entry) -> GalleryCard | Exception:
    try:
        return gallery_card(entry)
    except (SandboxError, OSError) as error:
        return error


def _picture(entry: Entry) -> tuple[str, Any] | Exception:
    try:
        return entry.title, thumbnail(load_scene(entry.path), SMALL).convert("RGB")
    except (SandboxError, OSError) as error:
        return error


def _made(
    make: Callable[[Entry], Made | Exception], entries: Sequence[Entry], options: GalleryOptions
) -> tuple[list[Made], list[Exception]]:
    """What is made of the scenes that can be used, and what is wrong with the others, which is told."""
    announce_compilation()
    jobs = min(options.jobs or os.cpu_count() or 1, len(entries))
    found, troubles = [], []
    with SceneProgress(Console(stderr=True), 1, "files") as progress:
        progress.begin("scenes", len(entries))
        for done, made in enumerate(_each(make, entries, jobs), 1):
            if isinstance(made, Exception):
                report(made)
                troubles.append(made)
            else:
                found.append(made)
            progress.done(done)
    return found, troubles


def _each(make: Callable[[Entry], Made], entries: Sequence[Entry], jobs: int) -> Iterator[Made]:
    if jobs == 1:
        return map(make, entries)
    compile_first()
    return elsewhere(make, entries, jobs)


def _told(options: GalleryOptions, shown: int, troubles: Sequence[Exception], what: str) -> int:
    """Say what was written, if anything was; the exit code."""
    code, output = UNUSABLE if troubles else HOLDS, options.output
    size = output.stat().st_size if shown else 0
    if options.json:
        facts = {"path": output.as_posix() if shown else None, "bytes": size, "scenes": shown}
        found = [problem for trouble in troubles for problem in problems_of(trouble)]
        print_document({**facts, "problems": found}, code)
    elif shown:
        print(f"{told(output)}: {what} of {shown} scene{'' if shown == 1 else 's'}, {size / 1000:,.0f} kB")
    return code

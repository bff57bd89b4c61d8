"""Pixels that grow with the text."""

from __future__ import annotations

from imgui_bundle import imgui


def scaled(pixels: float) -> float:
    """A length for text of the usual size, for text of the size that is set."""
    return pixels * float(imgui.get_style().font_scale_main)

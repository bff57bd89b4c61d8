"""Words cut to the room there is."""

from __future__ import annotations

from collections.abc import Callable

from imgui_bundle import imgui


def fitting(words: str, room: float, width: Callable[[str], float] | None = None) -> str:
    """Words, cut with an ellipsis where they are wider than `room` pixels, by `width` or as ImGui draws them."""
    measure = width or (lambda text: float(imgui.calc_text_size(text).x))
    if measure(words) <= room:
        return words
    low, high = 0, len(words)
    while low < high:
        middle = (low + high + 1) // 2
        fits = measure(words[:middle].rstrip() + "…") <= room
        low, high = (middle, high) if fits else (low, middle - 1)
    return words[:low].rstrip() + "…"

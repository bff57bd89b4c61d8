"""The counters of a game in a corner of a picture, and in its middle how it ended."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace

import numpy as np

from sandbox.engine.world import World
from sandbox.render.label import LETTER, Box, Label
from sandbox.render.marks import Marks
from sandbox.render.overlays.legend import EDGE, Corner
from sandbox.render.overlays.look import Look
from sandbox.render.overlays.pen import Pen, box_corners

SPACE, GAP = 7.0, 22.0
"""Pixels between a name and its value, and from one counter to the next."""
ENDINGS = {"won": "Won", "lost": "Lost"}
"""What is said of an outcome."""
SIZE, LARGE, LEADING = 15.0, 30.0, 1.5
"""Pixels of the words and of the outcome, and from one line to the next in heights of the text."""
_USUAL, _LEAST = 400.0, 0.6
"""Pixels of a picture's height below which words get smaller, and how small they get."""
_CARD, _BANNER = 0.78, 0.9
"""Opacity of what is behind them."""
_HIGH = 0.38
"""Where the middle of the banner is, in parts of the picture's height."""

Counter = tuple[float, str, float, str]
"""The pixel at which its name begins, its name, that of its value, and this."""


def counter_lines(
    counters: Mapping[str, float], room: float, width: Callable[[str, bool], float]
) -> Iterator[list[Counter]]:
    """The counters in lines, each as many as fit into `room` pixels, at least one; `width` is that of a text, which is
    a value or not."""
    line: list[Counter] = []
    x = 0.0
    for title, value in _named(counters):
        after = width(title, False) + SPACE
        wide = after + width(value, True)
        if line and x + wide > room:
            yield line
            line, x = [], 0.0
        line.append((x, title, x + after, value))
        x += wide + GAP
    if line:
        yield line


def _named(counters: Mapping[str, float]) -> Iterator[tuple[str, str]]:
    """The name of each for people, and its value."""
    for name, number in counters.items():
        yield name.replace("-", " ").replace("_", " "), f"{number:g}"


def score_words(world: World) -> str:
    """The counters and the outcome in one line; empty where nothing is played."""
    parts = [f"{name} {value}" for name, value in _named(world.counters)]
    ending = world.outcome
    if ending is not None:
        parts.append(ENDINGS[ending.result] + (f": {ending.text}" if ending.text else ""))
    return "  ·  ".join(parts)


def draw_scoreboard(look: Look, corner: Corner) -> tuple[Marks, tuple[Box, ...]]:
    """A layer with counters and outcome, and the room that they take; nothing where nothing is played."""
    pen = Pen(look, look.scale)
    cards = [_counters(look, corner), _ending(look)]
    for labels, box, opacity in cards:
        if labels:
            pen.fill(box_corners(np.array([box[:2]]), np.array([box[2:]])), look.palette.halo, opacity)
    words = [label for labels, _, _ in cards for label in labels]
    return replace(pen.marks(calm=False), labels=words), tuple(box for labels, box, _ in cards if labels)


def _scale(look: Look) -> float:
    """That of words, less in small pictures."""
    return look.scale * min(max(look.camera.size[1] / _USUAL, _LEAST), 1.0)


def _counters(look: Look, corner: Corner) -> tuple[list[Label], Box, float]:
    (width, height), size = look.camera.size, SIZE * _scale(look)
    lines = list(counter_lines(look.world.counters, width - 2 * EDGE, lambda text, _: LETTER * size * len(text)))
    wide = max((line[-1][2] + LETTER * size * len(line[-1][3]) for line in lines), default=0.0)
    high = LEADING * size * len(lines)
    left = EDGE if corner.endswith("left") else width - EDGE - wide
    top = EDGE if corner.startswith("upper") else height - EDGE - high
    labels = []
    for number, line in enumerate(lines):
        y = top + LEADING * size * (number + 0.5)
        for _, name, value_at, value in line:
            # Widths are guessed: so each name stands right beside its value.
            labels.append(Label(name, (left + value_at - SPACE, y), look.palette.quiet, size, "right"))
            labels.append(Label(value, (left + value_at, y), look.palette.text, size))
    return labels, (left - 8.0, top - 4.0, left + wide + 8.0, top + high + 4.0), _CARD


def _ending(look: Look) -> tuple[list[Label], Box, float]:
    outcome, (width, height), palette, scale = look.world.outcome, look.camera.size, look.palette, _scale(look)
    if outcome is None:
        return [], (0.0, 0.0, 0.0, 0.0), _BANNER
    color = palette.green if outcome.result == "won" else palette.text
    words = [(ENDINGS[outcome.result], LARGE * scale, color)]
    words += [(outcome.text, SIZE * scale, palette.text)] if outcome.text else []
    wide = max(LETTER * size * len(text) for text, size, _ in words)
    high = LEADING * sum(size for _, size, _ in words)
    y = top = _HIGH * height - high / 2
    labels = []
    for text, size, ink in words:
        labels.append(Label(text, (width / 2, y + LEADING * size / 2), ink, size, "middle"))
        y += LEADING * size
    return labels, (width / 2 - wide / 2 - 16.0, top - 6.0, width / 2 + wide / 2 + 16.0, y + 6.0), _BANNER

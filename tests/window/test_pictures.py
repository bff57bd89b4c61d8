"""The whole window, with all its panels, looks as it did: its pictures are those that were kept, within a tolerance.

`SANDBOX_RENEW_PICTURES=1 python -m pytest tests/window/test_pictures.py` keeps those of now: look at them first. What
is kept is a quarter as wide and high, and means of blocks are compared, so that another driver may place an edge half
a pixel beside ours.
"""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

import sandbox
from sandbox.window.screen import Canvas
from tests.window.hands import SIZE, play

KEPT = Path(__file__).with_name("pictures")
SCENE = sandbox.Scene(
    title="A yard",
    materials={"oak": {"density": 0.7}, "wet-ice": {"friction": 0.02}},
    bodies=[
        {"id": "ground", "type": "static", "material": "oak", "shapes": [{"box": [40, 1]}], "position": [0, -0.5]},
        {"id": "crate", "material": "wet-ice", "shapes": [{"box": [1, 1]}], "position": [0, 0.5]},
        {"id": "ball", "shapes": [{"circle": 0.5}], "position": [3, 0.5]},
        {"id": "wedge", "shapes": [{"polygon": [[0, 0], [2, 0], [2, 1]]}], "position": [-4, 1], "angle": 20},
        {"id": "rod", "shapes": [{"capsule": [[-1, 0], [1, 0]], "radius": 0.2}], "position": [2, 4]},
    ],
    joints=[{"id": "hinge", "type": "revolute", "bodies": ["rod"], "anchor": [1, 4]}],
    regions=[{"id": "pool", "water": 1, "inside": [4, 0, 7, 1.5]}],
    view={"center": [0, 3], "height": 12},
)
STEPS = "key .\n" * 8
SHOTS = {
    "inspector": STEPS + "click @0,0.5\n",
    "light-overlays": STEPS + "key F8\nkey Ctrl+P\nwait 3\ntype overlay contact points\nkey Enter\n"
    "key Ctrl+P\nwait 3\ntype overlay joint\nkey Enter\n",
    "separating-axes": "key K\nclick @-3,1.7\nclick @0,0.5\n",
    "help": "key F1\n",
    "small": STEPS + "click @0,0.5\nkey F2\n",
    "plots-and-world": "key F6\nwait 2\nkey F3\n" + STEPS,
}
SMALL = (400, 300)
"""The size of the window of that name."""
BLOCK = 5


def blocks(picture: Any) -> Any:
    """Means of blocks of pixels, without the corner that tells how quick this machine is."""
    pixels = np.asarray(picture.convert("RGB"), float).copy()
    pixels[: 24 // 4, 800 // 4 :] = 0.0
    high, wide = (side // BLOCK * BLOCK for side in pixels.shape[:2])
    return pixels[:high, :wide].reshape(high // BLOCK, BLOCK, wide // BLOCK, BLOCK, 3).mean(axis=(1, 3))


def alike(one: Any, other: Any) -> bool:
    """Whether two pictures show the same."""
    if one.size != other.size:
        return False
    apart = np.abs(blocks(one) - blocks(other)).max(axis=2)
    return bool(apart.mean() < 1.0 and (apart > 8.0).mean() < 0.005)


@pytest.mark.parametrize("name", SHOTS)
def test_the_window_looks_as_it_did(name: str, canvas: Canvas, tmp_path: Path) -> None:
    shown = tmp_path / f"{name}.png"
    size = SMALL if name == "small" else SIZE
    play(
        canvas,
        SCENE,
        tmp_path,
        SHOTS[name] + "move @-2,6\nwait 4\n",
        lambda screen: screen.workspace.shots.append(shown),
        "wait 2\n",
        size=size,
    )
    with Image.open(shown) as shot:
        assert shot.size == size
        small = shot.convert("RGB").resize((size[0] // 4, size[1] // 4), Image.Resampling.BOX)
    if os.environ.get("SANDBOX_RENEW_PICTURES"):
        small.save(KEPT / f"{name}.png", optimize=True)
    with Image.open(KEPT / f"{name}.png") as kept:
        assert alike(small, kept), f"{name} looks otherwise; see {shown}"


def test_what_looks_otherwise_is_noticed() -> None:
    kept = {}
    for name in SHOTS:
        with Image.open(KEPT / f"{name}.png") as image:
            kept[name] = image.convert("RGB")
    assert [(a, b) for a in kept for b in kept if a < b and alike(kept[a], kept[b])] == []
    moved = Image.fromarray(np.roll(np.asarray(kept["inspector"]), 2, axis=1))
    assert not alike(moved, kept["inspector"])

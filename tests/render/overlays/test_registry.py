from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from sandbox.errors import ArgumentError
from sandbox.render.camera import Camera
from sandbox.render.frame import capture
from sandbox.render.overlays.legend import quiet_corner
from sandbox.render.overlays.registry import OVERLAYS, draw_overlays, find_overlay
from sandbox.render.theme import DARK, LIGHT
from tests.render.overlays.looks import GROUND, SIZE, crate, look_at, shipped_world, shown, world_of

SCENES = {
    "first/crates-on-a-ramp": 60,
    "joints/ragdolls": 60,
    "sensors/zigzag": 120,
    "motion/bullets": 12,
    "shapes/tetrominoes": 90,
    "solver/on-a-post": 30,
}


@pytest.mark.parametrize("theme", [DARK, LIGHT], ids=["dark", "light"])
@pytest.mark.parametrize("scene", SCENES)
def test_every_overlay_draws_sound_marks_and_changes_nothing(scene: str, theme: Any) -> None:
    world = shipped_world(scene.split("/")[1], SCENES[scene])
    look = look_at(world, theme=theme)
    before = world.digest()
    for name, overlay in OVERLAYS.items():
        marks = overlay.draw(look)
        strokes = marks.strokes
        for numbers in (strokes.start, strokes.end, strokes.width, strokes.color, strokes.opacity):
            assert np.isfinite(numbers).all(), name
        assert (strokes.width > 0.0).all()
        assert (strokes.color >= 0.0).all()
        assert (strokes.color <= 1.0).all()
        for tint in marks.tints:
            assert tint.color.shape == (len(world.bodies), 3)
            assert (tint.amount >= 0.0).all()
            assert (tint.amount <= 1.0).all()
        assert all(label.text for label in marks.labels)
    assert world.digest() == before


@pytest.mark.parametrize("name", OVERLAYS)
def test_every_overlay_can_be_drawn_where_there_is_nothing_or_nothing_has_happened(name: str) -> None:
    for world in (world_of(), world_of(GROUND), world_of(GROUND, crate("a", 0, 0.5))):
        layers = shown(look_at(world), name)
        assert len(layers) == 2


def test_names_titles_and_help_are_fit_for_menus() -> None:
    for name, overlay in OVERLAYS.items():
        assert name == overlay.name == name.lower()
        assert overlay.title
        assert overlay.help.endswith(".")
        assert len(overlay.help) < 90
    assert len({overlay.title for overlay in OVERLAYS.values()}) == len(OVERLAYS)


def test_an_unknown_name_gets_the_nearest() -> None:
    with pytest.raises(ArgumentError, match=r"no overlay 'contcats'.*contacts"):
        find_overlay("contcats")
    with pytest.raises(ArgumentError, match="there are outlines, boxes"):
        find_overlay("qqqq")


def test_nothing_shown_looks_at_nothing() -> None:
    assert draw_overlays([], None) == ()  # type: ignore[arg-type]


def test_a_frame_of_other_bodies_gives_no_marks() -> None:
    world = world_of(GROUND, crate("a", 0, 0.5), steps=5)
    look = look_at(world)
    world.spawn([crate("b", 3, 2)])
    assert shown(look, "boxes", "contacts") == ()
    assert shown(replace(look, frame=capture(world.state)), "boxes", "contacts") != ()


@pytest.mark.parametrize("name", OVERLAYS)
def test_a_world_that_was_rewound_can_be_looked_at(name: str) -> None:
    world = world_of(GROUND, *(crate(f"c{k}", 1.2 * k - 4, 0.6 + k) for k in range(8)))
    start = world.snapshot()
    world.step(80)
    world.restore(start)
    shown(look_at(world), name)


def test_the_guide_tells_of_every_overlay() -> None:
    guide = (Path(__file__).parents[3] / "sandbox" / "cli" / "README.md").read_text(encoding="utf-8")
    for name, overlay in OVERLAYS.items():
        what = overlay.help.removesuffix(".")
        assert f"| `{name}` | {what[0].lower()}{what[1:]} |" in guide


@pytest.mark.parametrize(
    ("places", "corner"),
    [
        ([(0, 0)], "lower left"),
        ([(-9, -5)], "upper left"),
        ([(-9, -5), (-9, 5)], "upper right"),
        ([(-9, -5), (-9, 5), (9, 5)], "lower right"),
        ([(-9, -5), (-9, 5), (9, 5), (9, -5), (9.5, -5)], "lower left"),
    ],
)
def test_the_legend_looks_for_a_corner_in_which_nothing_is(places: list[tuple[float, float]], corner: str) -> None:
    world = world_of(*(crate(f"c{k}", x, y) for k, (x, y) in enumerate(places)))
    look = look_at(world, Camera((0.0, 0.0), 30.0, SIZE))
    assert quiet_corner(look) == corner
    *_, card = draw_overlays([OVERLAYS["boxes"]], look, quiet_corner(look))
    left, top = card.fills[0].points[0].min(axis=0)
    assert (left < SIZE[0] / 3) == corner.endswith("left")
    assert (top < SIZE[1] / 3) == corner.startswith("upper")


def test_words_of_overlays_keep_off_the_legend() -> None:
    look = look_at(shipped_world("pile", 60))
    *_, card = shown(look, "separations", "grid")
    low, high = card.fills[0].points[0].min(axis=0), card.fills[0].points[0].max(axis=0)
    names = {entry.text for name in ("separations", "grid") for entry in OVERLAYS[name].draw(look).legend}
    others = [label.box for label in card.labels if label.text not in names]
    assert others
    for left, top, right, bottom in others:
        assert right <= low[0] or left >= high[0] or bottom <= low[1] or top >= high[1]

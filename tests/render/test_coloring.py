"""Ways to colour bodies, and what the names of materials make of their looks."""

from __future__ import annotations

from typing import Any, get_args

import numpy as np
import pytest

import sandbox
from sandbox.errors import ArgumentError
from sandbox.render.body_colors import body_colors_of
from sandbox.render.camera import Camera
from sandbox.render.coloring.paint import ramp
from sandbox.render.coloring.registry import COLORINGS, find_coloring
from sandbox.render.draw_list import build_draw_list
from sandbox.render.frame import capture
from sandbox.render.marks import Marks
from sandbox.render.materials.looks import look_of
from sandbox.render.materials.textures import TEXTURES, UNITS, textures
from sandbox.render.overlays.look import Look
from sandbox.render.overlays.palette import palette_for
from sandbox.render.surface_finish import texture_at
from sandbox.render.theme import DARK, LIGHT
from sandbox.scene.settings import View

CAMERA = Camera((0.0, 1.0), 60.0, (640, 400))


def scene(**view: Any) -> sandbox.Scene:
    wood, ice = {"density": 0.7}, {"density": 0.9}
    return sandbox.Scene.model_validate(
        {
            "format": 1, "gravity": [0, 0], "materials": {"oak": wood, "black-ice": ice}, "view": view,
            "prefabs": {"plank": {"material": "oak", "shapes": [{"box": [2, 0.5]}]}},
            "bodies": [
                {"id": "soil", "type": "static", "material": "oak", "shapes": [{"box": [10, 1]}], "position": [0, -1]},
                {"id": "plank-1", "prefab": "plank", "position": [-3, 2], "velocity": [4, 0]},
                {"id": "plank-2", "prefab": "plank", "position": [3, 2], "color": "#ff0000"},
                {"id": "floe", "material": "black-ice", "shapes": [{"circle": 0.5}], "position": [0, 2]},
                {"id": "toy", "shapes": [{"circle": 0.5}, {"circle": 0.2, "at": [1, 0]}], "position": [0, 4]},
            ],
        }
    )  # fmt: skip


def drawn(name: str, world: sandbox.World) -> Marks:
    return COLORINGS[name].draw(Look(world, capture(world.state), CAMERA, DARK))


def color(marks: Marks, row: int) -> tuple[float, ...]:
    return tuple(marks.tints[0].color[row].tolist())


def test_a_scene_can_ask_for_every_way_to_colour() -> None:
    assert get_args(View.model_fields["color_by"].annotation) == tuple(COLORINGS)
    for name in COLORINGS:
        assert scene(color_by=name).view.color_by == name


def test_what_is_not_known_is_told_with_the_nearest() -> None:
    with pytest.raises(ArgumentError, match='did you mean "speed"'):
        find_coloring("sped")


def test_materials_and_groups_have_a_colour_each_and_a_legend() -> None:
    world = sandbox.World(scene())
    by_material, by_group = drawn("material", world), drawn("group", world)
    assert color(by_material, 1) == color(by_material, 2) != color(by_material, 3)
    assert color(by_material, 4) == palette_for(DARK).quiet
    assert [entry.text for entry in by_material.legend] == ["oak: 3 bodies", "black-ice: 1 body", "no material: 1 body"]
    assert color(by_group, 1) == color(by_group, 2) != color(by_group, 0)
    assert "plank: 2 bodies" in [entry.text for entry in by_group.legend]


def test_a_ramp_leads_from_rest_to_the_greatest_speed() -> None:
    world = sandbox.World(scene())
    world.step(2)
    marks = drawn("speed", world)
    assert marks.legend[-1].text == "5 m/s"
    rest, fast = ramp(DARK, np.array([0.0, 4.0 / 5.0]))
    assert color(marks, 4) == tuple(rest)
    assert color(marks, 1) == pytest.approx(tuple(fast), abs=1e-6)
    assert marks.tints[0].amount.tolist() == [0.0, 1.0, 1.0, 1.0, 1.0]


def test_mass_and_density_go_from_the_least_to_the_greatest() -> None:
    world = sandbox.World(scene())
    for name, light, heavy in (("mass", 1, 4), ("density", 1, 4)):
        marks, (least, most) = drawn(name, world), ramp(DARK, np.array([0.0, 1.0]))
        assert color(marks, heavy) == pytest.approx(tuple(most)), name
        assert color(marks, light) == pytest.approx(tuple(least)), name
        assert marks.tints[0].amount[0] == 0.0


@pytest.mark.parametrize("theme", [DARK, LIGHT], ids=["dark", "light"])
def test_the_ramp_is_read_by_its_lightness_alone(theme: Any) -> None:
    luma = ramp(theme, np.linspace(0.0, 1.0, 60)) @ (0.2126, 0.7152, 0.0722)
    assert (np.diff(luma if theme is DARK else -luma) > 0.0).all()


def test_sleep_and_islands_colour_as_their_overlays_do() -> None:
    world = sandbox.World(scene())
    world.step(120)
    assert {entry.text.split(":")[0] for entry in drawn("sleep", world).legend} >= {"asleep"}
    assert not drawn("sleep", world).labels
    assert "bodies alone: 1" in [entry.text for entry in drawn("island", world).legend]


@pytest.mark.parametrize(
    ("name", "texture"),
    [("oak", "wood"), ("wet-ice", "ice"), ("Sandstone 2", "stone"), ("old_planks", "wood"), ("wooden", "wood"),
     ("rice", None), ("licence", None), ("", None), ("nice", None), ("rubber", "rubber")],
)  # fmt: skip
def test_words_in_names_of_materials(name: str, texture: str | None) -> None:
    look = look_of(name)
    assert (look.texture if look else None) == texture


@pytest.mark.parametrize("theme", [DARK, LIGHT])
def test_known_materials_look_like_themselves_and_colors_overrule(theme: Any) -> None:
    colors = body_colors_of(sandbox.World(scene()).state, theme)
    wood, oak = look_of("wood"), look_of("oak")
    assert wood is oak is not None
    assert colors.base[1] == pytest.approx(wood.color(theme), abs=0.05)
    assert tuple(colors.base[2]) == (1.0, 0.0, 0.0)
    assert colors.opacity.tolist()[3] < 1.0 == colors.opacity[1]
    assert [TEXTURES[k] for k in colors.texture.tolist()] == ["wood", "wood", "wood", "ice", ""]


def test_textures_are_restrained_repeat_and_keep_the_colour() -> None:
    for tile in textures()[1:]:
        assert 0.005 < tile.std() < 0.05
        assert np.abs(tile).max() < 0.2
        assert abs(tile.mean()) < 0.02
        step = np.abs(np.diff(tile, axis=0)).max()
        assert np.abs(tile[0] - tile[-1]).max() <= 1.5 * step


def texture_values(world: sandbox.World, angle: float, scale: float) -> Any:
    """The texture of the first plank at places of its own, with the plank turned."""
    state = world.state
    row = world.names.index("plank-1")
    state.bodies.angle[row] = angle
    state.bodies.rotation_cos[row], state.bodies.rotation_sin[row] = np.cos(angle), np.sin(angle)
    camera = Camera((0.0, 2.0), scale, (8000, 8000))
    picture = build_draw_list(capture(state), camera, body_colors_of(state))
    shape = int(np.flatnonzero(picture.mesh.body[picture.shapes.index] == row)[0])
    local = np.random.default_rng(1).uniform((-0.9, -0.2), (0.9, 0.2), (200, 2))
    c, s = np.cos(angle), np.sin(angle)
    places = world.body("plank-1").position + local @ np.array([[c, s], [-s, c]])
    return texture_at(picture.shapes, np.full(200, shape), camera.to_screen(places)), picture.shapes


def test_a_texture_moves_turns_and_grows_with_its_body() -> None:
    world = sandbox.World(scene())
    straight, items = texture_values(world, 0.0, 400.0)
    turned, _ = texture_values(world, 1.1, 400.0)
    assert np.ptp(straight) > 0.02
    assert turned == pytest.approx(straight, abs=1e-9)
    assert items.unit[0] * UNITS > 128  # no smaller copy of the tile is looked into
    larger, _ = texture_values(world, 0.3, 800.0)
    assert larger == pytest.approx(straight, abs=1e-9)


def test_textures_fade_where_bodies_are_small_and_where_colours_mean_something() -> None:
    world = sandbox.World(scene())
    assert not texture_values(world, 0.0, 8.0)[0].any()
    near, middle = (np.ptp(texture_values(world, 0.0, scale)[0]) for scale in (400.0, 30.0))
    assert 0.0 < middle < near
    marks = drawn("mass", world)
    picture = build_draw_list(capture(world.state), CAMERA, body_colors_of(world.state), marks=[marks])
    assert not picture.shapes.texture.any()
    assert (picture.shapes.opacity == 1.0).all()


def test_shadows_are_cast_by_what_moves_and_can_be_left_out() -> None:
    state = sandbox.World(scene()).state
    for depth in (True, False):
        picture = build_draw_list(capture(state), CAMERA, body_colors_of(state), depth=depth)
        static = picture.mesh.body[picture.shapes.index] == 0
        assert not picture.shapes.shadow[static].any()
        assert (picture.shapes.shadow[~static] > 0.0).all() == depth

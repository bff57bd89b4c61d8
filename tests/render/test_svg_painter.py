"""SVG pictures, held against the surface painter by reading back the places in them."""

from __future__ import annotations

import re
from xml.etree import ElementTree

import numpy as np
import pytest

from sandbox.render.body_colors import choose_colors
from sandbox.render.camera import fit
from sandbox.render.draw_list import DrawList, build_draw_list
from sandbox.render.frame import capture, interesting_bounds
from sandbox.render.line import Line
from sandbox.render.svg_painter import svg_picture
from sandbox.render.theme import DARK
from sandbox.world.state import State
from tests.render.overlays.looks import look_at, shipped_world, shown
from tests.render.stages import letters, zoo

SIZE = (480, 300)
SVG = "{http://www.w3.org/2000/svg}"


def picture_of(state: State) -> DrawList:
    frame = capture(state)
    rope = Line((10.0, 20.0), (60.0, 20.0), 3.0, DARK.drag, 0.5)
    return build_draw_list(
        frame, fit(interesting_bounds(frame), SIZE), choose_colors(state.names, state.bodies.type, DARK), [rope]
    )


def shapes(root: ElementTree.Element) -> list[ElementTree.Element]:
    """The first thing drawn of every shape, with its frame."""
    return [group for group in root.iter(f"{SVG}g") if (group.get("transform") or "").startswith("matrix")]


@pytest.mark.parametrize("stage", [zoo, letters])
def test_every_shape_is_there_in_its_colour_where_it_is(stage: object) -> None:
    picture = picture_of(stage())  # type: ignore[operator]
    root = ElementTree.fromstring(svg_picture(picture, "a zoo"))
    assert root.findtext(f"{SVG}title") == "a zoo"
    groups = shapes(root)
    assert len(groups) == len(picture.shapes.index)
    for i, group in enumerate(groups):
        numbers = [float(part) for part in re.findall(r"[-\d.e]+", group.get("transform", ""))]
        assert numbers[4:] == pytest.approx(picture.shapes.origin[i], abs=0.01)
        assert numbers[:2] == pytest.approx(picture.shapes.axis[i], abs=1e-5)
        color = np.array([int(group[0].get("fill", "")[k : k + 2], 16) for k in (1, 3, 5)]) / 255
        assert color == pytest.approx(picture.shapes.fill[i], abs=0.003)


def test_outlines_lie_within_the_boundary() -> None:
    picture = picture_of(zoo())
    groups = shapes(ElementTree.fromstring(svg_picture(picture)))
    for i, group in enumerate(groups):
        row, node = int(picture.shapes.index[i]), group[0]
        half = picture.mesh.half[row].max() + picture.mesh.radius[row]
        reach = half * picture.camera.scale + picture.shapes.grow[i]
        line = float(node.get("stroke-width", "0"))
        if node.tag == f"{SVG}circle":
            assert float(node.get("r", "")) + line / 2 == pytest.approx(reach, abs=0.02)
        else:
            corners = np.array([pair.split(",") for pair in node.get("points", "").split()], float)
            assert np.abs(corners).max() <= reach + 0.02


def test_strokes_labels_and_fills_of_overlays_are_there() -> None:
    look = look_at(shipped_world("pile", 60))
    layers = shown(look, "grid", "separations")
    picture = build_draw_list(
        look.frame, look.camera, choose_colors(look.world.names, look.frame.type, DARK), marks=layers
    )
    root = ElementTree.fromstring(svg_picture(picture))
    texts = [node.text for node in root.iter(f"{SVG}text")]
    assert texts == [label.text for label in picture.labels]
    assert len(list(root.iter(f"{SVG}line"))) >= sum(len(layer.strokes) for layer in layers) + len(picture.below)
    polygons = [node for node in root.iter(f"{SVG}polygon") if node.get("stroke") is None]
    assert len(polygons) == sum(len(fills) for layer in layers for fills in layer.fills)

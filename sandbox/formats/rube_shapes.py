"""Fixtures of R.U.B.E.: as it exports them, each with one shape, and as it saves what was drawn."""

from __future__ import annotations

from sandbox.formats.box2d.terms import chain_of, edge_of
from sandbox.formats.box2d.world import Fixture, Outline
from sandbox.formats.numbers import Vec
from sandbox.formats.outlines import without_repeats
from sandbox.formats.reading import Node
from sandbox.formats.remarks import Remarks
from sandbox.formats.rube_node import RubeNode
from sandbox.geometry.decompose import decompose
from sandbox.geometry.polygon import PolygonError


def exported_fixtures(node: RubeNode, remarks: Remarks) -> list[Fixture]:
    """The fixture, or none with a remark. Raises `MisreadError`."""
    outline = _exported(node)
    return _made(node, [outline] if outline else [], remarks)


def drawn_fixtures(node: RubeNode, remarks: Remarks) -> list[Fixture]:
    """A fixture for each part of what was drawn: vertices, and the shapes that they are. Raises `MisreadError`."""
    points = node.points("vertices")
    shapes = list(node.nodes("shapes"))
    outlines = [outline for shape in shapes for outline in _drawn(shape, points, node, remarks)]
    return _made(node, outlines, remarks)


def _made(node: RubeNode, outlines: list[Outline], remarks: Remarks) -> list[Fixture]:
    fixtures = [
        Fixture(
            place=node.place,
            outline=outline,
            density=node.number("density"),
            friction=node.number("friction"),
            restitution=node.number("restitution"),
            sensor=node.flag("sensor"),
            category=node.whole("filter-categoryBits", 1),
            mask=node.whole("filter-maskBits", 0xFFFF),
            group=node.whole("filter-groupIndex"),
        )
        for outline in outlines
    ]
    if not fixtures:
        remarks.note(node.place, "a fixture without a circle, polygon, edge or chain is left out")
    return fixtures


def _exported(node: RubeNode) -> Outline | None:
    if circle := node.node("circle"):
        return Outline("circle", [circle.vector("center")], circle.number("radius"))
    if edge := node.node("edge"):
        return edge_of(edge)
    if loop := node.node("loop"):
        return chain_of(loop, closed=True)
    if chain := node.node("chain"):
        return chain_of(chain)
    if polygon := node.node("polygon"):
        return Outline("polygon", polygon.points("vertices"))
    return None


def _drawn(shape: Node, points: list[Vec], fixture: Node, remarks: Remarks) -> list[Outline]:
    kind = shape.text("type")
    if kind == "circle" and points:
        return [Outline("circle", points[:1], shape.number("radius"))]
    if kind in ("line", "chain", "loop"):
        closed = kind == "loop"
        if len(points) > 3 and points[0] == points[-1]:
            closed, points = True, points[:-1]
        return [Outline("chain", points, closed=closed)]
    if kind != "polygon":
        remarks.note(fixture.place, f'a shape of the type "{kind[:40]}" is left out')
        return []
    ring = without_repeats(points)
    if len(ring) < 3:
        remarks.note(fixture.place, "a polygon is left out: it has fewer than 3 corners")
        return []
    try:  # the editor cuts what is not convex when it exports
        return [Outline("polygon", list(part.vertices)) for part in decompose(ring).parts]
    except PolygonError as error:
        remarks.note(fixture.place, f"a polygon is left out: {error}")
        return []

"""What every file of a Box2D world calls as Box2D itself does: the fields of `b2BodyDef`, and of lines."""

from __future__ import annotations

from sandbox.formats.box2d.world import Body, BodyType, Outline
from sandbox.formats.numbers import Vec
from sandbox.formats.reading import Node
from sandbox.formats.remarks import Remarks

TYPES: tuple[BodyType, ...] = ("static", "kinematic", "dynamic")
"""In the order of `b2BodyType`."""


def body_of(node: Node, kind: BodyType, name: str) -> Body:
    """A body without fixtures. Raises `MisreadError`."""
    return Body(
        place=node.place,
        name=name,
        type=kind,
        position=node.vector("position"),
        angle=node.number("angle"),
        velocity=node.vector("linearVelocity"),
        spin=node.number("angularVelocity"),
        linear_damping=node.number("linearDamping"),
        angular_damping=node.number("angularDamping"),
        gravity_scale=node.number("gravityScale", 1.0),
        fixed_rotation=node.flag("fixedRotation"),
        bullet=node.flag("bullet"),
        allow_sleep=node.flag("allowSleep", True),
    )


def edge_of(node: Node) -> Outline:
    """One line, and the vertices before and after it where it has them. Raises `MisreadError`."""
    line = Outline("chain", [node.vector("vertex1"), node.vector("vertex2")])
    return _ghosted(node, line, ("hasVertex0", "vertex0"), ("hasVertex3", "vertex3"))


def chain_of(node: Node, closed: bool = False) -> Outline:
    """A chain; one that leads back to its first vertex is closed. Raises `MisreadError`."""
    points = node.points("vertices")
    if len(points) > 3 and points[0] == points[-1]:
        closed, points = True, points[:-1]
    line = _ghosted(node, Outline("chain", points, closed=closed), ("hasPrevVertex", "prevVertex"),
                    ("hasNextVertex", "nextVertex"))  # fmt: skip
    if closed:
        line.before = line.after = None
    return line


def note_unread(node: Node, remarks: Remarks, *known: str) -> None:
    """A remark on the fields of an object that nobody has read, but for those `known` to mean nothing."""
    if found := node.unread(*known):
        place = f"{node.place} ({', '.join(found)[:80]})".strip()
        remarks.note(place, "fields that mean nothing to a scene are left out")


def _ghosted(node: Node, line: Outline, before: tuple[str, str], after: tuple[str, str]) -> Outline:
    line.before, line.after = (_ghost(node, *keys) for keys in (before, after))
    return line


def _ghost(node: Node, has: str, vertex: str) -> Vec | None:
    return (node.vector(vertex) if node.has(vertex) else (0.0, 0.0)) if node.flag(has) else None

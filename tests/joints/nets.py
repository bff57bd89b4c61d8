"""Nets of boxes: grids of n x m, each joined to its neighbours, hung up by some of them or free."""

from __future__ import annotations

import dataclasses

import numpy as np

from sandbox import SetPose, SetVelocity
from sandbox.engine.world import World
from sandbox.scene.flat import FlatJoint, Vec
from tests.flat import AWAKE, body, box
from tests.joints.jointed import joint, jointed

KINDS = {
    "hinge": {"kind": "revolute"},
    "stopped hinge": {"kind": "revolute", "lower": -0.2, "upper": 0.2},
    "weld": {"kind": "weld"},
    "elastic weld": {"kind": "weld", "hertz": 8.0, "damping_ratio": 0.2, "angular_hertz": 8.0},
    "slider": {"kind": "prismatic", "axis": (1.0, 0.3), "lower": -0.2, "upper": 0.2},
    "rod": {"kind": "distance"},
    "spring": {"kind": "distance", "hertz": 4.0, "damping_ratio": 0.1},
    "friction": {"kind": "friction", "max_force": 50.0, "max_torque": 5.0},
}
"""Words of each kind of joint in a net."""


def net(
    across: int, down: int, kind: str, hung: str = "top", substeps: int = 4, braced: bool = False, post: bool = False
) -> World:
    """A net of boxes of 0.8 m, 1 m apart, that hangs from its "top", its "middle", its "corner", or "nothing".

    `braced` adds diagonals, which say what others say already; with a `post` it hangs on a static body, not on the
    world.
    """
    places = {(r, c): (float(c), -float(r)) for r in range(down) for c in range(across)}
    bodies = [body(_name(at), box(0.8, 0.8, mask=0), position=place) for at, place in places.items()]
    pairs: list[tuple[tuple[int, int] | None, tuple[int, int]]] = []
    held = {"top": range(across), "middle": range(across // 2 - 2, across // 2 + 2), "corner": range(1)}.get(
        hung, range(0)
    )
    for r, c in places:
        if r == 0 and c in held:
            pairs.append((None, (r, c)))
        steps = ((-1, 0), (0, -1), *(((-1, -1), (-1, 1)) if braced else ()))
        pairs += [((r + y, c + x), (r, c)) for y, x in steps if (r + y, c + x) in places]
    joints = [_link(f"j{k}", places, a, b, **KINDS[kind]) for k, (a, b) in enumerate(pairs)]
    if post:
        bodies.append(body("post", box(0.5, 0.5, mask=0), type="static", position=(3.0, 7.0)))
        joints = [dataclasses.replace(each, body_a="post") if each.body_a is None else each for each in joints]
    return jointed(tuple(bodies), tuple(joints), settings=dataclasses.replace(AWAKE, substeps=substeps))


def throw(world: World, random: np.random.Generator, speed: float, apart: float) -> None:
    """Give every body a velocity of its own and move it out of its place: standard deviations in m/s and m."""
    for name, here in zip(world.names, np.array(world.bodies.position), strict=True):
        vx, vy, w, x, y, turn = random.normal(0.0, 1.0, 6)
        world.apply(SetPose(name, (float(here[0] + apart * x), float(here[1] + apart * y)), float(apart * turn)))
        world.apply(SetVelocity(name, (float(speed * vx), float(speed * vy)), float(speed * w)))


def _name(at: tuple[int, int]) -> str:
    return f"b{at[0]}-{at[1]}"


def _link(
    name: str, places: dict[tuple[int, int], Vec], a: tuple[int, int] | None, b: tuple[int, int], **words: object
) -> FlatJoint:
    """A joint half way between two boxes, or from the middle of one to that of the other if it keeps a distance."""
    here = places[b]
    there = places[a] if a else (here[0], here[1] + 1.0)
    at = {"at": (0.5 * (here[0] + there[0]), 0.5 * (here[1] + there[1]))}
    if words["kind"] == "distance":
        at = {"anchor_a": there, "anchor_b": here}
    return joint(name, b=_name(b), a=_name(a) if a else None, **at, **words)  # type: ignore[arg-type]


def kinetic_energy(world: World) -> float:
    """Of all bodies, J."""
    b = world.state.bodies
    speeds = b.mass * (b.velocity_x**2 + b.velocity_y**2) + b.inertia * b.angular_velocity**2
    return float(np.sum(0.5 * speeds))


def soft_parts(world: World) -> int:
    """How many parts of a world have soft joints, as they are too dense to be factorised."""
    return int((world.scratch.joints.parts.direct == 0).sum())

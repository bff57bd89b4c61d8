"""The records of force fields: regions, the half-planes that bound them, and thrusters."""

from __future__ import annotations

from sandbox.tables import COUNT, UNLIMITED, Field, Table, Values, whole
from sandbox.world.bounds import SHARE

WATER, GRAVITY, GRAVITY_SCALE, ATTRACTION, WIND = 0, 1, 2, 3, 4
NEVER = 1 << 62
"""The step at which what has no end ends."""
_STEP = Values(0, NEVER)

REGION = Table(
    "region",
    (
        whole("kind", "0 water, 1 gravity, 2 scaled gravity, 3 attraction, 4 wind", Values(WATER, WIND)),
        whole(
            "first_edge", "first row of its half-planes in the edge table", Values(0, row_of="edge", count="edge_count")
        ),
        whole("edge_count", "it lies in all of them; without one and without a disc it is everywhere", COUNT),
        Field("disc_x", "m", "middle of the disc it lies in as well"),
        Field("disc_y", "m", "middle of the disc it lies in as well"),
        Field("disc_radius", "m", "0 without a disc"),
        whole("start_step", "first step in which it acts", _STEP),
        whole("end_step", "first step after that in which it does not", _STEP),
        Field("density", "kg/m^2", "of water or air"),
        Field("flow_x", "m/s", "velocity of water or air"),
        Field("flow_y", "m/s", "velocity of water or air"),
        Field("drag", "1/s or 1", "water: rate at which a body as dense loses speed; wind: pressure coefficient"),
        Field("angular_drag", "1/s", "water: rate at which a body as dense loses spin"),
        Field("gravity_x", "m/s^2", "gravity: instead of the scene's"),
        Field("gravity_y", "m/s^2", "gravity: instead of the scene's"),
        Field("scale", "1", "scaled gravity: factor"),
        Field("center_x", "m", "attraction: where to"),
        Field("center_y", "m", "attraction: where to"),
        Field("strength", "m/s^2", "attraction: acceleration at 1 m"),
        whole("falloff", "attraction: power of the distance it falls with, 0 to 3", Values(0, 3)),
        Field("core", "m", "attraction: nearer than this it falls to nothing"),
        Field("range", "m", "attraction: farther than this there is none", values=UNLIMITED),
    ),
)

EDGE = Table(
    "edge",
    (
        Field("normal_x", "1", "unit normal, outward", values=SHARE),
        Field("normal_y", "1", "unit normal, outward", values=SHARE),
        Field("offset", "m", "the half-plane is where normal . p <= offset"),
    ),
)

THRUSTER = Table(
    "thruster",
    (
        whole("body", "index of the body it pushes", Values(0, row_of="body")),
        Field("force_x", "N", "in the body's frame"),
        Field("force_y", "N", "in the body's frame"),
        Field("local_x", "m", "where it pushes, from the centre of mass, in the body's frame"),
        Field("local_y", "m", "where it pushes, from the centre of mass, in the body's frame"),
        whole("start_step", "first step in which it pushes", _STEP),
        whole("end_step", "first step after that in which it does not", _STEP),
    ),
)

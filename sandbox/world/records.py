"""The record of everything a world stores: one table a concept, one row a field.

The dtypes, the digest, the snapshot layout and the documentation are derived from these tables. Booleans are 0
or 1; an index of -1 means none.
"""

from __future__ import annotations

from sandbox.scene.limits import ALL_BITS, MAX_SUBSTEPS, MAX_VERTICES
from sandbox.tables import ANY_WHOLE, COUNT, FLAG, STEP_OR_NEVER, Field, Table, Values, whole, whole_i4
from sandbox.world.bounds import LENGTH, PLACE, SHARE, SPEED
from sandbox.world.field_records import EDGE, REGION, THRUSTER
from sandbox.world.joint_records import JOINT
from sandbox.world.rule_records import CONTROL, OUTCOME, PATH, RULE, SENSING, SPAWNER, TALLY

STATIC, KINEMATIC, DYNAMIC = 0, 1, 2
CIRCLE, BOX, CAPSULE, SEGMENT, POLYGON = 0, 1, 2, 3, 4
SEAMED, ONE_WAY = 1, 2

_BODY, _SHAPE = Values(0, row_of="body"), Values(0, row_of="shape")
_BITS = Values(0, ALL_BITS)
_FEATURE = Values(-1, 64 * MAX_VERTICES - 1)
_ISLAND = Values(0, row_of="body", past=1)
_CORE = Values(0, row_of="vertex", count="vertex_count")

BODY = Table(
    "body",
    (
        Field("position_x", "m", "body origin, as the scene gives it", values=PLACE),
        Field("position_y", "m", "body origin, as the scene gives it", values=PLACE),
        Field("angle", "rad", "angle turned so far, not wrapped", values=PLACE),
        Field("velocity_x", "m/s", "velocity of the centre of mass", values=SPEED),
        Field("velocity_y", "m/s", "velocity of the centre of mass", values=SPEED),
        Field("angular_velocity", "rad/s", "counter-clockwise is positive", values=SPEED),
        Field("center_x", "m", "centre of mass in the world", values=PLACE),
        Field("center_y", "m", "centre of mass in the world", values=PLACE),
        Field("rotation_cos", "1", "cosine of the angle; what the step turns", values=SHARE),
        Field("rotation_sin", "1", "sine of the angle; what the step turns", values=SHARE),
        Field("local_center_x", "m", "centre of mass from the origin, in the body's frame", values=LENGTH),
        Field("local_center_y", "m", "centre of mass from the origin, in the body's frame", values=LENGTH),
        Field("mass", "kg", "0 for static and kinematic bodies"),
        Field("inertia", "kg m^2", "about the centre of mass; 0 where it cannot turn"),
        Field("inverse_mass", "1/kg", "0 for static and kinematic bodies"),
        Field("inverse_inertia", "1/(kg m^2)", "0 where the body cannot turn"),
        Field("force_x", "N", "applied during the next step, then cleared"),
        Field("force_y", "N", "applied during the next step, then cleared"),
        Field("torque", "N m", "applied during the next step, then cleared"),
        Field("linear_damping", "1/s", "v' = -damping v"),
        Field("angular_damping", "1/s", "w' = -damping w"),
        Field("gravity_scale", "1", "multiplies the scene's gravity"),
        Field("sleep_speed", "m/s", "the body is slow while no point of it moves faster"),
        Field("extent", "m", "farthest surface point from the centre of mass", hashed=False, values=LENGTH),
        whole("type", "0 static, 1 kinematic, 2 dynamic", Values(STATIC, DYNAMIC)),
        whole("bullet", "1: it does not pass through moving bodies either", FLAG),
        whole("awake", "1 while the body is simulated; 0 asleep", FLAG),
        Field("sleep_time", "s", "how long the body has been slow"),
        Field("slow_speed", "m/s", "fastest point of the body when it became slow"),
        whole("island", "1 + first row of the island it fell asleep with; 0 while awake", _ISLAND),
        whole("posed", "1 from the command that sets the pose until the next step", FLAG),
        whole("stirred", "1 when the body woke in the last step, -1 when it fell asleep", Values(-1, 1), hashed=False),
        whole("was_asleep", "1 when it slept after the last step", FLAG, hashed=False),
        whole("frozen_step", "step at which bad numbers froze the body; -1 if never", STEP_OR_NEVER),
    ),
)

SURFACE = ("density", "friction", "restitution", "rolling_resistance", "surface_speed")
"""Columns of a shape: what a material says and a command may change."""

SHAPE = Table(
    "shape",
    (
        whole("body", "index of its body", _BODY),
        whole("kind", "0 circle, 1 box, 2 capsule, 3 segment, 4 polygon; for drawing only", Values(CIRCLE, POLYGON)),
        whole("vertex_start", "first row of its core in the vertex table", _CORE),
        whole("vertex_count", "1 circle, 2 capsule or segment, 3..64 polygon", Values(1, MAX_VERTICES)),
        Field("radius", "m", "rounding around the core", values=LENGTH),
        Field("thin", "m", "half its smallest width", hashed=False),
        Field("density", "kg/m^2", "what its body's mass is made of", hashed=False),
        Field("friction", "1", "Coulomb coefficient; a pair uses sqrt(a b)"),
        Field("restitution", "1", "a pair uses max(a, b)"),
        Field("rolling_resistance", "m", "lever arm of the rolling friction; a pair uses max(a, b)"),
        Field("surface_speed", "m/s", "conveyor: speed of the surface, clockwise around the shape"),
        whole("category", "bit set of what the shape is", _BITS),
        whole("mask", "bit set of what it collides with", _BITS),
        whole("group", "same positive group always collides, same negative group never, 0 no group", ANY_WHOLE),
        whole("sensor", "1: feels what overlaps it and pushes nothing", FLAG),
        whole(
            "part",
            "number of the part of a concave polygon or chain, from 1; 0 for a shape of its own",
            COUNT,
            hashed=False,
        ),
        Field("one_way_x", "1", "unit direction in which bodies pass, in the body's frame; 0, 0 if none do"),
        Field("one_way_y", "1", "unit direction in which bodies pass, in the body's frame; 0, 0 if none do"),
        whole(
            "traits",
            "bit 0: its rows in the seam table hold; bit 1: it is one-way",
            Values(0, SEAMED | ONE_WAY),
            hashed=False,
        ),
        whole(
            "seam_start", "first row in the seam table, if it has any", Values(0, row_of="seam", past=1), hashed=False
        ),
        whole(
            "outline_start",
            "first row of the concave polygon in the outline table",
            Values(0, row_of="outline", count="outline_count"),
            hashed=False,
        ),
        whole("outline_count", "sides of the concave polygon; 0 unless this is its first part", COUNT, hashed=False),
    ),
)

VERTEX = Table(
    "vertex",
    (
        Field("x", "m", "core vertex from the centre of mass, in the body's frame, counter-clockwise", values=LENGTH),
        Field("y", "m", "core vertex from the centre of mass, in the body's frame, counter-clockwise", values=LENGTH),
        Field("normal_x", "1", "outward unit normal of the edge to the next vertex; 0 for a circle", values=SHARE),
        Field("normal_y", "1", "outward unit normal of the edge to the next vertex; 0 for a circle", values=SHARE),
    ),
)


OUTLINE = Table(
    "outline",
    (
        Field("start_x", "m", "where a side of a concave polygon begins, from the centre of mass", hashed=False),
        Field("start_y", "m", "where a side begins, in the body's frame; the inside is on its left", hashed=False),
        Field("end_x", "m", "where it ends", hashed=False),
        Field("end_y", "m", "where it ends", hashed=False),
    ),
)
"""What concave polygons look like; they collide by their convex parts."""


SEAM = Table(
    "seam",
    (
        Field("before_x", "1", "outward unit normal of the polygon's side that ends in this vertex", hashed=False),
        Field("before_y", "1", "the same, in the body's frame", hashed=False),
        Field("after_x", "1", "outward unit normal of the polygon's side that begins in this vertex", hashed=False),
        Field("after_y", "1", "the same, in the body's frame", hashed=False),
        Field(
            "shown_from",
            "1",
            "share of the part's edge from this vertex on where sides of the polygon begin",
            hashed=False,
        ),
        Field("shown_to", "1", "where they end; 0 if the whole edge lies within the polygon", hashed=False),
    ),
)
"""One row for each vertex of a part: of a concave polygon, of a chain, of abutting tiles. What the whole is there."""


def _kept_of_point(k: int) -> tuple[Field, ...]:
    """What a point of a contact keeps from step to step."""
    return (
        whole(f"feature{k}", f"feature id of point {k}: 64 * vertex of a + vertex of b", _FEATURE),
        Field(f"normal_impulse{k}", "N s", f"at point {k}, accumulated over the last of the scene's substeps"),
        Field(f"tangent_impulse{k}", "N s", f"at point {k}, accumulated over the last of the scene's substeps"),
        Field(f"rest_length{k}", "m", f"gap at which the spring of point {k} does not push"),
    )


def _place_of_point(k: int) -> tuple[Field, ...]:
    """Where a point of a contact is."""
    return (
        Field(f"anchor_ax{k}", "m", f"contact point {k} from the centre of body a, world axes"),
        Field(f"anchor_ay{k}", "m", f"contact point {k} from the centre of body a, world axes"),
        Field(f"anchor_bx{k}", "m", f"contact point {k} from the centre of body b, world axes"),
        Field(f"anchor_by{k}", "m", f"contact point {k} from the centre of body b, world axes"),
        Field(f"separation{k}", "m", f"gap at point {k} when the step began; negative when they overlap"),
    )


CONTACT = Table(
    "contact",
    (
        whole_i4("shape_a", "index of the first shape; shape_a < shape_b", _SHAPE),
        whole_i4("shape_b", "index of the second shape", _SHAPE),
        whole_i4("body_a", "index of the first body", _BODY),
        whole_i4("body_b", "index of the second body", _BODY),
        whole_i4("point_count", "1 or 2", Values(1, 2)),
        whole_i4("substep_level", "of the island when the contact was last solved", Values(0, 4)),
        whole_i4("touching", "1 once the shapes have pushed or overlapped, until they are well apart", FLAG),
        whole_i4("axis_owner", "whose face gave the normal: 0 of a, 1 of b, 2 it joins two vertices", Values(0, 2)),
        *_kept_of_point(1),
        *_kept_of_point(2),
        Field("rolling_impulse", "N m s", "accumulated over the last of the scene's substeps"),
        Field("impact_impulse", "N s", "normal impulse of the impacts during the step, both points"),
        Field("restitution", "1", "mixed coefficient"),
        Field("surface_speed", "m/s", "tangent speed asked of b relative to a"),
        Field("friction", "1", "mixed coefficient"),
        Field("rolling_resistance", "m", "mixed lever arm"),
        Field("normal_x", "1", "unit normal from a to b"),
        Field("normal_y", "1", "unit normal from a to b"),
        Field("radius_a", "m", "rounding of shape a"),
        Field("radius_b", "m", "rounding of shape b"),
        *_place_of_point(1),
        *_place_of_point(2),
    ),
)
"""Four cache lines a row: what a contact keeps from step to step is in the first two, and often all that is asked.
Which columns are read side by side, `contact_solver/contact_rows.py` tells."""

DRAG = Table(
    "drag",
    (
        whole("body", "index of the dragged body; -1 when the row is free", Values(-1, row_of="body")),
        Field("target_x", "m", "where the grabbed point is pulled to"),
        Field("target_y", "m", "where the grabbed point is pulled to"),
        Field("local_x", "m", "grabbed point from the centre of mass, in the body's frame"),
        Field("local_y", "m", "grabbed point from the centre of mass, in the body's frame"),
        Field("hertz", "1/s", "stiffness of the soft constraint"),
        Field("damping_ratio", "1", "1 is critical damping"),
        Field("max_force", "N", "limit of the pull"),
        Field("impulse_x", "N s", "accumulated over the last substep, as of level 0"),
        Field("impulse_y", "N s", "accumulated over the last substep, as of level 0"),
    ),
)

SETTINGS = Table(
    "settings",
    (
        Field("step_seconds", "s", "length of one step", values=Values(1e-5, 10.0)),
        whole("substeps", "solver substeps in a step", Values(1, MAX_SUBSTEPS)),
        Field("gravity_x", "m/s^2", ""),
        Field("gravity_y", "m/s^2", ""),
        Field("contact_hertz", "1/s", "stiffness of contacts", values=Values(0.0, 1e5)),
        Field("contact_damping_ratio", "1", "damping of contacts", values=Values(0.0, 1e4)),
        Field("push_out_speed", "m/s", "fastest overlap recovery", values=Values(0.0, 1e7)),
        Field("restitution_threshold", "m/s", "slower impacts do not bounce", values=Values(0.0, 1e7)),
        Field("units_per_meter", "1", "units of length to a metre", hashed=False, values=Values(1e-6, 1e6)),
        whole("sleeping", "1 lets resting islands fall asleep", FLAG),
        whole("warm_starting", "1 begins a substep with the impulses of the last one", FLAG, hashed=False),
        whole("accumulate", "1 clamps the sum of a point's impulses, 0 each of them", FLAG, hashed=False),
        whole("soft", "1 makes contacts springs with dampers, 0 corrects overlaps by Baumgarte", FLAG, hashed=False),
        whole("relax", "1 takes the speed back that pushes overlaps apart", FLAG, hashed=False),
        whole("speculative", "1 lets contacts work before the shapes touch", FLAG, hashed=False),
    ),
)

COUNTERS = Table(
    "counters",
    (
        whole("step_count", "steps taken since the start", COUNT),
        whole("contact_count", "rows in use in the contact table", COUNT),
        whole("old_contact_count", "rows that were in use in the step before", COUNT, hashed=False),
        whole("pair_count", "pairs the grid proposed in the last step", COUNT, hashed=False),
        whole("found_count", "contacts found in the step under way", COUNT, hashed=False),
        whole("color_count", "colours of the contact graph in the last step", COUNT, hashed=False),
        whole("awake_count", "dynamic bodies awake after the last step", COUNT, hashed=False),
        whole("asleep_count", "dynamic bodies asleep after the last step", COUNT, hashed=False),
        whole("still", "1 when steps change nothing until a command comes", FLAG, hashed=False),
        whole(
            "substep_watch",
            "how often piles are looked at: 0 unknown, 1 every eighth step, 2 at every step",
            Values(0, 2),
        ),
        whole(
            "substep_levels", "substep levels that piles took in the last step, as bits; 1 is level 0", Values(0, 31)
        ),
        whole("broken_count", "joints broken so far", COUNT, hashed=False),
        whole("frozen_count", "bodies frozen so far", COUNT),
    ),
)


BODY_WORDS = BODY.dtype.itemsize // 8


class BodyPlace:
    """Which word of a body's row is which, for who asks for single ones (`State.body_words`)."""

    _ALL = tuple(field.name for field in BODY.fields)
    POSITION_X = _ALL.index("position_x")
    POSITION_Y = _ALL.index("position_y")
    ANGLE = _ALL.index("angle")
    VELOCITY_X = _ALL.index("velocity_x")
    VELOCITY_Y = _ALL.index("velocity_y")
    ANGULAR_VELOCITY = _ALL.index("angular_velocity")
    CENTER_X = _ALL.index("center_x")
    CENTER_Y = _ALL.index("center_y")
    ROTATION_COS = _ALL.index("rotation_cos")
    ROTATION_SIN = _ALL.index("rotation_sin")
    LOCAL_CENTER_X = _ALL.index("local_center_x")
    LOCAL_CENTER_Y = _ALL.index("local_center_y")
    MASS = _ALL.index("mass")
    INERTIA = _ALL.index("inertia")
    INVERSE_MASS = _ALL.index("inverse_mass")
    INVERSE_INERTIA = _ALL.index("inverse_inertia")
    FORCE_X = _ALL.index("force_x")
    FORCE_Y = _ALL.index("force_y")
    TORQUE = _ALL.index("torque")
    TYPE = _ALL.index("type")
    AWAKE = _ALL.index("awake")
    SLEEP_TIME = _ALL.index("sleep_time")
    ISLAND = _ALL.index("island")
    POSED = _ALL.index("posed")


class CounterPlace:
    """Which word of the row of counters is which, for who asks in every step."""

    _ALL = tuple(field.name for field in COUNTERS.fields)
    STEPS = _ALL.index("step_count")
    CONTACTS = _ALL.index("contact_count")
    AWAKE = _ALL.index("awake_count")
    STILL = _ALL.index("still")
    WATCH = _ALL.index("substep_watch")
    BROKEN = _ALL.index("broken_count")
    FROZEN = _ALL.index("frozen_count")


TABLES = (
    BODY, SHAPE, VERTEX, OUTLINE, SEAM, CONTACT, JOINT, DRAG, REGION, EDGE, THRUSTER, SETTINGS, COUNTERS,
    CONTROL, TALLY, RULE, SPAWNER, SENSING, PATH, OUTCOME,
)  # fmt: skip
"""All stored tables, in the order of the snapshot and the digest."""

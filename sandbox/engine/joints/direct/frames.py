"""How far every joint of a batch is from what it keeps, at the poses its bodies were looked at."""

from __future__ import annotations

from sandbox._jit import inlined_kernel, kernel
from sandbox._vectors import WIDTH, Vector, load, select, spread, store
from sandbox.engine.joints.direct import places as at
from sandbox.engine.joints.direct.records import Batches
from sandbox.engine.joints.direct.targets import may_be_sprung
from sandbox.engine.joints.laws import gap, is_close, length_and_direction, rope, turned
from sandbox.tables import Floats, Records
from sandbox.world.joint_records import (
    DISTANCE,
    FRICTION,
    GEAR,
    MOTOR,
    PRISMATIC,
    PULLEY,
    TARGET,
    WHEEL,
)


@kernel
def measure_frames(d: Batches, batch: Records) -> None:
    """Anchors, gaps and errors of all joints of a batch; gears last, for they build on others."""
    v = d.memory
    layout = d.layouts[batch.layout]
    gears = 0
    for f in range(layout.first_frame, layout.frame_end):
        frame = d.layout_frames[f]
        if frame.kind == GEAR:
            gears += 1
            continue
        _place_anchors(v, batch, frame)
        _find_errors(v, batch, frame)
    for f in range(layout.first_frame, layout.frame_end if gears > 0 else layout.first_frame):
        frame = d.layout_frames[f]
        if frame.kind == GEAR:
            joint = batch.joints + frame.constants
            first = _coordinate(v, frame.coordinate_1, frame.kind_1)
            second = _coordinate(v, frame.coordinate_2, frame.kind_2)
            error = first + load(v, joint + at.RATIO) * second - load(v, joint + at.LENGTH)
            store(v, frame.place + at.ERRORS, error)


@kernel
def _place_anchors(v: Floats, batch: Records, frame: Records) -> None:
    """Arms, the gap between the anchors and the angle between the bodies."""
    a = frame.seat_a
    b = frame.seat_b
    joint = batch.joints + frame.constants
    x = load(v, joint + (at.POINT_AX if frame.kind == TARGET else at.ANCHOR_AX))
    y = load(v, joint + (at.POINT_AY if frame.kind == TARGET else at.ANCHOR_AY))
    if frame.kind == MOTOR:
        x = x + load(v, joint + at.POINT_AX)
        y = y + load(v, joint + at.POINT_AY)
    ax, ay = turned(load(v, a + at.COS), load(v, a + at.SIN), x, y)
    x = load(v, joint + at.ANCHOR_BX)
    y = load(v, joint + at.ANCHOR_BY)
    bx, by = turned(load(v, b + at.COS), load(v, b + at.SIN), x, y)
    store(v, frame.place + at.ARM_AX, ax)
    store(v, frame.place + at.ARM_AY, ay)
    store(v, frame.place + at.ARM_BX, bx)
    store(v, frame.place + at.ARM_BY, by)
    store(v, frame.place + at.GAP_X, _gap(v, batch, frame, at.CENTER_X, at.AHEAD_X, ax, bx))
    store(v, frame.place + at.GAP_Y, _gap(v, batch, frame, at.CENTER_Y, at.AHEAD_Y, ay, by))
    turn = load(v, b + at.ANGLE) - load(v, a + at.ANGLE) - load(v, joint + at.REFERENCE_ANGLE)
    store(v, frame.place + at.TURN, turn)


@inlined_kernel
def _gap(v: Floats, batch: Records, frame: Records, center: int, way: int, arm_a: Vector, arm_b: Vector) -> Vector:
    center_a = load(v, batch.seats + frame.seat_a + center)
    center_b = load(v, batch.seats + frame.seat_b + center)
    return gap(center_a, center_b, load(v, frame.seat_a + way), load(v, frame.seat_b + way), arm_a, arm_b)


@kernel
def _find_errors(v: Floats, batch: Records, frame: Records) -> None:
    """Errors of rows 0 to 2, and the place that rows 3 and 4 act on, which these find where errors 3 and 4 would be."""
    kind = frame.kind
    joint = batch.joints + frame.constants
    x = load(v, frame.place + at.GAP_X)
    y = load(v, frame.place + at.GAP_Y)
    error_0 = x
    error_1 = y
    place = load(v, frame.place + at.TURN)
    if kind in (PRISMATIC, WHEEL):
        error_1 = place
        c = load(v, frame.seat_a + at.COS)
        s = load(v, frame.seat_a + at.SIN)
        ux, uy = turned(c, s, load(v, joint + at.AXIS_X), load(v, joint + at.AXIS_Y))
        store(v, frame.place + at.ALONG_X, ux)
        store(v, frame.place + at.ALONG_Y, uy)
        error_0 = ux * y - uy * x
        place = ux * x + uy * y
    elif kind == DISTANCE:
        place, ux, uy = length_and_direction(x, y, 1.0)
        store(v, frame.place + at.ALONG_X, ux)
        store(v, frame.place + at.ALONG_Y, uy)
        error_0 = place - load(v, joint + at.LENGTH)
    elif kind == PULLEY:
        error_0 = _find_pulley_error(v, batch, frame)
    store(v, frame.place + at.ERRORS, error_0)
    store(v, frame.place + at.ERRORS + WIDTH, error_1)
    store(v, frame.place + at.ERRORS + 2 * WIDTH, load(v, frame.place + at.TURN))
    store(v, frame.place + at.PLACE, place)
    store(v, frame.place + at.PLACE + WIDTH, place)
    levered = spread(1.0)
    if kind != MOTOR and kind != FRICTION:  # their gaps are by design, as are those of springs
        ax = load(v, frame.place + at.ARM_AX)
        ay = load(v, frame.place + at.ARM_AY)
        close = is_close(ax, ay, load(v, frame.place + at.ARM_BX), load(v, frame.place + at.ARM_BY), x, y)
        if may_be_sprung(kind):
            close = close | (load(v, joint + at.HERTZ) > 0.0)
        levered = select(close, 1.0, spread(0.0))
    store(v, frame.place + at.LEVERED, levered)


@kernel
def _find_pulley_error(v: Floats, batch: Records, frame: Records) -> Vector:
    """`ALONG` becomes the direction of the rope at a, `GAP` that at b, both away from the wheels."""
    joint = batch.joints + frame.constants
    x, y = _rope(v, batch, frame.seat_a, joint + at.POINT_AX, frame.place + at.ARM_AX)
    length_a, ux, uy = length_and_direction(x, y, 0.0)
    store(v, frame.place + at.ALONG_X, ux)
    store(v, frame.place + at.ALONG_Y, uy)
    x, y = _rope(v, batch, frame.seat_b, joint + at.POINT_BX, frame.place + at.ARM_BX)
    length_b, ux, uy = length_and_direction(x, y, 0.0)
    store(v, frame.place + at.GAP_X, ux)
    store(v, frame.place + at.GAP_Y, uy)
    return length_a + load(v, joint + at.RATIO) * length_b - load(v, joint + at.LENGTH)


@inlined_kernel
def _rope(v: Floats, batch: Records, seat: int, wheel: int, arm: int) -> tuple[Vector, Vector]:
    """From the wheel to the anchor; each y follows its x in memory."""
    x = rope(
        load(v, wheel),
        load(v, batch.seats + seat + at.CENTER_X),
        load(v, seat + at.AHEAD_X),
        load(v, arm),
    )
    y = rope(
        load(v, wheel + WIDTH),
        load(v, batch.seats + seat + at.CENTER_Y),
        load(v, seat + at.AHEAD_Y),
        load(v, arm + WIDTH),
    )
    return x, y


@inlined_kernel
def _coordinate(v: Floats, place: int, kind: int) -> Vector:
    """What a gear couples: the slide of a prismatic joint, the angle of another."""
    return load(v, place + (at.PLACE if kind == PRISMATIC else at.TURN))

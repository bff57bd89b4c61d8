"""The rows of every joint: in which direction each pushes its bodies, and how easily they give way."""

from __future__ import annotations

from sandbox._jit import inlined_kernel, kernel
from sandbox._vectors import WIDTH, Mask, Vector, load, select, spread, store
from sandbox.engine.joints.direct import places as at
from sandbox.engine.joints.direct.records import ALONG_X, ALONG_Y, OF_BODY, TURN, Batches
from sandbox.engine.joints.laws import Jacobian, along, own_stiffness
from sandbox.tables import Floats, Records
from sandbox.world.joint_records import DISTANCE, GEAR, PRISMATIC, PULLEY


@kernel
def fill_rows(d: Batches, batch: Records) -> None:
    """Jacobian, stiffness and present error of all rows of a batch."""
    v = d.memory
    layout = d.layouts[batch.layout]
    for f in range(layout.first_frame, layout.frame_end):
        frame = d.layout_frames[f]
        for r in range(frame.first_row, frame.row_end):
            row = d.equations[r]
            if row.axis == TURN:
                _store(v, row.place + at.JACOBIAN, _about())
            elif row.axis == ALONG_X or row.axis == ALONG_Y:
                _store(v, row.place + at.JACOBIAN, _point(v, frame.place, row.axis))
            elif frame.kind == GEAR:
                _fill_gear(v, batch, frame, row)
            else:
                _store(v, row.place + at.JACOBIAN, _jacobian(v, batch, frame, row.slot))
            store(v, batch.rows + row.kept + at.ERROR, row_error(v, frame, row))
    fill_stiffness(d, batch)


@kernel
def fill_stiffness(d: Batches, batch: Records) -> None:
    """Stiffness of all rows of a batch."""
    v = d.memory
    layout = d.layouts[batch.layout]
    for r in range(layout.first_row, layout.row_end):
        row = d.equations[r]
        if is_of_body(row):
            continue
        inertia_a = load(v, batch.seats + row.seat_1 + at.INVERSE_INERTIA)
        inertia_b = load(v, batch.seats + row.seat_2 + at.INVERSE_INERTIA)
        if row.axis == TURN:
            store(v, batch.rows + row.kept + at.STIFFNESS, inertia_a + inertia_b)
            continue
        mass_a = load(v, batch.seats + row.seat_1 + at.INVERSE_MASS)
        mass_b = load(v, batch.seats + row.seat_2 + at.INVERSE_MASS)
        found = own_stiffness(mass_a, inertia_a, mass_b, inertia_b, _loaded(v, row.place + at.JACOBIAN))
        if row.sides == 4:  # the same body may be on two of them
            for k in range(1, 5):
                for m in range(1, 5):
                    if (k > 2 or m > 2) and _seat(row, k) == _seat(row, m):
                        one = row.place + at.JACOBIAN + (k - 1) * at.SIDE
                        other = row.place + at.JACOBIAN + (m - 1) * at.SIDE
                        found = found + side_product(v, batch, one, other, _seat(row, k))
        store(v, batch.rows + row.kept + at.STIFFNESS, found)


@inlined_kernel
def is_of_body(row: Records) -> bool:
    """Whether a row is the velocity of a body that stays in the system."""
    return bool(row.augmented == OF_BODY)


@inlined_kernel
def row_error(v: Floats, frame: Records, row: Records) -> Vector:
    """Error of a row at the pose its joint was measured at; for springs, limits and motors the place."""
    return load(v, frame.place + at.ERRORS + row.slot * WIDTH)


@inlined_kernel
def counts_radians(frame: Records, row: Records) -> bool:
    """Whether the error of a row is an angle: that of a gear is in what its first joint counts."""
    return bool(row.axis == TURN or (frame.kind == GEAR and frame.kind_1 != PRISMATIC))


@inlined_kernel
def units_of(d: Batches, frame: Records, row: Records) -> float:
    """In how many of its units a row counts a metre; 1 where it counts radians."""
    return 1.0 if counts_radians(frame, row) else float(d.units[0])


@inlined_kernel
def _loaded(v: Floats, place: int) -> Jacobian:
    return (
        load(v, place),
        load(v, place + 1 * WIDTH),
        load(v, place + 2 * WIDTH),
        load(v, place + 3 * WIDTH),
        load(v, place + 4 * WIDTH),
        load(v, place + 5 * WIDTH),
    )


@inlined_kernel
def _store(v: Floats, place: int, j: Jacobian) -> None:
    store(v, place, j[0])
    store(v, place + 1 * WIDTH, j[1])
    store(v, place + 2 * WIDTH, j[2])
    store(v, place + 3 * WIDTH, j[3])
    store(v, place + 4 * WIDTH, j[4])
    store(v, place + 5 * WIDTH, j[5])


@inlined_kernel
def _point(v: Floats, f: int, axis: int) -> Jacobian:
    """Way of the second anchor of a joint against the first along x or y, as `along` has it; where the anchors are
    apart by more than a lever, each body is pushed at its own."""
    together = load(v, f + at.LEVERED) != 0.0
    one = spread(1.0)
    none = spread(0.0)
    if axis == ALONG_X:
        arm = load(v, f + at.ARM_AY)
        return -one, none, select(together, arm + load(v, f + at.GAP_Y), arm), one, none, -load(v, f + at.ARM_BY)
    arm = load(v, f + at.ARM_AX)
    return none, -one, -select(together, arm + load(v, f + at.GAP_X), arm), none, one, load(v, f + at.ARM_BX)


@kernel
def _jacobian(v: Floats, batch: Records, frame: Records, slot: int) -> Jacobian:
    """Of what slides, a rod or a pulley."""
    if frame.kind == PULLEY:
        return _pulley(v, batch, frame)
    f = frame.place
    ax = load(v, f + at.ARM_AX)
    ay = load(v, f + at.ARM_AY)
    bx = load(v, f + at.ARM_BX)
    by = load(v, f + at.ARM_BY)
    x = load(v, f + at.ALONG_X)
    y = load(v, f + at.ALONG_Y)
    if slot == 0 and frame.kind != DISTANCE:  # across the slide
        turned_x = -y
        y = x
        x = turned_x
    return along(ax, ay, bx, by, load(v, f + at.GAP_X), load(v, f + at.GAP_Y), x, y)


@inlined_kernel
def _about() -> Jacobian:
    """Angle between the bodies."""
    none = spread(0.0)
    return none, none, spread(-1.0), none, none, spread(1.0)


@inlined_kernel
def _pulley(v: Floats, batch: Records, frame: Records) -> Jacobian:
    f = frame.place
    ratio = load(v, batch.joints + frame.constants + at.RATIO)
    ax = load(v, f + at.ALONG_X)
    ay = load(v, f + at.ALONG_Y)
    bx = ratio * load(v, f + at.GAP_X)
    by = ratio * load(v, f + at.GAP_Y)
    turn_a = load(v, f + at.ARM_AX) * ay - load(v, f + at.ARM_AY) * ax
    turn_b = load(v, f + at.ARM_BX) * by - load(v, f + at.ARM_BY) * bx
    return ax, ay, turn_a, bx, by, turn_b


@kernel
def _fill_gear(v: Floats, batch: Records, frame: Records, row: Records) -> None:
    """The first joint's coordinate goes to sides 1 and 2, the second one's to sides 3 and 4."""
    ratio = load(v, batch.joints + frame.constants + at.RATIO)
    first = _coordinate(v, frame.coordinate_1, frame.kind_1)
    second = _coordinate(v, frame.coordinate_2, frame.kind_2)
    _store(v, row.place + at.JACOBIAN, first)
    scaled = (
        ratio * second[0],
        ratio * second[1],
        ratio * second[2],
        ratio * second[3],
        ratio * second[4],
        ratio * second[5],
    )
    _store(v, row.place + at.JACOBIAN + 2 * at.SIDE, scaled)


@kernel
def _coordinate(v: Floats, f: int, kind: int) -> Jacobian:
    if kind != PRISMATIC:
        return _about()
    ax = load(v, f + at.ARM_AX)
    ay = load(v, f + at.ARM_AY)
    bx = load(v, f + at.ARM_BX)
    by = load(v, f + at.ARM_BY)
    x = load(v, f + at.ALONG_X)
    y = load(v, f + at.ALONG_Y)
    return along(ax, ay, bx, by, load(v, f + at.GAP_X), load(v, f + at.GAP_Y), x, y)


@kernel
def _seat(row: Records, k: int) -> int:
    if k <= 2:
        return int(row.seat_1 if k == 1 else row.seat_2)
    return int(row.seat_3 if k == 3 else row.seat_4)


@inlined_kernel
def side_product(v: Floats, batch: Records, one: int, other: int, seat: int) -> Vector:
    """What one body, on a side of a row and on a side of another, adds to their J M^-1 J^T."""
    x = load(v, one)
    y = load(v, one + WIDTH)
    w = load(v, one + 2 * WIDTH)
    mass = load(v, batch.seats + seat + at.INVERSE_MASS)
    inertia = load(v, batch.seats + seat + at.INVERSE_INERTIA)
    linear = x * load(v, other) + y * load(v, other + WIDTH)
    return mass * linear + inertia * (w * load(v, other + 2 * WIDTH))


@inlined_kernel
def row_speed(v: Floats, row: Records) -> Vector:
    """Speed of the bodies along a row, J v."""
    j = row.place + at.JACOBIAN
    a = row.seat_1
    b = row.seat_2
    if row.axis == TURN:
        return load(v, b + at.VELOCITY_W) - load(v, a + at.VELOCITY_W)
    if row.axis == ALONG_X or row.axis == ALONG_Y:
        way = at.VELOCITY_X if row.axis == ALONG_X else at.VELOCITY_Y
        speed = load(v, j + 2 * WIDTH) * load(v, a + at.VELOCITY_W) - load(v, a + way)
        return speed + load(v, b + way) + load(v, j + at.SIDE + 2 * WIDTH) * load(v, b + at.VELOCITY_W)
    speed = _side_speed(v, j, a) + load(v, j + at.SIDE) * load(v, b + at.VELOCITY_X)
    speed = speed + load(v, j + at.SIDE + WIDTH) * load(v, b + at.VELOCITY_Y)
    speed = speed + load(v, j + at.SIDE + 2 * WIDTH) * load(v, b + at.VELOCITY_W)
    if row.sides == 4:
        for k in range(2, 4):
            side = j + k * at.SIDE
            seat = row.seat_3 if k == 2 else row.seat_4
            speed = speed + load(v, side) * load(v, seat + at.VELOCITY_X)
            speed = speed + load(v, side + WIDTH) * load(v, seat + at.VELOCITY_Y)
            speed = speed + load(v, side + 2 * WIDTH) * load(v, seat + at.VELOCITY_W)
    return speed


@inlined_kernel
def _side_speed(v: Floats, side: int, seat: int) -> Vector:
    speed = load(v, side) * load(v, seat + at.VELOCITY_X)
    speed = speed + load(v, side + WIDTH) * load(v, seat + at.VELOCITY_Y)
    return speed + load(v, side + 2 * WIDTH) * load(v, seat + at.VELOCITY_W)


@kernel
def change_impulse(v: Floats, batch: Records, row: Records, change: Vector, impulse: int, who: Mask) -> None:
    """Add to a row's impulse, which is its field `impulse`, and to the velocities of its bodies, where `who` says. The
    rows of a body change nothing: what changes its velocity are its joints."""
    batch.foreseen = 0
    kept = batch.rows + row.kept + impulse
    before = load(v, kept)
    store(v, kept, select(who, before + change, before))
    j = row.place + at.JACOBIAN
    if row.axis == TURN:
        _turn(v, batch, row.seat_1, -change, who)
        _turn(v, batch, row.seat_2, change, who)
        return
    if row.axis == ALONG_X or row.axis == ALONG_Y:
        way = at.VELOCITY_X if row.axis == ALONG_X else at.VELOCITY_Y
        _shift(v, batch, row.seat_1, way, -change, who)
        _turn(v, batch, row.seat_1, load(v, j + 2 * WIDTH) * change, who)
        _shift(v, batch, row.seat_2, way, change, who)
        _turn(v, batch, row.seat_2, load(v, j + at.SIDE + 2 * WIDTH) * change, who)
        return
    if is_of_body(row):
        return
    _push(v, batch, row.seat_1, j, change, who)
    _push(v, batch, row.seat_2, j + at.SIDE, change, who)
    if row.sides == 4:
        _push(v, batch, row.seat_3, j + 2 * at.SIDE, change, who)
        _push(v, batch, row.seat_4, j + 3 * at.SIDE, change, who)


@inlined_kernel
def _push(v: Floats, batch: Records, seat: int, side: int, impulse: Vector, who: Mask) -> None:
    mass = load(v, batch.seats + seat + at.INVERSE_MASS)
    inertia = load(v, batch.seats + seat + at.INVERSE_INERTIA)
    x = load(v, seat + at.VELOCITY_X)
    y = load(v, seat + at.VELOCITY_Y)
    w = load(v, seat + at.VELOCITY_W)
    store(v, seat + at.VELOCITY_X, select(who, x + mass * (load(v, side) * impulse), x))
    store(v, seat + at.VELOCITY_Y, select(who, y + mass * (load(v, side + WIDTH) * impulse), y))
    store(v, seat + at.VELOCITY_W, select(who, w + inertia * (load(v, side + 2 * WIDTH) * impulse), w))


@inlined_kernel
def _shift(v: Floats, batch: Records, seat: int, way: int, impulse: Vector, who: Mask) -> None:
    """Push a body along x or y, of which `way` is its velocity."""
    speed = load(v, seat + way)
    store(v, seat + way, select(who, speed + load(v, batch.seats + seat + at.INVERSE_MASS) * impulse, speed))


@inlined_kernel
def _turn(v: Floats, batch: Records, seat: int, impulse: Vector, who: Mask) -> None:
    """Turn a body."""
    w = load(v, seat + at.VELOCITY_W)
    inertia = load(v, batch.seats + seat + at.INVERSE_INERTIA)
    store(v, seat + at.VELOCITY_W, select(who, w + inertia * impulse, w))

"""The stage before all others, in worlds that have fields: add up what pushes each body during the step.

Forces are taken once a step, at the pose that a body has in mid-step if nothing hinders it. As free bodies move by the
mean of their velocities, this is the leapfrog method (drift, kick, drift): second order, symplectic, so that orbits
and bobbing boats neither gain nor lose energy, and as good as one evaluation a substep would be for all that turns
less than a radian a step.
"""

from __future__ import annotations

from sandbox._jit import entry_point, kernel
from sandbox.engine.fields.drag import drag_force
from sandbox.engine.fields.gravity import change_gravity
from sandbox.engine.fields.records import BITS, Fields
from sandbox.engine.fields.strips import lay_strips, look_up, lowest_bit
from sandbox.engine.fields.thrust import thrust
from sandbox.engine.fields.wake import wake_switched
from sandbox.engine.fields.water import lift
from sandbox.engine.fields.wind import blow
from sandbox.engine.records.active_set import ActiveSet
from sandbox.engine.records.state import StateTables
from sandbox.geometry.trig import cos_sin
from sandbox.tables import Records
from sandbox.world.field_records import ATTRACTION, GRAVITY, WATER, WIND
from sandbox.world.records import DYNAMIC

STILL = 0.002
"""A body floats at rest when weight and lift are equal to this share of the weight."""


@entry_point
def apply_fields(
    state: StateTables,
    old_contacts: Records,
    joint_table: Records,
    active: ActiveSet,
    free_motions: Records,
    fields: Fields,
) -> None:
    """Add the forces of all fields to those of the coming step; wake whom a field begins to push."""
    bodies = state.bodies
    setting = state.settings[0]
    counter = state.counters[0]
    step = counter.step_count
    pushes = fields.pushes
    wake_switched(bodies, fields, active, step)
    _begin(bodies, pushes, setting)
    _mark_held(pushes, old_contacts, counter.contact_count, joint_table)
    _apply_regions(state, fields, step)
    thrust(fields.thrusters, pushes, step)
    _finish(bodies, pushes, free_motions, setting)


@kernel
def _begin(bodies: Records, pushes: Records, setting: Records) -> None:
    half = 0.5 * setting.step_seconds
    for i in range(bodies.shape[0]):
        body = bodies[i]
        push = pushes[i]
        push.active = 1 if body.type == DYNAMIC and body.awake == 1 else 0
        push.held = push.wet = 0
        if push.active == 0:
            continue
        push.x = body.center_x + half * body.velocity_x
        push.y = body.center_y + half * body.velocity_y
        push.cos, push.sin = cos_sin(body.angle + half * body.angular_velocity)
        push.gravity_x = setting.gravity_x
        push.gravity_y = setting.gravity_y
        push.force_x = push.force_y = push.torque = 0.0
        push.drag_xx = push.drag_xy = push.drag_yy = push.drag_xw = push.drag_yw = push.drag_ww = 0.0
        push.carry_x = push.carry_y = push.carry_w = 0.0


@kernel
def _apply_regions(state: StateTables, fields: Fields, step: int) -> None:
    """What each region does to each body that may be in it, in the order of the regions."""
    shapes, pushes = state.shapes, fields.pushes
    if fields.regions.shape[0] == 0:
        return
    lay_strips(fields, step)
    end = 0
    for i in range(state.bodies.shape[0]):
        first = end
        while end < shapes.shape[0] and shapes[end].body == i:
            end += 1
        if pushes[i].active == 1:
            look_up(fields, pushes[i], state.bodies[i].extent)
            _change_gravity(fields, pushes[i])
            _press(state, fields, first, end)


@kernel
def _change_gravity(fields: Fields, push: Records) -> None:
    """Let the regions found change the gravity of a body."""
    for word in range(fields.axes[0].words):
        bits = fields.found[word]
        while bits != 0:
            region = fields.regions[BITS * word + lowest_bit(bits)]
            if GRAVITY <= region.kind <= ATTRACTION:
                change_gravity(region, fields.edges, push)
            bits &= bits - 1


@kernel
def _press(state: StateTables, fields: Fields, first: int, end: int) -> None:
    """Let the regions found press on the shapes of a body, those from `first` to before `end`."""
    for word in range(fields.axes[0].words):
        bits = fields.found[word]
        while bits != 0:
            region = fields.regions[BITS * word + lowest_bit(bits)]
            for k in range(first, end if region.kind == WIND else first):
                blow(region, fields, state.bodies, state.shapes[k], state.vertices)
            for k in range(first, end if region.kind == WATER else first):
                lift(region, fields, state.bodies, state.shapes[k], state.vertices)
            bits &= bits - 1


@kernel
def _mark_held(pushes: Records, contacts: Records, count: int, joints: Records) -> None:
    """What touches something or hangs from it will not gain the speed that forces alone would give it."""
    for k in range(count):
        if contacts[k].normal_impulse1 > 0.0 or contacts[k].normal_impulse2 > 0.0:
            pushes[contacts[k].body_a].held = 1
            pushes[contacts[k].body_b].held = 1
    for k in range(joints.shape[0]):
        if joints[k].enabled == 1 and joints[k].broken_step < 0:
            if joints[k].body_a >= 0:
                pushes[joints[k].body_a].held = 1
            if joints[k].body_b >= 0:
                pushes[joints[k].body_b].held = 1


@kernel
def _finish(bodies: Records, pushes: Records, free_motions: Records, setting: Records) -> None:
    h = setting.step_seconds
    for i in range(bodies.shape[0]):
        body = bodies[i]
        push = pushes[i]
        free_motions[i].buoyed = 0
        if push.active == 0:
            continue
        scale = body.mass * body.gravity_scale
        fx = push.force_x + scale * (push.gravity_x - setting.gravity_x)
        fy = push.force_y + scale * (push.gravity_y - setting.gravity_y)
        ax = body.gravity_scale * setting.gravity_x + body.inverse_mass * (body.force_x + fx)
        ay = body.gravity_scale * setting.gravity_y + body.inverse_mass * (body.force_y + fy)
        free_motions[i].buoyed = push.wet if _balanced(ax, ay, push) else 0
        ahead = 0.0 if push.held == 1 else h
        dx, dy, turn = drag_force(
            push,
            body,
            body.velocity_x + ahead * ax,
            body.velocity_y + ahead * ay,
            body.angular_velocity + ahead * body.inverse_inertia * (body.torque + push.torque),
            h,
        )
        body.force_x += fx + dx
        body.force_y += fy + dy
        body.torque += push.torque + turn


@kernel
def _balanced(ax: float, ay: float, push: Records) -> bool:
    square = push.gravity_x * push.gravity_x + push.gravity_y * push.gravity_y
    return bool(ax * ax + ay * ay <= STILL * STILL * square)

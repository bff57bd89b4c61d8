"""Who wakes because of a field. Fields do not change while they act, so nobody needs to but when one begins or ends."""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.active.sleeping_islands import touch_row, wake_marked_islands
from sandbox.engine.fields.area import OUTSIDE, place
from sandbox.engine.fields.records import Fields
from sandbox.engine.records.active_set import ActiveSet
from sandbox.tables import Records
from sandbox.world.records import DYNAMIC


@kernel
def wake_switched(bodies: Records, fields: Fields, active: ActiveSet, step: int) -> None:
    """Wake the islands of all bodies that a region or a thruster begins or ceases to push in this step."""
    regions = fields.regions
    thrusters = fields.thrusters
    found = False
    for k in range(thrusters.shape[0]):
        body = bodies[thrusters[k].body]
        if _switches(thrusters[k], step) and body.type == DYNAMIC and body.awake == 0:
            body.awake = 1
            touch_row(active, thrusters[k].body)
            found = True
    for k in range(regions.shape[0]):
        if not _switches(regions[k], step):
            continue
        for i in range(bodies.shape[0]):
            body = bodies[i]
            if body.type != DYNAMIC or body.awake == 1:
                continue
            if place(regions[k], fields.edges, body.center_x, body.center_y, body.extent) != OUTSIDE:
                body.awake = 1
                touch_row(active, i)
                found = True
    if found:
        wake_marked_islands(bodies, active)


@kernel
def _switches(field: Records, step: int) -> bool:
    return bool(field.start_step == step or field.end_step == step)

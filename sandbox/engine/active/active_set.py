"""Who may move in a step. Most bodies of a large world rest: the stages go through lists of those that do not."""

from __future__ import annotations

from sandbox._jit import ZERO, kernel
from sandbox.engine.active.body_flags import disturbs, is_active
from sandbox.tables import Field, Integers, Records, Table
from sandbox.world.records import DYNAMIC

CENSUS = Table(
    "census",
    (
        Field("stale", "-", "1 when somebody may have woken, slept, come or changed since the lists were made", "i8"),
        Field("asleep", "-", "dynamic bodies that slept when they were made", "i8"),
        Field("era", "-", "counts how often they were made", "i8"),
        Field("laid", "-", "its value when the grid was parted", "i8"),
        Field("moving", "-", "shapes of bodies that may move", "i8"),
        Field("parted", "-", "1 when resting shapes have a grid of their own, see `parted`", "i8"),
        Field("cell", "m", "width of the cells of its level 0"),
        Field("used", "-", "its levels with many boxes", "i8"),
        Field("sparse", "-", "its boxes on other levels", "i8"),
        Field("woke", "-", "1 when the step under way has woken somebody", "i8"),
    ),
)
"""One row: what is known of the lists."""

NOT_MOVED = -1
"""In the place of a body's colours. No set of colours is that: there are less than 63."""

STIRS, SLEEPS = 1, 2
"""What `stirs` says of a body that a step may move, and of one that sleeps. 0 is for those that stay where they are."""


def new_census() -> Records:
    """One that knows nothing yet."""
    census = CENSUS.zeros(1)
    census.stale = 1
    return census


@kernel
def take_census(
    bodies: Records,
    census: Records,
    movers: Integers,
    stirs: Integers,
    motions: Records,
    flights: Records,
    pulls: Records,
    marks: Integers,
    palettes: Integers,
    holds: Records,
) -> bool:
    """List the bodies that a step may move in `movers[1:]`, ascending; `movers[0]` is how many those are.

    `stirs` tells them from the others, which are laid to rest in the scratch memory: the stages do not look after
    them. Nothing is done as long as nobody has woken, fallen asleep, or been changed by a command: returns whether.
    """
    if census[0].stale == 0:
        return False
    count = ZERO
    asleep = ZERO
    posed = ZERO
    for i in range(bodies.shape[0]):
        body = bodies[i]
        posed |= body.posed
        stirs[i] = STIRS if disturbs(body) else 0
        if stirs[i] == STIRS:
            count += 1
            movers[count] = i
            continue
        if body.type == DYNAMIC:
            stirs[i] = SLEEPS
            asleep += 1
            body.stirred = body.was_asleep - 1
            body.was_asleep = 1
        _lay_to_rest(body, motions[i], flights[i])
        pulls[i].moves = 0
        marks[i] = 0
        palettes[i] = NOT_MOVED
        hold = holds[i]
        hold.deep = hold.fresh = hold.fast = hold.hemmed = 0
    movers[0] = count
    census[0].asleep = asleep
    census[0].era += 1
    census[0].stale = posed  # who was put somewhere stirs for one step
    return True


@kernel
def _lay_to_rest(body: Records, motion: Records, flight: Records) -> None:
    motion.velocity_x = flight.start_x = flight.free_x = body.velocity_x
    motion.velocity_y = flight.start_y = flight.free_y = body.velocity_y
    motion.angular_velocity = flight.start_w = flight.free_w = body.angular_velocity
    motion.delta_x = motion.delta_y = motion.delta_angle = motion.delta_sin = 0.0
    motion.delta_cos = 1.0
    flight.pace = 0


@kernel
def list_live(bodies: Records, contacts: Records, count: int, live: Integers, strikers: Integers) -> None:
    """List the contacts with an active body in `live[1:]`, and those of them that may strike in `strikers[1:]`.

    Item 0 is how many. The narrow phase has made these lists; they are made anew after somebody has woken.
    """
    live[0] = 0
    strikers[0] = 0
    for i in range(count):
        if is_active(bodies[contacts[i].body_a]) or is_active(bodies[contacts[i].body_b]):
            list_contact(contacts[i], i, True, live, strikers)


@kernel
def list_contact(contact: Records, row: int, hard: bool, live: Integers, strikers: Integers) -> None:
    """List one contact that the solver will look at.

    It may strike if it has restitution, or at two points if it may close in `hard`.
    """
    live[0] += 1
    live[live[0]] = row
    if contact.restitution > 0.0 or (hard and contact.point_count == 2):
        strikers[0] += 1
        strikers[strikers[0]] = row

"""Islands, some at a time, and the memory in which they are solved."""

from __future__ import annotations

from typing import NamedTuple

from sandbox.engine.contact_solver.blocks import ALL_COLORS, LANES
from sandbox.tables import Field, Floats, Integers, Records, Table

SIZE = 2048
"""Bodies and contacts of a batch: contacts take 352 bytes each, so that it has 0.7 MB at most."""
BLOCKS = SIZE // LANES + ALL_COLORS
"""That many contacts fill no more blocks: every colour has one that is not full, settled or not."""

STRUCK_BODY = Table(
    "struck_body",
    (
        Field("body", "-", "its row", "i8"),
        Field("last_x", "m/s", "velocity after the pass before"),
        Field("last_y", "m/s", "velocity after the pass before"),
        Field("last_w", "rad/s", "velocity after the pass before"),
    ),
)
"""One row a body whose contacts are solved together."""

IMPACT = Table(
    "impact",
    (
        Field("group", "-", "the lowest body of those with which it strikes together; -1 before it has struck", "i4"),
        Field("next", "-", "the next contact that strikes together with it; -1: none", "i4"),
        Field("passes", "-", "that its groups have taken in the step", "i8"),
        Field("moment", "s", "when it closes, from the beginning of the substep; looking back, from its end"),
        Field("impulse", "N s", "of the contact before the impacts of the substep"),
        Field("rebound1", "m/s", "speed at which point 1 is to open, see `restitution/rebound_speed.py`"),
        Field("rebound2", "m/s", "the same at point 2"),
        Field("load1", "N s", "normal impulse at point 1 of what strikes together"),
        Field("load2", "N s", "the same at point 2"),
        Field("last1", "N s", "normal impulse at point 1 after the pass before"),
        Field("last2", "N s", "the same at point 2"),
        Field("mass", "kg", "effective mass at point 1"),
        Field("drag", "N s", "friction impulse of what strikes together"),
        Field("last_drag", "N s", "the same after the pass before"),
        Field("lever_a", "m", "how far the tangent passes by the centre of a, where the contact rubs"),
        Field("lever_b", "m", "the same of b"),
        Field("rub_mass", "kg", "effective mass along the tangent there"),
        Field("slides", "-", "the sign of the slip of what slides back after a while; 0: friction may hold it"),
        Field("opening1", "m/s", "of jointed bodies: speed at which point 1 opens by loads and friction"),
        Field("opening2", "m/s", "the same at point 2"),
        Field("slip", "m/s", "the same along the tangent"),
    ),
)
"""One row for each contact with restitution that may have an impact: what its impacts in a substep need."""


IMPACT_SLOT = Table(
    "impact_slot",
    (
        Field("contact", "-", "row in the contact table", "i4"),
        Field("body_a", "-", "", "i4"),
        Field("body_b", "-", "", "i4"),
        Field("next_a", "-", "the next contact of body a in the list; -1: none", "i4"),
        Field("next_b", "-", "the same of body b", "i4"),
        Field("following", "-", "the next one in the worklist; -1: none, -2: it is not in it", "i4"),
        Field("strikes", "-", "how often it has struck in the substep", "i4"),
        Field("turn", "-", "in which it closes and has not struck yet", "i4"),
    ),
)
"""The same contacts, and where they are in the worklist, see `restitution/worklist.py`: two rows a cache line."""


class Batches(NamedTuple):
    """The batches that the islands of a substep level fall into, see `active.island_batches`.

    `size[0]` is how many bodies and contacts one has at most. `bodies` has the bodies of batch n from `first_body[n]`
    to before `first_body[n + 1]`; `struck` has as many rows for each, filled by those that take part in an inelastic
    impact. `impact_slots` has the contacts that may have an impact, by `first_impact`, and `impacts` what else they
    need. `blocks`, `lanes` and `starts` are what `ContactBlocks` has, for each worker but the first.
    """

    size: Integers
    bodies: Integers
    struck: Records
    first_body: Integers
    impacts: Records
    impact_slots: Records
    first_impact: Integers
    blocks: Records
    lanes: Floats
    starts: Integers

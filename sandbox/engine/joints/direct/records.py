"""How factorised parts lie in memory: layouts, which parts share, and batches of up to four parts of one layout.

The numbers themselves are in one array, see `places`.
"""

from __future__ import annotations

from typing import NamedTuple

from sandbox.tables import Field, Floats, Integers, Records, Table

LEVELS = 5
"""Substep levels of islands, 0 to 4."""

ANY_AXIS = 0
"""`axis` of a row whose Jacobian may have any number."""
ALONG_X = 1
"""One that keeps two points together along x: it pushes the second body by 1 along x, the first by -1."""
ALONG_Y = 2
"""The same along y."""
TURN = 3
"""One that acts on the angle between its bodies alone."""
ANY_PRODUCT = 2
"""`linear` of a product that is not known before its rows are."""

LAYOUT = Table(
    "layout",
    (
        Field("seats", "-", "bodies of a part: first those that joints move, then one for each fixed side", "i8"),
        Field("moving", "-", "how many of them joints move", "i8"),
        Field("first_frame", "-", "", "i8"),
        Field("frame_end", "-", "", "i8"),
        Field("first_row", "-", "", "i8"),
        Field("row_end", "-", "", "i8"),
        Field("joints", "-", "", "i8"),
        Field("bounded", "-", "1 when some row may have bounds", "i8"),
        Field("hinged", "-", "1 when all joints are hinges and welds: only that bodies turn is not linear", "i8"),
        Field("staggers", "-", "1 when its parts may take the leapfrog, see `stagger`", "i8"),
    ),
)

FRAME = Table(
    "frame",
    (
        Field("kind", "-", "as in the joint table", "i8"),
        Field("seat_a", "-", "place of its first body in the batch's memory", "i8"),
        Field("seat_b", "-", "", "i8"),
        Field("slot_a", "-", "the same bodies as numbers of seats", "i8"),
        Field("slot_b", "-", "", "i8"),
        Field("place", "-", "in the working memory", "i8"),
        Field("constants", "-", "place in the batch's memory of joints", "i8"),
        Field("joint", "-", "which of the part's joints it is, in the order of elimination", "i8"),
        Field("coupled", "-", "1 or 2: not that joint, a gear, but the first or second one that it couples", "i8"),
        Field("coordinate_1", "-", "gear: places of the two frames that it couples; others: its own", "i8"),
        Field("coordinate_2", "-", "", "i8"),
        Field("kind_1", "-", "gear: their kinds", "i8"),
        Field("kind_2", "-", "", "i8"),
        Field("limit", "-", "1 when it has limits", "i8"),
        Field("motor", "-", "1 when it has a motor", "i8"),
        Field("first_row", "-", "", "i8"),
        Field("row_end", "-", "", "i8"),
    ),
)
"""The joints of a layout, in the order of elimination; after a gear come two more, of the joints that it couples."""

EQUATION = Table(
    "equation",
    (
        Field("slot", "-", "0 to 2: what the kind keeps; 3: its spring; 4: its limit and motor", "i8"),
        Field("sides", "-", "members it acts on: 2, or 4 for a gear", "i8"),
        Field("axis", "-", "what is known of its Jacobian for good: `ANY_AXIS`, `ALONG_X`, `ALONG_Y` or `TURN`", "i8"),
        *(Field(f"seat_{k}", "-", "place of the body in the batch's memory", "i8") for k in (1, 2, 3, 4)),
        Field("bounded", "-", "1 when its impulse may have bounds, 0 when it gives whatever is asked for", "i8"),
        Field("kept", "-", "place of what lasts of it in the batch's memory", "i8"),
        Field("place", "-", "in the working memory", "i8"),
        Field("shares", "-", "1 when the next row acts on the same coordinate and has no equation of its own", "i8"),
        Field("first_entry", "-", "its column of the factor, from the diagonal down; nothing where it has none", "i8"),
        Field("entry_end", "-", "", "i8"),
        Field("first_target", "-", "", "i8"),
        Field("paired", "-", "1 when it is eliminated together with the next one, which is of the same joint", "i8"),
    ),
)
"""The rows of a layout."""

ENTRY = Table(
    "entry",
    (
        Field("place", "-", "in the factor", "i8"),
        Field("total", "-", "where the sum of its products is kept", "i8"),
        Field("other", "-", "place of the row below the diagonal", "i8"),
        Field("first_product", "-", "", "i8"),
        Field("product_end", "-", "", "i8"),
    ),
)

PRODUCT = Table(
    "product",
    (
        Field("one", "-", "place of the Jacobian of one row at a body", "i8"),
        Field("other", "-", "place of that of the other row at the same body", "i8"),
        Field("seat", "-", "place of the body", "i8"),
        Field("linear", "-", "product of what both do to its velocity: -1, 0, 1 or `ANY_PRODUCT`", "i8"),
    ),
)

BATCH = Table(
    "batch",
    (
        Field("layout", "-", "", "i8"),
        Field("level", "-", "substep level of its islands", "i8"),
        Field("count", "-", "parts in it, 1 to 4", "i8"),
        Field("lanes", "-", "where in the memory that begins which is known of its parts", "i8"),
        Field("seats", "-", "where its bodies begin", "i8"),
        Field("joints", "-", "where its joints begin", "i8"),
        Field("rows", "-", "where its rows begin", "i8"),
        Field("bodies", "-", "where its bodies are named", "i8"),
        Field("staggered", "-", "1 when its parts take the leapfrog", "i8"),
        Field("between", "-", "1 while their velocities are those of the middle of a substep", "i8"),
        Field("redundant", "-", "1 when a row of the last factor says what others say, in some lane", "i8"),
        Field("foreseen", "-", "1 while its joints are measured where their present velocities lead", "i8"),
    ),
)


class Batches(NamedTuple):
    """The arrays of factorised parts.

    Of layouts: `targets` are the entries from which the elimination of a row subtracts, in its order. `fixed` are the
    bodies on the fixed sides, part after part. Of batches: `found` is how many there are, where memory and names of
    bodies in use end, and where the memory of the first begins; `level` is the substep level under way, and whether the
    substep is the last one; `open` the batch that takes the next part of each layout and level, staggered or not;
    `parts` says which part lies in each lane, `bodies` who has each seat, in each lane. `memory` has a working place
    for each worker first: poses, frames, rows, factor, sums of products; then the batches. `found` ends with the size
    of a working place. Places in it count from where it begins; so do those in `own`, the batch that each worker is at.
    """

    layouts: Records
    layout_frames: Records
    equations: Records
    entries: Records
    products: Records
    targets: Integers
    fixed: Integers
    batches: Records
    own: Records
    found: Integers
    level: Integers
    open: Integers
    parts: Integers
    bodies: Integers
    memory: Floats

"""How factorised parts lie in memory: layouts, which parts share, and batches of up to four parts of one layout.

The numbers themselves are in one array, see `places`.
"""

from __future__ import annotations

from typing import NamedTuple

from sandbox.tables import Field, Floats, Integers, Integers32, Records, Table

MOST_STRUCK = 32
"""Contacts of a group of impacts that joints pass on: larger ones, as of a paddle that stirs thousands of balls, are
left to what joints take of them."""
LEVELS = 5
"""Substep levels of islands, 0 to 4."""

SUBSTEP_LEVEL, IS_LAST, PASSED_THROUGH, HAS_MATRIX = 0, 1, 2, 3
"""What `Batches.level` holds: the substep level under way; 1 in its last substep; through how many parts impacts of the
substep were passed on; 1 while `Batches.delassus` is the matrix of the group of impacts under way."""

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
OF_JACOBIAN, OF_MASS, OF_INERTIA = 3, 4, 5
"""`linear` of what is no product: what a row does to a body that stays in the system, and less its mass or inertia."""
OF_BODY = 2
"""`augmented` of a row that is the velocity of a body that stays in the system: it has no law, and no impulse."""

BODY = -1
"""In the place of a joint's kind: a body that stays in the system, whose rows are its velocity, see `augmented`."""

LAYOUT = Table(
    "layout",
    (
        Field("seats", "-", "bodies of a part: first those that joints move, then one for each fixed side", "i4"),
        Field("moving", "-", "how many of them joints move", "i4"),
        Field("first_frame", "-", "", "i4"),
        Field("frame_end", "-", "", "i4"),
        Field("first_row", "-", "", "i4"),
        Field("row_end", "-", "", "i4"),
        Field("joints", "-", "", "i4"),
        Field("bounded", "-", "1 when some row may have bounds", "i4"),
        Field("hinged", "-", "1 when all joints are hinges and welds: only that bodies turn is not linear", "i4"),
        Field("staggers", "-", "1 when its parts may take the leapfrog, see `stagger`", "i4"),
    ),
)

FRAME = Table(
    "frame",
    (
        Field("kind", "-", "as in the joint table", "i4"),
        Field("seat_a", "-", "place of its first body in the batch's memory", "i4"),
        Field("seat_b", "-", "", "i4"),
        Field("slot_a", "-", "the same bodies as numbers of seats", "i4"),
        Field("slot_b", "-", "", "i4"),
        Field("place", "-", "in the working memory", "i4"),
        Field("constants", "-", "place in the batch's memory of joints", "i4"),
        Field("joint", "-", "which of the part's joints it is, in the order of elimination", "i4"),
        Field("coupled", "-", "1 or 2: not that joint, a gear, but the first or second one that it couples", "i4"),
        Field("coordinate_1", "-", "gear: places of the two frames that it couples; others: its own", "i4"),
        Field("coordinate_2", "-", "", "i4"),
        Field("kind_1", "-", "gear: their kinds", "i4"),
        Field("kind_2", "-", "", "i4"),
        Field("limit", "-", "1 when it has limits", "i4"),
        Field("motor", "-", "1 when it has a motor", "i4"),
        Field("first_row", "-", "", "i4"),
        Field("row_end", "-", "", "i4"),
    ),
)
"""The joints of a layout, in the order of elimination; after a gear come two more, of the joints that it couples."""

EQUATION = Table(
    "equation",
    (
        Field("slot", "-", "0 to 2: what the kind keeps; 3: its spring; 4: its limit and motor", "i4"),
        Field("sides", "-", "members it acts on: 2, or 4 for a gear", "i4"),
        Field("axis", "-", "what is known of its Jacobian for good: `ANY_AXIS`, `ALONG_X`, `ALONG_Y` or `TURN`", "i4"),
        *(Field(f"seat_{k}", "-", "place of the body in the batch's memory", "i4") for k in (1, 2, 3, 4)),
        Field("bounded", "-", "1 when its impulse may have bounds, 0 when it gives whatever is asked for", "i4"),
        Field("kept", "-", "place of what lasts of it in the batch's memory", "i4"),
        Field("place", "-", "in the working memory", "i4"),
        Field(
            "augmented",
            "-",
            "1 when it acts on a body that stays in the system and on another one; 2: its velocity",
            "i4",
        ),
        Field("shares", "-", "1 when the next row acts on the same coordinate and has no equation of its own", "i4"),
        Field("first_entry", "-", "its column of the factor, from the diagonal down; nothing where it has none", "i4"),
        Field("entry_end", "-", "", "i4"),
        Field("first_target", "-", "", "i4"),
        Field("paired", "-", "1 when it is eliminated together with the next one, which is of the same joint", "i4"),
    ),
)
"""The rows of a layout."""

ENTRY = Table(
    "entry",
    (
        Field("place", "-", "in the factor", "i4"),
        Field("total", "-", "where the sum of its products is kept", "i4"),
        Field("other", "-", "place of the row below the diagonal", "i4"),
        Field("first_product", "-", "", "i4"),
        Field("product_end", "-", "", "i4"),
    ),
)

PRODUCT = Table(
    "product",
    (
        Field("one", "-", "place of the Jacobian of one row at a body", "i4"),
        Field("other", "-", "place of that of the other row at the same body", "i4"),
        Field("seat", "-", "place of the body", "i4"),
        Field("linear", "-", "product of what both do to its velocity: -1, 0, 1, `ANY_PRODUCT`, or 3 to 5", "i4"),
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
        Field("in_blow", "-", "of `own`: 1 while its rows and sums are in the working place for impacts", "i8"),
        Field(
            "next_struck", "-", "1 + the next batch that the same impact reaches, -1 for the last; 0 if none does", "i8"
        ),
    ),
)


class Batches(NamedTuple):
    """The arrays of factorised parts.

    Of layouts: `targets` are the entries from which the elimination of a row subtracts, in its order. `fixed` are the
    bodies on the fixed sides, part after part. Of batches: `found` is how many there are, where memory and names of
    bodies in use end, and where the memory of the first begins; `level` is what `SUBSTEP_LEVEL` and the names after
    it say; `open` the batch that takes the next part of each layout and level, staggered or not; `parts` says which
    part lies in each lane, `bodies` who has each seat, in each lane. `delassus` is the matrix of a group of impacts,
    three rows a contact. `units` has how many units of length a metre is, and how many metres one of them.
    `memory` has a working place for each worker first: poses, frames, rows, factor, sums of products; then the batches.
    `found` ends with the size of a working place. Places in it count from where it begins; so do those in `own`, the
    batch that each worker is at.
    """

    layouts: Records
    layout_frames: Records
    equations: Records
    entries: Records
    products: Records
    targets: Integers32
    fixed: Integers
    batches: Records
    own: Records
    found: Integers
    level: Integers
    open: Integers
    parts: Integers
    bodies: Integers
    delassus: Floats
    units: Floats
    memory: Floats

"""Rows lie in memory as those who read them count on: whole cache lines, and columns that are read at once side by
side."""

from __future__ import annotations

import pytest

from sandbox.engine.records.batches import IMPACT_SLOT
from sandbox.engine.records.bodies import BODY_FORCES, FREE_MOTION, IMPACT_BODY, MOTION, VELOCITY_PART
from sandbox.engine.records.colliders import GRID_BOX, PROXY
from sandbox.engine.records.contact_blocks import BLOCK
from sandbox.tables import Table
from sandbox.world.records import CONTACT

CACHE_LINE = 64


@pytest.mark.parametrize(
    ("table", "lines"),
    [(CONTACT, 4.0), (PROXY, 2.0), (GRID_BOX, 1.0), (MOTION, 1.0), (FREE_MOTION, 1.0), (BODY_FORCES, 1.0),
     (IMPACT_BODY, 1.0), (BLOCK, 1.0), (VELOCITY_PART, 0.5), (IMPACT_SLOT, 0.5)],
    ids=lambda each: each.name if isinstance(each, Table) else "",
)  # fmt: skip
def test_a_row_takes_so_many_cache_lines(table: Table, lines: float) -> None:
    """One more column costs every step: what it is worth has to be measured."""
    assert table.dtype.itemsize == lines * CACHE_LINE


@pytest.mark.parametrize("names", [("restitution", "friction"), ("friction", "surface_speed"), ("shape_a", "shape_b")])
def test_columns_that_do_not_lie_side_by_side_are_no_run(names: tuple[str, ...]) -> None:
    with pytest.raises(ValueError, match=f"{', '.join(names)} of the contact table do not lie side by side"):
        CONTACT.run(*names)

"""Tables for kernels in Python: fields as attributes of rows and of columns, in the same memory."""

from __future__ import annotations

import numpy as np
import pytest

from sandbox._plain_rows import plain_rows
from sandbox.tables import Field, Records, Table


@pytest.fixture
def table() -> Records:
    rows = Table("pair", (Field("mass", "kg", "a number"), Field("count", "1", "another", "i8"))).zeros(4)
    rows.mass[:], rows.count[:] = (0.5, 1.5, 2.5, 3.5), (4, 5, 6, 7)
    return rows


def test_fields_are_read_and_written_as_by_a_record_array(table: Records) -> None:
    rows = plain_rows(table)
    for one, two in zip(rows, table, strict=True):
        assert (one.mass, type(one.mass), one.count, type(one.count)) == (two.mass, np.float64, two.count, np.int64)
    rows[1].mass += 1.0
    rows.count[2] = 9
    rows[3] = rows[0]
    assert table.mass.tolist() == [0.5, 2.5, 2.5, 0.5]
    assert table["count"].tolist() == [4, 5, 9, 4]


def test_some_of_the_rows_are_such_a_table_too(table: Records) -> None:
    part = plain_rows(table[1:3])[:1]
    part[0].count = -1
    part.mass = 8.0
    assert part.mass.tolist() == [8.0]
    assert table.tolist()[1] == (8.0, -1)


@pytest.mark.parametrize("name", ["weight", "mass_", "fields"])
def test_what_is_no_field_is_told(table: Records, name: str) -> None:
    rows = plain_rows(table)
    with pytest.raises(AttributeError, match=name):
        getattr(rows[0], name)
    with pytest.raises(AttributeError, match=name):
        setattr(rows[0], name, 1.0)

"""Tables for kernels that run as Python: `rows[3].mass` and `rows.mass[3]` without a search for the name.

numpy's record arrays look a field up in Python, after an exception for not being an attribute: half of the time of a
run without the compiler. Here the fields are properties of classes made for each kind of row.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from operator import itemgetter
from typing import Any

import numpy as np
from numpy.typing import NDArray


def plain_rows(table: NDArray[Any]) -> NDArray[Any]:
    """The same memory, for kernels in Python."""
    kind, dtype = _classes(table.dtype)
    return np.asarray(table).view(dtype, kind)


@cache
def _classes(dtype: np.dtype[Any]) -> tuple[type[NDArray[Any]], np.dtype[Any]]:
    """The class of a table whose rows are of this dtype, and the same dtype with a class of its own for a row."""
    dtype = np.dtype((np.void, dtype))
    fields = {name: property(itemgetter(name), _setter(name)) for name in dtype.names or ()}
    row = type("PlainRow", (np.void,), {"__slots__": (), **fields})
    return type("PlainRows", (np.ndarray,), fields), np.dtype((row, dtype))


def _setter(name: str) -> Callable[[Any, Any], None]:
    def write(rows: Any, value: Any) -> None:
        rows[name] = value

    return write

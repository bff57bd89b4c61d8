"""The two cases of the tutorial this project began with, and its tables."""

from __future__ import annotations

SQUARE_ONE, TRIANGLE_ONE = ((13, 10), (13, 3), (6, 3), (6, 10)), ((14, 18), (15, 11), (10, 13))
SQUARE_TWO, TRIANGLE_TWO = ((11, 10), (11, 3), (4, 3), (4, 10)), ((13, 13), (8, 9), (7, 15))

TABLE_ONE = ((91, 42, 105, 70, "No"), (-21, -70, -77, -126, "Yes"))
TABLE_TWO = (
    (77, 28, 91, 49, "No"),
    (-21, -70, -63, -105, "No"),
    (-28, -77, -49, -91, "No"),
    (70, 21, 105, 63, "No"),
    (29, -34, -13, -47, "No"),
    (-27, -76, -57, -91, "No"),
    (82, 26, 104, 70, "No"),
)
"""amax, amin, bmax, bmin, gap."""

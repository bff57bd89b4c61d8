"""Bodies built many at once have, to the bit, what each has that is built alone."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from sandbox.geometry.mass import edge_normals, moments
from sandbox.scene.flat import FlatBody, Vec
from sandbox.world.body_rows import body_tables
from sandbox.world.moments import Cores, core_moments, half_widths
from tests.flat import body, box, capsule, circle, polygon, segment
from tests.geometry.convex_cases import cores

Core = tuple[tuple[Vec, ...], float]
numbers = st.floats(-50.0, 50.0)
sizes = st.floats(0.01, 20.0)
bodies = st.builds(
    lambda shapes, where, angle, kind, center: body(
        "b", *shapes, position=where, angle=angle, type=kind, center=center
    ),
    st.lists(
        st.one_of(
            st.builds(circle, sizes, st.tuples(numbers, numbers), density=sizes, sensor=st.booleans()),
            st.builds(box, sizes, sizes, st.tuples(numbers, numbers), radius=st.sampled_from((0.0, 0.3))),
            st.builds(capsule, sizes, sizes),
            st.builds(segment, st.just((0.0, -1.0)), st.just((2.5, 1.0)), radius=st.sampled_from((0.0, 0.3))),
            st.builds(polygon, st.just((0.0, 0.0)), st.just((3.0, 0.0)), st.just((0.0, 2.0)), density=sizes),
        ),
        max_size=4,
    ).map(tuple),
    st.tuples(numbers, numbers),
    st.floats(-700.0, 700.0),
    st.sampled_from(("static", "kinematic", "dynamic")),
    st.none() | st.tuples(numbers, numbers),
)


def half_width(core: tuple[Vec, ...]) -> float:
    """Half of the least that a core measures across one of its edges."""
    edges = zip(core, edge_normals(core), strict=True)
    return 0.5 * min(max(nx * (x - qx) + ny * (y - qy) for qx, qy in core) for (x, y), (nx, ny) in edges)


def laid_out(drawn: list[Core]) -> Cores:
    corners = np.array([corner for core, _ in drawn for corner in core], float).reshape(-1, 2)
    counts = np.array([len(core) for core, _ in drawn], np.int64)
    return Cores.of(
        counts, corners[:, 0].copy(), corners[:, 1].copy(), np.array([radius for _, radius in drawn], float)
    )


@given(st.lists(st.tuples(cores, st.sampled_from((0.0, 0.25, 3.0))), max_size=6))
def test_moments_of_many_are_those_of_each(drawn):
    together = np.array(core_moments(laid_out(drawn)))
    alone = np.array([moments(core, radius) for core, radius in drawn], float).reshape(-1, 4).T
    assert together.tobytes() == np.ascontiguousarray(alone).tobytes()
    widths = [half_width(core) if len(core) > 2 else 0.0 for core, _ in drawn]
    assert half_widths(laid_out(drawn)).tolist() == widths


@given(st.lists(bodies, max_size=6))
def test_bodies_of_a_crowd_are_those_that_are_alone(crowd: list[FlatBody]):
    together = body_tables([*crowd, *crowd])
    alone = [body_tables([each]) for each in (*crowd, *crowd)]
    for k, table in enumerate(together):
        for name in table.dtype.names:
            if name != "body" and not name.endswith("_start"):
                parts = np.concatenate([np.asarray(tables[k][name]) for tables in alone] or [table[name]])
                assert parts.tobytes() == np.ascontiguousarray(table[name]).tobytes(), name
    shapes = together[1]
    assert shapes.body.tolist() == [row for row, each in enumerate((*crowd, *crowd)) for _ in each.shapes]
    for name in ("vertex", "outline"):
        counts = shapes[f"{name}_count"]
        assert shapes[f"{name}_start"].tolist() == (np.cumsum(counts) - counts).tolist()

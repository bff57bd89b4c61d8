"""Whole steps of fast bodies against a naive twin that looks everywhere on their way."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sandbox.engine.world import World
from sandbox.scene.flat import FlatShape
from tests.examples import examples
from tests.flat import body, box, capsule, circle, polygon, segment, world
from tests.naive.time_of_impact import Meeting, Mover, TooCloseError

STEP = 1.0 / 60.0
DEEP, DEEP_SHARE, CREEP, GROWTH = 0.005, 0.25, 0.02, 0.05
"""How deep (m) bodies may come into each other on their way, at most by that share of their half widths; what is as
deep already may come deeper by a share of it."""
STILL: dict[str, FlatShape] = {
    "wall": box(0.05, 40.0), "line": segment((0.0, -20.0), (0.0, 20.0)), "plate": box(0.04, 1.0),
    "post": circle(0.1), "wedge": polygon((-0.3, -0.5), (0.4, -0.1), (0.0, 0.6)), "pill": capsule(0.4, 0.03),
}  # fmt: skip
FAST: dict[str, FlatShape] = {
    "ball": circle(0.08), "box": box(0.2, 0.12), "rod": box(1.2, 0.04), "capsule": capsule(0.3, 0.05),
    "triangle": polygon((-0.15, -0.1), (0.2, -0.05), (0.0, 0.25)),
}  # fmt: skip
angles = st.floats(-math.pi, math.pi)


@st.composite
def shots(draw: st.DrawFn) -> World:
    """A fast body, and what stands in its way or next to it."""
    speed = draw(st.sampled_from([3.0, 20.0, 90.0, 400.0]))
    distance = draw(st.floats(1.2, 2.0)) + draw(st.floats(0.0, 1.0)) * speed * STEP
    aim = draw(st.floats(-0.6, 0.6))
    still = [
        body(f"still-{k}", STILL[draw(st.sampled_from(list(STILL)))], type="static", angle=draw(angles),
             position=(1.5 * k, draw(st.floats(-0.5, 0.5))))
        for k in range(draw(st.integers(1, 2)))
    ]  # fmt: skip
    fast = body(
        "fast", FAST[draw(st.sampled_from(list(FAST)))], position=(-distance, aim), angle=draw(angles),
        velocity=(speed, draw(st.floats(-0.2, 0.2)) * speed), angular_velocity=draw(st.sampled_from([0.0, 5.0, -40.0])),
    )  # fmt: skip
    return world(*still, fast, gravity=(0.0, 0.0))


def mover(w: World, row: Any, shape: Any, way: tuple[float, float] = (0.0, 0.0), turn: float = 0.0) -> Mover:
    """A shape of a body at the pose of now, and a way from there."""
    rows = w.state.vertices[int(shape.vertex_start) : int(shape.vertex_start + shape.vertex_count)]
    core = [(float(vertex.x), float(vertex.y)) for vertex in rows]
    return Mover(core, float(shape.radius), (float(row.center_x), float(row.center_y)), way, float(row.angle), turn)


def let_pass(a: Any, b: Any) -> float:
    """Depth (m) that two shapes may come to unforeseen."""
    return min(DEEP, DEEP_SHARE * float(a.thin + b.thin))


def pose(w: World) -> np.ndarray:
    """Of the fast body, which comes last: centre and angle."""
    row = w.state.bodies[-1]
    return np.array([row.center_x, row.center_y, row.angle], float)


@given(shots())
@examples(120)
def test_no_way_through_a_step_leads_too_deep_into_what_stands(w):
    bodies, shapes = w.state.bodies, w.state.shapes
    for _ in range(6):
        fast, before = bodies[-1], pose(w)
        froms = mover(w, fast, shapes[-1])
        w.step()
        x, y, turn = (float(value) for value in pose(w) - before)
        for k in range(len(bodies) - 1):
            meeting = Meeting(
                mover(w, bodies[k], shapes[k]), Mover(froms.core, froms.radius, froms.center, (x, y), froms.angle, turn)
            )
            if meeting.separation(0.0) > meeting.fastest():
                continue
            deep = let_pass(shapes[k], shapes[-1])
            overlap = max(deep, -meeting.separation(0.0))
            deep = overlap + max(CREEP * deep, GROWTH * min(overlap, shapes[-1].thin - overlap))
            try:
                found = meeting.first_below(-1.02 * deep, 0.02 * deep)
            except TooCloseError:
                continue
            assert found is None, f"{w.names[k]} at {found}"


@given(shots())
@examples(120)
def test_what_the_twin_sees_meet_is_stopped_and_what_it_sees_pass_is_not(w):
    """Up to the first step in which they meet, and of what starts apart: what is within may come out unhindered."""
    bodies, shapes = w.state.bodies, w.state.shapes
    for _ in range(6):
        fast = bodies[-1]
        way = STEP * float(fast.velocity_x), STEP * float(fast.velocity_y)
        turn = STEP * float(fast.angular_velocity)
        free = pose(w) + np.array([*way, turn])
        gaps, through = [], False
        for k in range(len(bodies) - 1):
            meeting = Meeting(mover(w, bodies[k], shapes[k]), mover(w, fast, shapes[-1], way, turn))
            gaps.append(float(meeting.separations(np.linspace(0.0, 1.0, 200)).min()))
            deep = gaps[-1] < -3.0 * let_pass(shapes[k], shapes[-1])
            through = through or (deep and meeting.separation(0.0) > 0.0)
        # What comes by nearer than this may have a contact, which takes turning for straight.
        near = 0.05 + meeting.fastest() / 200.0 + 0.5 * turn * turn * float(fast.extent)
        w.step()
        if through:
            assert not np.allclose(pose(w), free, rtol=0.0, atol=1e-9)
            return
        if min(gaps) <= near:
            return
        assert pose(w) == pytest.approx(free, abs=1e-9 * (1.0 + np.abs(free).max()))


@given(st.sampled_from(["wall", "line"]), st.sampled_from(list(FAST)), angles, st.data())
@examples(150)
def test_nobody_ends_on_the_other_side_of_a_long_wall(wall, fast, tilt, data):
    speed, spin = data.draw(st.floats(2.0, 600.0)), data.draw(st.floats(-60.0, 60.0))
    slant, place = data.draw(st.floats(-1.2, 1.2)), data.draw(st.floats(-4.0, -0.8))
    c, s = math.cos(tilt), math.sin(tilt)
    vx, vy = speed * math.cos(slant), speed * math.sin(slant)
    w = world(
        body("wall", STILL[wall], type="static", angle=tilt),
        body(
            "fast", FAST[fast], position=(c * place, s * place), velocity=(c * vx - s * vy, s * vx + c * vy),
            angular_velocity=spin, angle=data.draw(angles),
        ),
        gravity=(0.0, 0.0),
    )  # fmt: skip
    row = w.state.bodies[1]
    for _ in range(12):
        w.step()
        along = float(c * row.center_y - s * row.center_x)
        if abs(along) > 19.0:
            return
        assert float(c * row.center_x + s * row.center_y) < 0.0

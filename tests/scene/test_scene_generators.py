"""What generators make: names, places, limits, and the same random numbers everywhere."""

from __future__ import annotations

import math
import time

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sandbox.errors import SceneError
from sandbox.scene import FlatBody, Scene, loads_scene
from sandbox.scene.generators import Grid, Pyramid, Row, Scatter, Stack, body_count, body_names
from sandbox.scene.limits import MAX_BODIES
from sandbox.scene.splitmix import SplitMix64

PREFABS = {"crate": {"shapes": [{"box": [2, 1]}]}, "ball": {"shapes": [{"circle": 0.5}]}}


def made(**generator) -> tuple[FlatBody, ...]:
    return Scene(prefabs=PREFABS, generate=[{"id": "it", **generator}]).flatten().bodies


def places(**generator) -> dict[str, tuple[float, float]]:
    return {body.id: body.position for body in made(**generator)}


def test_a_row_steps_by_a_width_or_as_told():
    assert places(row="crate", count=3, at=[1, 5]) == {"it-1": (1, 5), "it-2": (3, 5), "it-3": (5, 5)}
    assert places(row="crate", count=2, step=[0.5, -1]) == {"it-1": (0, 0), "it-2": (0.5, -1)}


def test_a_stack_grows_upwards():
    assert places(stack="crate", count=3, at=[1, 0.5]) == {
        "it-1": (1, 0.5),
        "it-2": (1, 1.5),
        "it-3": (1, 2.5),
    }
    assert places(stack="crate", count=2, spacing=1.25) == {"it-1": (0, 0), "it-2": (0, 1.25)}


def test_a_grid_begins_at_the_lower_left():
    assert places(grid="crate", columns=2, rows=2, at=[1, 1], stagger=0.5) == {
        "it-1-1": (1, 1),
        "it-1-2": (3, 1),
        "it-2-1": (1.5, 2),
        "it-2-2": (3.5, 2),
    }


def test_a_pyramid_stands_on_its_widest_row():
    assert places(pyramid="crate", rows=3, at=[10, 0.5]) == {
        "it-1-1": (8, 0.5),
        "it-1-2": (10, 0.5),
        "it-1-3": (12, 0.5),
        "it-2-1": (9, 1.5),
        "it-2-2": (11, 1.5),
        "it-3-1": (10, 2.5),
    }


def test_default_spacing_is_that_of_the_turned_prefab():
    prefabs = {"upright": {"angle": 90, "shapes": [{"box": [2, 1]}]}}
    scene = Scene(prefabs=prefabs, generate=[{"id": "it", "stack": "upright", "count": 2}])
    assert scene.flatten().bodies[1].position == (0, 2)
    assert scene.flatten().bodies[1].angle == pytest.approx(math.pi / 2)


def test_bodies_of_a_generator_share_their_shapes_and_point_to_it():
    first, *others = made(pyramid="crate", rows=4)
    assert all(body.shapes is first.shapes for body in others)
    assert {body.pointer for body in (first, *others)} == {"/generate/0"}


@given(st.integers(1, 40), st.integers(0, 1000))
def test_scattered_bodies_keep_apart_and_inside(count, seed):
    bodies = made(scatter="ball", count=count, seed=seed, inside=[-10, 0, 10, 12])
    points = [body.position for body in bodies]
    assert all(-10 <= x <= 10 and 0 <= y <= 12 for x, y in points)
    assert all(math.dist(a, b) >= 1 for k, a in enumerate(points) for b in points[:k])
    assert bodies == made(scatter="ball", count=count, seed=seed, inside=[-10, 0, 10, 12])


def test_another_seed_is_another_arrangement():
    def points(seed):
        return places(scatter="ball", count=5, seed=seed, inside=[0, 0, 9, 9])

    assert points(1) != points(2)


def test_scattered_angles_lie_in_their_range():
    angles = [body.angle for body in made(scatter="ball", count=50, inside=[0, 0, 99, 99], angle=[-10, 20])]
    assert min(angles) < 0 < max(angles)
    assert all(math.radians(-10) <= angle <= math.radians(20) for angle in angles)


def test_the_random_numbers_are_those_of_the_paper():
    # The reference implementation's first outputs for the seed 1234567.
    random = SplitMix64(1234567)
    assert [random.next_bits() for _ in range(3)] == [
        6457827717110365317, 3203168211198807973, 9817491932198370423,
    ]  # fmt: skip


@pytest.mark.parametrize(
    ("generator", "message"),
    [
        ({"scatter": "ball", "count": 500, "inside": [0, 0, 5, 5]}, "of 500 bodies fit"),
        ({"row": "ball", "count": 3, "step": [1e9, 0]}, "farther than 1e\\+09 m"),
        ({"row": "ball", "count": MAX_BODIES + 1}, "count must not be above 100000"),
        ({"grid": "ball", "columns": 1000, "rows": 1000}, "1000000 bodies; 100000 is the limit"),
        ({"pyramid": "ball", "rows": 100_000}, "5000050000 bodies; 100000 is the limit"),
    ],
)
def test_what_cannot_be_made_is_refused(generator, message):
    with pytest.raises(SceneError, match=message):
        made(**generator)


def test_too_many_shapes_are_refused():
    prefabs = {"many": {"shapes": [{"circle": 1}] * 30}}
    with pytest.raises(SceneError, match="300000 shapes; 200000 is the limit"):
        Scene(prefabs=prefabs, generate=[{"id": "a", "row": "many", "count": 10_000}])


def test_counting_needs_no_making():
    for generator in (
        Row(id="a", row="x", count=3),
        Stack(id="a", stack="x", count=3),
        Grid(id="a", grid="x", columns=3, rows=2),
        Pyramid(id="a", pyramid="x", rows=4),
        Scatter(id="a", scatter="x", count=3, inside=(0, 0, 1, 1)),
    ):
        assert body_count(generator) == len(body_names(generator)) == len(set(body_names(generator)))


def test_a_generated_id_may_not_be_taken():
    with pytest.raises(SceneError, match='the id "a-1" is taken by bodies\\[0\\]'):
        Scene(
            prefabs=PREFABS,
            bodies=[{"id": "a-1", "prefab": "ball"}],
            generate=[{"id": "a", "row": "ball", "count": 2}],
        )


def load_pyramid(rows: int) -> float:
    """Seconds of the processor that it takes to load so many rows, which what else runs does not lengthen."""
    text = f"""{{"prefabs": {{"crate": {{"shapes": [{{"box": [1, 1]}}]}}}},
        "generate": [{{"id": "wall", "pyramid": "crate", "rows": {rows}, "at": [0, 0.5]}}]}}"""
    start = time.process_time()
    assert len(loads_scene(text).flatten().bodies) == rows * (rows + 1) // 2
    return time.process_time() - start


def test_sixteen_times_as_many_bodies_take_about_sixteen_times_as_long_to_load():
    """40 ms for 5,050 bodies; were it a square of them, it would be 240 times as long as for 325."""
    few, many = (min(load_pyramid(rows) for _ in range(5)) for rows in (25, 100))
    assert many < 50.0 * few + 0.1

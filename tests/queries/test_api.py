"""What users rely on: nothing changes, filters, hard cases with known answers, and clear refusals."""

from __future__ import annotations

import math
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import sandbox
from sandbox import Box, Circle, Filter, QueryError, Segment, SetPose, UnknownBodyError
from sandbox.scene.flat import FlatSettings
from tests.determinism.busy import STEPS, digests
from tests.determinism.busy import scene as busy_scene
from tests.flat import body, box, capsule, circle, ground, polygon, scene, segment, world

ROOT = Path(__file__).parents[2]


def ask_everything(w: sandbox.World) -> list[object]:
    """Every query there is, on the first bodies of a world."""
    q = w.query
    x, y = map(float, w.bodies.center[1])
    seen = Filter(exclude=(w.names[0],))
    rays = q.rays(np.zeros((4, 2)), np.array([[9.0, 1.0], [-9.0, 1.0], [0.0, -9.0], [0.5, 9.0]]))
    columns = [column.tolist() for column in (rays.body, rays.shape, rays.point, rays.normal, rays.fraction)]
    return [
        q.ray((x - 9.0, y), (20.0, 0.3)), q.ray_all((x, y + 9.0), (0.1, -20.0)),
        q.point((x, y)), q.nearest((x + 3.0, y)),
        q.overlap_box((x - 1.0, y - 1.0), (x + 2.0, y + 1.0)), q.overlap_shape(Circle((x, y), 2.0), seen),
        q.cast(Box(0.5, 0.5, (x - 9.0, y), 0.3), (20.0, 0.3), seen),
        q.cast_all(Circle((x, y + 9.0), 0.3), (0.1, -20.0)),
        q.distance(w.names[0], w.names[1]), columns,
    ]  # fmt: skip


def test_questions_change_nothing():
    """No digest, no snapshot, no later step: asked between all steps, or never."""
    asked, silent = sandbox.World(busy_scene()), sandbox.World(busy_scene())
    for step in range(STEPS):
        before = asked.digest(), asked.snapshot()
        ask_everything(asked)
        assert (asked.digest(), asked.snapshot()) == before
        assert digests(asked, step, step + 1) == digests(silent, step, step + 1)
    assert asked.snapshot() == silent.snapshot()


PROGRAM = """
from sandbox import World
from tests.determinism.busy import scene
from tests.queries.test_api import ask_everything
w = World(scene())
w.step(20)
print(ask_everything(w))
"""


@pytest.mark.slow
def test_the_same_answers_without_the_compiler():
    answers = [
        subprocess.run(
            [sys.executable, "-c", PROGRAM], cwd=ROOT, capture_output=True, text=True, check=True,
            env={**os.environ, "PYTHONPATH": str(ROOT), "NUMBA_DISABLE_JIT": off},
        ).stdout
        for off in ("0", "1")
    ]  # fmt: skip
    assert answers[0] == answers[1]
    assert len(answers[0]) > 500


def test_answers_follow_steps_commands_and_restores():
    w = world(ground(), body("ball", circle(0.5), position=(0.0, 5.0)))
    high = w.query.ray((0.0, 9.0), (0.0, -20.0))
    saved = w.snapshot()
    w.step(30)
    low = w.query.ray((0.0, 9.0), (0.0, -20.0))
    assert high is not None
    assert low is not None
    assert low.point[1] == pytest.approx(float(w.body("ball").position[1]) + 0.5)
    assert low.point[1] < high.point[1] - 1.0
    w.apply(SetPose("ball", (7.0, 3.0), 0.0))
    assert w.query.ray((7.0, 9.0), (0.0, -20.0)).point == pytest.approx((7.0, 3.5))
    w.restore(saved)
    assert w.query.ray((0.0, 9.0), (0.0, -20.0)) == high


def test_sleeping_static_and_kinematic_bodies_are_seen():
    parts = [
        body("box", box(1.0, 1.0), position=(0.0, 0.5)),
        body("lift", box(1.0, 1.0), type="kinematic", position=(3.0, 0.5)),
    ]
    w = sandbox.World(scene(ground(), *parts, settings=FlatSettings(sleeping=True)))
    w.step(120)
    assert not w.body("box").awake
    assert [hit.body for hit in w.query.ray_all((-2.0, 0.25), (9.0, 0.0))] == ["box", "lift"]
    assert w.query.ray((8.0, 5.0), (0.0, -9.0)).body == "ground"


def row() -> sandbox.World:
    """Discs in a row: what they are and what they collide with differs."""
    discs = [
        ("plain", {}), ("second", {"category": 2}), ("shy", {"mask": 4}),
        ("mates", {"group": 5}), ("rivals", {"group": -5}),
    ]  # fmt: skip
    parts = [body(name, circle(0.5, **surface), position=(2.0 * k, 0.0)) for k, (name, surface) in enumerate(discs)]
    return world(*parts, body("wall", box(1.0, 4.0), type="static", position=(10.0, 0.0)), gravity=(0.0, 0.0))


ALL = ["plain", "second", "shy", "mates", "rivals", "wall"]


@pytest.mark.parametrize(
    ("seen", "expected"),
    [
        (None, ALL),
        (Filter(), ALL),
        (Filter(mask=2), ["second"]),
        (Filter(mask=0), []),
        (Filter(category=1), ["plain", "second", "mates", "rivals", "wall"]),
        (Filter(category=4), ALL),
        (Filter(mask=2, group=5), ["second", "mates"]),
        (Filter(group=-5), ["plain", "second", "shy", "mates", "wall"]),
        (Filter(exclude=("plain", "wall")), ["second", "shy", "mates", "rivals"]),
        (Filter(types=("static",)), ["wall"]),
        (Filter(types=("dynamic", "kinematic"), exclude=("shy",)), ["plain", "second", "mates", "rivals"]),
        (Filter(types=()), []),
    ],
)
def test_filters(seen, expected):
    q = row().query
    start, way = (-5.0, 0.0), (30.0, 0.0)
    assert [hit.body for hit in q.ray_all(start, way, seen)] == expected
    assert getattr(q.ray(start, way, seen), "body", None) == (expected or [None])[0]
    assert [hit.body for hit in q.cast_all(Circle(start, 0.25), way, seen)] == expected
    assert [hit.body for hit in q.overlap_box((-1.0, -1.0), (12.0, 1.0), seen)] == expected
    assert [hit.body for hit in q.overlap_shape(Segment((-1.0, 0.0), (12.0, 0.0)), seen)] == expected
    assert [hit.body for x in (0, 2, 4, 6, 8, 10) for hit in q.point((x, 0), seen)] == expected
    assert getattr(q.nearest((-4.0, 0.0), filter=seen), "body", None) == (expected or [None])[0]
    batch = q.rays([start], way, seen)
    assert [q._world.names[i] for i in batch.body if i >= 0] == expected[:1]
    assert [hit.body for hit in q.ray_all(start, way)] == ALL, "a filter lasts for one query"


def test_an_empty_world():
    q = world().query
    assert q.ray((0.0, 0.0), (1.0, 0.0)) is None
    assert q.cast(Circle((0.0, 0.0), 1.0), (1.0, 0.0)) is None
    assert q.nearest((0.0, 0.0)) is None
    assert q.ray_all((0.0, 0.0), (1.0, 0.0)) == q.point((0.0, 0.0)) == q.overlap_box((0, 0), (1, 1)) == ()
    assert q.rays([(0.0, 0.0)], (1.0, 2.0)).point.tolist() == [[1.0, 2.0]]
    assert len(q.rays(np.empty((0, 2)), np.empty((0, 2)))) == 0


def cube(at=(0.0, 0.0), **fields) -> sandbox.World:
    """A unit box."""
    return world(body("box", box(1.0, 1.0), position=at, **fields), gravity=(0.0, 0.0))


@pytest.mark.parametrize("far", [0.0, 1e4, 2.0**23])
@pytest.mark.parametrize(
    ("origin", "way", "fraction", "normal"),
    [
        ((-2.0, 0.0), (4.0, 0.0), 0.375, (-1.0, 0.0)),
        ((-2.0, 0.5), (4.0, 0.0), 0.375, (-1.0, 0.0)),  # along an edge
        ((-2.0, -0.5), (4.0, 0.0), 0.375, (-1.0, 0.0)),
        ((2.0, 0.5), (-4.0, 0.0), 0.375, (1.0, 0.0)),
        ((-1.5, 0.5), (1.0, 0.0), 1.0, (-1.0, 0.0)),  # ends at a corner
        ((0.0, 0.0), (4.0, 0.0), 0.0, (0.0, 0.0)),  # begins inside
        ((0.5, 0.25), (4.0, 0.0), 0.0, (1.0, 0.0)),  # begins on the outline and leaves
        ((0.5, 0.25), (-4.0, 0.0), 0.0, (1.0, 0.0)),  # begins on the outline and enters
        ((0.0, 0.0), (0.0, 0.0), 0.0, (0.0, 0.0)),  # no length
        ((0.25, 0.5), (0.0, 0.0), 0.0, (0.0, 1.0)),
    ],
)
def test_a_ray_at_a_box(origin, way, fraction, normal, far):
    hit = cube((far, far)).query.ray((origin[0] + far, origin[1] + far), way)
    assert hit is not None
    assert (hit.body, hit.shape, hit.fraction, hit.normal) == ("box", 0, fraction, normal)
    assert hit.point == (origin[0] + far + fraction * way[0], origin[1] + far + fraction * way[1])


@pytest.mark.parametrize("far", [0.0, 1e4, 2.0**23])
@pytest.mark.parametrize(
    ("origin", "way"),
    [
        ((-2.0, 0.5 + 1e-6), (4.0, 0.0)),
        ((-2.0, 0.0), (1.5 - 1e-6, 0.0)),
        ((0.6, 0.0), (4.0, 0.0)),
        ((0.6, 0.0), (0.0, 0.0)),
    ],
)
def test_a_ray_past_a_box(origin, way, far):
    assert cube((far, far)).query.ray((origin[0] + far, origin[1] + far), way) is None


def test_a_ray_through_a_corner_from_all_around():
    """Where three boxes meet in a corner, every ray through the corner that comes from outside hits one of them."""
    w = world(*(body(f"{k}", box(1.0, 1.0), position=p) for k, p in enumerate([(0.5, 0.5), (-0.5, 0.5), (0.5, -0.5)])))
    for k in range(360):
        way = math.cos(k), math.sin(k)
        hits = w.query.ray_all((-3.0 * way[0], -3.0 * way[1]), (6.0 * way[0], 6.0 * way[1]))
        assert {hit.body for hit in hits} == {"0", "1", "2"}


def test_lines_are_met_from_both_sides_and_along():
    w = world(body("line", segment((-1.0, 0.0), (1.0, 0.0)), type="static"))
    assert w.query.ray((0.0, 1.0), (0.0, -2.0)).normal == (0.0, 1.0)
    assert w.query.ray((0.0, -1.0), (0.0, 2.0)).normal == (0.0, -1.0)
    along = w.query.ray((-3.0, 0.0), (8.0, 0.0))
    assert (along.fraction, along.normal) == (0.25, (-1.0, 0.0))


def test_tiny_and_huge_shapes_mixed():
    """A speck of 10 um before a wall of 20,000 km, 10,000 km from the origin."""
    far = 1e7
    w = world(
        body("wall", box(2e7, 2e7), type="static", position=(0.0, -1e7)),
        body("speck", circle(1e-5), type="static", position=(far, 1e-3)),
    )
    assert [hit.body for hit in w.query.ray_all((far, 1.0), (0.0, -2.0))] == ["speck", "wall"]
    assert [hit.body for hit in w.query.ray_all((far - 3e6, 1e-3), (6e6, 0.0))] == ["speck"]
    assert w.query.ray((far, 0.5), (0.0, -1.0)).fraction == pytest.approx(0.5 - 1e-3 - 1e-5, abs=1e-12)
    assert w.query.nearest((far, 0.4)).body == "speck"
    assert w.query.nearest((far - 1.0, 0.4)).body == "wall"


def test_a_cast_touches_where_the_shapes_meet():
    w = world(ground(), body("post", box(0.2, 3.0), type="static", position=(5.0, 1.5)))
    down = w.query.cast(Box(1.0, 1.0, (0.0, 4.0)), (0.0, -8.0))
    assert (down.body, down.fraction, down.normal, down.point) == ("ground", 0.4375, (0.0, 1.0), (0.0, 0.0))
    aside = w.query.cast(Circle((0.0, 2.0), 0.5), (10.0, 0.0))
    assert (aside.body, aside.fraction, aside.normal) == ("post", pytest.approx(0.44), (-1.0, 0.0))
    assert aside.point == pytest.approx((4.9, 2.0))
    assert w.query.cast(Box(1.0, 1.0, (0.0, 0.0)), (0.0, 5.0)).normal == (0.0, 0.0)


def test_the_way_out_of_an_overlap():
    (hit,) = cube().query.overlap_shape(Box(1.0, 1.0, (0.75, 0.125)))
    assert (hit.normal, hit.depth, hit.point) == ((1.0, 0.0), 0.25, (0.5, 0.0625))
    assert cube().query.overlap_shape(Box(1.0, 1.0, (1.0, 1.0)))[0].depth == 0.0
    assert cube().query.overlap_shape(Box(1.0, 1.0, (1.0, 1.0 + 1e-9))) == ()


@pytest.mark.parametrize("thickness", [0.0, 1e-80, 1e-20, 1e-16])
@pytest.mark.parametrize("height", [0.25, -0.25])
def test_the_way_out_of_a_box_as_thin_as_a_line(height, thickness):
    """Both long sides are as near to the disc's middle: the one that faces it decides."""
    w = world(body("disc", circle(0.5), type="static", position=(0.25, height)))
    (hit,) = w.query.overlap_box((-1.0, -thickness), (1.0, 0.0))
    assert hit.normal == (0.0, -1.0 if height > 0.0 else 1.0)
    assert hit.depth == pytest.approx(0.25)


def test_the_distance_of_bodies_of_many_shapes():
    comb = [box(0.2, 1.0, (float(k), 0.0)) for k in range(40)]
    w = world(
        body("comb", *comb),
        body("ball", circle(0.25), position=(20.4, 3.0)),
        body("pin", circle(0.1), position=(7.5, 0.0)),
    )
    gap = w.query.distance("ball", "comb")
    assert gap.shape_b == 20 + 0
    assert gap.distance == pytest.approx(math.hypot(0.3, 2.5) - 0.25)
    assert w.query.distance("comb", "pin").distance == pytest.approx(0.3)
    assert w.query.distance("comb", "ball").point_a == pytest.approx(gap.point_b)


def test_more_answers_than_there_was_room_for():
    w = world(*(body(f"{k}", circle(0.5), position=(0.01 * k, 0.0)) for k in range(500)))
    assert [hit.shape for hit in w.query.overlap_box((-1.0, -1.0), (9.0, 1.0))] == list(range(500))
    assert [hit.shape for hit in w.query.ray_all((-2.0, 0.0), (20.0, 0.0))] == list(range(500))


REFUSED = {
    "nan": (lambda q: q.ray((math.nan, 0.0), (1.0, 0.0)), "finite number"),
    "infinite": (lambda q: q.ray((0.0, 0.0), (math.inf, 0.0)), "ray: x of the translation"),
    "too far": (lambda q: q.point((1e10, 0.0)), "within"),
    "no pair": (lambda q: q.cast(Circle((0, 0), 1.0), 3.0), "pair"),
    "text": (lambda q: q.nearest("ab"), "pair"),
    "negative": (lambda q: q.nearest((0.0, 0.0), within=-1.0), "0 m or more"),
    "no distance": (lambda q: q.nearest((0.0, 0.0), within=math.nan), "0 m or more"),
    "corners": (lambda q: q.overlap_box((1.0, 0.0), (0.0, 1.0)), "below and left"),
    "no shape": (lambda q: q.overlap_shape((1.0, 2.0)), "Circle, Capsule, Segment, Polygon or Box, not tuple"),
    "itself": (lambda q: q.distance("box", "box"), "twice"),
    "no category": (lambda q: q.point((0.0, 0.0), Filter(category=0)), "category 0"),
    "type": (lambda q: q.point((0.0, 0.0), Filter(types=("sleepy",))), "'sleepy'"),
    "id": (lambda q: q.point((0.0, 0.0), Filter(exclude="box")), "exclude"),
    "no filter": (lambda q: q.ray((0.0, 0.0), (1.0, 1.0), "box"), "asked with a Filter, or None, not 'box'"),
    "mask": (lambda q: q.point((0.0, 0.0), Filter(mask="box")), "mask is a bit set of 32 categories"),
    "33 categories": (lambda q: q.point((0.0, 0.0), Filter(category=2**32)), "category is a bit set of 32"),
    "group": (lambda q: q.point((0.0, 0.0), Filter(group=1.5)), "group is a whole number, not 1.5"),
    "one number": (lambda q: q.point(np.array(3.0)), "pair"),
    "a word": (lambda q: q.nearest((0.0, 0.0), "far"), "0 m or more, not 'far'"),
    "ragged": (lambda q: q.rays([(0, 0), (1, 1)], [(0, 0)] * 3), "pairs"),
    "triples": (lambda q: q.rays(np.zeros((2, 3)), np.zeros((2, 3))), "pairs"),
    "one and three": (lambda q: q.rays(np.zeros((2, 1)), np.zeros((2, 3))), "pairs"),
    "a ray of nan": (lambda q: q.rays([(0.0, math.nan)], [(1.0, 0.0)]), "number"),
}


@pytest.mark.parametrize("name", REFUSED)
def test_what_cannot_be_asked_is_refused_with_the_mend(name):
    ask, words = REFUSED[name]
    w = cube()
    with pytest.raises(QueryError, match=words):
        ask(w.query)
    assert w.query.ray((-2.0, 0.0), (4.0, 0.0)).body == "box", "and the next question is answered"


def test_an_unknown_body_is_refused_with_the_nearest_name():
    for ask in (lambda q: q.distance("box", "bix"), lambda q: q.point((0.0, 0.0), Filter(exclude=("bix",)))):
        w = cube()
        with pytest.raises(UnknownBodyError, match="'box'"):
            ask(w.query)
        assert w.query.point((0.0, 0.0))[0].body == "box"


def test_rounded_and_sharp_shapes_give_normals_that_point_out():
    shapes = [circle(0.5), capsule(0.5, 0.25), polygon((0.0, -0.6), (0.6, 0.3), (-0.5, 0.4)), box(0.8, 0.9)]
    w = world(*(body(f"{k}", shape, position=(3.0 * k, 0.0), angle=0.4) for k, shape in enumerate(shapes)))
    for k in range(4):
        for turn in range(40):
            way = (math.cos(0.16 * turn), math.sin(0.16 * turn))
            hit = w.query.ray((3.0 * k - 1.4 * way[0], -1.4 * way[1]), (2.0 * way[0], 2.0 * way[1]))
            if hit is not None:
                out = hit.point[0] + 1e-6 * hit.normal[0], hit.point[1] + 1e-6 * hit.normal[1]
                assert w.query.point(out) == ()
                assert w.query.nearest(out).distance == pytest.approx(1e-6, abs=1e-12)


def test_a_ray_is_given_by_its_translation_or_by_its_end():
    q = world(ground(), body("crate", box(1.0, 1.0), position=(0.0, 0.5))).query
    assert q.ray((-4.0, 0.5), end=(4.0, 0.5)) == q.ray((-4.0, 0.5), (8.0, 0.0))
    assert q.ray((-4.0, 0.5), end=(-1.0, 0.5)) is None
    assert q.ray_all((1.0, 9.0), end=(-1.0, -9.0)) == q.ray_all((1.0, 9.0), (-2.0, -18.0))
    for ask, name in ((q.ray, "ray"), (q.ray_all, "ray_all")):
        for given in ({}, {"translation": (1.0, 0.0), "end": (1.0, 0.0)}):
            with pytest.raises(QueryError, match=f"{name}: a ray has a translation or an end=, one of the two"):
                ask((0.0, 0.0), **given)
        with pytest.raises(QueryError, match="the end"):
            ask((0.0, 0.0), end=(1.0,))
        with pytest.raises(QueryError, match="the end"):
            ask((0.0, 0.0), end=())

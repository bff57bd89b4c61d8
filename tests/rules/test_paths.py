"""Bodies on paths: where they are, how they carry others, and what stops them."""

from __future__ import annotations

from typing import Any

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from sandbox._jit import interpreted
from sandbox._plain_rows import plain_rows
from sandbox.engine.bodies.paths import place_after
from sandbox.engine.commands.set_path import SetPath
from sandbox.engine.rules.paths import ways_of
from sandbox.engine.world import World
from sandbox.errors import CommandError
from sandbox.scene import Scene
from sandbox.scene.flat_body import FlatPath
from sandbox.scene.play.path import BodyPath
from tests.examples import examples


def lift(path: dict[str, Any], *others: dict[str, Any], **fields: Any) -> World:
    """A world with one body on a path, begun at (1, 2)."""
    body = {"id": "lift", "type": "kinematic", "position": [1, 2], "shapes": [{"box": [2, 0.2]}], "path": path}
    return World(Scene(bodies=[{**body, **fields}, *others]))


def pose_at(path: FlatPath, seconds: float) -> tuple[float, float, float]:
    """Where a path is after so many seconds: x and y (m) and angle (rad) from its origin."""
    ways, stops = map(plain_rows, ways_of([path]))
    return interpreted(place_after)(ways[0], stops, seconds)


def heights(path: dict[str, Any], *times: float) -> list[float]:
    return [pose_at(BodyPath(**path).flat(), time)[1] for time in times]


class TestPlaces:
    def test_times(self):
        path = {"to": [[0, 2], [0, 3]], "times": [1, 3]}
        assert heights(path, 0, 0.5, 1, 2, 3, 9) == [0, 1, 2, 2.5, 3, 3]

    def test_a_speed_and_pauses(self):
        path = {"to": [[0, 2], [0, 3]], "speed": 2, "pause": 1}
        assert heights(path, 0.5, 1.5, 2, 2.5, 3, 3.25, 3.5, 4, 9) == [0, 1, 2, 2, 2, 2.5, 3, 3, 3]

    def test_a_loop_goes_on_to_its_first_place(self):
        path = {"to": [[0, 2]], "times": [1, 3], "mode": "loop"}
        assert heights(path, 0, 0.5, 1, 2, 3, 3.5, 30.5) == [0, 1, 2, 1, 0, 1, 1]
        path = {"to": [[0, 2]], "speed": 2, "pause": 0.5, "mode": "loop"}
        assert heights(path, 0.25, 1, 1.5, 1.75, 2, 2.5, 3, 3.25, 4) == [0, 1, 2, 2, 2, 1, 0, 0, 1]

    def test_ping_pong_goes_back_the_way_it_came(self):
        path = {"to": [[0, 2], [0, 3]], "times": [1, 3], "mode": "ping-pong"}
        assert heights(path, 0.5, 2, 3, 4, 5, 5.5, 6, 6.5) == [1, 2.5, 3, 2.5, 2, 1, 0, 1]
        path = {"to": [[0, 2]], "speed": 2, "pause": 1, "mode": "ping-pong"}
        assert heights(path, 0.5, 1.5, 2.5, 3.5, 4, 4.5, 5.5) == [0, 1, 2, 1, 0, 0, 1]

    def test_smooth_legs_begin_and_end_at_rest(self):
        path = {"to": [[0, 1]], "times": [1], "easing": "smooth"}
        assert heights(path, 0, 0.25, 0.5, 0.75, 1) == [0, 0.15625, 0.5, 0.84375, 1]

    def test_angles_go_with_the_places(self):
        path = BodyPath(to=[[0, 0], [1, 0]], times=[1, 2], turn=[90, 0]).flat()
        assert pose_at(path, 0.5) == pytest.approx((0, 0, 0.7853982))
        assert pose_at(path, 1.5) == pytest.approx((0.5, 0, 0.7853982))


class TestBodies:
    def test_poses_are_exact_whatever_the_frame(self):
        path = {"to": [[3, 0.7]], "times": [1.7], "turn": [130], "mode": "ping-pong", "easing": "smooth"}
        w = lift(path, shapes=[{"box": [1, 1], "at": [0.7, 0.3]}], angle=30)
        flat = w.flat.bodies[0].path
        assert flat is not None
        for step in range(1, 400):
            w.step()
            x, y, angle = pose_at(flat, step * float(w.state.settings[0].step_seconds))
            row = w.state.bodies[0]
            assert (row.position_x, row.position_y) == (1 + x, 2 + y)
            assert row.angle == w.flat.bodies[0].angle + angle

    def test_what_rides_on_it_is_carried_and_wakes_when_it_sets_off(self):
        crate = {"id": "crate", "position": [1, 2.6], "shapes": [{"box": [1, 1], "friction": 0.8}]}
        w = lift({"to": [[0, 0], [3, 2]], "times": [4, 8], "easing": "smooth"}, crate)
        w.step(239)
        assert not w.state.bodies[1].awake
        w.step(240)
        assert w.body("crate").position == pytest.approx((4.0, 4.6), abs=0.02)
        w.step(120)
        assert not w.state.bodies[1].awake

    def test_commands_stop_it_and_let_it_go_on(self):
        w = lift({"to": [[0, 4]], "times": [4], "enabled": False})
        w.step(60)
        assert w.body("lift").position == (1.0, 2.0)
        w.apply(SetPath("lift", enabled=True))
        w.step(60)
        assert w.body("lift").position == pytest.approx((1.0, 3.0))
        w.apply(SetPath("lift", enabled=False))
        w.step(60)
        assert w.body("lift").position == pytest.approx((1.0, 3.0))
        assert w.body("lift").velocity == (0.0, 0.0)
        w.apply(SetPath("lift", enabled=True, time=3.0))
        w.step()
        assert w.body("lift").position == pytest.approx((1.0, 5.0 + 1 / 60))

    def test_one_that_is_spawned_goes_its_way_from_there(self):
        w = World(Scene(prefabs={"lift": {"type": "kinematic", "shapes": [{"circle": 1}],
                                          "path": {"to": [[1, 0]], "speed": 1}}}))  # fmt: skip
        w.step(10)
        w.spawn([{"id": name, "prefab": "lift", "position": [x, 0]} for name, x in [("a", 0), ("b", 5), ("c", 9)]])
        w.delete("b")
        w.step(30)
        assert w.body("a").position[0] == pytest.approx(0.5)
        assert w.body("c").position[0] == pytest.approx(9.5)
        again = World(w.scene)
        again.restore(w.snapshot())
        for world in (w, again):
            world.step(40)
        assert w.digest() == again.digest()
        assert w.body("c").position[0] == 10.0

    def test_who_has_none_refuses(self):
        w = lift({"to": [[0, 4]], "times": [4]}, {"id": "crate", "shapes": [{"circle": 1}]})
        with pytest.raises(CommandError, match="the body has no path; give it one in the scene"):
            w.apply(SetPath("crate", enabled=True))
        with pytest.raises(CommandError, match="time must not be negative"):
            w.apply(SetPath("lift", time=-1.0))


coordinates = st.floats(-50, 50, width=32)


@example([(0.0, 31.0), (0.0, 0.0), (0.0, 0.0)], 2.0, 0.8620276963672764, "once", False, 0.0)
@given(st.lists(st.tuples(coordinates, coordinates), min_size=1, max_size=5), st.floats(0.1, 9), st.floats(0, 2),
       st.sampled_from(["once", "loop", "ping-pong"]), st.booleans(), st.floats(0, 1e4))  # fmt: skip
@examples(200)
def test_a_path_stays_among_its_places_and_comes_to_each(places, speed, pause, mode, smooth, seconds):
    if all(place == (0, 0) for place in places):
        places[0] = (1, 0)
    path = BodyPath(to=places, speed=speed, pause=pause, mode=mode, easing="smooth" if smooth else "linear").flat()
    for axis in (0, 1):
        values = [0.0, *(place[axis] for place in places)]
        assert min(values) - 1e-9 <= pose_at(path, seconds)[axis] <= max(values) + 1e-9
    assert list(path.times) == sorted(path.times)
    for time, point in zip(path.times[:-1], path.points, strict=False):
        assert pose_at(path, time) == pytest.approx(point, abs=1e-6)

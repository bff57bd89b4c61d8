"""What rules see and do, one thing at a time."""

from __future__ import annotations

from typing import Any

import pytest

from sandbox.engine.commands.delete import Delete
from tests.rules.games import add, ball, game, told, wall

UP = ball(velocity=[0, 6])


class TestTriggers:
    def test_a_hit_names_both_bodies_in_the_order_of_the_rule(self):
        w = game(
            [{"id": "r", "when": {"hit": ["wall-*", "ball"]}, "do": [{"delete": "@first"}, add()]}],
            bodies=[UP, wall("wall-1", 1), wall("wall-2", -1)],
        )
        w.step(15)
        assert w.names == ("ball", "wall-2")
        assert w.counters == {"n": 1}

    def test_a_hit_that_is_too_slow_or_weak_is_none(self):
        mass = 3.14159 * 0.2**2
        for least, count in [
            ({"speed": 5.9}, 1), ({"speed": 6.1}, 0), ({"impulse": 11.9 * mass}, 1), ({"impulse": 12.1 * mass}, 0),
        ]:  # fmt: skip
            w = game([{"when": {"hit": ["ball", "wall"], **least}, "do": [add()]}], bodies=[UP, wall("wall", 1)])
            w.step(20)
            assert w.counters["n"] == count, least

    def test_contacts_begin_and_end(self):
        rules = [{"when": {kind: ["ball", "wall"]}, "do": [add(value)]} for kind, value in [("begin", 1), ("end", 10)]]
        w = game(rules, bodies=[UP, wall("wall", 1)])
        w.step(30)
        assert w.counters["n"] == 11

    def test_a_sensor_is_entered_and_left_once_by_a_body_of_many_shapes(self):
        train = {"id": "train", "position": [-3, 0], "velocity": [6, 0], "shapes": [
            {"circle": 0.2}, {"circle": 0.2, "at": [-0.3, 0]}, {"circle": 0.2, "at": [-0.6, 0]}]}  # fmt: skip
        gate = {"id": "gate", "type": "static", "shapes": [{"box": [0.2, 2], "sensor": True}]}
        rules = [{"when": {kind: ["gate", "*"]}, "do": [add(value)]} for kind, value in [("enter", 1), ("leave", 10)]]
        w = game(rules, bodies=[gate, train])
        w.step(20)
        assert w.counters["n"] == 0
        w.step(12)
        assert w.counters["n"] == 1
        w.step(60)
        assert w.counters["n"] == 11

    def test_a_joint_breaks(self):
        w = game(
            [{"when": {"joint_break": "pin*"}, "do": [add()]}, {"when": {"time": 0.1}, "do": [{"break_joint": "pin"}]}],
            joints=[{"id": "pin", "type": "revolute", "bodies": ["ball"], "anchor": [0, 0]}],
        )
        w.step(6)
        assert w.counters["n"] == 0
        w.step(2)
        assert w.counters["n"] == 1
        assert w.joint("pin").broken

    @pytest.mark.parametrize(
        ("when", "steps"),
        [
            ({"time": 0}, [1]),
            ({"time": 0.5}, [30]),
            ({"every": 0.5}, [30, 60, 90]),
            ({"every": 0.5, "start": 0.1}, [6, 36, 66, 96]),
            ({"every": 0.001, "start": 1.6}, [96, 97, 98, 99, 100]),
        ],
    )
    def test_time(self, when: dict[str, Any], steps: list[int]):
        w = game([{"when": when, "do": [add()]}])
        found = []
        for step in range(1, 101):
            before = w.counters["n"]
            w.step()
            found += [step] * int(w.counters["n"] - before)
        assert found == steps

    @pytest.mark.parametrize(
        ("changes", "value", "count"),
        [([1, 1, 1], 2, 1), ([5], 2, 1), ([-1, -3], -2, 1), ([2, -2, 2], 2, 2), ([1, 1], 0, 0), ([3, -3], 0, 1)],
    )
    def test_a_counter_reaches_a_value_from_below_or_above(self, changes: list[float], value: float, count: int):
        rules = [{"when": {"time": 0.1 * (k + 1)}, "do": [add(change)]} for k, change in enumerate(changes)]
        rules.append({"when": {"count": "n", "reaches": value}, "do": [{"counter": "m", "add": 1}]})
        w = game(rules, counters={"n": 0, "m": 0})
        w.step(60)
        assert w.counters["m"] == count

    def test_counters_lead_to_counters_in_one_step_but_each_rule_once(self):
        rules = [
            {"when": {"time": 0.1}, "do": [add()]},
            {"when": {"count": "n", "reaches": 1}, "do": [{"counter": "m", "add": 1}]},
            {"when": {"count": "m", "reaches": 1}, "do": [{"counter": "n", "set": 0}, {"counter": "n", "set": 1}]},
        ]
        w = game(rules, counters={"n": 0, "m": 0})
        w.step(10)
        assert w.counters == {"n": 1, "m": 1}


class TestRules:
    def test_all_see_what_happened_though_one_deletes_it(self):
        rules = [
            {"when": {"hit": ["ball", "wall"]}, "do": [{"delete": ["@first", "@second"]}]},
            {"when": {"hit": ["ball", "wall"]}, "do": [{"delete": ["@first", "@second"]}, add()]},
        ]
        w = game(rules, bodies=[UP, wall("wall", 1)])
        w.step(30)
        assert w.names == ()
        assert w.counters["n"] == 1

    def test_limit_and_cooldown(self):
        w = game([{"when": {"every": 0.1}, "do": [add()], "limit": 4, "cooldown": 0.25}])
        w.step(60)
        assert w.counters["n"] == 4  # steps 6, 24, 42, 60
        w.step(60)
        assert w.counters["n"] == 4

    def test_only_if_a_counter_is_in_a_range(self):
        w = game([
            {"when": {"every": 0.1}, "do": [add()]},
            {"when": {"every": 0.1}, "if": {"counter": "n", "least": 2, "most": 3}, "do": [{"counter": "m", "add": 1}]},
            {"when": {"every": 0.1}, "if": {"counter": "n", "equals": 5}, "do": [{"counter": "m", "add": 10}]},
        ], counters={"n": 0, "m": 0})  # fmt: skip
        w.step(60)
        assert w.counters == {"n": 10, "m": 12}

    def test_only_if_two_touch(self):
        w = game(
            [{"when": {"every": 0.1}, "if": {"touches": ["floor", "ball"]}, "do": [add()]}],
            bodies=[ball(position=[0, 1.7], shapes=[{"circle": 0.2}]), wall("floor", 0, shapes=[{"box": [4, 0.4]}])],
            gravity=(0, -10),
        )
        w.step(28)  # it falls 1.3 m, half a second
        assert w.counters["n"] == 0
        w.step(60)
        assert w.counters["n"] == 9  # steps 36 to 84

    def test_a_deleted_body_comes_apart_from_nothing(self):
        w = game(
            [{"when": {"end": ["ball", "*"]}, "do": [add()]}],
            bodies=[ball(position=[0, 0.4]), wall("floor", 0)],
            gravity=(0, -10),
        )
        w.step(30)
        w.apply(Delete("floor"))
        w.step(5)
        assert [event["event"] for event in w.events if event["event"] == "end"] == []
        assert w.counters["n"] == 0

    def test_the_first_outcome_stays(self):
        rules = [{"when": {"time": 0.1}, "do": [{"win": "well done"}]}, {"when": {"time": 0.2}, "do": [{"lose": "no"}]}]
        w = game(rules)
        assert w.outcome is None
        w.step(6)
        assert [told(w, "win")[0]["text"], w.outcome] == ["well done", w.outcome]
        w.step(30)
        assert w.outcome is not None
        assert (w.outcome.result, w.outcome.text, w.outcome.step) == ("won", "well done", 6)


class TestActions:
    def do(self, *actions: dict[str, Any], steps: int = 1, **fields: Any):
        w = game([{"id": "r", "when": {"time": 0}, "do": list(actions)}], **fields)
        w.step(steps)
        return w

    def test_an_impulse_and_a_force_push(self):
        w = self.do({"impulse": [1, 2], "of": "ball", "turning": 0.5}, bodies=[ball(mass=2, inertia=1)])
        assert w.body("ball").velocity == pytest.approx((0.5, 1.0))
        assert w.body("ball").angular_velocity == pytest.approx(0.5)
        w = self.do({"force": [60, 0], "of": "ball"}, steps=2, bodies=[ball(mass=2)])
        assert w.body("ball").velocity == pytest.approx((0.5, 0.0))

    def test_a_velocity_may_leave_a_part_as_it_is(self):
        w = self.do({"velocity": [None, 3], "of": "*"}, bodies=[ball(velocity=[1, 1], angular_velocity=90)])
        assert w.body("ball").velocity == pytest.approx((1.0, 3.0))
        assert w.body("ball").angular_velocity == pytest.approx(1.5707963)

    def test_pushes_along_places_and_bodies(self):
        target = wall("target", 4)
        w = self.do({"velocity": [2, 0], "of": "ball", "along": "target"}, bodies=[BALL_AT_0, target])
        assert w.body("ball").velocity == pytest.approx((0.0, 2.0))
        w = self.do({"velocity": [2, 0], "of": "ball", "along": "target", "reach": 8}, bodies=[BALL_AT_0, target])
        assert w.body("ball").velocity == pytest.approx((0.0, 1.0))
        w = self.do({"velocity": [2, 0], "of": "ball", "along": "@self"}, bodies=[ball(angle=90)])
        assert w.body("ball").velocity == pytest.approx((0.0, 2.0))
        w = self.do({"velocity": [10, 0], "of": "ball", "along": "@motion"}, bodies=[ball(velocity=[3, 4])])
        assert w.body("ball").velocity == pytest.approx((6.0, 8.0))

    def test_bodies_are_put_somewhere(self):
        w = self.do({"put": "ball", "at": [3, 4], "angle": 180}, bodies=[ball(velocity=[1, 0])])
        assert w.body("ball").position == pytest.approx((3.0, 4.0))
        assert w.body("ball").angle == pytest.approx(3.14159265)
        assert w.body("ball").velocity == pytest.approx((1.0, 0.0))

    def test_a_spawned_body_comes_in_the_frame_of_another(self):
        gun = {"id": "gun", "position": [2, 1], "angle": 90, "shapes": [{"circle": 0.3}]}
        shot = {"id": "shot", "position": [1, 0], "velocity": [5, 0], "shapes": [{"circle": 0.1}]}
        w = self.do({"spawn": shot, "at": "gun"}, bodies=[gun])
        assert w.names == ("gun", "shot-1")
        assert w.body("shot-1").position == pytest.approx((2.0, 2.0))
        assert w.body("shot-1").velocity == pytest.approx((0.0, 5.0))
        assert told(w, "spawn") == [{"event": "spawn", "step": 1, "body": "shot-1", "by": "r"}]

    def test_not_more_are_spawned_than_may_be_there_nor_too_soon(self):
        shot = {"id": "shot", "position": [1, 0], "velocity": [0, 9], "shapes": [{"circle": 0.1}]}
        w = game([{"when": {"every": 0.1}, "do": [{"spawn": shot, "limit": 3, "every": 0.15}]}])
        w.step(24)
        assert w.names == ("ball", "shot-1", "shot-2")
        w.step(60)
        assert w.names == ("ball", "shot-1", "shot-2", "shot-3")
        w.delete("shot-2")
        w.step(12)
        assert w.names == ("ball", "shot-1", "shot-3", "shot-4")

    def test_ids_that_are_taken_are_passed_over(self):
        shot = {"id": "shot", "shapes": [{"circle": 0.1}]}
        w = game(
            [{"when": {"every": 0.1}, "do": [{"spawn": shot}]}], bodies=[ball(), ball(id="shot-2", position=[9, 9])]
        )
        w.step(12)
        assert w.names == ("ball", "shot-2", "shot-1", "shot-3")

    def test_settings_change(self):
        w = self.do(
            {"surface": {"friction": 0.9}, "of": "ball"}, {"thruster": True, "of": "ball", "thrust": [6, 0]},
            {"joint": "pin", "motor_speed": 90}, {"region": "air", "enabled": False, "set": {"wind": [1, 2]}},
            {"gravity": [0, -3]}, {"path": "lift", "enabled": False, "time": 0.5},
            bodies=[
                ball(thrusters=[{"force": [1, 0]}]),
                {"id": "wheel", "position": [3, 0], "shapes": [{"circle": 1}]},
                {"id": "lift", "type": "kinematic", "position": [9, 0], "shapes": [{"circle": 1}],
                 "path": {"to": [[0, 1]], "speed": 1}},
            ],
            joints=[{"id": "pin", "type": "revolute", "bodies": ["wheel"], "anchor": [3, 0], "motor_speed": 0}],
            regions=[{"id": "air", "wind": [0, 0]}],
        )  # fmt: skip
        assert told(w, "refused") == []
        assert w.state.shapes.friction[0] == 0.9
        assert w.state.thrusters[0].force_x == 6.0
        assert w.state.joints[0].motor_speed == pytest.approx(1.5707963)
        assert w.state.regions[0].end_step == 1
        assert w.gravity == (0.0, -3.0)
        assert (w.state.paths[0].enabled, w.state.paths[0].steps) == (0, 30)

    def test_an_explosion_pushes_away(self):
        w = self.do({"explode": 1, "at": [-1, 0], "radius": 3}, bodies=[BALL_AT_0])
        assert w.body("ball").velocity[0] > 0.1

    def test_what_is_refused_is_told_and_changes_nothing(self):
        w = self.do({"impulse": [1, 0], "of": "wall"}, add(), bodies=[wall("wall", 0)])
        (refused,) = told(w, "refused")
        assert "only a dynamic body can be pushed" in refused["text"]
        assert refused["by"] == "r"
        assert w.counters["n"] == 1


BALL_AT_0 = ball()

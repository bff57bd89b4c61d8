"""How the cost of each stage grows with the size of a scene: twice as much four times over, and the exponent of it.

`python -m pytest -m benchmark -s tests/benchmarks/test_growth.py`
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Iterator
from functools import cache

import numpy as np
import pytest

import sandbox
from sandbox._jit import entry_point, kernel_argument
from sandbox.bench.stages import TimedCalls
from sandbox.engine.broad_phase.fat_boxes import SLACK
from sandbox.engine.broad_phase.pair_cache import select_pairs, update_pair_cache
from sandbox.engine.broad_phase.proxies import bound_some_shapes
from sandbox.engine.records.state import StateTables
from tests.benchmarks.test_narrow_phase import nanoseconds_a_pair

pytestmark = pytest.mark.benchmark

ROWS = 10
BOXES = ROWS * (ROWS + 1) // 2
PYRAMIDS = (8, 16, 32, 64, 128)
"""Pyramids side by side: contacts, islands and colours of each are those of one."""
TURNS = 30

Words = dict[str, object]


def pyramids(count: int) -> sandbox.Scene:
    width = 12.0 * count
    return sandbox.Scene(
        prefabs={"box": {"shapes": [{"box": [1, 1], "friction": 0.6}]}},
        bodies=[{"id": "ground", "type": "static", "shapes": [{"box": [width, 1]}], "position": [width / 2, -0.5]}],
        generate=[{"id": f"p{k}", "pyramid": "box", "rows": ROWS, "at": [12.0 * k + 6.0, 0.5]} for k in range(count)],
        settings={"sleeping": False},
    )


@cache
def settled(count: int) -> sandbox.World:
    """A world of pyramids after 20 steps, whose stages are timed."""
    world = sandbox.World(pyramids(count))
    TimedCalls.in_place(world)
    world.step(20)
    return world


@entry_point
def broad_phase(state, active, colliders, joint_filter, grid, valid):
    """Inner kernels are not for Python to call: boxes and proxies, the grid unless the cached pairs are `valid`, the
    pairs and their order."""
    shapes = state.shapes.shape[0]
    bound_some_shapes(state, active.shapes, True, colliders, grid)
    grid.cache.info[0].valid = valid
    seconds = state.settings[0].step_seconds
    update_pair_cache(colliders, active.shapes, shapes, seconds, SLACK, grid)
    return select_pairs(colliders, seconds, joint_filter, grid)


def fastest(run: Callable[[], object], turns: int = TURNS) -> float:
    """Seconds of the quickest turn, as what else runs on the machine only ever adds; the first of all compiles."""
    run()
    times = []
    for _ in range(turns):
        start = time.perf_counter()
        run()
        times.append(time.perf_counter() - start)
    return min(times)


def tell(stage: str, seconds: dict[int, float]) -> float:
    """Print microseconds for each number of boxes, and the exponent of growth: 1 is in proportion, 2 quadratic."""
    sizes, costs = np.log(list(seconds)), np.log(list(seconds.values()))
    exponent = float(np.polyfit(sizes, costs, 1)[0])
    told = ", ".join(f"{size:,}: {1e6 * cost:,.0f}" for size, cost in seconds.items())
    print(f"\n{stage}, us by boxes: {told}; exponent {exponent:.2f}")
    return exponent


def test_broad_phase() -> None:
    seconds, again, pairs = {}, {}, {}
    for count in PYRAMIDS:
        world = settled(count)
        tables = StateTables(*(getattr(world.state, name) for name in StateTables._fields))
        scratch = world.scratch
        bundles = (tables, scratch.active, scratch.colliders, scratch.joint_filter, scratch.grid)
        arguments = [kernel_argument(bundle) for bundle in bundles]
        seconds[count * BOXES] = fastest(lambda arguments=arguments: broad_phase(*arguments, 0))
        again[count * BOXES] = fastest(lambda arguments=arguments: broad_phase(*arguments, 1))
        pairs[count] = broad_phase(*arguments, 1)
    assert math.isfinite(tell("proxies, grid and pairs", seconds))
    assert math.isfinite(tell("proxies and cached pairs", again))
    assert [pairs[count] for count in PYRAMIDS] == [count // PYRAMIDS[0] * pairs[PYRAMIDS[0]] for count in PYRAMIDS]


def test_narrow_phase() -> None:
    found = {count: nanoseconds_a_pair(settled(count)) for count in PYRAMIDS}
    seconds = {count * BOXES: 1e-9 * cost * pairs for count, (cost, pairs) in found.items()}
    assert math.isfinite(tell("narrow phase", seconds))
    assert found[PYRAMIDS[-1]][1] == PYRAMIDS[-1] // PYRAMIDS[0] * found[PYRAMIDS[0]][1]


@pytest.mark.parametrize("part", ["collide", "solve"])
def test_half_of_the_step(part: str) -> None:
    seconds = {}
    for count in PYRAMIDS:
        world = settled(count)
        calls = world._stepper.calls
        assert isinstance(calls, TimedCalls)
        times = []
        for _ in range(TURNS):
            calls.forget_times()
            world.step()
            times.append(calls.seconds[part])
            assert calls.counts[part] == 1
        seconds[count * BOXES] = min(times)
    assert math.isfinite(tell(f"{part}, a step", seconds))


def test_building_a_world() -> None:
    seconds = {}
    for count in PYRAMIDS:
        scene = pyramids(count)
        seconds[count * BOXES] = fastest(lambda scene=scene: sandbox.World(scene), turns=3)
        assert len(sandbox.World(scene).bodies) == count * BOXES + 1
    assert math.isfinite(tell("building a World", seconds))


def test_reading_a_scene() -> None:
    seconds = {}
    for count in PYRAMIDS:
        text = pyramids(count).model_dump_json(by_alias=True, exclude_unset=True)
        seconds[count * BOXES] = fastest(lambda text=text: sandbox.loads_scene(text), turns=3)
        assert len(sandbox.loads_scene(text).flatten().bodies) == count * BOXES + 1
    assert math.isfinite(tell("reading a scene", seconds))


def test_spawning_one_among_many() -> None:
    seconds = {}
    for count in PYRAMIDS:
        world = sandbox.World(pyramids(count))
        turn = iter(range(1000))

        def spawn(world: sandbox.World = world, turn: object = turn) -> None:
            world.spawn({"id": f"new-{next(turn)}", "shapes": [{"circle": 0.5}], "position": [0, 50]})

        seconds[count * BOXES] = fastest(spawn, turns=10)
        assert len(world.bodies) == count * BOXES + 1 + 11
    assert math.isfinite(tell("spawning one body among so many", seconds))


def test_pushing_one_among_many() -> None:
    """Each of a thousand bodies that are awake gets a velocity, as a game does in every step."""
    seconds = {}
    for count in PYRAMIDS:
        world = sandbox.World(pyramids(count))
        world.step(2)
        commands = [sandbox.SetVelocity(name, (0.0, 0.0), 0.0) for name in world.names[1:] * 3][:1000]
        seconds[count * BOXES] = fastest(lambda world=world, all_of=commands: [*map(world.apply, all_of)], 5) / 1000
    assert math.isfinite(tell("setting the velocity of one body among so many", seconds))


def test_deleting_one_among_many() -> None:
    seconds = {}
    for count in PYRAMIDS:
        world = sandbox.World(pyramids(count))
        world.step()
        names = iter(world.names[-20:])
        seconds[count * BOXES] = fastest(lambda world=world, names=names: world.delete(next(names)), turns=10)
        assert len(world.bodies) == count * BOXES + 1 - 11
    assert math.isfinite(tell("deleting one body among so many", seconds))


def ragdolls(name: str) -> tuple[list[Words], list[Words]]:
    """25 bodies with ten others each, on hinges with stops."""
    bodies: list[Words] = []
    joints: list[Words] = []
    for k in range(25):
        ids = [f"{name}-{k}-{part}" for part in range(11)]
        bodies += [
            {"id": each, "shapes": [{"box": [0.4, 0.2]}], "position": [8.0 * k + 0.5 * part, 50.0]}
            for part, each in enumerate(ids)
        ]
        hinge: Words = {"type": "revolute", "anchor": [8.0 * k, 50.0], "lower": -20}
        joints += [{**hinge, "id": f"{each}-joint", "bodies": [ids[0], each]} for each in ids[1:]]
    return bodies, joints


def test_spawning_ragdolls_among_many() -> None:
    seconds = {}
    for count in PYRAMIDS:
        world = sandbox.World(pyramids(count))
        crowds = iter([ragdolls(f"crowd-{turn}") for turn in range(6)])
        seconds[count * BOXES] = fastest(lambda world=world, crowds=crowds: world.spawn(*next(crowds)), turns=5)
        assert len(world.bodies) == count * BOXES + 1 + 6 * 275
        assert len(world.state.joints) == 6 * 250
    assert math.isfinite(tell("spawning 25 ragdolls among so many", seconds))


def test_spawning_many_at_once() -> None:
    seconds = {}
    for count in PYRAMIDS:
        many = [
            {"id": f"new-{k}", "shapes": [{"circle": 0.5}], "position": [float(k), 50.0]} for k in range(count * BOXES)
        ]
        worlds = [sandbox.World(pyramids(1)) for _ in range(4)]
        fresh = iter(worlds)
        seconds[count * BOXES] = fastest(lambda fresh=fresh, many=many: next(fresh).spawn(many), turns=3)
        assert all(len(world.bodies) == BOXES + 1 + count * BOXES for world in worlds)
    assert math.isfinite(tell("spawning so many bodies at once", seconds))


CHANGES: dict[str, Callable[[int], sandbox.Command]] = {
    "spawning a ball": lambda k: sandbox.Spawn({"id": f"ball-{k}", "shapes": [{"circle": 0.3}], "position": [k, 9]}),
    "spawning a tile": lambda k: sandbox.Spawn({"id": f"new-{k}", "prefab": "tile", "position": [k, 20]}),
    "moving a tile": lambda k: sandbox.SetPose(f"tile-{k}", (float(k), 30.0), 0.0),
    "deleting a ball": lambda k: sandbox.Delete(f"ball-{k}"),
    "deleting the last tile": lambda k: sandbox.Delete(f"new-{k}"),
    "deleting one of the first tiles": lambda k: sandbox.Delete(f"tile-{k}"),
    "spawning two balls with a hinge": lambda k: sandbox.Spawn(*hinged_pair(k)),
    "deleting a hinge": lambda k: sandbox.DeleteJoint(f"hinge-{k}"),
    "deleting a ball where there are hinges": lambda k: sandbox.Delete(f"left-{k}"),
}


def hinged_pair(k: int) -> tuple[list[Words], list[Words]]:
    names = [f"left-{k}", f"right-{k}"]
    balls = [{"id": name, "shapes": [{"circle": 0.3}], "position": [k + 0.5 * n, 40]} for n, name in enumerate(names)]
    return balls, [{"id": f"hinge-{k}", "type": "revolute", "bodies": names, "anchor": [k + 0.25, 40]}]


def test_changes_among_static_tiles() -> None:
    """Each with the step after it, one after the other; a ball and the last tile go from the end of the tables, the
    first ones from where all others close up. In the end some balls hang together."""
    seconds: dict[str, dict[int, float]] = {name: {} for name in CHANGES}
    for count in (2000, 4000, 8000, 16000, 32000):
        tiles = [{"id": f"tile-{k}", "prefab": "tile", "position": [k % 200, -(k // 200)]} for k in range(count)]
        prefabs = {"tile": {"type": "static", "shapes": [{"box": [1, 1]}]}}
        world = sandbox.World(sandbox.Scene(prefabs=prefabs, bodies=tiles, settings={"sleeping": False}))
        for name, make in CHANGES.items():
            turn = iter(range(1000))

            def change(world: sandbox.World = world, make: Callable = make, turn: Iterator[int] = turn) -> None:
                world.apply(make(next(turn)))
                world.step()

            seconds[name][count] = fastest(change, turns=12)
        assert len(world.bodies) == count
    for name, costs in seconds.items():
        assert math.isfinite(tell(f"{name} among so many tiles, with a step", costs))


AMONG_SLEEPERS: dict[str, Callable[[int, int], sandbox.Command]] = {
    "spawning a ball": lambda k, _: sandbox.Spawn({"id": f"ball-{k}", "shapes": [{"circle": 0.3}], "position": [k, 9]}),
    "deleting a ball": lambda k, _: sandbox.Delete(f"ball-{k}"),
    "pushing a sleeper": lambda k, count: sandbox.ApplyImpulse(f"box-{k * 7919 % count}", (0.01, 0.0)),
    "joining two sleepers": lambda k, _: sandbox.Spawn(joints=hinge_of_sleepers(k)),
    "deleting their joint": lambda k, _: sandbox.DeleteJoint(f"hinge-{k}"),
    "deleting one of the first": lambda k, _: sandbox.Delete(f"box-{2 * k}"),
}


def hinge_of_sleepers(k: int) -> list[Words]:
    x = 2.0 * (2 * k + 100)
    names = [f"box-{2 * k + 100}", f"box-{2 * k + 101}"]
    return [{"id": f"hinge-{k}", "type": "revolute", "bodies": names, "anchor": [x + 1.0, 0.5]}]


def test_changes_among_sleepers() -> None:
    """Each with the step after it, one after the other, among boxes that sleep on grounds of a thousand each."""
    seconds: dict[str, dict[int, float]] = {name: {} for name in AMONG_SLEEPERS}
    for count in (4000, 8000, 16000, 32000, 64000):
        ground = {"type": "static", "shapes": [{"box": [2100, 2]}]}
        floors = [{**ground, "id": f"floor-{f}", "position": [1000, 40 * f - 1]} for f in range(count // 1000)]
        box = {"shapes": [{"box": [1, 1]}]}
        boxes = [{**box, "id": f"box-{k}", "position": [2 * (k % 1000), 0.5 + 40 * (k // 1000)]} for k in range(count)]
        world = sandbox.World(sandbox.Scene(bodies=[*floors, *boxes], settings={"sleeping": True}))
        world.step(100)
        assert world.awake_count == 0
        for name, make in AMONG_SLEEPERS.items():
            turn = iter(range(1000))

            def change(
                world: sandbox.World = world, make: Callable = make, turn: Iterator[int] = turn, count: int = count
            ) -> None:
                world.apply(make(next(turn), count))
                world.step()

            seconds[name][count] = fastest(change, turns=12)
        assert len(world.bodies) == count + count // 1000 - 13
    for name, costs in seconds.items():
        assert math.isfinite(tell(f"{name} among so many sleepers, with a step", costs))


@pytest.mark.parametrize("tiles", [2000, 20000])
def test_steps_of_what_has_fallen_off_a_level(tiles: int) -> None:
    """By how fast it falls, where all else lies still behind it: each doubling takes as many steps as all before."""
    level = [
        {"id": f"tile-{k}", "type": "static", "shapes": [{"box": [1, 1]}], "position": [k, 0]} for k in range(tiles)
    ]
    balls = [{"id": f"b{k}", "shapes": [{"circle": 0.5}], "position": [-10 - 2 * k, 5 + k % 7 * 3]} for k in range(200)]
    world = sandbox.World(sandbox.Scene(bodies=[*level, *balls], settings={"sleeping": False}))
    seconds: dict[int, float] = {}
    for steps in (600, 1200, 2400, 4800, 9600):
        world.step(steps - world.step_count - 200)
        start = time.process_time()
        world.step(200)
        seconds[round(-world.body("b0").velocity[1])] = (time.process_time() - start) / 200
    told = ", ".join(f"{speed:,} m/s: {1e6 * cost:,.0f}" for speed, cost in seconds.items())
    print(f"\n200 balls that fall past {tiles:,} tiles, us a step: {told}")
    assert max(seconds) > 10 * min(seconds)

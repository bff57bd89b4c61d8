"""Scenes that nobody tuned the engine for, each in any size: what people build that no engine's own benchmarks have.

A scene of size 1 has some hundreds to thousands of bodies, one of size n about n times as many.
"""

from __future__ import annotations

import math
import random
from collections.abc import Callable, Iterable
from typing import Any

import sandbox

Words = dict[str, Any]
Parts = tuple[list[Words], list[Words]]
"""Bodies and joints."""


def pit(width: float, **surface: float) -> list[Words]:
    """A floor at height 0 and two walls."""
    sides = [
        (-0.5 * width - 1.0, 100.0, 2.0, 200.0),
        (0.5 * width + 1.0, 100.0, 2.0, 200.0),
        (0.0, -1.0, width + 4, 2.0),
    ]
    return [
        {"id": f"side{k}", "type": "static", "position": [x, y], "shapes": [{"box": [w, h], **surface}]}
        for k, (x, y, w, h) in enumerate(sides)
    ]


def heap(shapes: Iterable[Words], width: float, pitch: float, **surface: float) -> list[Words]:
    """Bodies of one shape each, row upon row in a pit."""
    across = int(width / pitch) - 1
    found = pit(width, **surface)
    for k, shape in enumerate(shapes):
        x, y = (k % across - 0.5 * across + 0.5) * pitch, (k // across + 0.5) * pitch
        found.append({"id": f"b{k}", "position": [x + 0.01 * (k % 7), y], "shapes": [{**shape, **surface}]})
    return found


def hinge(name: str, bodies: list[str], x: float, y: float) -> Words:
    return {"id": name, "type": "revolute", "bodies": bodies, "anchor": [x, y]}


def rope(name: str, links: int, x: float, y: float, down: bool) -> Parts:
    """Links of 0.25 m from a hinge in the world on, straight down or level."""
    bodies, joints = [], []
    for k in range(links):
        along = 0.25 * (k + 0.5)
        place = [x, y - along] if down else [x + along, y]
        end = [0.0, 0.1] if down else [0.1, 0.0]
        capsule = {"capsule": [[-end[0], -end[1]], end], "radius": 0.05}
        bodies.append({"id": f"{name}-{k}", "position": place, "shapes": [capsule]})
        held = [f"{name}-{k - 1}", f"{name}-{k}"] if k else [f"{name}-0"]
        joints.append(hinge(f"{name}-j{k}", held, x if down else x + 0.25 * k, y - 0.25 * k if down else y))
    return bodies, joints


def together(parts: Iterable[Parts]) -> Parts:
    bodies, joints = [], []
    for more, links in parts:
        bodies += more
        joints += links
    return bodies, joints


def ropes(size: int) -> Parts:
    """Side by side, each swung a little: some touch."""
    bodies, joints = together(rope(f"r{q}", 40, 0.6 * q, 0.0, True) for q in range(50 * size))
    push = random.Random(5)
    for body in bodies:
        body["velocity"] = [push.uniform(-3.0, 3.0), 0.0]
    return bodies, joints


def one_rope(size: int) -> Parts:
    return rope("r", 1000 * size, 0.0, 0.0, False)


def cloth(size: int, side: int = 50, **spring: float) -> Parts:
    """Discs in a square net of rods or springs, that hangs from every fifth disc of its upper edge."""
    n = int(side * math.sqrt(size))
    bodies: list[Words] = []
    joints: list[Words] = []
    for a in range(n):
        for b in range(n):
            fixed = b == 0 and a % 5 == 0
            here = [0.5 * a, -0.5 * b]
            kind = "static" if fixed else "dynamic"
            bodies.append({"id": f"c{a}-{b}", "type": kind, "position": here, "shapes": [{"circle": 0.1}]})
            for da, db in ((1, 0), (0, 1)):
                if a >= da and b >= db:
                    ends = [f"c{a - da}-{b - db}", f"c{a}-{b}"]
                    anchors = [[here[0] - 0.5 * da, here[1] + 0.5 * db], here]
                    joints.append(
                        {"id": f"{ends[0]}:{ends[1]}", "type": "distance", "bodies": ends, "anchors": anchors, **spring}
                    )
    return bodies, joints


def small_cloth(size: int) -> Parts:
    return cloth(size, 15)


def spring_net(size: int) -> Parts:
    return cloth(size, hertz=8.0, damping_ratio=0.1)


def weld_net(size: int) -> Parts:
    """A wall of boxes, each welded to its neighbours, that sticks out of another wall."""
    across, down = int(60 * math.sqrt(size)), int(40 * math.sqrt(size))
    bodies: list[Words] = []
    joints: list[Words] = []
    for a in range(across):
        for b in range(down):
            name = f"c{a}-{b}"
            bodies.append({"id": name, "position": [a, -b], "shapes": [{"box": [0.8, 0.8]}]})
            left = [f"c{a - 1}-{b}", name] if a else [name]
            joints.append({"id": f"h{a}-{b}", "type": "weld", "bodies": left, "anchor": [a - 0.5, -b]})
            if b:
                above = [f"c{a}-{b - 1}", name]
                joints.append({"id": f"v{a}-{b}", "type": "weld", "bodies": above, "anchor": [a, 0.5 - b]})
    return bodies, joints


def loops(size: int) -> Parts:
    """Closed chains of 60 links that hold balls together."""
    return together(_loop(f"l{q}", 12.0 * q) for q in range(10 * size))


def _loop(name: str, x: float) -> Parts:
    count, radius = 60, 30.0 / (2.0 * math.pi)
    outer = radius / math.cos(math.pi / count)
    bodies: list[Words] = [
        {"id": f"{name}-ground", "type": "static", "position": [x, -0.5], "shapes": [{"box": [12, 1]}]}
    ]
    joints = []
    for k in range(count):
        at, between = 2.0 * math.pi * k / count, 2.0 * math.pi * (k - 0.5) / count
        place = [x + radius * math.cos(at), 6.0 + radius * math.sin(at)]
        capsule = {"capsule": [[-0.2, 0.0], [0.2, 0.0]], "radius": 0.08}
        bodies.append({"id": f"{name}-{k}", "position": place, "angle": math.degrees(at) + 90.0, "shapes": [capsule]})
        held = [f"{name}-{(k - 1) % count}", f"{name}-{k}"]
        joints.append(hinge(f"{name}-j{k}", held, x + outer * math.cos(between), 6.0 + outer * math.sin(between)))
    for k in range(30):
        place = [x + 0.9 * (k % 6) - 2.25, 4.0 + 0.9 * (k // 6)]
        bodies.append({"id": f"{name}-ball{k}", "position": place, "shapes": [{"circle": 0.4}]})
    return bodies, joints


def welded_triples(size: int) -> Parts:
    bodies, joints = pit(60.0 * size), []
    for k in range(250 * size):
        x, y = 2.2 * (k % (25 * size)) - 27.0 * size, 1.0 + 1.1 * (k // (25 * size))
        names = [f"w{k}-{part}" for part in range(3)]
        bodies += [
            {"id": name, "position": [x + 0.6 * part, y], "shapes": [{"box": [0.5, 0.5]}]}
            for part, name in enumerate(names)
        ]
        joints += [
            {
                "id": f"j{k}-{part}",
                "type": "weld",
                "bodies": names[part : part + 2],
                "anchor": [x + 0.6 * part + 0.3, y],
            }
            for part in range(2)
        ]
    return bodies, joints


def bouncing_pit(size: int) -> Parts:
    return heap([{"circle": 0.5}] * (2000 * size), 60.0 * size, 1.1, restitution=0.8), []


def sizes_mixed(size: int) -> Parts:
    """Discs, boxes and capsules, the largest 20 times as wide as the least."""
    chance = random.Random(5)
    radii = [0.08 * 20.0 ** chance.random() for _ in range(1500 * size)]
    shapes: list[Words] = []
    for k, r in enumerate(radii):
        box, capsule = {"box": [1.8 * r, 1.4 * r]}, {"capsule": [[-0.5 * r, 0.0], [0.5 * r, 0.0]], "radius": 0.4 * r}
        shapes.append([{"circle": r}, box, capsule][k % 3])
    return heap(shapes, 120.0 * size, 3.3), []


def heavy_on_light(size: int) -> Parts:
    bodies = heap([{"circle": 0.5}] * (3000 * size), 80.0 * size, 1.02)
    return [*bodies, {"id": "heavy", "position": [0, 60], "shapes": [{"circle": 4, "density": 20}]}], []


def columns(size: int) -> Parts:
    """Balls in straight columns of 22 that do not touch each other, as a grid of them begins."""
    across = 90 * size
    found = pit(100.0 * size)
    for k in range(2000 * size):
        place = [1.1 * (k % across) - 49.0 * size, 2.0 + 1.5 * (k // across)]
        found.append({"id": f"b{k}", "position": place, "shapes": [{"circle": 0.45}]})
    return found, []


def ragdolls(size: int) -> Parts:
    """Six bodies each, with limits, thrown on a heap."""
    rows = [
        _ragdoll(f"r{k}", 3.2 * (k % (15 * size)) - 24.0 * size, 2.0 + 3.0 * (k // (15 * size)))
        for k in range(150 * size)
    ]
    return together([(pit(50.0 * size), []), *rows])


def _ragdoll(name: str, x: float, y: float) -> Parts:
    bodies: list[Words] = [
        {"id": f"{name}-trunk", "position": [x, y], "shapes": [{"capsule": [[0, -0.4], [0, 0.4]], "radius": 0.25}]},
        {"id": f"{name}-head", "position": [x, y + 0.9], "shapes": [{"circle": 0.22}]},
    ]
    joints = [{**hinge(f"{name}-neck", [f"{name}-trunk", f"{name}-head"], x, y + 0.65), "lower": -40, "upper": 40}]
    for part, dx, dy in (("arm1", -0.6, 0.3), ("arm2", 0.6, 0.3), ("leg1", -0.25, -0.95), ("leg2", 0.25, -0.95)):
        level = dy > 0.0
        limb = {"capsule": [[0, -0.25], [0, 0.25]], "radius": 0.12}
        place, angle = [x + dx, y + dy], 90 if level else 0
        bodies.append({"id": f"{name}-{part}", "position": place, "angle": angle, "shapes": [limb]})
        joint = hinge(
            f"{name}-{part}", [f"{name}-trunk", f"{name}-{part}"], x + 0.5 * dx, y + (dy if level else dy + 0.3)
        )
        joints.append({**joint, "lower": -60, "upper": 60})
    return bodies, joints


def cars(size: int) -> Parts:
    """They drive over bumps, one behind the other."""
    bumps = [[x - 50.0, 0.3 * math.sin(0.9 * x)] for x in range(100 + 800 * size)]
    chains = [{"chain": bumps[k : k + 901], "friction": 0.9} for k in range(0, len(bumps) - 1, 900)]
    bodies: list[Words] = [{"id": "hill", "type": "static", "shapes": chains}]
    joints = []
    for k in range(150 * size):
        x = 5.0 * k
        bodies.append({"id": f"c{k}", "position": [x, 1.6], "shapes": [{"box": [2.4, 0.6]}]})
        for wheel in (-0.8, 0.8):
            name, at = f"w{k}{wheel}", [x + wheel, 1.0]
            bodies.append({"id": name, "position": at, "shapes": [{"circle": 0.45, "friction": 0.9}]})
            drive = {"motor_speed": -300, "max_torque": 3, "hertz": 4, "damping_ratio": 0.7, "axis": [0, 1]}
            joints.append({"id": f"j{name}", "type": "wheel", "bodies": [f"c{k}", name], "anchor": at, **drive})
    return bodies, joints


def needles(size: int) -> Parts:
    return heap([{"box": [5, 0.08]}] * (1000 * size), 120.0 * size, 5.2), []


def stars(size: int) -> Parts:
    """Concave outlines, each of several parts."""
    tips = [(math.cos(math.pi * k / 5), math.sin(math.pi * k / 5), 1.0 if k % 2 == 0 else 0.45) for k in range(10)]
    return heap([{"polygon": [[r * c, r * s] for c, s, r in tips]}] * (500 * size), 60.0 * size, 2.2), []


def tiles(size: int) -> Parts:
    """Capsules that walk on waves of static boxes."""
    chance = random.Random(5)
    across = 200 * size
    bodies: list[Words] = []
    for k in range(20_000 * size):
        place = [float(k % across), 6.0 * (k // across) - 0.5 + math.sin(0.3 * (k % across))]
        bodies.append({"id": f"t{k}", "type": "static", "position": place, "shapes": [{"box": [1, 1]}]})
    for k in range(500 * size):
        capsule = {"capsule": [[0.0, -0.3], [0.0, 0.3]], "radius": 0.3}
        place, speed = [7.3 * k % across, 6.0 * (13 * k % 100) + 2.2], [chance.uniform(-5.0, 5.0), 0.0]
        bodies.append({"id": f"w{k}", "position": place, "velocity": speed, "shapes": [capsule]})
    return bodies, []


def _tumbled(shapes: Iterable[Words], size: int, pitch: float) -> Parts:
    """Bodies that fall any way up into a pit: after some seconds a heap that has come to rest."""
    chance = random.Random(7)
    width = 60.0 * size
    across = int(width / pitch) - 1
    found = pit(width, friction=0.5)
    for k, shape in enumerate(shapes):
        x, y = (k % across - 0.5 * across + 0.5) * pitch, (k // across + 0.5) * pitch
        place = {"position": [x + chance.uniform(-0.1, 0.1), y], "angle": chance.uniform(0.0, 360.0)}
        found.append({"id": f"b{k}", **place, "shapes": [{**shape, "friction": 0.5}]})
    return found, []


def heap_of_balls(size: int) -> Parts:
    return _tumbled([{"circle": 0.5}] * (3000 * size), size, 1.2)


def heap_of_boxes(size: int) -> Parts:
    return _tumbled([{"box": [1, 1]}] * (3000 * size), size, 1.6)


def heap_of_capsules(size: int) -> Parts:
    return _tumbled([{"capsule": [[-0.3, 0], [0.3, 0]], "radius": 0.25}] * (3000 * size), size, 1.4)


def heap_of_polygons(size: int, radius: float = 0.0) -> Parts:
    """Of three to eight corners on circles of different sizes."""
    chance = random.Random(3)
    shapes = []
    for k in range(3000 * size):
        corners, r, turn = 3 + k % 6, chance.uniform(0.35, 0.65) - radius, chance.uniform(0.0, 6.3)
        angles = [turn + 2.0 * math.pi * (i + chance.uniform(-0.2, 0.2)) / corners for i in range(corners)]
        shapes.append({"polygon": [[r * math.cos(angle), r * math.sin(angle)] for angle in angles], "radius": radius})
    return _tumbled(shapes, size, 1.6)


def heap_of_rounded_polygons(size: int) -> Parts:
    return heap_of_polygons(size, 0.1)


def small_pyramid(size: int) -> Parts:
    """55 boxes, or as many beside them."""
    bodies: list[Words] = [{"id": "ground", "type": "static", "position": [0, -1], "shapes": [{"box": [200, 2]}]}]
    for n in range(size):
        for row in range(10):
            for k in range(10 - row):
                place = [20.0 * n + (k - 0.5 * (9 - row)) * 1.1, 0.5 + row]
                bodies.append({"id": f"b{n}-{row}-{k}", "position": place, "shapes": [{"box": [1, 1]}]})
    return bodies, []


def pendulums(size: int) -> Parts:
    """Of one, two and three rods."""
    return together(
        rope(f"p{n}-{links}", links, 5.0 * n, 10.0 * links, False) for n in range(size) for links in (1, 2, 3)
    )


def one_ragdoll(size: int) -> Parts:
    return together([(pit(20.0 * size), []), *(_ragdoll(f"r{n}", 4.0 * n, 2.0) for n in range(size))])


SCENES: tuple[Callable[[int], Parts], ...] = (
    ropes, one_rope, cloth, small_cloth, spring_net, weld_net, loops, welded_triples, bouncing_pit, sizes_mixed,
    heavy_on_light, columns, ragdolls, cars, needles, stars, tiles, heap_of_balls, heap_of_boxes, heap_of_capsules,
    heap_of_polygons, heap_of_rounded_polygons, small_pyramid, pendulums, one_ragdoll,
)  # fmt: skip
SETTLING = (heap_of_balls, heap_of_boxes, heap_of_capsules, heap_of_polygons, heap_of_rounded_polygons)
"""Those of interest when they have come to rest."""


def scene_of(build: Callable[[int], Parts], size: int) -> sandbox.Scene:
    """The scene of that size; nothing in it falls asleep, as in the other engines."""
    bodies, joints = build(size)
    return sandbox.Scene(bodies=bodies, joints=joints, settings={"sleeping": False})

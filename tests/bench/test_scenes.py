"""The benchmark scenes: small sound files out of everybody's way, and drivers that say the same to everybody."""

from __future__ import annotations

import json
from pathlib import Path

import jsonschema
import pytest

import sandbox
from sandbox.bench import layouts, steering
from sandbox.bench.course import Course
from sandbox.bench.drivers import DRIVERS
from sandbox.bench.ragdolls import BONES, rain
from sandbox.engine.commands.delete import Delete
from sandbox.engine.commands.spawn import Spawn
from sandbox.resources import benchmark_scenes, find_scene, scene_name, scenes_dir, shipped_scenes

FILES = {scene_name(file): file for file in benchmark_scenes()}
SCHEMA = jsonschema.Draft202012Validator(json.loads((scenes_dir() / "scene.schema.json").read_text(encoding="utf-8")))
every_scene = pytest.mark.parametrize("name", FILES)


def test_they_are_all_there_and_in_nobody_s_way() -> None:
    assert [sum(name.startswith(origin) for name in FILES) for origin in ("box2d-", "pymunk-")] == [10, 13]
    assert FILES.keys() >= DRIVERS.keys()
    assert not set(FILES.values()) & set(shipped_scenes())
    assert not set(FILES) & {scene_name(file) for file in shipped_scenes()}
    assert not [path for path in (scenes_dir() / "benchmarks").iterdir() if path not in FILES.values()]


@every_scene
def test_it_is_sound_small_and_tidy(name: str) -> None:
    text = FILES[name].read_text(encoding="utf-8")
    SCHEMA.validate(json.loads(text))
    scene = sandbox.load_scene(FILES[name])
    assert len(text) < 60_000
    assert max(len(line) for line in text.splitlines() if not line.startswith('  "about"')) <= 126
    assert list(json.loads(text))[:4] == ["$schema", "format", "title", "about"]
    source = "shared/benchmarks.c" if name.startswith("box2d") else "benchmarks/chipmunk.py"
    assert source in scene.about
    assert scene.about.endswith(".")
    assert scene.settings.steps >= 100
    assert ("`sandbox bench`" in scene.about) == (name in DRIVERS and name != "pymunk-add-pair")
    for expectation in scene.to_data().get("expect", ()):
        assert expectation["at"] == scene.settings.steps


@every_scene
def test_it_can_be_built(name: str) -> None:
    course = Course(sandbox.load_scene(FILES[name]), name)
    assert len(sandbox.World(course.scene).state.bodies) == len(course.flat.bodies)


def test_they_are_found_by_name_and_a_misspelt_name_is_mended() -> None:
    assert find_scene(Path("box2d-tumbler")) == FILES["box2d-tumbler"]
    with pytest.raises(sandbox.SceneError, match='did you mean "box2d-tumbler"'):
        sandbox.load_scene("box2d-tumblre")


def test_a_driver_says_the_same_whenever_it_is_asked() -> None:
    for driver in DRIVERS.values():
        assert [driver.commands(step) for step in (0, 1, 8, 320)] == [driver.commands(step) for step in (0, 1, 8, 320)]


def test_the_pusher_gets_where_it_should_be() -> None:
    way = sum(steering.junkyard(step)[0].velocity[0] / 60.0 for step in range(201))  # type: ignore[attr-defined]
    assert way == pytest.approx(steering._pusher(200))
    assert way > 30.0


def test_the_rain_takes_out_what_it_brought_in() -> None:
    assert rain(1) == ()
    (first,) = rain(0)
    out, new = rain(40 * 8)
    assert isinstance(first, Spawn)
    assert isinstance(out, Delete)
    assert isinstance(new, Spawn)
    assert len(first.bodies) == len(new.bodies) == 25 * len(BONES)
    assert set(out.bodies) == {body["id"] for body in first.bodies}
    assert not {body["id"] for body in new.bodies} & set(out.bodies)


@pytest.mark.parametrize(
    ("parts", "bodies", "joints"),
    [
        (layouts.joint_grid(10, held=1), 100, 2 * 10 * 9 - 2),
        (layouts.slow_explosion(50), 50, 0),
        (layouts.mixed_static_dynamic(20, n=20), 21, 0),
        (layouts.mostly_static_single(10), 1, 0),
        (layouts.multifixture(4), 4, 0),
    ],
)
def test_what_no_generator_makes(parts: layouts.Parts, bodies: int, joints: int) -> None:
    assert (len(parts["bodies"]), len(parts.get("joints", ()))) == (bodies, joints)
    words = {"prefabs": {"disc": {"shapes": [{"circle": 0.4}]}}, "materials": {"bare": {"friction": 0}}}
    scene = sandbox.Scene(**words, **{key: part[:500] for key, part in parts.items()})
    assert len(scene.flatten().bodies) == bodies


def test_a_course_knows_who_is_in_the_scene() -> None:
    course = Course(sandbox.load_scene(FILES["pymunk-tumbler"]), "pymunk-tumbler")
    assert course.change(0) is None
    change = course.change(1)
    assert change is not None
    assert [body.id for body in change.bodies] == ["box-1"]
    assert [body.id for body in course.among(course.bodies).bodies] == ["drum", "box-1"]
    assert course.inside == (-16.0, -26.0, 16.0, 6.0)


def test_a_course_forgets_who_was_deleted() -> None:
    course = Course(sandbox.load_scene(FILES["box2d-rain"]), "box2d-rain")
    course.change(0)
    assert len(course.among(course.bodies).bodies) == 2505 + 25 * len(BONES)
    assert len(course.among(course.bodies).joints) == 25 * (len(BONES) - 1)
    course.change(40 * 8)
    assert len(course.among(course.bodies).bodies) == 2505 + 25 * len(BONES)
    assert len(course.among(course.bodies).joints) == 25 * (len(BONES) - 1)
    assert not [name for name in course.bodies if name.startswith("doll-0")]

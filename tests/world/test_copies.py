"""Copies: `copy.copy`, `copy.deepcopy` and `pickle` of worlds, of what looks at them, and of what they answer."""

from __future__ import annotations

import copy
import pickle
import subprocess
import sys
from typing import Any

import numpy as np
import pytest

import sandbox
from sandbox import ApplyImpulse, Delete, Problem, Spawn, UnknownBodyError, errors
from sandbox.engine.world import World
from sandbox.geometry.polygon import ConcaveError, PolygonError
from sandbox.replay.revisions.trace import RevisionError


def pickled(value: Any) -> Any:
    """Through `pickle` and back."""
    return pickle.loads(pickle.dumps(value))


COPIERS = [copy.copy, copy.deepcopy, pickled]
APART = [copy.deepcopy, pickled]
SCENE = sandbox.Scene(
    bodies=[
        {"id": "ground", "type": "static", "shapes": [{"box": [20, 1]}], "position": [0, -0.5]},
        {"id": "gate", "type": "static", "shapes": [{"box": [1, 4], "sensor": True}], "position": [3, 2]},
        {"id": "box", "shapes": [{"box": [1, 1]}], "position": [3, 0.6]},
        {"id": "bob", "shapes": [{"circle": 0.2}], "position": [-3, 2]},
    ],
    joints=[{"type": "revolute", "id": "pivot", "bodies": ["ground", "bob"], "anchor": [-4, 2]}],
)


def lively(workers: int = 1) -> World:
    """A world in which things were spawned, deleted and pushed; one of the deletions is not told yet."""
    world = World(SCENE, workers)
    world.step(10)
    world.spawn({"id": "late", "shapes": [{"circle": 0.5}], "position": [5, 0.5]})
    world.spawn({"id": "later", "shapes": [{"circle": 0.5}], "position": [-1, 0.5]})
    world.apply(ApplyImpulse("box", (1.0, 2.0)))
    world.step(12)
    world.delete("late")
    world.apply(ApplyImpulse("later", (0.5, 4.0)))
    return world


def told(world: World) -> list[Any]:
    """What a world tells of its last step."""
    return [list(world.events), world.sensed, world.contact_impulses.tolist(), world.names, world.flat]


@pytest.mark.parametrize("copier", COPIERS)
def test_a_copy_goes_on_by_itself_and_as_the_original_would(copier):
    world = lively(workers=2)
    twin = copier(world)
    assert told(twin) == told(world)
    assert world.events.end is not None
    assert (twin.digest(), twin.step_count, twin.workers) == (world.digest(), world.step_count, 2)
    assert twin.scene == world.scene
    before = world.digest(), world.body("later").position
    trace = []
    for _ in range(30):
        twin.step()
        trace.append((twin.digest(), told(twin)))
    assert twin.body("later").position != before[1]
    assert (world.digest(), world.body("later").position) == before
    for expected in trace:
        world.step()
        assert (world.digest(), told(world)) == expected
    assert any(event["event"] == "end" and "late" in (event["a"], event["b"]) for event in trace[0][1][0])


@pytest.mark.parametrize("copier", COPIERS)
def test_a_copy_answers_queries_and_takes_commands(copier):
    world = lively()
    world.query.ray((-5.0, 0.5), (20.0, 0.0))
    twin = copier(world)
    twin.delete("box")
    twin.spawn({"id": "new", "shapes": [{"circle": 0.5}], "position": [9, 0.5]})
    twin.step()
    assert "box" in world.names
    assert twin.query.ray((12.0, 0.5), (-20.0, 0.0)).body == "new"
    assert world.query.ray((12.0, 0.5), (-20.0, 0.0)).body == "box"


def test_a_shallow_and_a_deep_copy_keep_the_scene():
    world = World(SCENE)
    assert copy.copy(world).scene is copy.deepcopy(world).scene is SCENE
    assert copy.copy(SCENE) is copy.deepcopy(SCENE) is SCENE
    assert pickled(SCENE) == SCENE
    assert pickled(SCENE).flatten() == SCENE.flatten()


def test_a_copy_of_a_flat_world():
    world = World(SCENE.flatten())
    world.step(3)
    twin = pickled(world)
    twin.step(4)
    world.step(4)
    assert twin.digest() == world.digest()


class Counted(World):
    """A world with an attribute and a slot of its own, made of nothing."""

    __slots__ = ("__dict__", "marks")

    def __init__(self) -> None:
        super().__init__(SCENE)
        self.marks = ["a"]
        self.watched = self.body("box")


@pytest.mark.parametrize("copier", APART)
def test_a_copy_of_a_subclass_has_its_attributes(copier):
    world = Counted()
    world.step(5)
    twin = copier(world)
    assert type(twin) is Counted
    assert (twin.digest(), twin.marks) == (world.digest(), ["a"])
    twin.step(5)
    twin.marks.append("b")
    assert world.marks == ["a"]
    assert twin.watched.position == twin.body("box").position
    assert twin.watched.position != world.watched.position


@pytest.mark.parametrize("copier", APART)
def test_views_of_a_copy_look_at_the_copy(copier):
    world = lively()
    gone = world.body("bob")
    world.apply(Delete("bob"))
    views = copier([world, world.body("later"), world.bodies, world.query, gone])
    twin, view, columns, query, gone = views
    twin.step(5)
    assert view.position == twin.body("later").position != world.body("later").position
    assert columns is twin.bodies
    assert query is twin.query
    assert gone.id == "bob"
    with pytest.raises(UnknownBodyError):
        _ = gone.position
    view.velocity = (1.0, 0.0)
    assert twin.body("later").velocity == (1.0, 0.0)


def test_a_joint_view_of_a_copy():
    world = World(SCENE)
    twin, joint = pickled((world, world.joint("pivot")))
    joint.enabled = False
    assert (twin.joint("pivot").enabled, world.joint("pivot").enabled) == (False, True)


def test_a_shallow_copy_of_a_view_looks_at_the_same_world():
    world = World(SCENE)
    for view in (world.body("box"), world.joint("pivot")):
        twin = copy.copy(view)
        world.step()
        assert repr(twin) == repr(view)
    assert copy.copy(world.bodies) is world.bodies
    assert copy.copy(world.query) is world.query


@pytest.mark.parametrize("copier", COPIERS)
def test_answers_events_commands_and_recordings_can_be_copied(copier):
    world = lively()
    recording = sandbox.record(SCENE, 5, [(2, Spawn({"id": "x", "shapes": [{"circle": 1}], "position": [0, 9]}))])
    answers = [
        world.query.ray((12.0, 0.5), (-20.0, 0.0)),
        world.query.overlap_shape(sandbox.Circle((0.0, 0.0), 3.0)),
        *world.body("box").shapes,
        recording,
        *recording.commands,
    ]
    for answer in answers:
        assert copier(answer) == answer
    rays = world.query.rays([(12.0, 0.5)], [(-20.0, 0.0)])
    assert np.array_equal(copier(rays).point, rays.point)
    assert list(copier(world.events)) == list(world.events)


KINDS = [kind for kind in vars(errors).values() if isinstance(kind, type) and issubclass(kind, errors.SandboxError)]
MADE = [
    *(kind("a text") for kind in KINDS if not issubclass(kind, (errors.FileError, errors.RefusedCommandError))),
    errors.RefusedCommandError(2, "Delete", 7, 0.1, "no body 'a' in this world"),
    *(kind("a.json", [Problem("wrong", "/bodies", 3, 4)]) for kind in KINDS if issubclass(kind, errors.FileError)),
    PolygonError("bad", 3, 1), ConcaveError("dented", 2), RevisionError("old"),
]  # fmt: skip


@pytest.mark.parametrize("copier", COPIERS)
@pytest.mark.parametrize("error", MADE, ids=lambda error: type(error).__name__)
def test_an_error_can_be_copied(error, copier):
    error.add_note("seen on the way")
    twin = copier(error)
    assert type(twin) is type(error)
    assert (str(twin), twin.args, vars(twin)) == (str(error), error.args, vars(error))


def test_a_world_goes_on_in_another_process():
    world = lively()
    program = "import pickle, sys; w = pickle.load(sys.stdin.buffer); w.step(9); print(w.digest(), len(w.events))"
    done = subprocess.run([sys.executable, "-c", program], input=pickle.dumps(world), capture_output=True, check=True)
    world.step(9)
    assert done.stdout.decode().split() == [world.digest(), str(len(world.events))]


@pytest.mark.parametrize("copied", COPIERS)
def test_a_copy_of_a_batch_goes_on_by_itself(copied):
    """Its columns follow it; one of its worlds has become a world of its own."""
    batch = sandbox.Batch(SCENE, 3)
    batch.step(5)
    batch.apply(sandbox.DeleteJoint("pivot"), worlds=[1])
    before = batch.positions.copy()
    other = copied(batch)
    assert np.array_equal(other.positions, before)
    other.step(20)
    assert np.array_equal(batch.positions, before)
    assert not np.array_equal(other.positions[0], before[0])
    batch.step(20)
    assert np.array_equal(other.positions, batch.positions)
    assert [other.digest(k) for k in range(3)] == [batch.digest(k) for k in range(3)]
    for each in (batch, other):
        each.reset()
    assert other.digest(0) == batch.digest(0) == sandbox.Batch(SCENE, 1).digest(0)


@pytest.mark.parametrize("copied", [copy.copy, copy.deepcopy])
def test_a_copy_of_a_player_goes_its_own_way(copied):
    player = sandbox.Player(SCENE)
    player.step(5)
    digest, other = player.world.digest(), copied(player)
    other.seek(0)
    assert (player.step_count, player.world.step_count, player.world.digest()) == (5, 5, digest)
    other.seek(5)
    assert other.world.digest() == digest

"""Compile what the tests run once, in two processes, before any of pytest's workers would each do it by itself.

`python -m tests.compiled PART` is one of the processes. What neither thinks of is compiled by the first test that
needs it, and kept for the others too.
"""

from __future__ import annotations

import hashlib
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import sandbox
from sandbox._jit import jit_enabled
from sandbox._kernel_cache import cache_folder
from sandbox.cli.every_entry_point import lay_out_many_joints
from sandbox.engine.continuous_collision.solve_continuous import solve_continuous
from sandbox.engine.events.sensors import SensorOverlaps
from sandbox.engine.fields.apply import apply_fields
from sandbox.engine.joints.nets import do_nets
from sandbox.engine.joints.solve import do_joints
from sandbox.engine.memory.binding import bind
from sandbox.engine.memory.scratch import Scratch
from sandbox.engine.restitution.jointed.strike import strike_through_joints
from sandbox.engine.restitution.strike_batch import strike_batch
from sandbox.engine.step import begin, collide, finish, solve
from sandbox.engine.stepper import Stepper
from sandbox.engine.world import World
from sandbox.geometry.exact_axes import Axis
from sandbox.geometry.pair import pair_of
from sandbox.geometry.shapes import Box
from sandbox.reference.arbitration import our_answer
from sandbox.reference.pair import Core, Pair
from sandbox.scene.flat import FlatScene
from sandbox.world.build import build_state
from tests.determinism import busy, floating
from tests.engine.stages import Paused, island_roots, solve_mouse_joints
from tests.flat import body, circle, scene

ROOT = Path(__file__).parents[1]


def compile_all(say: Callable[[str], None]) -> None:
    """Fill an empty kernel cache; at once if it has been done for these very files."""
    done = cache_folder() / f"tests-{_files()}"
    if not jit_enabled() or done.exists():
        return
    say("compiling the kernels once for all workers; they are kept for the next time")
    command = [sys.executable, "-m", "tests.compiled"]
    parts = [subprocess.Popen([*command, part], cwd=ROOT, stdin=subprocess.DEVNULL) for part in PARTS]
    failed = [part for part in parts if part.wait() != 0]
    if not failed:
        done.touch()


def _files() -> str:
    """Entry points outside the engine are kept under a hash of their file."""
    digest = hashlib.blake2b(digest_size=8)
    for file in sorted(Path(sandbox.__file__).parent.rglob("*.py")):
        digest.update(file.read_bytes())
    return digest.hexdigest()


def _once(part: Any, of: FlatScene) -> None:
    """Call a part of the step in a world in which it calls no other one."""
    state = build_state(of)
    part(*bind(part, state, Scratch.for_state(state, 16)))


def _solve() -> None:
    """What moves bodies, the solvers of joints, and the stages which are tested by themselves; fields, and what is
    asked of a world."""
    for part in (solve, do_joints, do_nets):
        _once(part, busy.scene())
    stages = Paused(World(busy.scene()))
    stages.lay_out()
    stages.begin()
    stages.warm()
    stages.solve(0.0, 0.0, 0.0)
    stages.move()
    stages.store()
    solve_mouse_joints(stages.tables, stages.scratch.solver, 0, stages.substep)
    island_roots(2, [(0, 1)], [True, True])
    Stepper(build_state(busy.scene()), workers=2).bind_workers()
    _once(apply_fields, floating.scene())
    both = scene(body("a", circle(1.0, sensor=True)), body("b", circle(1.0)))
    SensorOverlaps(build_state(both)).update()
    ask = World(both).query
    ask.ray((-2.0, 0.0), (4.0, 0.0))
    ask.ray_all((-2.0, 0.0), (4.0, 0.0))
    ask.nearest((0.0, 0.0))
    ask.point((0.0, 0.0))
    ask.distance("a", "b")


def _others() -> None:
    """What finds contacts, resolves impacts and takes back who went too far, and whatever else is called from
    Python."""
    for part in (collide, begin, finish, solve_continuous, strike_batch, strike_through_joints):
        _once(part, busy.scene())
    stages = Paused(World(busy.scene()))
    stages.detect()
    stages.strike()
    lay_out_many_joints()
    pair = pair_of(Box(1.0, 1.0), Box(1.0, 1.0, (2.0, 0.0)))
    pair.manifold(0.0)
    pair.nearest()
    pair.manifold_on(Axis(0, 1, 0, 1, 0, 0))
    our_answer(Pair(Core(((0.0, 0.0),)), Core(((1.0, 0.0),))))


PARTS = {"solve": _solve, "others": _others}

if __name__ == "__main__":
    PARTS[sys.argv[1]]()

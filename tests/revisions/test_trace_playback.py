"""A film of another process's run is the film of the run itself."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from sandbox import ApplyImpulse, Delete, EndDrag, Spawn, StartDrag
from sandbox.errors import SandboxError
from sandbox.replay.golden.run import Run, RunStepper
from sandbox.replay.revisions.against import HERE
from sandbox.replay.revisions.trace import Trace, trace
from sandbox.replay.revisions.trace_playback import TracePlayback, film_samples
from sandbox.report.filming import film_run
from sandbox.report.pairs import _pair, _world_at
from sandbox.scene import Scene
from tests.cli.conftest import CRATE, GROUND

BALL = {"id": "ball", "shapes": [{"circle": 0.3}], "position": [0.2, 2.0]}
POST = {"id": "post", "type": "static", "shapes": [{"box": [0.2, 2]}], "position": [-3, 1]}
ROPE = {"id": "rope", "type": "distance", "bodies": ["post", "crate"], "anchors": [[-3, 1.9], [0, 0.5]]}
COMMANDS: tuple[tuple[int, Any], ...] = (
    (2, Spawn(BALL)),
    (4, StartDrag("crate", (0.3, 0.8))),
    (9, EndDrag("crate")),
    (10, ApplyImpulse("ball", (2.0, 1.0))),
    (14, Delete("crate")),
)
LAST = 18


@pytest.fixture(scope="module")
def run() -> Run:
    return Run(Scene(bodies=[GROUND, POST, CRATE], joints=[ROPE], settings={"steps": LAST}), LAST, COMMANDS)


@pytest.fixture(scope="module")
def past(run: Run) -> Trace:
    """The run by this same code in a process of its own."""
    return trace(HERE, run, [7], film=film_samples(LAST, 1))


@pytest.mark.slow
def test_the_film_is_that_of_the_run(run: Run, past: Trace) -> None:
    wanted, got = film_run(run), film_run(run, stepper=TracePlayback(run, past))
    assert [body.id for body in got.bodies] == ["ground", "post", "crate", "ball"]
    assert np.array_equal(got.poses, wanted.poses, equal_nan=True)
    assert np.array_equal(got.awake, wanted.awake)
    assert np.array_equal(got.held, wanted.held)
    assert got.figures == wanted.figures
    assert got.cut == ""


def test_moments_left_out_are_passed_over(run: Run, past: Trace) -> None:
    few = {key: rows for key, rows in past.arrays.items() if int(key.split(".")[0]) in (6, 12, LAST)}
    thin = Trace(past.columns, past.codes, few)
    stepper, straight = TracePlayback(run, thin), RunStepper(run.scene, run.commands)
    for step in range(1, LAST + 1):
        stepper.advance()
        straight.advance()
        assert stepper.step == step
        if step in (6, 12, LAST):
            same = np.asarray(stepper.world.state.bodies.position_x) == np.asarray(
                straight.world.state.bodies.position_x
            )
            assert same.all()


def test_a_dumped_moment_has_its_pairs(run: Run, past: Trace) -> None:
    worlds = [_world_at(stepper, 7) for stepper in (TracePlayback(run, past), RunStepper(run.scene, run.commands))]
    pair = _pair(worlds[0], worlds[1], 7, "crate")
    assert pair is not None
    assert pair.names == ("ground", "crate")
    assert pair.got == pair.expected


def test_other_bodies_end_it(run: Run, past: Trace) -> None:
    other = TracePlayback(Run(run.scene, LAST), past)  # without the commands, no ball is spawned
    with pytest.raises(SandboxError, match="other bodies in the other revision"):
        _led_to_the_end(other)
    film = film_run(run, stepper=TracePlayback(Run(run.scene, LAST), past))
    assert (film.end, "other bodies" in film.cut) == (3, True)


def _led_to_the_end(stepper: RunStepper) -> None:
    while stepper.step < LAST:
        stepper.advance()


def test_the_fingerprints_are_those_of_a_recording(run: Run, past: Trace) -> None:
    from sandbox.replay.recording.recorder import record

    digests = record(run.scene, run.steps, run.commands).digests
    assert past.fingerprints == digests
    assert past.parts_from(digests) == 0
    assert past.parts_from((*digests[:4], "0000 0000 0000 0000")) == 5
    assert Trace((), None, {}).parts_from(digests) is None

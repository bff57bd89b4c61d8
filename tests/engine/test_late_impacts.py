"""What comes to touch within a step, in islands that take finer substeps, is stopped as often as in others."""

from __future__ import annotations

from tests.determinism.processes import other_process
from tests.engine.late_impacts import LANDINGS, SPEED, SUBSTEPS, landings


def test_finer_substeps_solve_impacts_no_more_often():
    """Once as the step begins, and as many times within it as the scene has substeps."""
    (found,) = other_process("tests.engine.late_impacts", NUMBA_DISABLE_JIT="1")
    assert 1 < int(found) <= 1 + SUBSTEPS < LANDINGS


def test_what_lands_in_between_hardly_rebounds():
    world = landings()
    world.step()
    speeds = [world.body(f"b{k}").velocity[1] for k in range(LANDINGS)]
    assert max(map(abs, speeds)) < 0.05 * SPEED

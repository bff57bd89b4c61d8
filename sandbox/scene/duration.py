"""How long a scene runs."""

from __future__ import annotations

from sandbox.scene.scene import Scene


def planned_steps(scene: Scene, steps: int | None = None) -> int:
    """`steps`; without, the scene's own number, or the last step its expectations name if that is later."""
    if steps is not None:
        return steps
    return max(scene.settings.steps, *(expectation.last_step for expectation in scene.expect), 0)

"""A scene stepped by the simple solver."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from sandbox.errors import SandboxError
from sandbox.reference.simple.bodies import Body
from sandbox.reference.simple.collisions import Placed, Shape, find_contacts, keep_impulses
from sandbox.reference.simple.contacts import Contact
from sandbox.reference.simple.solver import Numbers, step
from sandbox.reference.simple.techniques import Techniques
from sandbox.scene import Scene
from sandbox.scene.flat import FlatScene
from sandbox.tables import Records
from sandbox.world.build import build_state
from sandbox.world.records import BODY, DYNAMIC
from sandbox.world.state import State


class SimpleWorld:
    """Bodies and contacts of a scene; `techniques` are those of its settings unless given.

    Masses, outlines and surfaces are what the engine starts with (`state`, which stays as it is). Bodies never sleep.
    Raises `SandboxError` for a scene with more in it than contacts.
    """

    def __init__(self, scene: Scene | FlatScene, techniques: Techniques | None = None) -> None:
        flat = scene.flatten() if isinstance(scene, Scene) else scene
        refuse_more_than_contacts(flat)
        self.state: State = build_state(flat)
        self.techniques = techniques or Techniques.of(flat)
        said = flat.settings
        self.numbers = Numbers(
            1.0 / said.step_rate, complex(*flat.gravity), said.contact_hertz, said.contact_damping_ratio,
            said.push_out_speed * said.units_per_meter, said.restitution_threshold * said.units_per_meter,
        )  # fmt: skip
        self.bodies = [_body(row) for row in self.state.bodies]
        self.contacts: dict[tuple[int, int], Contact] = {}
        self._shapes = [_shape(row, self.bodies, self.state) for row in self.state.shapes]

    def collide(self) -> None:
        """Find the contacts of now; impulses of the step before stay with theirs."""
        old = self.contacts
        self.contacts = find_contacts(self._shapes, self.numbers.seconds if self.techniques.speculative else 0.0)
        keep_impulses(self.contacts, old)

    def solve(self, after: Callable[[], None] = lambda: None) -> None:
        """Solve the contacts found and move; `after` is called after each pass over the contacts."""
        for body in self.bodies:
            body.moved, body.turned = 0j, 1 + 0j
        step(self.bodies, list(self.contacts.values()), self.numbers, self.techniques, after)

    def step(self, steps: int = 1) -> None:
        """Take some steps."""
        for _ in range(steps):
            self.collide()
            self.solve()

    def placed(self) -> tuple[Placed, ...]:
        """All shapes where they are now."""
        return tuple(shape.placed() for shape in self._shapes)

    def records(self) -> Records:
        """The engine's table of bodies with the poses and velocities of now."""
        rows = BODY.zeros(len(self.bodies))
        rows[:] = self.state.bodies
        for row, body in zip(rows, self.bodies, strict=True):
            row.center_x, row.center_y = body.center.real, body.center.imag
            row.angle, turn = body.angle, body.rotation
            row.rotation_cos, row.rotation_sin = turn.real, turn.imag
            row.velocity_x, row.velocity_y = body.velocity.real, body.velocity.imag
            row.angular_velocity = body.angular
        return rows


def refuse_more_than_contacts(scene: FlatScene) -> None:
    """Raise `SandboxError`, naming all that the simple solver cannot step, if there is any of it."""
    shapes = [shape for body in scene.bodies for shape in body.shapes]
    counts = {
        "joint": len(scene.joints),
        "region": len(scene.regions),
        "thruster": sum(len(body.thrusters) for body in scene.bodies),
        "sensor": sum(shape.sensor for shape in shapes),
        "one-way shape": sum(any(shape.one_way) for shape in shapes),
    }
    found = [f"{count} {what}{'s' if count > 1 else ''}" for what, count in counts.items() if count]
    if found:
        raise SandboxError(f"the simple solver knows contacts alone; this scene has {' and '.join(found)}")


def told_apart(scene: FlatScene) -> tuple[str, ...]:
    """What of a scene the simple solver does otherwise than the engine, a line each."""
    notes = ["the simple solver takes the same number of substeps, never sleeps, and catches nothing in mid-step"]
    if any(shape.seam or shape.part for body in scene.bodies for shape in body.shapes):
        notes.append("chains and concave polygons are single lines and parts to it: bodies may catch at their seams")
    return tuple(notes)


def _body(row: Any) -> Body:
    return Body(
        float(row.inverse_mass), float(row.inverse_inertia), complex(row.velocity_x, row.velocity_y),
        float(row.angular_velocity), complex(row.center_x, row.center_y), float(row.angle), bool(row.type == DYNAMIC),
        float(row.gravity_scale), float(row.linear_damping), float(row.angular_damping),
    )  # fmt: skip


def _shape(row: Any, bodies: list[Body], state: State) -> Shape:
    vertices: Any = state.vertices[row.vertex_start : row.vertex_start + row.vertex_count]
    return Shape(
        bodies[row.body], tuple(complex(x, y) for x, y in zip(vertices.x, vertices.y, strict=True)), float(row.radius),
        float(row.friction), float(row.restitution), float(row.rolling_resistance), float(row.surface_speed),
        int(row.category), int(row.mask), int(row.group),
    )  # fmt: skip

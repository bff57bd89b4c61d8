"""What the runs of other engines have in common."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple, Protocol

from sandbox.scene.flat import FlatBody, FlatJoint, FlatScene, Vec


class Pose(NamedTuple):
    """Origin of a body (m), cosine and sine of its angle, velocity of its centre of mass (m/s) and spin (rad/s)."""

    x: float
    y: float
    cos: float
    sin: float
    velocity_x: float
    velocity_y: float
    spin: float


class OtherRun(Protocol):
    """A scene in the hands of another engine; `label` is its name and version."""

    label: str

    @property
    def notes(self) -> tuple[str, ...]:
        """What of all that was brought in the engine does otherwise or leaves out, a line each."""

    def add(self, bodies: Iterable[FlatBody], joints: Iterable[FlatJoint]) -> None:
        """Bring bodies and joints in."""

    def remove(self, names: Iterable[str]) -> None:
        """Take bodies out, with the joints that hold them."""

    def set_velocity(self, name: str, velocity: Vec, angular_velocity: float) -> None:
        """Give a body a velocity (m/s) and an angular velocity (rad/s)."""

    def step(self) -> None:
        """Go on by one step of the scene."""

    def pose(self, name: str) -> Pose:
        """Where a body is and how it moves."""

    def close(self) -> None:
        """Give back what it holds; nothing else may be asked after it."""


def left_out(scene: FlatScene) -> Iterator[str]:
    """What of a scene no other engine has."""
    if scene.regions:
        yield "regions are left out"
    if any(body.thrusters for body in scene.bodies):
        yield "thrusters are left out"
    if scene.rules:
        yield "rules are left out"


def other_joints(joints: Iterable[FlatJoint], made: Sequence[str]) -> Iterator[str]:
    """Which kinds of joints are left out by an engine that has only those kinds `made`."""
    for kind in sorted({joint.kind for joint in joints} - set(made)):
        yield f"joints of the kind {kind} are left out"


def one_way_shapes(bodies: Iterable[FlatBody], chains: bool) -> Iterator[str]:
    """A line if there are one-way shapes; `chains` says whether one-sided chains count."""
    shapes = (shape for body in bodies for shape in body.shapes)
    if any(any(shape.one_way) and (chains or not shape.seam) for shape in shapes):
        yield "one-way shapes are solid from both sides"

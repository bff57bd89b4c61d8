"""The views of the bodies and joints of one world, each made when it is first asked for."""

from __future__ import annotations

from typing import Protocol

from sandbox.engine.views.base import ViewedWorld
from sandbox.engine.views.body import BodyView
from sandbox.engine.views.joint import JointView
from sandbox.world.directory import Directory


class NamedWorld(ViewedWorld, Protocol):
    """As much of a world as finding a view by its id takes."""

    @property
    def directory(self) -> Directory:
        """From ids to rows."""


class Views:
    """A view stays the same body or joint whatever comes and goes, so each is kept, by its serial number, until rows
    go."""

    __slots__ = ("_all_joints", "_bodies", "_joints", "_world")

    def __init__(self, world: NamedWorld) -> None:
        self._world = world
        self.forget()

    def forget(self) -> None:
        """Somebody has gone, whose views nobody needs any longer, or serial numbers are those of others."""
        self._bodies: dict[int, BodyView] = {}
        self._joints: dict[int, JointView] = {}
        self._all_joints: tuple[tuple[str, ...], tuple[JointView, ...]] | None = None

    def body(self, name: str) -> BodyView:
        """The body of that id. Raises `UnknownBodyError` with the nearest name."""
        directory = self._world.directory
        serial = directory.body_serial(name)
        view = self._bodies.get(serial)
        if view is None:
            view = self._bodies[serial] = BodyView(self._world, directory.body(name))
        return view

    def joint(self, name: str) -> JointView:
        """The joint of that id. Raises `UnknownJointError` with the nearest name."""
        directory = self._world.directory
        serial = directory.joint_serial(name)
        view = self._joints.get(serial)
        if view is None:
            view = self._joints[serial] = JointView(self._world, directory.joint(name))
        return view

    @property
    def joints(self) -> tuple[JointView, ...]:
        """All joints, row by row: the same tuple as long as none comes or goes."""
        ids = self._world.state.census.joints.ids
        if self._all_joints is None or self._all_joints[0] is not ids:
            self._all_joints = ids, tuple(JointView(self._world, row) for row in range(len(ids)))
        return self._all_joints[1]

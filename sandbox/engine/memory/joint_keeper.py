"""What hangs together by joints in one world, kept in scratch memory as joints come, go and are switched."""

from __future__ import annotations

from sandbox.engine.joints.assembly import assemble, assemble_more
from sandbox.engine.joints.fewer_parts import going_parts, without_parts
from sandbox.engine.joints.part_layout import PartLayouts
from sandbox.engine.memory.scratch import Scratch
from sandbox.world.rows import Moved
from sandbox.world.state import State


class JointKeeper:
    """Keeps `scratch.joints` and `scratch.joint_filter`. What comes or goes as a whole is put there or taken out; all
    else is put off, and assembled once for all that was done before a step: whoever looks at them calls `settle`."""

    __slots__ = ("_stale", "layouts")

    def __init__(self, layouts: PartLayouts) -> None:
        self.layouts = layouts
        self._stale = False

    def forget(self) -> None:
        """Joints broke or were switched, or bodies froze: all that hangs together is to be found out anew."""
        self._stale = True

    def settle(self, state: State, scratch: Scratch) -> None:
        """Find out what hangs together, where that is not known."""
        if self._stale:
            self._stale = False
            found = assemble(state.joints, state.bodies, self.layouts, scratch.room.bodies)
            scratch.joint_filter, scratch.joints = found

    def add(self, state: State, scratch: Scratch, first: int) -> None:
        """Joints have come, from row `first` on."""
        if self._stale:
            return
        known = scratch.joint_filter, scratch.joints
        more = assemble_more(state.joints, state.bodies, self.layouts, known, first)
        if more is None:
            self.forget()
        else:
            scratch.joint_filter, scratch.joints = more

    def move(self, state: State, scratch: Scratch, moved: Moved) -> bool:
        """Rows have gone, and others have moved into their places; returns whether that is of any concern to joints."""
        work = scratch.joints
        if not self._stale and work is None and len(moved.joints) == 0:
            return False
        going = None if self._stale or work is None else going_parts(work, moved.joints)
        if work is None or going is None or going.all():
            self.forget()
        else:
            scratch.joint_filter, scratch.joints = without_parts(
                scratch.joint_filter, work, self.layouts, going, moved, state.joints
            )
        return True

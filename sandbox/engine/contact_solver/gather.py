"""The bodies of a block of contacts, gathered before the arithmetic and scattered after it."""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.contact_solver import blocks as cb
from sandbox.tables import Floats, Records


@kernel
def gather_velocities(motions: Records, slots: Records, slot: int, count: int, g: Floats) -> None:
    """Copy the velocities of the bodies of `slots[slot : slot + count]` into lanes."""
    for k in range(count):
        a = motions[slots[slot + k].body_a]
        b = motions[slots[slot + k].body_b]
        g[cb.VELOCITY_AX + k] = a.velocity_x
        g[cb.VELOCITY_AY + k] = a.velocity_y
        g[cb.ANGULAR_A + k] = a.angular_velocity
        g[cb.VELOCITY_BX + k] = b.velocity_x
        g[cb.VELOCITY_BY + k] = b.velocity_y
        g[cb.ANGULAR_B + k] = b.angular_velocity


@kernel
def gather_deltas(motions: Records, slots: Records, slot: int, count: int, g: Floats) -> None:
    """Copy how far the bodies of `slots[slot : slot + count]` have moved and turned since the step began."""
    for k in range(count):
        a = motions[slots[slot + k].body_a]
        b = motions[slots[slot + k].body_b]
        g[cb.DELTA_X + k] = b.delta_x - a.delta_x
        g[cb.DELTA_Y + k] = b.delta_y - a.delta_y
        g[cb.COS_A + k] = a.delta_cos
        g[cb.SIN_A + k] = a.delta_sin
        g[cb.COS_B + k] = b.delta_cos
        g[cb.SIN_B + k] = b.delta_sin


@kernel
def scatter_velocities(motions: Records, slots: Records, slot: int, count: int, g: Floats) -> None:
    """Copy the velocities of lanes back."""
    for k in range(count):
        a = motions[slots[slot + k].body_a]
        b = motions[slots[slot + k].body_b]
        a.velocity_x = g[cb.VELOCITY_AX + k]
        a.velocity_y = g[cb.VELOCITY_AY + k]
        a.angular_velocity = g[cb.ANGULAR_A + k]
        b.velocity_x = g[cb.VELOCITY_BX + k]
        b.velocity_y = g[cb.VELOCITY_BY + k]
        b.angular_velocity = g[cb.ANGULAR_B + k]

"""What expectations measure: functions from a state to one value a body, as NumPy columns.

Each factory takes body indices (`Rows`) and returns a `Measure`; however many bodies there are, judging is a
few column operations.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from sandbox.world.state import State

Values: TypeAlias = NDArray[np.float64]
Rows: TypeAlias = NDArray[np.int64]
Measure: TypeAlias = Callable[[State], Values]
_ROUNDING = 1e-9
"""Gap (m) that is none."""


def speed(rows: Rows) -> Measure:
    """Speed of the centre of mass, m/s."""
    return lambda state: np.hypot(state.bodies.velocity_x[rows], state.bodies.velocity_y[rows])


def turning(rows: Rows) -> Measure:
    """How fast each body turns, rad/s, without its sign."""
    return lambda state: np.abs(state.bodies.angular_velocity[rows])


def angle(rows: Rows) -> Measure:
    """The angle turned so far, degrees; a full turn counts as 360."""
    return lambda state: np.degrees(state.bodies.angle[rows])


def turned_from(rows: Rows, start: Values) -> Measure:
    """How far each body turned since its `start` angle (rad), degrees, without the sign."""
    return lambda state: np.degrees(np.abs(state.bodies.angle[rows] - start))


def distance_from(rows: Rows, x: Any, y: Any) -> Measure:
    """Distance of each body's origin from (`x`, `y`), m; scalars or one value a row."""
    return lambda state: np.hypot(state.bodies.position_x[rows] - x, state.bodies.position_y[rows] - y)


def height(rows: Rows) -> Measure:
    """The y of each body's origin, m."""

    def measure(state: State) -> Values:
        heights: Values = state.bodies.position_y[rows]
        return heights

    return measure


def outside(rows: Rows, box: Sequence[float]) -> Measure:
    """How far each body's origin is outside of `box` (left, bottom, right, top), m; negative inside."""
    left, bottom, right, top = box

    def measure(state: State) -> Values:
        x, y = state.bodies.position_x[rows], state.bodies.position_y[rows]
        # np.maximum passes NaN on, so a lost body counts as outside.
        beside = np.maximum(left - x, x - right)
        value: Values = np.maximum(beside, np.maximum(bottom - y, y - top))
        return value

    return measure


def awake(rows: Rows) -> Measure:
    """1 for a body that is simulated, 0 for one asleep."""
    return lambda state: state.bodies.awake[rows].astype(np.float64)


def touch_count(first: Rows, second: Rows) -> Measure:
    """One value: how many contacts between a body of `first` and a body of `second` really touch."""

    def measure(state: State) -> Values:
        contacts: Any = state.contacts[: state.counters[0].contact_count]
        in_first, in_second = _mask(state, first), _mask(state, second)
        a, b = contacts.body_a, contacts.body_b
        between = (in_first[a] & in_second[b]) | (in_second[a] & in_first[b])
        return np.array([np.count_nonzero(_touching(contacts[between]))], dtype=np.float64)

    return measure


def sensed_count(carriers: Rows, others: Rows) -> Measure:
    """One value: how many shapes of `others` are in sensors of `carriers`."""

    def measure(state: State) -> Values:
        from sandbox.engine.events.sensors import SensorOverlaps

        overlaps = SensorOverlaps(state)
        overlaps.update()
        rows = overlaps.now
        inside = np.isin(rows.sensor_body, carriers) & np.isin(rows.body, others)
        return np.array([np.count_nonzero(inside)], dtype=np.float64)

    return measure


def _touching(contacts: Any) -> NDArray[np.bool_]:
    """Contacts that overlap or push; the table also holds pairs that are merely near.

    What has come to rest where nothing presses it on may be apart by rounding.
    """
    one = (contacts.separation1 <= _ROUNDING) | (contacts.normal_impulse1 > 0.0)
    two = (contacts.separation2 <= _ROUNDING) | (contacts.normal_impulse2 > 0.0)
    struck = contacts.impact_impulse > 0.0
    touching: NDArray[np.bool_] = ((contacts.point_count > 0) & one) | ((contacts.point_count > 1) & two) | struck
    return touching


def _mask(state: State, rows: Rows) -> NDArray[np.bool_]:
    mask = np.zeros(len(state.bodies), dtype=np.bool_)
    mask[rows] = True
    return mask


def counter(row: int) -> Measure:
    """The value of a counter of the scene's rules, by its row."""
    return lambda state: np.array([float(state.tallies[row].value)])


def outcome(state: State) -> Values:
    """0 while the game is open, 1 won, 2 lost; open where nothing is played."""
    return np.array([float(state.outcome[0].result) if len(state.outcome) else 0.0])

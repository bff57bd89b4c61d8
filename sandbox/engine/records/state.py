"""The tables of a world's state that the stages of a step read and write."""

from __future__ import annotations

from typing import NamedTuple

from sandbox.tables import Records


class StateTables(NamedTuple):
    """Tables of `world.state.State`; contacts and joints are in bundles of their own. `settings` and `counters` have
    one row each."""

    bodies: Records
    shapes: Records
    vertices: Records
    seams: Records
    drags: Records
    settings: Records
    counters: Records

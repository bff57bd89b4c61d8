"""The rows that events are told in."""

from __future__ import annotations

from sandbox.tables import Field, Table

CONTACT_EVENT = Table(
    "contact_event",
    (
        Field("body_a", "-", "index of the first body in `events.names`", "i8"),
        Field("body_b", "-", "index of the second body", "i8"),
        Field("shape_a", "-", "row of the first shape; shape_a < shape_b; -1 if it was deleted", "i8"),
        Field("shape_b", "-", "row of the second shape; -1 if it was deleted", "i8"),
        Field("x", "m", "where they touch: the middle of the contact points"),
        Field("y", "m", ""),
        Field("normal_x", "1", "unit normal from a to b"),
        Field("normal_y", "1", ""),
        Field("impulse", "N s", "normal impulse over the whole step"),
        Field("speed", "m/s", "at which they closed in when the step began"),
    ),
)
SENSOR_EVENT = Table(
    "sensor_event",
    (
        Field("sensor_body", "-", "index of the sensor's body", "i8"),
        Field("body", "-", "index of the body that it senses", "i8"),
        Field("sensor", "-", "row of the sensor shape; -1 if it was deleted", "i8"),
        Field("shape_index", "-", "row of the shape that it senses; -1 if it was deleted", "i8"),
    ),
)

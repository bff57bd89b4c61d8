"""All that the inspector draws over the scene."""

from __future__ import annotations

from sandbox.window.sat.outcome_drawing import OutcomeDrawing
from sandbox.window.sat.rail_drawing import RailDrawing
from sandbox.window.sat.shape_drawing import ShapeDrawing


class Drawing(ShapeDrawing, RailDrawing, OutcomeDrawing):
    """Shapes, rails and outcome on one sheet."""

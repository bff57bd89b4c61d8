"""What an author writes: the models of a scene file, loading, checking, and the flat form for a world."""

from sandbox.scene.body import Body, Prefab
from sandbox.scene.flat import FlatBody, FlatScene, FlatSettings, FlatShape
from sandbox.scene.generators import Grid, Pyramid, Row, Scatter, Stack
from sandbox.scene.load import load_scene, loads_scene
from sandbox.scene.material import Material
from sandbox.scene.scene import Scene
from sandbox.scene.schema import schema
from sandbox.scene.settings import Settings, View
from sandbox.scene.shapes import Box, Capsule, Circle, Polygon, Segment

__all__ = [
    "Body",
    "Box",
    "Capsule",
    "Circle",
    "FlatBody",
    "FlatScene",
    "FlatSettings",
    "FlatShape",
    "Grid",
    "Material",
    "Polygon",
    "Prefab",
    "Pyramid",
    "Row",
    "Scatter",
    "Scene",
    "Segment",
    "Settings",
    "Stack",
    "View",
    "load_scene",
    "loads_scene",
    "schema",
]

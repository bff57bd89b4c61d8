"""The stated limits of a scene. A file past one of them is refused before memory is taken for it."""

from __future__ import annotations

from sandbox.geometry import polygon

MAX_BYTES = 16 * 1024 * 1024
"""Size of a scene file."""

MAX_DEPTH = 32
"""Nesting of objects and lists in a scene file."""

MAX_BODIES = 100_000
"""Bodies of a scene, generated ones included."""

MAX_SHAPES = 200_000
"""Shapes of a scene, over all its bodies."""

MAX_GENERATORS = 10_000
"""Generators of a scene."""

MAX_JOINTS = 100_000
"""Joints of a scene, generated ones included."""

MAX_REGIONS = 1000
"""Regions of a scene."""

MAX_THRUSTERS = 100
"""Thrusters of a body."""

MAX_EXPECTATIONS = 1000
"""Expectations of a scene."""

MAX_VERTICES = polygon.MAX_VERTICES
"""Vertices of a convex shape."""

MAX_OUTLINE = 1000
"""Vertices of a polygon that may be concave, those of its holes included."""

MAX_PATH = 100_000
"""Characters of a path in the syntax of SVG."""

MAX_HOLES = 100
"""Holes of a polygon."""

MAX_NAME = 100
"""Characters of an id, of another name, or of a pattern for ids."""

MAX_MATCHES = 5_000_000
"""Ids that the patterns of all expectations are held against: patterns by bodies."""

MAX_SUBSTEPS = 64
"""Solver substeps in a step."""

MAX_CATEGORIES = 31
"""Named collision categories: 32 bits, the lowest of which is "default"."""

MAX_PROBLEMS = 100
"""Mistakes listed for one file; a last line counts the rest."""

MAX_ALIKE = 10
"""Mistakes of one sort listed for one file; a line counts the others."""

MAX_FINDINGS = 2000
"""Mistakes of one sort looked into before the rest is let be."""

ALL_BITS = 0xFFFFFFFF
"""A mask that collides with everything."""

MAX_RULES = 1000
"""Rules of a scene."""

MAX_CONTROLS = 100
"""Controls of a scene."""

MAX_COUNTERS = 100
"""Named counters of a scene."""

MAX_ACTIONS = 100
"""Actions of a rule, or of a control for one occasion."""

MAX_ALL_ACTIONS = 5000
"""Actions of all rules and controls of a scene."""

MAX_ALIVE = 10_000
"""Bodies that rules and controls may have brought that are there at once, all kinds together."""

MAX_TEXT = 500
"""Characters of a text to the player."""

MAX_EXPRESSION = 500
"""Characters of an expression."""

MAX_EXPRESSION_DEPTH = 32
"""Nesting of parentheses, signs and powers in an expression."""

MAX_VARS = 1000
"""Numbers by name, those of included files counted, and parameters of a prefab."""

MAX_INCLUDES = 100
"""Files that a scene includes, and those that these include."""

MAX_NESTING = 16
"""Prefabs within prefabs, and files that include files."""

MAX_VALUES = 2_000_000
"""Values that the copies of prefabs have together: half of what a file of 16 MiB can hold."""

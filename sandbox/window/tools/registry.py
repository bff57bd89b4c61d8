"""All tools, in the order of the toolbar."""

from __future__ import annotations

from sandbox.window.tools.act import BlastTool, EraseTool, MagnetTool
from sandbox.window.tools.draw import BoxTool, CapsuleTool, CircleTool, WallTool
from sandbox.window.tools.freehand import ChainTool, PolygonTool
from sandbox.window.tools.hand import Hand
from sandbox.window.tools.join import (
    HingeTool,
    MotorTool,
    PinTool,
    RodTool,
    RopeTool,
    SliderTool,
    SpringTool,
    WeldTool,
    WheelTool,
)  # fmt: skip
from sandbox.window.tools.pair import PairTool
from sandbox.window.tools.play import PlayTool
from sandbox.window.tools.regions import AttractorTool, WaterTool, WindTool, ZoneTool
from sandbox.window.tools.tool import Tool
from sandbox.window.tools.turn import TurnTool

GROUPS: tuple[tuple[str, tuple[type[Tool], ...]], ...] = (
    ("Move", (Hand, TurnTool, PlayTool)),
    (
        "Draw",
        (
            CircleTool,
            BoxTool,
            CapsuleTool,
            PolygonTool,
            WallTool,
            ChainTool,
            WaterTool,
            WindTool,
            ZoneTool,
            AttractorTool,
        ),
    ),
    ("Join", (HingeTool, WeldTool, RodTool, SpringTool, RopeTool, SliderTool, WheelTool, MotorTool, PinTool)),
    ("Act", (EraseTool, BlastTool, MagnetTool)),
    ("Look", (PairTool,)),
)


def new_tools() -> dict[str, Tool]:
    """One of each, by name."""
    return {kind.name: kind() for _, kinds in GROUPS for kind in kinds}

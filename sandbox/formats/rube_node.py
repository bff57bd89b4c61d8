"""Values of b2dJson: how it writes numbers, and what it hangs on everything."""

from __future__ import annotations

import re
import struct
from typing import Any

import numpy as np

from sandbox.formats.reading import Node
from sandbox.formats.remarks import Remarks
from sandbox.scene.finding import Path

_HEX = re.compile(r"[0-9A-Fa-f]{8}")


class RubeNode(Node):
    """Numbers of 32 bits: as decimals, or as the eight hexadecimal digits of their bytes."""

    def number_of(self, value: Any, path: Path) -> float:
        if isinstance(value, str) and _HEX.fullmatch(value):
            value = struct.unpack(">f", bytes.fromhex(value))[0]
        number = super().number_of(value, path)
        with np.errstate(over="ignore"):
            short = np.float32(number)
        # 0.20000000298023224 is what a float makes of 0.2: the shortest decimal that is the same float.
        return float(str(short)) if float(short) == number else number


def note_properties(node: RubeNode, remarks: Remarks) -> None:
    """A remark on the custom properties of an object."""
    if node.value("customProperties"):
        remarks.note(node.place, "custom properties are left out")

"""Files of other programs: from them to a scene, and back."""

from sandbox.formats.exports import TARGETS, Exported, export_scene
from sandbox.formats.imports import Imported, import_scene, open_scene
from sandbox.formats.remarks import Remark, remark_lines
from sandbox.formats.table import FORMATS

__all__ = [
    "FORMATS",
    "TARGETS",
    "Exported",
    "Imported",
    "Remark",
    "export_scene",
    "import_scene",
    "open_scene",
    "remark_lines",
]

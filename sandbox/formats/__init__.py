"""Files of other programs: from them to a scene, and back."""

from sandbox.formats.imports import Imported, import_scene, open_scene
from sandbox.formats.remarks import Remark, remark_lines
from sandbox.formats.source import Options
from sandbox.formats.table import FORMATS

__all__ = ["FORMATS", "Imported", "Options", "Remark", "import_scene", "open_scene", "remark_lines"]

"""How paths are told."""

from __future__ import annotations

import os
from pathlib import Path

import pytest


def shown(path: Path, config: pytest.Config) -> Path:
    """A path as a person in the folder of the session would write it, if that is still the folder of the process."""
    here = Path(config.invocation_params.dir)
    if here != Path.cwd():
        return path
    return Path(os.path.relpath(path, here)) if path.is_relative_to(here) else path

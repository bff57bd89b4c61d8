"""What the end of a test session tells about recordings. It travels with the reports, so that pytest-xdist keeps it."""

from __future__ import annotations

from typing import Any

import pytest

WRITTEN = "recordings written"
_KEY = "sandbox_written"


def note_written(item: pytest.Item, path: str) -> None:
    """A test wrote a recording."""
    item.user_properties.append((_KEY, path))


def written_files(terminalreporter: Any) -> list[str]:
    """The recordings that were written in this session."""
    reports = [one for kind in ("passed", "failed") for one in terminalreporter.getreports(kind)]
    return sorted({str(value) for one in reports for key, value in one.user_properties if key == _KEY})

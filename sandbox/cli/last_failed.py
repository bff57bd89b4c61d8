"""Which recordings failed the last time in this folder, kept in the user's cache folder."""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Sequence
from pathlib import Path

from platformdirs import user_cache_path

from sandbox._atomic_write import write_text
from sandbox.replay.golden.cases import Case
from sandbox.replay.golden.examine import Report


def remember(reports: Sequence[Report]) -> None:
    """Note what failed now; of recordings that did not run, what was known stays. Nothing is written under CI."""
    if os.environ.get("CI"):
        return
    ran = {_key(report.case) for report in reports}
    failed = [key for key in _read() if key not in ran]
    failed += [_key(report.case) for report in reports if not report.fine]
    try:
        _file().parent.mkdir(parents=True, exist_ok=True)
        write_text(_file(), json.dumps(sorted(failed)))
    except OSError:
        pass  # a folder that cannot be written to has no memory; the run itself is not worse for it


def only_failed(cases: list[Case]) -> list[Case]:
    """Those of `cases` that failed the last time; all of them if none did."""
    failed = set(_read())
    return [case for case in cases if _key(case) in failed] or cases


def _read() -> list[str]:
    try:
        found = json.loads(_file().read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return []
    return [key for key in found if isinstance(key, str)] if isinstance(found, list) else []


def _key(case: Case) -> str:
    return Path(os.path.realpath(case.replay)).as_posix()  # unlike `resolve`, it takes links that go in a circle


def _file() -> Path:
    root = os.environ.get("SANDBOX_CACHE_DIR")
    base = Path(root) if root else user_cache_path("sandbox2d")
    here = hashlib.blake2b(str(Path.cwd()).encode(), digest_size=8).hexdigest()
    return base / "last-failed" / f"{here}.json"

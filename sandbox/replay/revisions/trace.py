"""A run with some code of `sandbox`, as data: a checksum of every column after every step, and whole tables of some."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
from collections.abc import Collection, Mapping, Sequence
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from sandbox.errors import SandboxError
from sandbox.replay.golden.run import Run
from sandbox.replay.recording.command_words import encode
from sandbox.replay.revisions import tracer
from sandbox.scene import Scene
from sandbox.tables import Records, Table
from sandbox.world.field_records import REGION, THRUSTER
from sandbox.world.joint_records import JOINT
from sandbox.world.records import BODY, CONTACT, DRAG, SETTINGS, SHAPE

TABLES: dict[str, Table] = dict(
    zip(tracer.TABLES, (CONTACT, JOINT, DRAG, BODY, SHAPE, THRUSTER, REGION, SETTINGS), strict=True)
)
"""What the tables of a trace are called, and their declarations here."""


@dataclass(frozen=True)
class TraceSamples:
    """What to keep for a film: some `columns` of some tables, after some `steps`."""

    steps: tuple[int, ...] = ()
    columns: Mapping[str, Sequence[str]] = field(default_factory=dict)


class RevisionError(SandboxError):
    """The code of a revision cannot run this; the text says why."""


@dataclass(frozen=True)
class Trace:
    """`codes[k]` are the checksums of `columns` ("table.field") after step k; `arrays` what was dumped.

    `fingerprints` are those of a recording, from step 1 on; empty if that revision does not know them.
    """

    columns: tuple[str, ...]
    codes: Any
    arrays: dict[str, Any]
    fingerprints: tuple[str, ...] = ()

    def rows(self, step: int, table: str, shared: Collection[str]) -> Records:
        """A dumped table in the layout of today; only the columns in `shared` are filled."""
        found = self.arrays.get(f"{step}.{table}")
        made = TABLES[table].zeros(0 if found is None else len(found))
        for name in made.dtype.names or ():
            if found is not None and f"{table}.{name}" in shared:
                made[name] = found[name]
        return made

    def parts_from(self, digests: Sequence[str]) -> int | None:
        """The first step after which this is not what a recording's fingerprints say; 0: there is none; None: this
        revision knows no fingerprints.
        """
        if not self.fingerprints:
            return None
        pairs = enumerate(zip(digests, self.fingerprints, strict=False), 1)
        return next((step for step, (old, new) in pairs if old != new), 0)

    def names(self, step: int, key: str = "names") -> tuple[str, ...]:
        """The ids of bodies (or `joint_names`), row by row."""
        return tuple(self.arrays[f"{step}.{key}"].tolist())


NO_SAMPLES = TraceSamples()


def trace(
    root: Path, run: Run, dump: Collection[int] = (), no_jit: bool = False, film: TraceSamples = NO_SAMPLES
) -> Trace:
    """Run with the code that lies in `root`, in a process of its own. Raises `RevisionError` if it cannot."""
    if not isinstance(run.scene, Scene):
        raise RevisionError("only a scene can be run by another revision, not a flat one")
    with tempfile.TemporaryDirectory(prefix="sandbox-trace-") as folder:
        job, out = Path(folder, "job.json"), Path(folder, "out.npz")
        job.write_text(json.dumps(_job(root, run, run.scene, dump, film)), encoding="utf-8")
        done = _call(root, job, out, no_jit)
        if done.returncode == 0:
            return _read(out)
        told = out.read_text(encoding="utf-8") if done.returncode == 3 and out.is_file() else _last_line(done.stderr)
        raise RevisionError(told)


def _job(root: Path, run: Run, scene: Scene, dump: Collection[int], film: TraceSamples) -> dict[str, Any]:
    commands = [[step, *encode(command)] for step, command in run.commands]
    return {
        "root": str(root),
        "scene": scene.to_data(),
        "commands": commands,
        "steps": run.steps,
        "dump": sorted(dump),
        "film": asdict(film),
    }


def _call(root: Path, job: Path, out: Path, no_jit: bool) -> subprocess.CompletedProcess[str]:
    # No byte code is kept: two revisions that are checked out within a second could take each other's.
    environment = os.environ | {"PYTHONPATH": str(root), "PYTHONDONTWRITEBYTECODE": "1"}
    if no_jit:
        environment["NUMBA_DISABLE_JIT"] = "1"
    command = [sys.executable, "-P", tracer.__file__, str(job), str(out)]
    return subprocess.run(command, env=environment, capture_output=True, text=True, check=False, cwd=root)


def _read(out: Path) -> Trace:
    with np.load(out, allow_pickle=False) as found:
        arrays = {name: found[name] for name in found.files}
    columns, prints = (tuple(arrays.pop(key).tolist()) for key in ("columns", "fingerprints"))
    return Trace(columns, arrays.pop("codes"), arrays, prints)


def _last_line(text: str) -> str:
    lines = [line for line in text.splitlines() if line.strip()]
    return lines[-1] if lines else "its process ended without a word"

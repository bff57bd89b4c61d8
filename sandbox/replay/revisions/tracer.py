"""Run as a program of its own, by whatever revision of `sandbox` is on PYTHONPATH: `python -P tracer.py JOB OUT`.

Asks little of that revision: `Scene`, and `World` with `apply`, `step`, `state`, `names` and `contacts`. JOB is JSON:
scene, commands, steps, what to dump, and the folder that the code must come from. OUT gets a CRC-32 of every column of
every table after every step, the tables themselves after the steps to dump, some columns of some after those to film,
and the fingerprints that a recording would hold, if that revision knows them. Exit code 3: OUT says why not.
"""

from __future__ import annotations

import importlib
import json
import sys
from pathlib import Path
from typing import Any
from zlib import crc32

TABLES = ("contacts", "joints", "drags", "bodies", "shapes", "thrusters", "regions", "settings")


def main(job_file: str, out_file: str) -> int:
    """Do the job; the exit code."""
    try:
        job = json.loads(Path(job_file).read_text(encoding="utf-8"))
        arrays = _run(job)
    except Exception as error:
        text = " ".join(f"{type(error).__name__}: {error}".split())
        Path(out_file).write_text(text[:500], encoding="utf-8")
        return 3
    import numpy as np

    with open(out_file, "wb") as file:
        np.savez(file, **arrays)
    return 0


def _run(job: dict[str, Any]) -> dict[str, Any]:
    import numpy as np

    import sandbox

    if not Path(sandbox.__file__).resolve().is_relative_to(Path(job["root"]).resolve()):
        raise ImportError(f"there is no sandbox in {job['root']}")
    world = sandbox.World(sandbox.Scene(**job["scene"]))
    commands = [(row[0], _command(row)) for row in job["commands"]]
    columns = [f"{table}.{name}" for table, rows in _tables(world) for name in rows.dtype.names]
    codes, arrays = [_codes(world)], _dump(world, 0, job["dump"])
    take, prints = _fingerprint(), []
    for step in range(1, job["steps"] + 1):
        while commands and commands[0][0] < step:
            world.apply(commands.pop(0)[1])
        world.step()
        codes.append(_codes(world))
        prints += [take(world.state)] if take else []
        arrays |= _film(world, step, job["film"]) | _dump(world, step, job["dump"])
    known = {"columns": np.array(columns), "codes": np.array(codes, np.uint32), "fingerprints": np.array(prints, str)}
    return {**known, **arrays}


def _fingerprint() -> Any:
    """What makes a fingerprint of a state; None if that revision has no recordings yet."""
    try:
        return importlib.import_module("sandbox.replay.recording.fingerprint").fingerprint
    except (ImportError, AttributeError):
        return None


def _tables(world: Any) -> list[tuple[str, Any]]:
    known = [(name, getattr(world.state, name)) for name in TABLES[1:] if hasattr(world.state, name)]
    return [("contacts", world.contacts), *known]


def _codes(world: Any) -> list[int]:
    return [crc32(_bits(rows[name])) for _, rows in _tables(world) for name in rows.dtype.names]


def _bits(column: Any) -> bytes:
    """A column as bytes: whole numbers take eight bytes, as many as they may take in another revision."""
    bits: bytes = (column.astype("i8") if column.dtype.kind == "i" else column).tobytes()
    return bits


def _dump(world: Any, step: int, wanted: list[int]) -> dict[str, Any]:
    import numpy as np

    if step not in wanted:
        return {}
    names = {f"{step}.names": np.array(world.names, str), f"{step}.joint_names": _joint_names(world)}
    return {**names, **{f"{step}.{table}": np.array(rows) for table, rows in _tables(world)}}


def _film(world: Any, step: int, film: dict[str, Any]) -> dict[str, Any]:
    import numpy as np

    if step not in film.get("steps", ()):
        return {}
    arrays = {f"{step}.names": np.array(world.names, str)}
    for table, rows in _tables(world):
        names = [name for name in film["columns"].get(table, ()) if name in rows.dtype.names]
        kept = np.empty(len(rows), [(name, rows.dtype[name]) for name in names])
        for name in names:
            kept[name] = rows[name]
        if names:
            arrays[f"{step}.{table}"] = kept
    return arrays


def _joint_names(world: Any) -> Any:
    import numpy as np

    return np.array(getattr(world, "joint_names", ()), str)


def _command(row: list[Any]) -> Any:
    words = importlib.import_module("sandbox.replay.recording.command_words")
    timed, found = words.decode(row, ())
    if timed is None:
        raise ValueError(f"the command {row[1]} is not known there: {found[0].message}")
    return timed[1]


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))

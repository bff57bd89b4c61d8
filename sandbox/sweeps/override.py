"""Other values in the words of a scene, by paths such as `bodies.crate.position.0` or `vars.rows`.

The seam between sweeps and scene files: what `--set` does for one run (`scene/authoring/changes.py`), for many.
"""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

from sandbox._bounded_read import read_bytes
from sandbox.errors import ArgumentError, SceneError
from sandbox.scene import Scene, loads_scene
from sandbox.scene.limits import MAX_BYTES

SEED = "seed"
"""The path that stands for `vars.seed` where a scene has that number, else for the seed of every generator that has
one."""


@dataclass(frozen=True)
class Words:
    """What an author wrote: the text, the file that it is from, beside which includes are looked for, the values that
    were set before, and a fingerprint of what it includes."""

    text: str
    source: str
    before: Mapping[str, Any]
    included: str

    @classmethod
    def of(cls, scene: Scene) -> Words:
        """Those of a scene; of one that was built in Python, what a file of it would say."""
        text = scene.text if scene.text is not None else json.dumps(scene.to_data())
        included = b"".join(read_bytes(file, MAX_BYTES) for file in scene.included_files)
        source = os.path.abspath(scene.source) if os.path.isfile(scene.source) else scene.source
        return cls(text, source, scene.set_values, hashlib.blake2b(included, digest_size=8).hexdigest())

    def with_values(self, values: Mapping[str, Any]) -> Scene:
        """The scene with other values. Raises `SceneError`, and `ArgumentError` for a seed of nothing."""
        changed = {**self.before, **{path: value for path, value in values.items() if path != SEED}}
        if SEED in values:
            changed |= dict.fromkeys(self._seeds(), values[SEED])
        return loads_scene(self.text, self.source, changed)

    def told(self, error: SceneError) -> str:
        """The first mistake, without the name of the file and of an option that nobody gave."""
        problem = error.problems[0]
        path = problem.source.removeprefix(f"{self.source}: --set ") if problem.source else ""
        alone = replace(problem, source="", excerpt="", line=0, column=0)
        words = SceneError("", [alone]).lines()[0].removeprefix(": ")
        return f"{path}: {words}" if path else words

    def _seeds(self) -> list[str]:
        data = json.loads(self.text)
        if SEED in data.get("vars", ()):
            return [f"vars.{SEED}"]
        found = [f"generate.{k}.{SEED}" for k, entry in enumerate(data.get("generate", ())) if "scatter" in entry]
        if not found:
            raise ArgumentError("seed: nothing in this scene is random: it has no scatter generator")
        return found

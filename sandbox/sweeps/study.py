"""A sweep before it runs, and one run of it: plain data, so that any process can make the run."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import islice

from sandbox._version import __version__
from sandbox.engine.arithmetic_version import ARITHMETIC
from sandbox.engine.world import World
from sandbox.errors import ArgumentError, SandboxError, SceneError
from sandbox.replay.headless_run import planned_steps
from sandbox.scene import Scene
from sandbox.sweeps.collector import check_names, run_and_collect
from sandbox.sweeps.design import Design, Values
from sandbox.sweeps.expression import Collected, read_expressions
from sandbox.sweeps.override import Words

OK = "ok"
_TRIED = 100
"""So many runs are looked at for one whose scene can be."""


@dataclass(frozen=True)
class Study:
    """What all runs of a sweep share: the words of the scene, what varies, how many steps, what is collected.

    `steps` is None for as many as the scene itself plans.
    """

    words: Words
    paths: tuple[str, ...]
    steps: int | None
    collect: tuple[str, ...]

    @property
    def expressions(self) -> tuple[Collected, ...]:
        """What is collected. Raises `ArgumentError`."""
        return read_expressions(self.collect)

    @property
    def columns(self) -> tuple[str, ...]:
        """The names of the columns that are collected."""
        return tuple(column for each in self.expressions for column in each.columns)

    def scene(self, values: Values) -> Scene:
        """The scene of the run with these values of the parameters."""
        return self.words.with_values(dict(zip(self.paths, values, strict=True)))

    def fingerprint(self, runs: Sequence[Values]) -> str:
        """16 hex digits of everything that decides what the runs give, the version of this package included."""
        words = [self.words.text, self.words.before, self.words.included]
        everything = [__version__, ARITHMETIC, words, self.paths, self.steps, self.collect, runs]
        return hashlib.blake2b(json.dumps(everything).encode(), digest_size=8).hexdigest()


@dataclass(frozen=True)
class Outcome:
    """What came of a run: `values` are those of the columns, NaN where it failed; `status` is "ok" or the error."""

    run: int
    values: tuple[float, ...]
    digest: str
    steps: int
    status: str

    @property
    def is_ok(self) -> bool:
        """Whether it ran to its end."""
        return self.status == OK


def study_of(scene: Scene, design: Design, steps: int | None, collect: Sequence[str]) -> Study:
    """The study of a scene, all of it checked: paths lead somewhere, and what is collected is there.

    Raises `ArgumentError` or `SceneError`.
    """
    study = Study(Words.of(scene), design.paths, steps, tuple(collect))
    expressions = study.expressions
    for name in study.columns:
        if name in (*design.paths, "digest", "steps", "status"):
            raise ArgumentError(f"collect: there is a column {name!r} already; give this one another name")
    first = _first_scene(study, design.runs)
    if first is not None:
        check_names(expressions, first.flatten(), planned_steps(first, steps))
    return study


def _first_scene(study: Study, runs: Sequence[Values]) -> Scene | None:
    """The scene of the first run that can be; the error of the very first one if none can."""
    refusal: SceneError | None = None
    for values in islice(runs, _TRIED):
        try:
            return study.scene(values)
        except SceneError as error:
            refusal = refusal or error
    if refusal is not None:
        raise ArgumentError(f"the scene cannot be with such values: {study.words.told(refusal)}")
    return None


def make_run(study: Study, run: int, values: Values) -> Outcome:
    """One run of a study. What goes wrong in it is its status."""
    try:
        scene = study.scene(values)
        steps = planned_steps(scene, study.steps)
        world = World(scene)
        collected = run_and_collect(world, steps, study.expressions)
        return Outcome(run, collected, world.digest(), world.step_count, OK)
    except (SandboxError, MemoryError) as error:
        lost = (float("nan"),) * len(study.columns)
        return Outcome(run, lost, "", 0, _status(study, error))


def _status(study: Study, error: Exception) -> str:
    """What a run that failed says: one line."""
    text = study.words.told(error) if isinstance(error, SceneError) else str(error) or type(error).__name__
    return text.splitlines()[0]

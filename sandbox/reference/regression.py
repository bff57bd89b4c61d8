"""A disagreement as a test: a file that pytest runs as it is, with the exact poses."""

from __future__ import annotations

import re
from pathlib import Path
from string import Template

from sandbox._atomic_write import write_text
from sandbox.reference.ask_pymunk import PYMUNK_VERSION
from sandbox.reference.comparison_result import Comparison, Disagreement, Miss
from sandbox.resources import SCENE_SUFFIX
from sandbox.scene import Scene

_PAIR = Template('''\
"""$title

sandbox:       $ours
pymunk $version: $theirs
exact:         $truth
"""

from sandbox.reference.pair import Core, Pair
from sandbox.reference.arbitration import faults_of

PAIR = $pair


def test_$name() -> None:
    assert faults_of(PAIR) == []
''')

_STEP = Template('''\
"""$title"""

from pathlib import Path

from sandbox.reference.comparison import compare
from sandbox.scene import load_scene

SCENE = Path(__file__).with_name("$scene")


def test_$name() -> None:
    tally = compare(load_scene(SCENE), steps=$step, first=$step)
    assert tally.disagreements == []
    assert tally.misses == []
''')


def save_regressions(scene: Scene, source: Path, tally: Comparison, folder: Path) -> list[Path]:
    """Write a test for every disagreement and every missed pair kept in `tally`; the files written.

    What a pair of shapes can show stands alone. What takes a whole step (a missed pair, a lost contact) comes with a
    copy of the scene, which runs to the same bits anywhere. Raises OSError.
    """
    stem = source.name.removesuffix(SCENE_SUFFIX)
    tests = [_of_disagreement(found, stem) for found in tally.disagreements]
    tests += [_of_miss(miss, stem) for miss in tally.misses]
    if not tests:
        return []
    folder.mkdir(parents=True, exist_ok=True)
    if any(_copy_name(stem) in text for _, text in tests):
        scene.save(folder / _copy_name(stem))
    written = []
    for name, text in tests:
        path = folder / f"test_{name}.py"
        write_text(path, text)
        written.append(path)
    return list(dict.fromkeys(written))


def _of_disagreement(found: Disagreement, stem: str) -> tuple[str, str]:
    name = _identifier(f"{stem}_step_{found.step}_shapes_{found.shapes[0]}_{found.shapes[1]}")
    title = f"{stem}, step {found.step}: {found.names[0]} and {found.names[1]}, {found.what}."
    if found.what in ("no contact", "contact axis"):
        return name, _STEP.substitute(title=title, scene=_copy_name(stem), name=name, step=found.step)
    text = _PAIR.substitute(
        title=title,
        ours=found.ours,
        version=PYMUNK_VERSION,
        theirs=found.theirs,
        truth=found.ruling.truth,
        pair=found.pair.source(),
        name=name,
    )
    return name, text


def _of_miss(miss: Miss, stem: str) -> tuple[str, str]:
    name = _identifier(f"{stem}_step_{miss.step}_missed")
    title = f"{stem}, step {miss.step}: the grid missed {miss.names[0]} and {miss.names[1]}."
    return name, _STEP.substitute(title=title, scene=_copy_name(stem), name=name, step=miss.step)


def _copy_name(stem: str) -> str:
    return f"{stem}{SCENE_SUFFIX}"


def _identifier(text: str) -> str:
    return re.sub(r"\W+", "_", text.lower())

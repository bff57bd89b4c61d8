"""`sandbox compare --twin`: whole scenes beside pymunk or the simple solver, as a table, JSON or a picture."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from sandbox._printable import printable, told
from sandbox.cli.document import print_document
from sandbox.cli.failures import HOLDS, UNUSABLE, problems, report
from sandbox.errors import SandboxError

if TYPE_CHECKING:
    from rich.console import Console

    from sandbox.reference.others import TwinName
    from sandbox.reference.twin import Twin
    from sandbox.scene import Scene

_ROWS = 12
_WIDTH = 120
_MEASURES = (
    ("energy", "energy", "J", 1.0),
    ("penetration", "overlap", "mm", 1e3),
    ("height", "height", "m", 1.0),
    ("top", "top", "m", 1.0),
)
"""Field of the measures, what the table calls it, its unit there and the factor to it."""


@dataclass(frozen=True)
class Task:
    """With whom scenes are compared, how long, how often they are measured, where curves go, what is set in them."""

    name: TwinName
    steps: int | None
    every: int
    plot: Path | None
    values: Mapping[str, Any]


def run_twins(files: Sequence[Path], task: Task, as_json: bool) -> int:
    """Run every scene in the engine and in the twin, and show what came of it; the exit code."""
    from rich.console import Console

    from sandbox.cli.progress import SceneProgress

    if task.plot is not None:
        _check_plot(task.plot, files)
    out = Console(soft_wrap=True, highlight=False)
    # In a file there is room for numbers of any length.
    out = out if out.is_terminal else Console(soft_wrap=True, highlight=False, width=_WIDTH)
    entries: list[dict[str, Any]] = []
    with SceneProgress(out if out.is_terminal and not as_json else Console(stderr=True), len(files)) as progress:
        for file in files:
            entries.append(_run(file, task, None if as_json else out, progress))
    code = UNUSABLE if any("problems" in entry for entry in entries) else HOLDS
    if as_json:
        print_document(_facts(entries, task.name), code)
    return code


def _check_plot(plot: Path, files: Sequence[Path]) -> None:
    from sandbox.cli.picture_options import writable_picture
    from sandbox.reference.twin_plot import SUFFIXES, require_matplotlib

    if len(files) > 1:
        raise SandboxError(f"--plot draws one scene; {len(files)} were given")
    writable_picture(plot, SUFFIXES, files)
    require_matplotlib()


def _run(file: Path, task: Task, out: Console | None, progress: Any) -> dict[str, Any]:
    from sandbox.cli.opening import open_any
    from sandbox.reference.twin import simulate_twin
    from sandbox.scene.duration import planned_steps

    plot = task.plot
    try:
        scene = open_any(file, task.values)
        total = planned_steps(scene) if task.steps is None else task.steps
        progress.begin(file.name, total)
        twin = simulate_twin(scene, total, task.every, progress.done, task.name)
        if plot is not None:
            _save(twin, scene, file, plot)
    except (SandboxError, OSError) as error:
        report(error)
        return {"path": file.as_posix(), "problems": problems(error)}
    if out is not None:
        _show(out, file, scene, twin, plot)
    return _entry(file, scene, twin, plot)


def _save(twin: Twin, scene: Scene, file: Path, plot: Path) -> None:
    from sandbox.reference.twin_plot import save_plot

    save_plot(twin, scene.title or file.name, plot)


def _show(out: Console, file: Path, scene: Scene, twin: Twin, plot: Path | None) -> None:
    from rich.text import Text

    title = f"{told(file)}: {printable(scene.title)}" if scene.title else told(file)
    out.print(Text(title, style="bold"))
    out.print(_table(twin))
    for note in twin.notes:
        out.print(Text(f"  {note}", style="dim"))
    if plot is not None:
        out.print(Text(f"  drawn into {told(plot)}", style="dim"))


def _table(twin: Twin) -> Any:
    """About a dozen samples, evenly spread; each measure once for both engines."""
    from rich import box
    from rich.table import Table

    table = Table(box=box.SIMPLE_HEAD, header_style="dim", pad_edge=False, collapse_padding=True)
    table.add_column("time\ns", justify="right")
    for _, name, unit, _ in _MEASURES:
        table.add_column(f"{name}\n{unit}\nsandbox", justify="right")
        table.add_column(f"\n\n{twin.name}", justify="right", style="cyan")
    last = len(twin.times) - 1
    for k in sorted({round(last * i / _ROWS) for i in range(_ROWS + 1)}):
        cells = [f"{twin.times[k]:.2f}"]
        for field, _, _, factor in _MEASURES:
            cells += [f"{factor * getattr(side[k], field):.5g}" for side in (twin.ours, twin.theirs)]
        table.add_row(*cells)
    return table


def _facts(entries: list[dict[str, Any]], name: TwinName) -> dict[str, Any]:
    from sandbox.reference.ask_pymunk import PYMUNK_VERSION

    versions = {"pymunk": PYMUNK_VERSION} if name == "pymunk" else {}
    return {"twin": name, **versions, "scenes": entries}


def _entry(file: Path, scene: Scene, twin: Twin, plot: Path | None) -> dict[str, Any]:
    return {
        "path": file.as_posix(),
        "title": scene.title,
        "notes": list(twin.notes),
        "plot": plot.as_posix() if plot is not None else None,
        "times": list(twin.times),
        "sandbox": [asdict(each) for each in twin.ours],
        twin.name: [asdict(each) for each in twin.theirs],
    }

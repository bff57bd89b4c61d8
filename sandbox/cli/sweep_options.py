"""What `sandbox sweep` takes, checked before anything runs."""

from __future__ import annotations

import os
from collections.abc import Collection, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Literal

import typer

from sandbox._atomic_write import check_writable
from sandbox._printable import told
from sandbox.cli.document import JSON
from sandbox.cli.options import SET
from sandbox.cli.output import check_not_source
from sandbox.errors import SandboxError

_SCENE = typer.Argument(
    metavar="SCENE", help="A scene file, or the name of one that comes with the package; with --plot, also a table."
)
_VARY = typer.Option(
    "--vary", metavar="PATH=VALUES", show_default=False,
    help="What varies, and through which values: vars.friction=0.1:0.9:9 (LOW:HIGH:COUNT), seed=0:100 (whole numbers, "
    "both ends included), materials.wood.friction=0.2,0.5. May be repeated: every combination is run.",
)  # fmt: skip
_STEPS = typer.Option(min=0, max=10_000_000, metavar="N", show_default=False, help="Steps of a run; the scene's own.")
_COLLECT = typer.Option(
    "--collect", metavar="WHAT", show_default=False,
    help="What becomes columns at the end of a run: \"body('crate').position\", \"max(body('crate').speed)\", "
    "\"at(120, energy)\", \"apex = max(body('ball').y)\". May be repeated.",
)  # fmt: skip
_OUTPUT = typer.Option(
    "-o", "--output", metavar="FILE", show_default=False, help="A table, .csv or .parquet; standard output is CSV."
)
_SAMPLE = typer.Option(min=1, max=1_000_000, metavar="N", show_default=False, help="N random runs instead of a grid.")
_SEED = typer.Option(min=0, metavar="S", help="Another seed, another sample.")
_JOBS = typer.Option("-j", "--jobs", min=0, max=256, metavar="N", help="Processes; 0 is one for each processor.")
_SCHEDULER = typer.Option(metavar="ADDRESS", show_default=False, help="Run on this Dask cluster, as tcp://host:8786.")
_RESUME = typer.Option("--resume", help="Go on with a sweep that was ended: finished runs are kept.")
_FORCE = typer.Option("--force", help="Write over a table that is there.")
_PLOT = typer.Option(metavar="FILE", show_default=False, help="Draw columns of the table: .png or .svg.")
_X = typer.Option("--x", metavar="COLUMN", show_default=False, help="Along the x axis; default: the first that varies.")
_Y = typer.Option("--y", metavar="COLUMN", show_default=False, help="What is drawn; may be repeated, a panel each.")
_OVER = typer.Option(
    "--over", metavar="COLUMN", show_default=False,
    help="Draw a heat map: this column upwards, --y as colours; default where two values vary: the second.",
)  # fmt: skip
_BY = typer.Option("--by", metavar="COLUMN", show_default=False, help="A colour for each value of this column.")
_THEME = typer.Option(metavar="dark|light", help="Colours of the plot.")


@dataclass(frozen=True)
class SweepOptions:
    """What `sandbox sweep` was asked for."""

    scene: Annotated[Path, _SCENE]
    vary: Annotated[list[str] | None, _VARY] = None
    steps: Annotated[int | None, _STEPS] = None
    collect: Annotated[list[str] | None, _COLLECT] = None
    output: Annotated[Path | None, _OUTPUT] = None
    sample: Annotated[int | None, _SAMPLE] = None
    seed: Annotated[int, _SEED] = 1
    set: Annotated[list[str] | None, SET] = None
    jobs: Annotated[int, _JOBS] = 0
    scheduler: Annotated[str | None, _SCHEDULER] = None
    resume: Annotated[bool, _RESUME] = False
    force: Annotated[bool, _FORCE] = False
    plot: Annotated[Path | None, _PLOT] = None
    x: Annotated[str | None, _X] = None
    y: Annotated[list[str] | None, _Y] = None
    by: Annotated[str | None, _BY] = None
    over: Annotated[str | None, _OVER] = None
    theme: Annotated[Literal["dark", "light"], _THEME] = "dark"
    json: Annotated[bool, JSON] = False

    @property
    def is_of_table(self) -> bool:
        """Whether SCENE is a table that was made before."""
        from sandbox.sweeps.table import SUFFIXES

        return self.scene.suffix.lower() in SUFFIXES

    def check_table(self) -> None:
        """Raises `SandboxError` where a table that is there is to be drawn, and an option is about runs."""
        if self.plot is None:
            raise SandboxError(f"{told(self.scene)} is a table; --plot FILE draws it, and a scene is run")
        for name in ("vary", "steps", "collect", "set", "sample", "scheduler", "resume", "output"):
            if getattr(self, name) not in (None, False):
                text = f"--{name} is for a scene that is run, and {told(self.scene)} is a table, which is only drawn"
                raise SandboxError(text)


def varied(texts: list[str]) -> Mapping[str, str]:
    """The paths of `--vary` and what they go through. Raises `SandboxError`."""
    found: dict[str, str] = {}
    for text in texts:
        path, equals, values = text.partition("=")
        path = path.strip()
        if not equals or not path or not values.strip():
            raise SandboxError(f"--vary {text!r}: write PATH=VALUES, such as gravity.1=-12:-2:6")
        if path in found:
            raise SandboxError(f"--vary {path} is given twice; list its values: {path}={found[path]},{values}")
        found[path] = values.strip()
    return found


def check_set(values: Collection[str], paths: Collection[str]) -> None:
    """Raises `SandboxError` where `--set` gives one value to what `--vary` goes through: it would count for nothing."""
    for path in paths:
        for name in values:
            if name == path or name.startswith(f"{path}."):
                raise SandboxError(f"--set {name}: --vary {path} puts other values there; leave one of them away")


def check_output(options: SweepOptions) -> None:
    """Refuse at once what cannot be written, or should not be, before anything is run."""
    from sandbox.sweeps.journal import journal_of
    from sandbox.sweeps.table import SUFFIXES, require_arrow

    output = options.output
    if output is None:
        if options.resume:
            raise SandboxError("--resume goes on with a table: name it with -o")
        return
    suffix = output.suffix.lower()
    if suffix not in SUFFIXES:
        raise SandboxError(f"{told(output)}: the name of a table must end in {' or '.join(SUFFIXES)}")
    if suffix == ".parquet":
        require_arrow()
    check_not_source(output, [options.scene])
    check_writable(output)
    journal = journal_of(output)
    if os.path.lexists(journal) and not (options.resume or options.force):
        mend = "--resume goes on with it, --force begins anew"
        raise SandboxError(f"{told(journal)}: here is the journal of a sweep that was ended; {mend}")
    if os.path.lexists(output) and not options.force and not (options.resume and os.path.lexists(journal)):
        raise SandboxError(f"{told(output)}: there is a file of that name already; --force writes over it")


def check_plot_file(plot: Path, scene: Path) -> None:
    """Refuse a picture that cannot be drawn. Raises `SandboxError` or `OSError`."""
    from sandbox.cli.picture_options import writable_picture
    from sandbox.sweeps.plot import SUFFIXES, require_matplotlib

    writable_picture(plot, SUFFIXES, [scene])
    require_matplotlib()

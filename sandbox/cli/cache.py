"""`sandbox cache`: where compiled kernels are kept, and under which name a CI server should keep them."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any

import typer

from sandbox._printable import told
from sandbox.cli.document import JSON, print_document

_KEY = typer.Option("--key", help="Print only the key: it changes when the kernels have to be compiled anew.")
_PATH = typer.Option("--path", help="Print only the folder: SANDBOX_CACHE_DIR, or the user's cache folder.")
_FILL = typer.Option("--fill", help="Compile the kernels now, for this very processor, if they are not there yet.")
_INTO = typer.Option(
    metavar="DIR", show_default=False, help="Compile for all usual processors of this platform, for a wheel."
)


def cache(
    key: Annotated[bool, _KEY] = False,
    path: Annotated[bool, _PATH] = False,
    fill: Annotated[bool, _FILL] = False,
    into: Annotated[Path | None, _INTO] = None,
    json: Annotated[bool, JSON] = False,
) -> None:
    """Say where compiled kernels are kept, and the key under which a CI server can keep that folder.

    The key is made of the kernels' sources, the versions of numba and Python, and the processor.

    Exit code 0, or 2 if the folder cannot be used.
    """
    if into is not None:
        _compile_for_wheel(into, json)
        return
    found = _found(fill)
    if json:
        print_document(found)
    elif key or path:
        print("\n".join(str(found[name]) for name, wanted in (("key", key), ("path", path)) if wanted))
    else:
        state = "compiled" if found["compiled"] else "not compiled yet"
        if found["shipped"]:
            state += f", and shipped for {found['shipped']}"
        print(f"path: {told(found['path'])}\nkey:  {found['key']}\nkernels: {state}, {found['bytes'] / 1e6:.1f} MB")


def _found(fill: bool) -> dict[str, Any]:
    from sandbox._kernel_cache import cache_folder, cache_key, cache_root, is_compiled, sources_hash
    from sandbox._shipped_code import shipped_folder

    cache_folder().mkdir(parents=True, exist_ok=True)  # raises what kept it from being made
    shipped = shipped_folder(sources_hash())
    if fill and not is_compiled():
        _compile()
    return {
        "path": cache_root().as_posix(),
        "key": cache_key(),
        "compiled": is_compiled(),
        "shipped": shipped and shipped.name,
        "bytes": sum(file.stat().st_size for file in cache_folder().rglob("*") if file.is_file()),
    }


def _compile() -> None:
    import os

    from sandbox._shipped_code import SWITCH
    from sandbox.cli.compiling import announce_compilation
    from sandbox.engine.world import World
    from sandbox.scene import Scene

    os.environ[SWITCH] = "0"  # for the other process too
    announce_compilation()
    World(Scene()).step()


def _compile_for_wheel(folder: Path, as_json: bool) -> None:
    from sandbox.cli.compile_for_wheel import compile_for_wheel

    levels = compile_for_wheel(folder)
    size = sum(file.stat().st_size for level in levels for file in level.iterdir())
    names = [level.name for level in levels]
    if as_json:
        print_document({"path": folder.as_posix(), "levels": names, "bytes": size})
    else:
        print(f"{told(folder)}: machine code for {', '.join(names)}, {size / 1e6:.1f} MB")

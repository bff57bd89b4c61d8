"""`sandbox cache`: where compiled kernels are kept, and under which name a CI server should keep them."""

from __future__ import annotations

from typing import Annotated, Any

import typer

_KEY = typer.Option("--key", help="Print only the key: it changes when the kernels have to be compiled anew.")
_PATH = typer.Option("--path", help="Print only the folder: SANDBOX_CACHE_DIR, or the user's cache folder.")
_FILL = typer.Option("--fill", help="Compile the kernels now if they are not there yet.")
_JSON = typer.Option("--json", help="Print one JSON document instead.")


def cache(
    key: Annotated[bool, _KEY] = False,
    path: Annotated[bool, _PATH] = False,
    fill: Annotated[bool, _FILL] = False,
    json: Annotated[bool, _JSON] = False,
) -> None:
    """Say where compiled kernels are kept, and the key under which a CI server can keep that folder.

    The key is made of the kernels' sources, the versions of numba and Python, and the processor.

    Exit code 0, or 2 if the folder cannot be used.
    """
    found = _found(fill)
    if json:
        _print_document(found)
    elif key or path:
        print("\n".join(str(found[name]) for name, wanted in (("key", key), ("path", path)) if wanted))
    else:
        state = "compiled" if found["compiled"] else "not compiled yet"
        print(f"path: {found['path']}\nkey:  {found['key']}\nkernels: {state}, {found['bytes'] / 1e6:.1f} MB")


def _found(fill: bool) -> dict[str, Any]:
    from sandbox._jit import cache_is_cold
    from sandbox._kernel_cache import cache_folder, cache_key, cache_root

    if fill and cache_is_cold():
        _compile()
    size = sum(file.stat().st_size for file in cache_folder().rglob("*") if file.is_file())
    compiled = not cache_is_cold()
    return {"format": 1, "path": cache_root().as_posix(), "key": cache_key(), "compiled": compiled, "bytes": size}


def _compile() -> None:
    from sandbox.cli.compiling import announce_compilation
    from sandbox.engine.world import World
    from sandbox.scene import Scene

    announce_compilation()
    World(Scene()).step()


def _print_document(found: dict[str, Any]) -> None:
    import json

    print(json.dumps(found, indent=2))
